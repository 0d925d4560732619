// SPDX-License-Identifier: MIT
//
// The straddling triangles of a block, cut by a method: those that one plane cuts, or several, each
// in its own way, as many at once as the method can.
#if defined(CLIPSCOPE_BATCH_STRADDLERS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_STRADDLERS_INL
#undef CLIPSCOPE_BATCH_STRADDLERS_INL
#else
#define CLIPSCOPE_BATCH_STRADDLERS_INL
#endif

#include "spaces/batch/barycentric-inl.hpp"
#include "spaces/batch/lane_queue-inl.hpp"
#include "spaces/batch/lanes-inl.hpp"
#include "spaces/batch/methods.hpp"
#include "spaces/batch/planes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

// The planes of a volume in the order in which they cut, and by their bits.
template <class Plane>
class PlanesByBit {
 public:
  explicit PlanesByBit(const std::array<Plane, kPlanes>& planes) {
    for (const Plane& plane : planes) by_bit_[static_cast<std::size_t>(plane.bit)] = plane;
  }
  // any: one bit.
  const Plane& operator[](unsigned any) const {
    return by_bit_[static_cast<std::size_t>(std::countr_zero(any))];
  }

 private:
  std::array<Plane, 8> by_bit_{};
};

template <class M>
inline constexpr bool kIsView = M::simd == Simd::view_planes;

template <class M>
using PlaneOf = std::conditional_t<kIsView<M>, ViewCodePlane, CodePlane>;

// A triangle's vertices as whole vectors: those of the input, or copies with zeros behind.
template <class S, class V>
class Padded {
 public:
  const V* vertex[3];

  // at(v): where a vertex lies.
  template <class F>
  HWY_INLINE void set(const S& shape, F&& at) {
    for (int v = 0; v < 3; ++v) {
      if constexpr (S::kLoadsInPlace) {
        vertex[v] = at(v);
      } else {
        std::memcpy(memory_[v], at(v), shape.floats() * sizeof(V));
        vertex[v] = memory_[v];
      }
    }
  }

 private:
  HWY_ALIGN V memory_[3][S::kWidth] = {};
};

// A survivor among those of its block; at(i, v): where vertex v of survivor i lies.
template <class At>
struct Survivor {
  const Survivors& all;
  std::size_t i;
  At& at;
  bool moderate;  // is_moderate; else it is only to be left out

  unsigned any() const { return all.any[i]; }
};

// Those that one plane cuts, with their splits, which are computed for the next ones together.
template <class SplitsOf, class Plane>
class SplitQueue {
 public:
  explicit SplitQueue(const std::array<Plane, kPlanes>& planes) : by_bit_(planes) {}

  void begin(const Cuts& cuts) { queue_.begin(cuts.one); }

  // The place of the next one among the splits.
  template <class At>
  HWY_INLINE std::size_t next(const Survivor<At>& s) {
    return queue_.next([&](std::span<const std::size_t> members) {
      splits_.clear();
      for (const std::size_t i : members) {
        splits_.add(by_bit_[s.all.any[i]], [&](int v, int c) { return s.at(i, v)[c]; });
      }
      splits_.compute();
    });
  }
  const SplitsOf& splits() const { return splits_; }
  // The plane that cuts it.
  template <class At>
  const Plane& plane_of(const Survivor<At>& s) const {
    return by_bit_[s.any()];
  }

 private:
  const PlanesByBit<Plane> by_bit_;
  SplitsOf splits_;
  LaneQueue<kMostSplits> queue_;
};

// Cuts from plane to plane, several triangles at once.
template <class M, class S, class V>
class ChainCuts {
 public:
  using Planes = std::array<PlaneOf<M>, kPlanes>;
  using Limits = std::conditional_t<kIsView<M>, ViewLimits, ClipLimits>;

  ChainCuts(const S& shape, const Limits& limits, const Planes& planes, DepthRange)
      : shape_(shape), ones_(planes), planes_(shape, limits, planes) {}

  void begin(const Cuts& cuts) {
    ones_.begin(cuts);
    others_.begin(cuts.other);
  }

  template <class At>
  HWY_INLINE int cut_one(const Survivor<At>& s, const V* const vertex[3], V* out, Tally&) {
    const std::size_t place = ones_.next(s);
    return s.moderate ? cut_one_plane(shape_, vertex, ones_.splits()[place], out) : kGiveUp;
  }
  template <class At>
  HWY_NOINLINE int cut_several(const Survivor<At>& s, const V* const*, V* out, Tally&) {
    const std::size_t i = others_.next([&](std::span<const std::size_t> members) {
      planes_.cut(members.size(), [&](std::size_t in, int v) { return s.at(members[in], v); });
    });
    return s.moderate ? planes_.write(i, out) : kGiveUp;
  }

 private:
  using Number = typename M::Number;

  using Several = PlaneAfterPlane<Number, S, Limits, PlaneOf<M>>;

  const S& shape_;
  SplitQueue<EdgeSplits<Number, V>, PlaneOf<M>> ones_;
  Several planes_;
  LaneQueue<Several::kTriangles> others_;
};

// The same, a triangle in each lane, as far as that goes.
template <class M, class S>
class LaneCuts {
 public:
  using Planes = std::array<CodePlane, kPlanes>;

  LaneCuts(const S& shape, const ClipLimits& limits, const Planes& planes, DepthRange)
      : shape_(shape), planes_(shape, limits, planes), lanes_(planes) {}

  void begin(const Cuts& cuts) {
    Choice all;
    for (std::size_t i = 0; i < std::size(all.bits); ++i) {
      all.bits[i] = cuts.one.bits[i] | cuts.other.bits[i];
    }
    queue_.begin(all);
  }

  template <class At>
  HWY_INLINE int cut_one(const Survivor<At>& s, const float* const vertex[3], float* out,
                         Tally& tally) {
    return cut_several(s, vertex, out, tally);
  }
  template <class At>
  HWY_INLINE int cut_several(const Survivor<At>& s, const float* const vertex[3], float* out,
                             Tally&) {
    const std::size_t lane = queue_.next([&](std::span<const std::size_t> members) {
      lanes_.cut(members.size(), [&](std::size_t in, int v) { return s.at(members[in], v); });
      std::size_t left[kTriangleLanes], count = 0;
      for (std::size_t in = 0; in < members.size(); ++in) {  // without a branch
        left[count] = members[in];
        place_[in] = count;
        count += static_cast<std::size_t>(lanes_.is_left(in));
      }
      if (count == 0) return;
      planes_.cut(count, [&](std::size_t in, int v) { return s.at(left[in], v); });
    });
    if (!s.moderate) return kGiveUp;
    return lanes_.is_left(lane) ? planes_.write(place_[lane], out)
                                : lanes_.write(shape_, lane, vertex, out);
  }

 private:
  const S& shape_;
  PlaneAfterPlane<typename M::Number, S, ClipLimits, CodePlane> planes_;
  LaneCutter lanes_;
  LaneQueue<kTriangleLanes> queue_;
  std::size_t place_[kTriangleLanes];  // of those that are left, among these
};

// Cuts from the three own vertices: distances and corners of several triangles at once.
template <class M, class S, class V>
class OriginalCuts {
 public:
  using Planes = std::array<CodePlane, kPlanes>;

  OriginalCuts(const S& shape, const ClipLimits&, const Planes& planes, DepthRange depth)
      : shape_(shape), planes_(planes), depth_(depth), ones_(planes) {}

  void begin(const Cuts& cuts) {
    ones_.begin(cuts);
    others_.begin(cuts.other);
  }

  template <class At>
  HWY_INLINE int cut_one(const Survivor<At>& s, const V* const vertex[3], V* out, Tally& tally) {
    const std::size_t place = ones_.next(s);
    if (!s.moderate) return kGiveUp;
    return way(tally).cut_one_plane(vertex, ones_.plane_of(s), ones_.splits(), place, out);
  }

  template <class At>
  HWY_NOINLINE int cut_several(const Survivor<At>& s, const V* const vertex[3], V* out,
                               Tally& tally) {
    const std::size_t lane = others_.next([&](std::span<const std::size_t> members) {
      corners_.cut(planes_, members.size(),
                   [&](std::size_t in, int v) { return s.at(members[in], v); });
    });
    // Without a plane that cuts there are vertices (0, 0, 0, 0).
    if (!s.moderate || (s.any() & kPlaneBits) == 0) return kGiveUp;
    return way(tally).cut_planes(vertex, corners_, lane, out);
  }

 private:
  static constexpr bool kCertain = M::promise.correctly_rounded;
  using Lanes = CornerLanes<kCertain, V, CodePlane>;

  FromOriginals<kCertain, S> way(Tally& tally) const { return {shape_, planes_, depth_, tally}; }

  const S& shape_;
  const Planes& planes_;
  const DepthRange depth_;
  SplitQueue<Splits<double, V>, CodePlane> ones_;
  Lanes corners_;
  LaneQueue<Lanes::kLanes> others_;
};

template <class M, int K, class V>
class Straddlers {
  static constexpr bool kIsChain = M::simd != Simd::originals;
  using S = Shape<K>;
  using Plane = PlaneOf<M>;

 public:
  using Limits = std::conditional_t<kIsView<M>, ViewLimits, ClipLimits>;

  Straddlers(DepthRange depth, int attributes)
      : shape{attributes},
        limits(depth),
        planes_(planes_in(depth)),
        cuts_(shape, limits, planes_, depth) {}
  Straddlers(const Frustum<float>& frustum, int attributes)
      : shape{attributes},
        limits(view_code_planes(frustum)),
        planes_(view_code_planes(frustum)),
        cuts_(shape, limits, planes_, frustum.depth) {}

  const S shape;
  const Limits limits;

  // To be called before the survivors of another block.
  void begin(const Survivors& survivors) { cuts_.begin(Cuts(survivors)); }

  // Cuts survivor i of a block; to be called for each that is not inside, in turn. at(i, v): where
  // a vertex of a survivor lies. Vertices written to `out`, or kGiveUp: then the plain version has
  // to do it.
  template <class At>
  HWY_INLINE int cut(const Survivors& survivors, std::size_t i, At& at, V* out, Tally& tally) {
    padded_.set(shape, [&](int v) { return at(i, v); });
    const Survivor<At> survivor{survivors, i, at, is_moderate(shape, padded_.vertex)};
    const bool one = is_one_plane(survivor.any());
    const int count = one ? cuts_.cut_one(survivor, padded_.vertex, out, tally)
                          : cuts_.cut_several(survivor, padded_.vertex, out, tally);
    if (HWY_LIKELY(count != kGiveUp)) {
      ++(one ? tally.one_plane : tally.planes);
    } else {
      ++(survivor.moderate && M::promise.correctly_rounded ? tally.exact : tally.plain);
    }
    return count;
  }

  // Those of the last triangle: whole vectors may be read.
  const V* const* vertices() const { return padded_.vertex; }

 private:
  static std::array<CodePlane, kPlanes> planes_in(DepthRange depth) {
    auto planes = code_planes(depth);
    // In the order of `kAllPlanes`.
    if (!kIsChain) std::rotate(planes.begin(), planes.begin() + 2, planes.end());
    return planes;
  }

  const std::array<Plane, kPlanes> planes_;  // in the order in which they cut
  Padded<S, V> padded_;
  std::conditional_t<M::simd == Simd::clip_lanes, LaneCuts<M, S>,
                     std::conditional_t<kIsChain, ChainCuts<M, S, V>, OriginalCuts<M, S, V>>>
      cuts_;
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
