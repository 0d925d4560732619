// SPDX-License-Identifier: MIT
//
// One straddling triangle, in SIMD over the coordinates and attributes of a vertex.
//
// Sutherland-Hodgman's polygon has one run of outside vertices per plane, so a bit mask names the
// edges to be met, and a list of numbers stands for the polygon: nothing is copied from plane to
// plane. Vertices carry their distances (spaces/measured.hpp). If rounding has made several runs
// all the same, the plain version takes over. A triangle cut by one plane has its order in a table;
// what that takes of distances comes from one_plane-inl.hpp.
#if defined(CLIPSCOPE_BATCH_CUT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_CUT_INL
#undef CLIPSCOPE_BATCH_CUT_INL
#else
#define CLIPSCOPE_BATCH_CUT_INL
#endif

#include <bit>
#include <span>

#include "spaces/batch/classify-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

// The floats of a vertex: 4 + K, or a number known at run time for K = kRunTime.
template <int K>
struct Shape {
  static constexpr bool kFixed = K != kRunTime;
  static constexpr std::size_t kMostFloats = kFixed ? 4 + K : 4 + kMaxAttributes;
  // Whole vectors: what a vertex occupies in scratch memory.
  static constexpr std::size_t kWidth = kMostFloats <= 4 ? 4 : (kMostFloats + 7) / 8 * 8;
  // Only then may a vector be loaded from the user's memory.
  static constexpr bool kLoadsInPlace = kFixed && kWidth == kMostFloats;

  int attributes = K;

  HWY_INLINE std::size_t floats() const {
    return kFixed ? kMostFloats : 4 + static_cast<std::size_t>(attributes);
  }
  HWY_INLINE std::size_t width() const { return kFixed ? kWidth : (floats() + 7) / 8 * 8; }
};

// Vectors of T over a vertex.
template <class T, class S>
using LanesOf = hn::CappedTag<T, S::kWidth <= 4 ? 4 : 8>;

// Floats or doubles of memory as a vector of T, and back; float to double is exact, double to float
// rounded.
template <class D, class From>
HWY_INLINE hn::Vec<D> load(D d, const From* p) {
  if constexpr (std::is_same_v<From, hn::TFromD<D>>) {
    return hn::LoadU(d, p);
  } else {
    return hn::PromoteTo(d, hn::LoadU(hn::Rebind<float, D>(), p));
  }
}
template <class D, class To>
HWY_INLINE void store(D d, hn::Vec<D> v, To* p) {
  if constexpr (std::is_same_v<To, hn::TFromD<D>>) {
    hn::StoreU(v, d, p);
  } else {
    const hn::Rebind<float, D> df;
    hn::StoreU(hn::DemoteTo(df, v), df, p);
  }
}

// Eight floats in one register, where there is one.
template <class D>
HWY_INLINE void store_eight(D d, hn::Vec<D4> low, hn::Vec<D4> high, float* out) {
  if constexpr (hn::MaxLanes(D()) == 8) {
    hn::StoreU(hn::Combine(d, high, low), d, out);
  } else {
    hn::StoreU(low, kD4, out);
    hn::StoreU(high, kD4, out + 4);
  }
}

// Whether all coordinates and attributes of three vertices are finite, and so far from the largest
// number that no difference or sum of two products with weights in [0, 1] overflows.
template <class S, class V>
HWY_INLINE bool is_moderate(const S& shape, const V* const v[3]) {
  const LanesOf<V, S> d;
  const auto most = hn::Set(d, std::numeric_limits<V>::max() / 4);
  bool ok = true;
  for (std::size_t i = 0; i < shape.width(); i += hn::Lanes(d)) {
    const auto sum =
        hn::Add(hn::Abs(hn::LoadU(d, v[0] + i)),
                hn::Add(hn::Abs(hn::LoadU(d, v[1] + i)), hn::Abs(hn::LoadU(d, v[2] + i))));
    ok = ok && hn::AllTrue(d, hn::Le(sum, most));
  }
  return ok;
}

// The signed distance in T of a vertex to a plane.
template <class T, class V>
HWY_INLINE T distance(const CodePlane& plane, const V* v) {
  return T(plane.w_weight) * T(v[3]) + T(plane.c_weight) * T(v[plane.axis]);
}
template <class T, class V>
HWY_INLINE T distance(const ViewCodePlane& plane, const V* v) {
  return T(plane.own) * T(v[plane.axis]) + T(plane.z_weight) * T(v[2]) + T(plane.constant);
}

// Lanes lane, lane + 1, … of a position, x y z w, and once more.
template <class D, class V>
HWY_INLINE hn::Vec<D> position_twice(D d, const V* v, std::size_t lane) {
  if constexpr (hn::MaxLanes(D()) == 8) {
    const auto p = load(hn::Half<D>(), v);
    return hn::Combine(d, p, p);
  } else {
    return load(d, v + lane % 4);
  }
}

// The signed distances in T of a vertex to the planes whose bits are lane, lane + 1, …, with the
// bits of `distance`.
template <class D, class V>
HWY_INLINE hn::Vec<D> distances(D d, const ClipLimits& limits, const V* v, std::size_t lane) {
  const auto w = hn::Set(d, static_cast<hn::TFromD<D>>(v[3]));
  return hn::Add(hn::Mul(load(d, limits.w_weight + lane), w),
                 hn::Mul(load(d, limits.c_weight + lane), position_twice(d, v, lane)));
}
template <class D, class V>
HWY_INLINE hn::Vec<D> distances(D d, const ViewLimits& limits, const V* v, std::size_t lane) {
  const auto z = hn::Set(d, static_cast<hn::TFromD<D>>(v[2]));
  const auto sum = hn::Add(hn::Mul(load(d, limits.own + lane), position_twice(d, v, lane)),
                           hn::Mul(load(d, limits.z_weight + lane), z));
  return hn::Add(sum, load(d, limits.constant + lane));
}

// A vertex to the output. Whole vectors may be written: what is behind is written later.
template <class S, class From, class To>
HWY_INLINE void copy_vertex(const S& shape, const From* v, To* out) {
  const LanesOf<From, S> d;
  for (std::size_t i = 0; i < shape.width(); i += hn::Lanes(d)) {
    store(d, hn::LoadU(d, v + i), out + i);
  }
}

// Floats that are whole vectors of d.
template <class D>
HWY_INLINE void copy_floats(D d, const float* from, std::size_t count, float* to) {
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    hn::StoreU(hn::LoadU(d, from + i), d, to + i);
  }
}

// Three vertices that lie one after the other.
template <class S>
HWY_INLINE void copy_triangle(const S& shape, const float* v, float* out) {
  if constexpr (S::kLoadsInPlace) {
    copy_floats(LanesOf<float, S>(), v, 3 * S::kWidth, out);
  } else {
    std::memcpy(out, v, 3 * shape.floats() * sizeof(float));
  }
}

// a + t (b - a) in T.
template <class T, class S, class From, class To>
HWY_INLINE void meet(const S& shape, const From* a, const From* b, T t, To* out) {
  const LanesOf<T, S> d;
  const auto vt = hn::Set(d, t);
  for (std::size_t i = 0; i < shape.width(); i += hn::Lanes(d)) {
    const auto va = load(d, a + i), vb = load(d, b + i);
    store(d, hn::Add(va, hn::Mul(vt, hn::Sub(vb, va))), out + i);
  }
}

inline constexpr int kGiveUp = -1;

// f(i) for each corner of a polygon, and for 0 to 3 always: most have three or four, and how many
// is not to be predicted.
template <class F>
HWY_INLINE void for_each_corner(int size, F&& f) {
  for (int i = 0; i < 4; ++i) f(i);
  for (int i = 4; i < size; ++i) f(i);
}

// A mask of the vertices outside a plane. The sign of a rounded sum is the exact one.
template <class T>
HWY_INLINE unsigned outside_mask(const T d[3]) {
  return static_cast<unsigned>(d[0] < 0) | static_cast<unsigned>(d[1] < 0) << 1 |
         static_cast<unsigned>(d[2] < 0) << 2;
}

// Where the edge that leaves the inside and the one that enters it meet the plane, from their ends
// nearer to it, with the bits of `from_nearer_end` (spaces/cut.hpp).
template <class T>
struct TwoCuts {
  // 0 to 2: a mask of the vertices outside; 3 and 4: whether the edges are cut from their ends
  // outside. 0 if a vertex lies on the plane: then nothing else is set.
  unsigned word;
  T leave, enter;
};

// A triangle that one plane cuts: the inside vertices in order, then the edge that leaves the
// inside and the one that enters it, each from one end towards the other.
struct OnePlane {
  std::uint8_t first, second;  // inside; `second` counts only if there are two
  std::uint8_t inside;         // how many
  std::uint8_t leave_from, leave_to, enter_from, enter_to;
};
// Indexed by TwoCuts::word.
inline constexpr std::array<OnePlane, 32> kOnePlane = [] {
  // Both edges from their ends inside, by the mask of outside vertices, 1 to 6.
  constexpr OnePlane kFromInside[7] = {{},
                                       {1, 2, 2, 2, 0, 1, 0},
                                       {2, 0, 2, 0, 1, 2, 1},
                                       {2, 2, 1, 2, 0, 2, 1},
                                       {0, 1, 2, 1, 2, 0, 2},
                                       {1, 1, 1, 1, 2, 1, 0},
                                       {0, 0, 1, 0, 1, 0, 2}};
  std::array<OnePlane, 32> r{};
  for (std::size_t word = 0; word < r.size(); ++word) {
    if (word % 8 == 7) continue;
    r[word] = kFromInside[word % 8];
    if ((word & 8) != 0) std::swap(r[word].leave_from, r[word].leave_to);
    if ((word & 16) != 0) std::swap(r[word].enter_from, r[word].enter_to);
  }
  return r;
}();

// A triangle that one plane cuts: vertices written to `out`, or kGiveUp.
template <class T, class S, class V, class To>
HWY_INLINE int cut_one_plane(const S& shape, const V* const vertex[3], const TwoCuts<T>& cuts,
                             To* out) {
  if (cuts.word == 0) return kGiveUp;  // a vertex on the plane
  const OnePlane& order = kOnePlane[cuts.word];
  const std::size_t stride = shape.floats();
  copy_vertex(shape, vertex[order.first], out);
  copy_vertex(shape, vertex[order.second], out + stride);
  To* cut = out + order.inside * stride;
  meet<T>(shape, vertex[order.leave_from], vertex[order.leave_to], cuts.leave, cut);
  const To w = cut[3];
  meet<T>(shape, vertex[order.enter_from], vertex[order.enter_to], cuts.enter, cut + stride);
  return w > 0 && cut[stride + 3] > 0 ? order.inside + 2 : kGiveUp;
}

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
