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

// The signed distances in T of a vertex to the planes whose bits are lane, lane + 1, …, with the
// bits of `distance`.
template <class D, class V>
HWY_INLINE hn::Vec<D> distances(D d, const ClipLimits& limits, const V* v, std::size_t lane) {
  const auto w = hn::Set(d, static_cast<hn::TFromD<D>>(v[3]));
  return hn::Add(hn::Mul(load(d, limits.w_weight + lane), w),
                 hn::Mul(load(d, limits.c_weight + lane), load(d, v + lane % 4)));
}
template <class D, class V>
HWY_INLINE hn::Vec<D> distances(D d, const ViewLimits& limits, const V* v, std::size_t lane) {
  const auto z = hn::Set(d, static_cast<hn::TFromD<D>>(v[2]));
  const auto sum = hn::Add(hn::Mul(load(d, limits.own + lane), load(d, v + lane % 4)),
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

// Where an edge meets a plane: at `t` from the end nearer to it, with the bits of `from_nearer_end`
// (spaces/cut.hpp). Pre-condition: d_in > 0 > d_out.
template <class T>
class EdgeCut {
 public:
  HWY_INLINE EdgeCut(T d_in, T d_out)
      : d_in_(d_in), beyond_(-d_out), t_(std::min(d_in, -d_out) / (d_in - d_out)) {}

  // Both ends are loaded and then blended: which is nearer can't be predicted, and pointers that
  // wait for it would make the loads wait.
  template <class D, class From, class To>
  HWY_INLINE void meet(D d, std::size_t count, const From* in, const From* out, To* to) const {
    const auto is_outside = hn::Lt(hn::Set(d, beyond_), hn::Set(d, d_in_));
    const auto vt = hn::Set(d, t_);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
      const auto v_in = load(d, in + i), v_out = load(d, out + i);
      const auto a = hn::IfThenElse(is_outside, v_out, v_in),
                 b = hn::IfThenElse(is_outside, v_in, v_out);
      store(d, hn::Add(a, hn::Mul(vt, hn::Sub(b, a))), to + i);
    }
  }

 private:
  T d_in_, beyond_, t_;
};

inline constexpr int kGiveUp = -1;

// A convex polygon's vertices as numbers in a pool, four bits each: kept in a register, where it is
// rotated without a loop. Beyond the size there are zeros.
struct List {
  std::uint64_t packed;
  int size;

  HWY_INLINE int at(int i) const { return static_cast<int>(packed >> (4 * i) & 15); }
  HWY_INLINE void add(int number) { packed |= static_cast<std::uint64_t>(number) << (4 * size++); }
  HWY_INLINE List first(int count) const {
    return {packed & ((std::uint64_t{1} << (4 * count)) - 1), count};
  }
  // The same polygon, from a place on.
  HWY_INLINE List from(int place) const {
    return List{packed >> (4 * place) | packed << (4 * (size - place)), size}.first(size);
  }
};
inline constexpr List kTriangle = {0x210, 3};
static_assert(3 + 2 * kPlanes <= 16);  // numbers in a pool

// f(i) for each place of a list, and for 0 to 3 always: most lists have three or four vertices, and
// how many is not to be predicted.
template <class F>
HWY_INLINE void for_each_place(const List& list, F&& f) {
  for (int i = 0; i < 4; ++i) f(i);
  for (int i = 4; i < list.size; ++i) f(i);
}

// The places in a list where it leaves the inside of a plane and enters it again.
struct Crossing {
  bool is_one_run;  // else rounding has made several runs of outside vertices: nothing else is set
  int last_in, first_out, last_out, first_in;
};

// outside: a mask of the places, neither empty nor full.
HWY_INLINE Crossing find_crossing(unsigned outside, int size) {
  const unsigned starts = outside & ~(outside << 1 | outside >> (size - 1));
  if ((starts & (starts - 1)) != 0) return {};
  const int first_out = std::countr_zero(starts), length = std::popcount(outside);
  const auto wrap = [size](int i) { return i - (size & -static_cast<int>(i >= size)); };
  return {true, wrap(first_out + size - 1), first_out, wrap(first_out + length - 1),
          wrap(first_out + length)};
}

// The inside vertices of a list, in order.
HWY_INLINE List inside_run(const List& list, unsigned outside, const Crossing& crossing) {
  return list.from(crossing.first_in).first(list.size - std::popcount(outside));
}

// Cuts a list by a plane; outside: a mask of the places. add(crossing, list) appends what takes the
// place of those outside. Whether they were one run.
template <class F>
HWY_INLINE bool cut_list(unsigned outside, List& list, F&& add) {
  if (outside == 0) return true;
  if (outside == (1u << list.size) - 1) {
    list = {};
    return true;
  }
  const Crossing crossing = find_crossing(outside, list.size);
  if (!crossing.is_one_run) return false;
  List r = inside_run(list, outside, crossing);
  add(crossing, r);
  list = r;
  return true;
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

// Sutherland-Hodgman in T, float or double, of vertices of V in a space with its limits and planes.
// Both functions write the polygon to `out` and return how many vertices it has, or kGiveUp.
template <class T, class S, class Limits, class Plane>
struct Chain {
  const S& shape;
  const Limits& limits;
  const std::array<Plane, kPlanes>& planes;

  // A triangle that one plane cuts.
  template <class V, class To>
  HWY_INLINE int cut_one_plane(const V* const vertex[3], const TwoCuts<T>& cuts, To* out) const {
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

  // any: the bits that some vertex has.
  template <class V, class To>
  HWY_INLINE int cut_planes(const V* const vertex[3], unsigned any, To* out) const {
    Pool pool;
    for (int i = 0; i < 3; ++i) {
      load_vertex(vertex[i], pool.vertex[i]);
      measure(vertex[i], pool.distance[i]);
    }
    List list = kTriangle;
    const Plane* cutting[kPlanes];
    std::size_t count = 0;  // found without a branch
    for (const Plane& plane : planes) {
      cutting[count] = &plane;
      count += any >> plane.bit & 1;
    }
    for (const Plane* plane : std::span(cutting, count)) {
      if (!cut(*plane, pool, list)) return kGiveUp;
    }
    if (list.size < 3) return 0;
    int kept = 0;
    for (int i = 0; i < list.size; ++i) {
      const T* v = pool.vertex[list.at(i)];
      if (!(v[3] > 0)) continue;
      copy_vertex(shape, v, out + kept++ * shape.floats());
    }
    return kept < 3 ? 0 : kept;
  }

 private:
  // Distances have their planes' bits as places.
  struct Pool {
    HWY_ALIGN T vertex[3 + 2 * kPlanes][S::kWidth];
    HWY_ALIGN T distance[3 + 2 * kPlanes][8];
    int size = 3;
  };
  using D = hn::CappedTag<T, 4>;

  template <class V>
  HWY_INLINE void load_vertex(const V* v, T* out) const {
    const LanesOf<T, S> d;
    for (std::size_t i = 0; i < shape.width(); i += hn::Lanes(d)) {
      hn::Store(load(d, v + i), d, out + i);
    }
  }

  template <class V>
  HWY_INLINE void measure(const V* v, T* out) const {
    const D d;
    for (std::size_t i = 0; i < 8; i += hn::Lanes(d)) {
      hn::Store(distances(d, limits, v, i), d, out + i);
    }
  }

  // Whether the outside vertices were one run.
  bool cut(const Plane& plane, Pool& pool, List& list) const {
    unsigned outside = 0;
    for_each_place(list, [&](int i) {
      outside |= static_cast<unsigned>(pool.distance[list.at(i)][plane.bit] < 0) << i;
    });
    outside &= (1u << list.size) - 1;
    return cut_list(outside, list, [&](const Crossing& c, List& r) {
      add_cut(plane, list.at(c.last_in), list.at(c.first_out), pool, r);
      add_cut(plane, list.at(c.first_in), list.at(c.last_out), pool, r);
    });
  }

  // The edge's meeting with the plane, unless its inside end lies on it.
  HWY_INLINE void add_cut(const Plane& plane, int in, int out, Pool& pool, List& list) const {
    const T d_in = pool.distance[in][plane.bit];
    if (d_in == 0) return;
    const EdgeCut<T> cut(d_in, pool.distance[out][plane.bit]);
    cut.meet(LanesOf<T, S>(), shape.width(), pool.vertex[in], pool.vertex[out],
             pool.vertex[pool.size]);
    cut.meet(D(), 8, pool.distance[in], pool.distance[out], pool.distance[pool.size]);
    list.add(pool.size++);
  }
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
