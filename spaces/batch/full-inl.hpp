// SPDX-License-Identifier: MIT
//
// The full contract: view space in, NDC out. A block of triangles is brought into the space where
// it is cut, classified and cut as in the stage, and divided.
//
//   by view planes     cut in view space, then projected
//   computed in float  projected, cut and divided in float
//   in double          projected, cut and divided in double; rounded to float at the end
//   correctly rounded  see full_rounded-inl.hpp
#if defined(CLIPSCOPE_BATCH_FULL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_FULL_INL
#undef CLIPSCOPE_BATCH_FULL_INL
#else
#define CLIPSCOPE_BATCH_FULL_INL
#endif

#include "spaces/batch/methods.hpp"
#include "spaces/batch/stage-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

// The rows of a projection matrix by lane, so that a position (x, y, z, …) becomes own (x, y, z, z)
// + z_weight (z, z, z, z) + one, with the bits of `to_clip`.
template <class V>
class ProjectionLanes {
  using D = hn::CappedTag<V, 4>;

 public:
  explicit ProjectionLanes(const Projection<V>& p)
      : own_{p.x.own, p.y.own, p.z.z, p.w.z},
        z_weight_{p.x.z, p.y.z, 0, 0},
        one_{p.x.one, p.y.one, p.z.one, p.w.one} {}

  // Four floats have to be readable. magnitude, if wanted: the sums of the magnitudes of the terms.
  HWY_INLINE void project(const float* v, V* out, V* magnitude = nullptr) const {
    const auto p = hn::LoadU(kD4, v), z = hn::Broadcast<2>(p);
    HWY_ALIGN float point[4];
    hn::Store(hn::IfThenElse(hn::FirstN(kD4, 3), p, z), kD4, point);
    const D d;
    const auto vz = hn::Set(d, static_cast<V>(hn::GetLane(z)));
    for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
      const auto own = hn::Mul(hn::Load(d, own_ + i), load(d, point + i)),
                 of_z = hn::Mul(hn::Load(d, z_weight_ + i), vz), one = hn::Load(d, one_ + i);
      hn::StoreU(hn::Add(hn::Add(own, of_z), one), d, out + i);
      if (magnitude != nullptr) {
        hn::StoreU(hn::Add(hn::Add(hn::Abs(own), hn::Abs(of_z)), hn::Abs(one)), d, magnitude + i);
      }
    }
  }

 private:
  HWY_ALIGN V own_[4], z_weight_[4], one_[4];
};

// A clip-space position divided by its w, rounded to float: (x, y, z, 1) / w. Whether w was finite
// and positive, and x, y, z are finite in float.
template <class V>
HWY_INLINE bool divide_to(const V* v, float* out) {
  const hn::CappedTag<V, 4> d;
  const V w = v[3];
  bool finite = w > 0 && w <= std::numeric_limits<V>::max();
  for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
    const auto is_coordinate = hn::FirstN(d, 3 - i);
    const auto numerator = hn::IfThenElse(is_coordinate, hn::LoadU(d, v + i), hn::Set(d, V(1)));
    const auto q = hn::Div(numerator, hn::Set(d, w));
    const auto is_finite = hn::Le(hn::Abs(q), hn::Set(d, V(kLargest)));
    finite = finite && hn::AllTrue(d, hn::Or(is_finite, hn::Not(is_coordinate)));
    store(d, q, out + i);
  }
  return finite;
}

template <class M, int K>
class FullClipper {
  using V = typename M::Number;
  using S = Shape<K>;

 public:
  FullClipper(const Projection<float>& projection, int attributes)
      : projection_(projection),
        straddlers_(make_straddlers(projection, attributes)),
        lanes_(plain::projection_in<V>(projection)) {}

  void operator()(const ViewVertexArray& in, Output& out) {
    const OutputAccess access{out};
    access.begin(in.attributes);
    Block memory;
    const S& shape = straddlers_.shape;
    const std::size_t stride = shape.floats(), from = stride - 1, triangles = in.count / 3;
    for (std::size_t first = 0; first < triangles; first += kBlock) {
      const std::size_t count = std::min(kBlock, triangles - first);
      const float* block = in.data + first * 3 * from;
      for (std::size_t v = 0; v < 3 * count; ++v) {
        bring(block + v * from, memory.vertices + v * stride);
      }
      classify_block(straddlers_.limits, memory.vertices, stride, count, memory.survivors);
      clip_survivors(block, first, count, memory, access);
    }
  }

 private:
  // What a block needs beside its results. Whole vectors are read and written.
  struct Block {
    HWY_ALIGN V vertices[kBlock * 3 * S::kMostFloats + kSlack];
    HWY_ALIGN V polygon[kMostVertices * S::kMostFloats + kSlack];
    Survivors survivors;
  };

  static Straddlers<M, K, V> make_straddlers(const Projection<float>& projection, int attributes) {
    if constexpr (kIsView<M>) {
      return {projection.frustum, attributes};
    } else {
      return {projection.volume.depth, attributes};
    }
  }

  // A view-space vertex into the space where it is cut: (x, y, z, 1) or clip space. Without
  // attributes there is no fourth float behind the last vertex.
  HWY_INLINE void bring(const float* v, V* out) const {
    const std::size_t attributes = straddlers_.shape.floats() - 4;
    HWY_ALIGN float position[4];
    if (attributes == 0) {
      std::memcpy(position, v, 3 * sizeof(float));
      v = position;
    }
    if constexpr (kIsView<M>) {
      const auto p = hn::IfThenElse(hn::FirstN(kD4, 3), hn::LoadU(kD4, v), hn::Set(kD4, 1.0f));
      hn::StoreU(p, kD4, out);
    } else {
      lanes_.project(v, out);
    }
    if constexpr (S::kFixed && S::kMostFloats == 8) {
      const hn::CappedTag<V, 4> d;
      for (std::size_t k = 0; k < 4; k += hn::Lanes(d)) {
        hn::StoreU(load(d, v + 3 + k), d, out + 4 + k);
      }
    } else {
      for (std::size_t k = 0; k < attributes; ++k) out[4 + k] = v[3 + k];
    }
  }

  HWY_INLINE void clip_survivors(const float* block, std::size_t first, std::size_t count,
                                 Block& memory, const OutputAccess& access) {
    const S& shape = straddlers_.shape;
    const std::size_t stride = shape.floats();
    const Survivors& survivors = memory.survivors;
    Writer writer = access.block(survivors.count);
    Tally& tally = access.tally();
    tally.rejected += count - survivors.count;
    straddlers_.begin(survivors);
    const auto at = [&](std::size_t i, int v) {
      return memory.vertices + (3 * survivors.triangle[i] + static_cast<std::size_t>(v)) * stride;
    };
    for (std::size_t i = 0; i < survivors.count; ++i) {
      const std::size_t t = survivors.triangle[i];
      int vertices = 3;
      if (survivors.any[i] == 0) {
        ++tally.inside;
        vertices = finish(at(i, 0), 3, writer.next);
      } else {
        vertices = straddlers_.cut(survivors, i, at, memory.polygon, tally);
        if (vertices != kGiveUp) vertices = finish(memory.polygon, vertices, writer.next);
      }
      if (vertices == kGiveUp) {
        vertices = plain::cut_full(kMethod<M>, projection_, shape.attributes,
                                   block + 3 * t * (stride - 1), writer.next);
      }
      writer.add(first + t, vertices);
    }
    access.commit(writer);
  }

  // Vertices of the space of the cut to NDC, rounded to float; how many, or kGiveUp where something
  // is not finite.
  HWY_INLINE int finish(const V* v, int count, float* out) const {
    const std::size_t stride = straddlers_.shape.floats();
    bool finite = true;
    for (int i = 0; i < count; ++i, v += stride, out += stride) {
      copy_vertex(straddlers_.shape, v, out);
      if constexpr (kIsView<M>) {
        HWY_ALIGN float position[4];
        lanes_.project(v, position);
        finite = divide_to(position, out) && finite;
      } else {
        finite = divide_to(v, out) && finite;
      }
    }
    return finite ? count : kGiveUp;
  }

  const Projection<float>& projection_;
  Straddlers<M, K, V> straddlers_;
  const ProjectionLanes<V> lanes_;
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
