// SPDX-License-Identifier: MIT
//
// Triangles that one plane cuts: what their new vertices take but the vertices themselves, of as
// many at once as a register has lanes.
//
// Such a triangle has one vertex, the apex, alone on its side: both edges that are cut meet there.
// Which one it is shows in the signs of three distances, and is chosen without a branch, which
// would be mispredicted two times in three.
#if defined(CLIPSCOPE_BATCH_ONE_PLANE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_ONE_PLANE_INL
#undef CLIPSCOPE_BATCH_ONE_PLANE_INL
#else
#define CLIPSCOPE_BATCH_ONE_PLANE_INL
#endif

#include "spaces/batch/cut-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

// Polygon: apex, cut of apex-b, cut of apex-c if the apex is inside, else b, c, cut of apex-c, cut
// of apex-b.
struct Apex {
  std::uint8_t apex, b, c;
  std::uint8_t first;       // vertex of the polygon
  std::uint8_t place_of_b;  // in the polygon: the cut of apex-b; that of apex-c is the third vertex
  std::uint8_t size;        // of the polygon
};
// Indexed by the mask of outside vertices, 1 to 6.
inline constexpr Apex kApex[7] = {{},
                                  {0, 1, 2, 1, 3, 4},
                                  {1, 2, 0, 2, 3, 4},
                                  {2, 0, 1, 2, 1, 3},
                                  {2, 0, 1, 0, 3, 4},
                                  {1, 2, 0, 1, 1, 3},
                                  {0, 1, 2, 0, 1, 3}};

// As many triangles as are cut at once, each by a plane of its own.
inline constexpr std::size_t kMostSplits = 32;

// The distances in T of some triangles, of vertices of V, from their planes.
// Own::compute_at(i) makes of those of triangles i, i + 1, … what the method wants.
template <class Own, class T, class V>
class PlaneDistances {
 public:
  using D = hn::CappedTag<T, 8>;
  using DU = hn::RebindToUnsigned<D>;
  static constexpr D kD{};

  void clear() { count_ = 0; }

  // One more; value(v, c): coordinate c of vertex v.
  template <class F>
  HWY_INLINE void add(const CodePlane& plane, F&& value) {
    for (int v = 0; v < 3; ++v) {
      a_[v][count_] = plane.w_weight * value(v, 3);
      b_[v][count_] = plane.c_weight * value(v, plane.axis);
    }
    ++count_;
  }
  template <class F>
  HWY_INLINE void add(const ViewCodePlane& plane, F&& value) {
    for (int v = 0; v < 3; ++v) {
      a_[v][count_] = plane.own * value(v, plane.axis) + plane.z_weight * value(v, 2);
      b_[v][count_] = plane.constant;
    }
    ++count_;
  }

  // After the last.
  HWY_INLINE void compute() {
    for (std::size_t i = 0; i < count_; i += hn::Lanes(kD)) static_cast<Own*>(this)->compute_at(i);
  }

 protected:
  // That of vertex v in triangles i, i + 1, …
  HWY_INLINE hn::Vec<D> at(int v, std::size_t i) const {
    return hn::Add(load(kD, a_[v] + i), load(kD, b_[v] + i));
  }

 private:
  std::size_t count_ = 0;
  // Terms of the distances; beyond the count whatever was there before.
  HWY_ALIGN V a_[3][kMostSplits] = {}, b_[3][kMostSplits] = {};
};

// Which of three vertices are outside by their distances, and which of them is the apex.
template <class D>
struct Sides {
  hn::Mask<D> outside[3], on_plane, apex_is_0, apex_is_1;

  HWY_INLINE explicit Sides(const hn::Vec<D> (&d)[3]) {
    for (int v = 0; v < 3; ++v) outside[v] = hn::Lt(d[v], hn::Zero(D()));
    const auto is_on = [&](int v) { return hn::Eq(d[v], hn::Zero(D())); };
    on_plane = hn::Or(is_on(0), hn::Or(is_on(1), is_on(2)));
    const auto same = [&](int a, int b) { return hn::Not(hn::Xor(outside[a], outside[b])); };
    apex_is_0 = same(1, 2);
    apex_is_1 = hn::AndNot(apex_is_0, same(0, 2));
  }

  // By the apex.
  HWY_INLINE hn::Vec<D> choose(hn::Vec<D> of_0, hn::Vec<D> of_1, hn::Vec<D> of_2) const {
    return hn::IfThenElse(apex_is_0, of_0, hn::IfThenElse(apex_is_1, of_1, of_2));
  }
  HWY_INLINE hn::Vec<D> apex(const hn::Vec<D> (&d)[3]) const { return choose(d[0], d[1], d[2]); }
  HWY_INLINE hn::Vec<D> b(const hn::Vec<D> (&d)[3]) const { return choose(d[1], d[2], d[0]); }
  HWY_INLINE hn::Vec<D> c(const hn::Vec<D> (&d)[3]) const { return choose(d[2], d[0], d[1]); }
};

// Masks as the bits of a word in each lane, the first one lowest; 0 where a vertex lies on the
// plane.
template <class D, std::size_t N>
HWY_INLINE hn::Vec<hn::RebindToUnsigned<D>> words(const Sides<D>& sides,
                                                  const hn::Mask<D> (&masks)[N]) {
  const hn::RebindToUnsigned<D> du;
  auto r = hn::Zero(du);
  for (std::size_t i = 0; i < N; ++i) {
    const auto bit = hn::Set(du, hn::TFromD<decltype(du)>{1} << i);
    r = hn::Or(r, hn::IfThenElseZero(hn::RebindMask(du, masks[i]), bit));
  }
  return hn::IfThenZeroElse(hn::RebindMask(du, sides.on_plane), r);
}

// How planes split some triangles of vertices of V, in T.
template <class T, class V>
class Splits : public PlaneDistances<Splits<T, V>, T, V> {
  using Base = PlaneDistances<Splits, T, V>;
  using D = typename Base::D;
  using DU = typename Base::DU;
  using Base::kD;

 public:
  // Of a triangle, in the order in which they were added: a mask of the vertices that are outside,
  // 0 if one lies on the plane: then nothing else holds.
  HWY_INLINE unsigned outside(std::size_t i) const { return static_cast<unsigned>(outside_[i]); }
  // The magnitudes of the distances of the apex, of b and of c.
  HWY_INLINE const T& apex(std::size_t i) const { return apex_[i]; }
  HWY_INLINE const T& b(std::size_t i) const { return b_[i]; }
  HWY_INLINE const T& c(std::size_t i) const { return c_[i]; }
  // One over those of b and of c from the apex.
  HWY_INLINE const T& over_b(std::size_t i) const { return over_b_[i]; }
  HWY_INLINE const T& over_c(std::size_t i) const { return over_c_[i]; }

 private:
  friend Base;

  HWY_INLINE void compute_at(std::size_t i) {
    const hn::Vec<D> d[3] = {this->at(0, i), this->at(1, i), this->at(2, i)};
    const Sides<D> sides(d);
    const auto apex = hn::Abs(sides.apex(d)), b = hn::Abs(sides.b(d)), c = hn::Abs(sides.c(d));
    const auto one = hn::Set(kD, T(1));
    hn::Store(apex, kD, apex_ + i);
    hn::Store(b, kD, b_ + i);
    hn::Store(c, kD, c_ + i);
    hn::Store(hn::Div(one, hn::Add(apex, b)), kD, over_b_ + i);
    hn::Store(hn::Div(one, hn::Add(apex, c)), kD, over_c_ + i);
    hn::Store(words(sides, sides.outside), DU(), outside_ + i);
  }

  HWY_ALIGN T apex_[kMostSplits], b_[kMostSplits], c_[kMostSplits], over_b_[kMostSplits],
      over_c_[kMostSplits];
  HWY_ALIGN hn::TFromD<DU> outside_[kMostSplits];
};

// The cuts of some triangles' edges.
template <class T, class V>
class EdgeSplits : public PlaneDistances<EdgeSplits<T, V>, T, V> {
  using Base = PlaneDistances<EdgeSplits, T, V>;
  using D = typename Base::D;
  using DU = typename Base::DU;
  using Base::kD;

 public:
  HWY_INLINE TwoCuts<T> operator[](std::size_t i) const {
    return {static_cast<unsigned>(word_[i]), leave_[i], enter_[i]};
  }

 private:
  friend Base;

  // The edge that leaves the inside is apex-c if the apex is outside, else apex-b.
  HWY_INLINE void compute_at(std::size_t i) {
    const hn::Vec<D> d[3] = {this->at(0, i), this->at(1, i), this->at(2, i)};
    const Sides<D> sides(d);
    const auto apex = sides.apex(d), b = sides.b(d), c = sides.c(d);
    const auto is_out = hn::Lt(apex, hn::Zero(kD));
    const auto of_leave = hn::IfThenElse(is_out, c, b), of_enter = hn::IfThenElse(is_out, b, c);
    // beyond < d_in, of numbers of which one is negative: their sum, whose sign is exact, is not.
    const auto zero = hn::Zero(kD);
    const hn::Mask<D> masks[] = {sides.outside[0], sides.outside[1], sides.outside[2],
                                 hn::Lt(zero, hn::Add(apex, of_leave)),
                                 hn::Lt(zero, hn::Add(apex, of_enter))};
    const auto t = [&](hn::Vec<D> other) {
      const auto x = hn::Abs(apex), y = hn::Abs(other);
      return hn::Div(hn::Min(x, y), hn::Add(x, y));
    };
    hn::Store(t(of_leave), kD, leave_ + i);
    hn::Store(t(of_enter), kD, enter_ + i);
    hn::Store(words(sides, masks), DU(), word_ + i);
  }

  HWY_ALIGN T leave_[kMostSplits], enter_[kMostSplits];
  HWY_ALIGN hn::TFromD<DU> word_[kMostSplits];
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
