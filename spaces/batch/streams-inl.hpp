// SPDX-License-Identifier: MIT
//
// Triangles whose coordinates are streams, classified as many at a time as a register has lanes.
#if defined(CLIPSCOPE_BATCH_STREAMS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_STREAMS_INL
#undef CLIPSCOPE_BATCH_STREAMS_INL
#else
#define CLIPSCOPE_BATCH_STREAMS_INL
#endif

#include "spaces/batch/classify-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

// Classifies triangles [first, first + count) in whole vectors, and returns how many that are:
// numbers of those inside go to the writer, others that survive, counted from `first`, to the list.
// Not inlined: there its speed hangs on what else is in the function.
template <class D>
HWY_NOINLINE std::size_t classify_streams(D d, const ClipLimits& limits, const TriangleStreams& in,
                                          std::size_t first, std::size_t count, Writer& writer,
                                          Survivors& out) {
  const hn::RebindToUnsigned<D> du;
  const auto floats = 3 * static_cast<std::size_t>(in.attribute_count);  // attributes of a triangle
  std::size_t t = 0;
  for (; t + hn::Lanes(d) <= count; t += hn::Lanes(d)) {
    const auto vertex = [&](std::size_t v) {
      const auto load = [&](std::size_t c) { return hn::LoadU(d, in.positions[v][c] + first + t); };
      return Positions<D>{load(0), load(1), load(2), load(3)};
    };
    const Positions<D> vertices[3] = {vertex(0), vertex(1), vertex(2)};
    const Triangles<D> triangles = classify(d, limits, vertices);
    if (hn::AllFalse(d, triangles.survive)) continue;
    writer.inside = append_numbers(du, first + t, mask_bits(d, triangles.inside), writer.inside);
    const auto cut = hn::AndNot(triangles.inside, triangles.survive);
    if (hn::AllFalse(d, cut)) continue;
    std::size_t i = out.count;
    out.add(d, t, {cut, triangles.inside, triangles.any});
    for (; i < out.count; ++i) {
      prefetch_floats(in.attributes + (first + out.triangle[i]) * floats, floats);
    }
  }
  return t;
}

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
