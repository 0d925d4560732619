// SPDX-License-Identifier: MIT
//
// Triangles that one plane cuts: what their new vertices take but the vertices themselves, of as
// many at once as a register has lanes.
//
// Such a triangle has one vertex, the apex, alone on its side: both edges that are cut meet there.
// Which one it is shows in the signs of three distances, and is chosen without a branch, which would
// be mispredicted two times in three.
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

// How planes split some triangles of vertices of V, in T.
template <class T, class V>
class Splits {
 public:
  static constexpr std::size_t kMost = 32;

  void clear() { count_ = 0; }

  // One more; value(v, c): coordinate c of vertex v.
  template <class F>
  HWY_INLINE void add(const CodePlane& plane, F&& value) {
    for (int v = 0; v < 3; ++v) {
      of_w_[v][count_] = plane.w_weight * value(v, 3);
      of_c_[v][count_] = plane.c_weight * value(v, plane.axis);
    }
    ++count_;
  }

  // After the last.
  HWY_INLINE void compute() {
    for (std::size_t i = 0; i < count_; i += hn::Lanes(kD)) compute(i);
  }

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
  using D = hn::CappedTag<T, 8>;
  using DU = hn::RebindToUnsigned<D>;
  using Word = hn::TFromD<DU>;
  static constexpr D kD{};
  HWY_INLINE void compute(std::size_t i) {
    hn::Vec<D> d[3];
    hn::Mask<D> out[3];
    for (int v = 0; v < 3; ++v) {
      d[v] = hn::Add(load(kD, of_w_[v] + i), load(kD, of_c_[v] + i));
      out[v] = hn::Lt(d[v], hn::Zero(kD));
    }
    // The apex is the vertex whose two others are on one side.
    const auto same = [&](int a, int b) { return hn::Not(hn::Xor(out[a], out[b])); };
    const auto is_0 = same(1, 2), is_1 = hn::AndNot(is_0, same(0, 2));
    const auto choose = [&](int of_0, int of_1, int of_2) {
      return hn::Abs(hn::IfThenElse(is_0, d[of_0], hn::IfThenElse(is_1, d[of_1], d[of_2])));
    };
    const auto apex = choose(0, 1, 2), b = choose(1, 2, 0), c = choose(2, 0, 1);
    const auto one = hn::Set(kD, T(1));
    hn::Store(apex, kD, apex_ + i);
    hn::Store(b, kD, b_ + i);
    hn::Store(c, kD, c_ + i);
    hn::Store(hn::Div(one, hn::Add(apex, b)), kD, over_b_ + i);
    hn::Store(hn::Div(one, hn::Add(apex, c)), kD, over_c_ + i);
    const DU du;
    const auto bit = [&](int v) {
      return hn::IfThenElseZero(hn::RebindMask(du, out[v]), hn::Set(du, Word{1} << v));
    };
    const auto on_plane = hn::Eq(hn::Min(apex, hn::Min(b, c)), hn::Zero(kD));
    const auto outside = hn::Or(bit(0), hn::Or(bit(1), bit(2)));
    hn::Store(hn::IfThenZeroElse(hn::RebindMask(du, on_plane), outside), du, outside_ + i);
  }

  std::size_t count_ = 0;
  // Terms of the distances; beyond the count whatever was there before.
  HWY_ALIGN V of_w_[3][kMost] = {}, of_c_[3][kMost] = {};
  HWY_ALIGN T apex_[kMost], b_[kMost], c_[kMost], over_b_[kMost], over_c_[kMost];
  HWY_ALIGN Word outside_[kMost];
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
