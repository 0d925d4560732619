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
template <class D>
HWY_INLINE std::size_t classify_streams(D d, const ClipLimits& limits, const TriangleStreams& in,
                                        std::size_t first, std::size_t count, Writer& writer,
                                        Survivors& out) {
  const hn::RebindToUnsigned<D> du;
  const auto floats = 3 * static_cast<std::size_t>(in.attribute_count);  // attributes of a triangle
  std::size_t t = 0;
  for (; t + hn::Lanes(d) <= count; t += hn::Lanes(d)) {
    // Per plane: whether some vertex is inside; and whether all are, of all planes.
    hn::Mask<D> some[kPlanes], every;
    auto least_w = hn::Zero(d), most_w = hn::Zero(d);
    for (int v = 0; v < 3; ++v) {
      const auto& p = in.positions[v];
      const auto x = hn::LoadU(d, p[0] + first + t), y = hn::LoadU(d, p[1] + first + t),
                 z = hn::LoadU(d, p[2] + first + t), w = hn::LoadU(d, p[3] + first + t);
      hn::Mask<D> in_plane[kPlanes];
      planes_inside(d, limits, {x, y, z, w}, in_plane);
      for (int i = 0; i < kPlanes; ++i) {
        some[i] = v == 0 ? in_plane[i] : hn::Or(some[i], in_plane[i]);
        every = v == 0 && i == 0 ? in_plane[i] : hn::And(every, in_plane[i]);
      }
      least_w = v == 0 ? w : hn::Min(least_w, w);
      most_w = v == 0 ? w : hn::Max(most_w, w);
    }
    hn::Mask<D> survives = some[0];
    for (int i = 1; i < kPlanes; ++i) survives = hn::And(survives, some[i]);
    if (hn::AllFalse(d, survives)) continue;
    // Where `every` holds no w is NaN.
    const auto inside =
        hn::And(every, hn::And(hn::Le(most_w, hn::Set(d, kLargest)), hn::Gt(least_w, hn::Zero(d))));
    writer.inside = append_numbers(du, first + t, mask_bits(d, inside), writer.inside);
    for (unsigned rest = mask_bits(d, hn::AndNot(inside, survives)); rest != 0; rest &= rest - 1) {
      const auto cut = t + static_cast<std::size_t>(std::countr_zero(rest));
      out.triangle[out.count++] = static_cast<std::uint16_t>(cut);
      prefetch_floats(in.attributes + (first + cut) * floats, floats);
    }
  }
  return t;
}

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
