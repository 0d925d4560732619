// SPDX-License-Identifier: MIT
//
// Outcodes in SIMD: comparisons only, hence exact.
//
// Included once per instruction set (Highway's foreach_target), so it has no include guard of the
// usual kind.
#if defined(CLIPSCOPE_BATCH_CLASSIFY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_CLASSIFY_INL
#undef CLIPSCOPE_BATCH_CLASSIFY_INL
#else
#define CLIPSCOPE_BATCH_CLASSIFY_INL
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <bit>
#include <limits>
#include <type_traits>

#include "spaces/batch/layout.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D4 = hn::CappedTag<float, 4>;
using D8 = hn::CappedTag<float, 8>;
inline constexpr D4 kD4;
inline constexpr D8 kD8;
// The widest: 4, 8 or 16 floats.
using D16 = hn::CappedTag<float, 16>;
inline constexpr D16 kD16;
inline constexpr std::size_t kMostLanes = hn::MaxLanes(D16());
// Whether (v, -v) fits into one register.
inline constexpr bool kHas8 = hn::MaxLanes(D8()) == 8;
static_assert(hn::MaxLanes(D4()) == 4);

inline constexpr float kLargest = std::numeric_limits<float>::max();
inline constexpr float kLeast = std::numeric_limits<float>::denorm_min();

// Clip space: (x, y, z, w) and its negative are compared with w where `keep` has ones, else with
// `fill`. Lane 3: w <= FLT_MAX, it is finite. Lane 7: -w <= -FLT_TRUE_MIN, it is positive. Lane 6,
// for depth from 0 on: -z <= 0.
struct alignas(32) ClipLimits {
  std::uint32_t keep[8] = {~0u, ~0u, ~0u, 0, ~0u, ~0u, ~0u, 0};
  float fill[8] = {0, 0, 0, kLargest, 0, 0, 0, -kLeast};
  float negative[8] = {0, 0, 0, 0, -0.0f, -0.0f, -0.0f, -0.0f};
  // The signed distances of the planes in these lanes, as CodePlane has them; 0 in lanes 3 and 7.
  float w_weight[8] = {1, 1, 1, 0, 1, 1, 1, 0}, c_weight[8] = {-1, -1, -1, 0, 1, 1, 1, 0};

  explicit ClipLimits(DepthRange depth) {
    if (depth != DepthRange::minus_one_to_one) {
      keep[6] = 0;
      w_weight[6] = 0;
    }
  }

  // Which comparisons of lanes lane, lane + 1, … the vertex at v passes.
  template <class D>
  HWY_INLINE hn::Mask<D> passes(D d, const float* v, std::size_t lane) const {
    const hn::RebindToUnsigned<D> du;
    const auto p = hn::LoadDup128(d, v);
    const auto w = hn::Broadcast<3>(p);
    const auto limit =
        hn::Or(hn::And(w, hn::BitCast(d, hn::Load(du, keep + lane))), hn::Load(d, fill + lane));
    return hn::Le(hn::Xor(p, hn::Load(d, negative + lane)), limit);
  }
};

// View space, of vertices (x, y, z, 1): the signed distances of all planes, own c + z_weight z +
// constant for coordinate c of each lane, as `view_distance` has them. Lanes 3 and 7 pass always.
struct alignas(32) ViewLimits {
  float own[8] = {}, z_weight[8] = {}, constant[8] = {};

  explicit ViewLimits(const std::array<ViewCodePlane, kPlanes>& planes) {
    for (const ViewCodePlane& plane : planes) {
      own[plane.bit] = plane.own;
      z_weight[plane.bit] = plane.z_weight;
      constant[plane.bit] = plane.constant;
    }
  }

  template <class D>
  HWY_INLINE hn::Mask<D> passes(D d, const float* v, std::size_t lane) const {
    const auto p = hn::LoadDup128(d, v);
    const auto sum = hn::Add(hn::Mul(hn::Load(d, own + lane), p),
                             hn::Mul(hn::Load(d, z_weight + lane), hn::Broadcast<2>(p)));
    return hn::Le(hn::Zero(d), hn::Add(sum, hn::Load(d, constant + lane)));
  }
};

// Asks memory for what is needed soon.
HWY_INLINE void prefetch_floats(const float* p, std::size_t count) {
  for (std::size_t i = 0; i < count; i += 16) hwy::Prefetch(p + i);
  if (count != 0) hwy::Prefetch(p + count - 1);
}
// The lines of so many bytes, further on by more than the processor looks ahead; they need not
// exist.
inline constexpr std::size_t kBytesAhead = 4096, kLineBytes = 64;
HWY_INLINE void prefetch_ahead(const void* p, std::size_t bytes) {
  const auto from = reinterpret_cast<std::uintptr_t>(p) + kBytesAhead;
  for (std::size_t i = 0; i < bytes; i += kLineBytes) {
    hwy::Prefetch(reinterpret_cast<const char*>(from + i));
  }
}

// Memory of which some lines at a time are brought into the cache of second level, so that it does
// not rest while a triangle is cut. Those that prefetch_ahead asks for are left out.
class NextLines {
 public:
  HWY_INLINE NextLines(const float* begin, std::size_t floats)
      : at_(reinterpret_cast<std::uintptr_t>(begin) + kBytesAhead),
        end_(reinterpret_cast<std::uintptr_t>(begin + floats)) {}

  HWY_INLINE void prefetch_some() {
    constexpr std::size_t kLines = 8;
    if (at_ >= end_) return;
    for (std::size_t i = 0; i < kLines; ++i, at_ += kLineBytes) {
      __builtin_prefetch(reinterpret_cast<const char*>(at_), 0, 2);
    }
  }

 private:
  std::uintptr_t at_, end_;
};

template <class D>
HWY_INLINE unsigned mask_bits(D d, hn::Mask<D> mask) {
  static_assert(std::endian::native == std::endian::little);
  std::uint64_t bits = 0;
  hn::StoreMaskBits(d, mask, reinterpret_cast<std::uint8_t*>(&bits));
  return static_cast<unsigned>(bits);
}

// The code of a vertex at v. Limits: ClipLimits or ViewLimits.
template <class Limits>
HWY_INLINE unsigned vertex_code(const Limits& limits, const float* v) {
  if constexpr (kHas8) {
    return ~mask_bits(kD8, limits.passes(kD8, v, 0)) & 0xFF;
  } else {
    const unsigned upper = mask_bits(kD4, limits.passes(kD4, v, 0)),
                   lower = mask_bits(kD4, limits.passes(kD4, v, 4));
    return ~(upper | lower << 4) & 0xFF;
  }
}

// The same for doubles. Pre-condition: they are finite.
HWY_INLINE unsigned vertex_code(const ClipLimits& limits, const double* v) {
  const double w = v[3], lowest_z = limits.keep[6] != 0 ? -w : 0.0;
  const auto set = [](bool outside, int at) { return static_cast<unsigned>(outside) << at; };
  return set(v[0] > w, 0) | set(v[1] > w, 1) | set(v[2] > w, 2) | set(v[0] < -w, 4) |
         set(v[1] < -w, 5) | set(v[2] < lowest_z, 6) | set(!(w > 0), 7);
}

// Vertices, one register per coordinate.
template <class D>
struct Positions {
  hn::Vec<D> x, y, z, w;
};

// The four floats at at(i), at(4 + i), at(8 + i) and so on, one after the other. Sixteen lanes are
// loaded under masks, which does without shuffles.
template <class D, class At>
HWY_INLINE hn::Vec<D> load_fourths(D d, std::size_t i, At&& at) {
  if constexpr (hn::MaxLanes(D()) == 16) {
    auto r = hn::LoadDup128(d, at(12 + i));
    r = hn::IfThenElse(hn::FirstN(d, 12), hn::LoadDup128(d, at(8 + i)), r);
    r = hn::IfThenElse(hn::FirstN(d, 8), hn::LoadDup128(d, at(4 + i)), r);
    return hn::IfThenElse(hn::FirstN(d, 4), hn::LoadDup128(d, at(i)), r);
  } else if constexpr (hn::MaxLanes(D()) == 8) {
    return hn::Combine(d, hn::LoadU(kD4, at(4 + i)), hn::LoadU(kD4, at(i)));
  } else {
    return hn::LoadU(d, at(i));
  }
}

// Loads the positions of as many vertices as d has lanes, 4, 8 or 16; at(i): where the i-th lies.
template <class D, class At>
HWY_INLINE Positions<D> load_positions_at(D d, At&& at) {
  const auto v0 = load_fourths(d, 0, at), v1 = load_fourths(d, 1, at), v2 = load_fourths(d, 2, at),
             v3 = load_fourths(d, 3, at);
  const auto xy_even = hn::InterleaveLower(d, v0, v2), xy_odd = hn::InterleaveLower(d, v1, v3),
             zw_even = hn::InterleaveUpper(d, v0, v2), zw_odd = hn::InterleaveUpper(d, v1, v3);
  return {hn::InterleaveLower(d, xy_even, xy_odd), hn::InterleaveUpper(d, xy_even, xy_odd),
          hn::InterleaveLower(d, zw_even, zw_odd), hn::InterleaveUpper(d, zw_even, zw_odd)};
}

// The same of vertices that lie `stride` floats apart.
template <class D>
HWY_INLINE Positions<D> load_positions(D d, const float* v, std::size_t stride) {
  return load_positions_at(d, [=](std::size_t i) { return v + i * stride; });
}

// f(bit, is_inside) for each plane; is_inside(p): which vertices of p are.
template <class D, class F>
HWY_INLINE void for_each_plane(D d, const ClipLimits& limits, F&& f) {
  using P = const Positions<D>&;
  const auto keep_z = hn::BitCast(d, hn::Set(hn::RebindToUnsigned<D>(), limits.keep[6]));
  f(0, [](P p) { return hn::Le(p.x, p.w); });
  f(1, [](P p) { return hn::Le(p.y, p.w); });
  f(2, [](P p) { return hn::Le(p.z, p.w); });
  f(4, [](P p) { return hn::Le(hn::Neg(p.w), p.x); });
  f(5, [](P p) { return hn::Le(hn::Neg(p.w), p.y); });
  f(6, [&](P p) { return hn::Le(hn::And(hn::Neg(p.w), keep_z), p.z); });
}

// What becomes of as many triangles as d has lanes.
template <class D>
struct Triangles {
  hn::Mask<D> survive;
  hn::Vec<hn::RebindToUnsigned<D>> any;  // the bits that some vertex has

  HWY_INLINE hn::Mask<D> inside(D d) const {
    return hn::RebindMask(d, hn::Eq(any, hn::Zero(hn::RebindToUnsigned<D>())));
  }
};

// Classifies triangles by their vertices, plane by plane: so few masks are alive at a time. Each
// comparison that all three vertices pass takes its bit away.
template <class D>
HWY_INLINE Triangles<D> classify(D d, const ClipLimits& limits, const Positions<D> (&v)[3]) {
  const hn::RebindToUnsigned<D> du;
  Triangles<D> r{hn::FirstN(d, hn::Lanes(d)), hn::Set(du, 0xFF)};
  const auto take = [&](hn::Mask<D> passes, int bit) {
    const auto value = hn::Set(du, 1u << bit);
    r.any = hn::Sub(r.any, hn::IfThenElseZero(hn::RebindMask(du, passes), value));
  };
  for_each_plane(d, limits, [&](int bit, auto is_inside) {
    const auto a = is_inside(v[0]), b = is_inside(v[1]), c = is_inside(v[2]);
    r.survive = hn::And(r.survive, hn::Or(a, hn::Or(b, c)));
    take(hn::And(a, hn::And(b, c)), bit);
  });
  // Where all planes are passed no w is NaN.
  take(hn::Le(hn::Max(v[0].w, hn::Max(v[1].w, v[2].w)), hn::Set(d, kLargest)), 3);
  take(hn::Gt(hn::Min(v[0].w, hn::Min(v[1].w, v[2].w)), hn::Zero(d)), 7);
  return r;
}

// A code with its complement above it. The codes of three vertices, or'ed, have the bits that some
// vertex has and, above, those that some vertex has not.
HWY_INLINE std::uint16_t with_complement(unsigned code) {
  return static_cast<std::uint16_t>(code | (~code & 0xFF) << 8);
}
// Three vertices inside have these bits and no others; those of a survivor have all of the second.
inline constexpr std::uint16_t kInsideCodes = 0xFF00;
inline constexpr std::uint16_t kSurvivingCodes = kPlaneBits << 8;

// The codes of three vertices at once: `all` has the bits that all of them have, `any` those that
// some have.
struct Codes {
  unsigned all, any;
};

template <class D, class Limits>
HWY_INLINE Codes triangle_codes_from(D d, const Limits& limits, const float* v, std::size_t stride,
                                     std::size_t lane) {
  const auto a = limits.passes(d, v, lane), b = limits.passes(d, v + stride, lane),
             c = limits.passes(d, v + 2 * stride, lane);
  const auto every = hn::And(a, hn::And(b, c)), some = hn::Or(a, hn::Or(b, c));
  return {mask_bits(d, some), mask_bits(d, every)};
}

template <class Limits>
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

HWY_INLINE Codes triangle_codes(const ClipLimits& limits, const double* v, std::size_t stride) {
  const unsigned a = vertex_code(limits, v), b = vertex_code(limits, v + stride),
                 c = vertex_code(limits, v + 2 * stride);
  return {a & b & c, a | b | c};
}

// Which triangles of a block are not rejected, in order, and the bits that some of their vertices
// have.
struct Survivors {
  std::uint32_t count = 0;
  std::uint16_t triangle[kMostBlock + kMostLanes];
  std::uint8_t any[kMostBlock + 64];  // whole vectors may be read

  // Without a branch: what is not kept is overwritten.
  HWY_INLINE void add(std::size_t t, unsigned some, bool survives) {
    triangle[count] = static_cast<std::uint16_t>(t);
    any[count] = static_cast<std::uint8_t>(some);
    count += survives;
  }
  HWY_INLINE void add(std::size_t t, Codes codes) {
    add(t, codes.any, (codes.all & kPlaneBits) == 0);
  }
  // Triangles t, t + 1, …
  template <class D>
  HWY_INLINE void add(D d, std::size_t t, const Triangles<D>& some) {
    const hn::RebindToUnsigned<D> du;
    if constexpr (hn::MaxLanes(D()) > 8) {
      const auto numbers = hn::Add(hn::Iota(du, 0), hn::Set(du, static_cast<std::uint32_t>(t)));
      const auto survive = hn::RebindMask(du, some.survive);
      narrow(du, hn::Compress(numbers, survive), triangle + count);
      narrow(du, hn::Compress(some.any, survive), any + count);
      count += static_cast<std::uint32_t>(hn::CountTrue(du, survive));
    } else {
      const unsigned bits = mask_bits(d, some.survive);
      HWY_ALIGN std::uint32_t codes[hn::MaxLanes(D())];
      hn::Store(some.any, du, codes);
      for (std::size_t i = 0; i < hn::Lanes(d); ++i) add(t + i, codes[i], (bits >> i & 1) != 0);
    }
  }

 private:
  template <class D, class To>
  static HWY_INLINE void narrow(D, hn::Vec<D> v, To* to) {
    const hn::Rebind<To, D> d;
    hn::StoreU(hn::DemoteTo(d, hn::BitCast(hn::RebindToSigned<D>(), v)), d, to);
  }
};

// The numbers first, first + 1, … of d's lanes whose bits are set; returns where the next number
// goes. Where an instruction does not do it, Highway looks a permutation up in a table of 1 KB,
// which GCC copies to the stack each time.
template <class D>
HWY_INLINE std::uint32_t* append_numbers(D d, std::size_t first, unsigned bits, std::uint32_t* to) {
  const std::size_t lanes = hn::Lanes(d);
  const auto numbers = hn::Add(hn::Iota(d, 0), hn::Set(d, static_cast<std::uint32_t>(first)));
  const unsigned all = (1u << lanes) - 1;
  if ((bits & all) == all) {  // as often with neighbours in a mesh
    hn::StoreU(numbers, d, to);
    return to + lanes;
  }
  if constexpr (hn::MaxLanes(D()) > 8) {
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits),
                                   static_cast<std::uint8_t>(bits >> 8)};
    return to + hn::CompressStore(numbers, hn::LoadMaskBits(d, bytes), d, to);
  } else {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      *to = static_cast<std::uint32_t>(first + lane);
      to += bits >> lane & 1;
    }
    return to;
  }
}

// Classifies as many triangles as a register has lanes, whose vertices lie one after the other, so
// many floats apart.
HWY_INLINE Triangles<D16> classify_next(const ClipLimits& limits, const float* v,
                                        std::size_t stride) {
  const Positions<D16> vertices[3] = {load_positions(kD16, v, 3 * stride),
                                      load_positions(kD16, v + stride, 3 * stride),
                                      load_positions(kD16, v + 2 * stride, 3 * stride)};
  return classify(kD16, limits, vertices);
}

// Classifies triangles whose vertices lie one after the other.
template <class Limits, class V>
HWY_INLINE void classify_block(const Limits& limits, const V* v, std::size_t stride,
                               std::size_t triangles, Survivors& out) {
  const auto at = [=](std::size_t t) { return v + 3 * t * stride; };
  const Limits own = limits;  // no store can be taken for one to them
  std::size_t t = 0;
  out.count = 0;
  if constexpr (std::is_same_v<Limits, ClipLimits> && std::is_same_v<V, float>) {
    for (; t + kMostLanes <= triangles; t += kMostLanes) {
      prefetch_ahead(at(t), 3 * kMostLanes * stride * sizeof(float));
      out.add(kD16, t, classify_next(own, at(t), stride));
    }
  }
  for (; t < triangles; ++t) out.add(t, triangle_codes(own, at(t), stride));
}

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
