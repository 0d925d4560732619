// SPDX-License-Identifier: MIT
//
// Outcodes in SIMD: comparisons only, hence exact.
//
// Included once per instruction set (Highway's foreach_target), so it has no include guard of the usual kind.
#if defined(CLIPSCOPE_BATCH_CLASSIFY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_CLASSIFY_INL
#undef CLIPSCOPE_BATCH_CLASSIFY_INL
#else
#define CLIPSCOPE_BATCH_CLASSIFY_INL
#endif

#include <hwy/highway.h>

#include <limits>

#include "spaces/batch/layout.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D4 = hn::CappedTag<float, 4>;
using D8 = hn::CappedTag<float, 8>;
inline constexpr D4 kD4;
inline constexpr D8 kD8;
// Whether (v, -v) fits into one register.
inline constexpr bool kHas8 = hn::MaxLanes(D8()) == 8;
static_assert(hn::MaxLanes(D4()) == 4);

inline constexpr float kLargest = std::numeric_limits<float>::max();
inline constexpr float kLeast = std::numeric_limits<float>::denorm_min();

// What (x, y, z, w) and its negative are compared with: w where `keep` has ones, else `fill`.
// Lane 3: w <= FLT_MAX, it is finite. Lane 7: -w <= -FLT_TRUE_MIN, it is positive. Lane 6, for depth from
// 0 on: -z <= 0.
struct alignas(32) Limits {
  std::uint32_t keep[8] = {~0u, ~0u, ~0u, 0, ~0u, ~0u, ~0u, 0};
  float fill[8] = {0, 0, 0, kLargest, 0, 0, 0, -kLeast};
  float negative[8] = {0, 0, 0, 0, -0.0f, -0.0f, -0.0f, -0.0f};

  explicit Limits(DepthRange depth) {
    if (depth != DepthRange::minus_one_to_one) keep[6] = 0;
  }
};

template <class D>
HWY_INLINE hn::Mask<D> passes(D d, const Limits& limits, const float* v, std::size_t lane) {
  const hn::RebindToUnsigned<D> du;
  const auto p = hn::LoadDup128(d, v);
  const auto w = hn::Broadcast<3>(p);
  const auto keep = hn::BitCast(d, hn::Load(du, limits.keep + lane));
  const auto limit = hn::Or(hn::And(w, keep), hn::Load(d, limits.fill + lane));
  return hn::Le(hn::Xor(p, hn::Load(d, limits.negative + lane)), limit);
}

template <class D>
HWY_INLINE unsigned mask_bits(D d, hn::Mask<D> mask) {
  std::uint8_t bits[8] = {0};
  hn::StoreMaskBits(d, mask, bits);
  return bits[0];
}

// The code of a vertex at v.
HWY_INLINE unsigned vertex_code(const Limits& limits, const float* v) {
  if constexpr (kHas8) {
    return ~mask_bits(kD8, passes(kD8, limits, v, 0)) & 0xFF;
  } else {
    return ~(mask_bits(kD4, passes(kD4, limits, v, 0)) | mask_bits(kD4, passes(kD4, limits, v, 4))
                                                             << 4) &
           0xFF;
  }
}

// Of three vertices: `all` has the bits that all of them have, `any` those that some have.
struct Codes {
  unsigned all, any;
};

template <class D>
HWY_INLINE Codes triangle_codes_from(D d, const Limits& limits, const float* v, std::size_t stride,
                                     std::size_t lane) {
  const auto a = passes(d, limits, v, lane), b = passes(d, limits, v + stride, lane),
             c = passes(d, limits, v + 2 * stride, lane);
  const auto every = hn::And(a, hn::And(b, c)), some = hn::Or(a, hn::Or(b, c));
  return {mask_bits(d, some), mask_bits(d, every)};
}

HWY_INLINE Codes triangle_codes(const Limits& limits, const float* v, std::size_t stride) {
  if constexpr (kHas8) {
    const Codes pass = triangle_codes_from(kD8, limits, v, stride, 0);
    return {~pass.all & 0xFF, ~pass.any & 0xFF};
  } else {
    const Codes upper = triangle_codes_from(kD4, limits, v, stride, 0),
                lower = triangle_codes_from(kD4, limits, v, stride, 4);
    return {~(upper.all | lower.all << 4) & 0xFF, ~(upper.any | lower.any << 4) & 0xFF};
  }
}

// Which triangles of a block are not rejected, in order, and the bits that some of their vertices have.
struct Survivors {
  std::uint32_t count = 0;
  std::uint16_t triangle[kBlock + 1];
  std::uint8_t any[kBlock + 1];

  // Without a branch: what is not kept is overwritten.
  HWY_INLINE void add(std::size_t t, Codes codes) {
    triangle[count] = static_cast<std::uint16_t>(t);
    any[count] = static_cast<std::uint8_t>(codes.any);
    count += (codes.all & kPlaneBits) == 0;
  }
};

// Triangles whose vertices lie one after the other, so many floats apart.
HWY_INLINE void classify_block(const Limits& limits, const float* v, std::size_t stride,
                               std::size_t triangles, Survivors& out) {
  for (std::size_t t = 0; t < triangles; ++t) {
    out.add(t, triangle_codes(limits, v + 3 * t * stride, stride));
  }
}

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
