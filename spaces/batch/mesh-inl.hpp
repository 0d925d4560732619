// SPDX-License-Identifier: MIT
//
// An indexed mesh's triangles, classified: each vertex once, then by their codes the triangles.
#if defined(CLIPSCOPE_BATCH_MESH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_MESH_INL
#undef CLIPSCOPE_BATCH_MESH_INL
#else
#define CLIPSCOPE_BATCH_MESH_INL
#endif

#include <bit>
#include <span>

#include "spaces/batch/classify-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

// f(i) for each i below count, one of each part in turn: to several streams memory delivers more
// than to one.
template <class F>
HWY_INLINE void for_parts_in_turn(std::size_t count, F&& f) {
  constexpr std::size_t kParts = 4;
  const std::size_t part = count / kParts, parts = kParts * part;
  for (std::size_t i = 0; i < part; ++i) {
    for (std::size_t p = 0; p < kParts; ++p) f(p * part + i);
  }
  for (std::size_t i = parts; i < count; ++i) f(i);
}

// Codes of as many vertices as kD16 has lanes, with their complements. Each comparison that a
// vertex passes turns its bit off and that of the complement on: it adds the difference.
HWY_INLINE void classify_positions(const ClipLimits& limits, const float* v, std::size_t stride,
                                   std::uint16_t* codes) {
  const hn::RebindToUnsigned<D16> du;
  const Positions<D16> p = load_positions(kD16, v, stride);
  auto sum = hn::Set(du, 0xFF);
  const auto turn = [&](hn::Mask<D16> passes, int bit) {
    sum = hn::Add(sum, hn::IfThenElseZero(hn::RebindMask(du, passes), hn::Set(du, 0xFFu << bit)));
  };
  for_each_plane(kD16, limits, [&](int bit, auto is_inside) { turn(is_inside(p), bit); });
  turn(hn::Le(p.w, hn::Set(kD16, kLargest)), 3);
  turn(hn::Gt(p.w, hn::Zero(kD16)), 7);
  const hn::Rebind<std::uint16_t, D16> d16;
  hn::StoreU(hn::DemoteTo(d16, hn::BitCast(hn::RebindToSigned<D16>(), sum)), d16, codes);
}

// Codes of all vertices of a mesh, with their complements.
HWY_INLINE void classify_vertices(const ClipLimits& limits, const VertexArray& in,
                                  std::size_t stride, std::uint16_t* codes) {
  const ClipLimits own = limits;  // no store can be taken for one to them
  const std::size_t at_once = kMostLanes, whole = in.count / at_once;
  for_parts_in_turn(whole, [&, first = in.data](std::size_t i) {
    const float* const v = first + i * at_once * stride;
    prefetch_ahead(v, at_once * stride * sizeof(float));
    classify_positions(own, v, stride, codes + i * at_once);
  });
  for (std::size_t i = whole * at_once; i < in.count; ++i) {
    codes[i] = with_complement(vertex_code(limits, in.data + i * stride));
  }
}

// A block of a mesh's triangles.
class MeshBlock {
 public:
  // codes: those of the vertices; indices: three per triangle.
  HWY_INLINE void classify(const std::uint16_t* codes, std::span<const std::uint32_t> indices) {
    const std::size_t count = indices.size() / 3;
    const std::uint32_t* i = indices.data();
    std::size_t t = 0;
    for (; t + kRun <= count; t += kRun, i += 3 * kRun) {
      prefetch_ahead(i, 3 * kRun * sizeof *i);
      for (std::size_t pair = 0; pair < kRun; pair += 2) {
        classify_two(codes, i + 3 * pair, codes_ + t + pair);
      }
    }
    for (; t < count; ++t, i += 3) {
      codes_[t] = static_cast<std::uint16_t>(codes[i[0]] | codes[i[1]] | codes[i[2]]);
    }
    std::fill_n(codes_ + count, kRun, 0);  // rejected
  }

  // Numbers of the triangles inside go to the writer, others that survive to the list. number: the
  // first triangle's in the mesh.
  HWY_INLINE void sort(std::size_t count, std::size_t number, Writer& writer,
                       Survivors& out) const {
    const hn::CappedTag<std::uint16_t, kRun> d;
    const hn::CappedTag<std::uint32_t, kRun> numbers;
    const auto surviving = hn::Set(d, kSurvivingCodes);
    out.count = 0;
    for (std::size_t t = 0; t < count; t += hn::Lanes(d)) {
      const auto codes = hn::LoadU(d, codes_ + t);
      const auto survives = hn::Eq(hn::And(codes, surviving), surviving);
      if (hn::AllFalse(d, survives)) continue;
      const auto inside = hn::Eq(codes, hn::Set(d, kInsideCodes));
      const unsigned bits = mask_bits(d, inside);
      for (std::size_t lane = 0; lane < hn::Lanes(d); lane += hn::Lanes(numbers)) {
        writer.inside = append_numbers(numbers, number + t + lane, bits >> lane, writer.inside);
      }
      for (unsigned rest = mask_bits(d, hn::AndNot(inside, survives)); rest != 0;
           rest &= rest - 1) {
        const std::size_t cut = t + static_cast<std::size_t>(std::countr_zero(rest));
        out.triangle[out.count] = static_cast<std::uint16_t>(cut);
        out.any[out.count++] = static_cast<std::uint8_t>(codes_[cut]);
      }
    }
  }

 private:
  // Triangles at a time: their indices are three cache lines.
  static constexpr std::size_t kRun = 16;

  // Classifies two triangles. The number of loads bounds the speed, so six indices are read as
  // three pairs.
  static HWY_INLINE void classify_two(const std::uint16_t* codes, const std::uint32_t* indices,
                                      std::uint16_t* HWY_RESTRICT out) {
    static_assert(std::endian::native == std::endian::little);
    const auto pair = [&](int k) {
      std::uint64_t two;
      std::memcpy(&two, indices + 2 * k, sizeof two);
      return two;
    };
    const auto first = [&](std::uint64_t two) { return codes[static_cast<std::uint32_t>(two)]; };
    const auto second = [&](std::uint64_t two) { return codes[two >> 32]; };
    const std::uint64_t a = pair(0), b = pair(1), c = pair(2);
    out[0] = static_cast<std::uint16_t>(first(a) | second(a) | first(b));
    out[1] = static_cast<std::uint16_t>(second(b) | first(c) | second(c));
  }

  std::uint16_t codes_[kMostBlock + kRun];
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
