// SPDX-License-Identifier: MIT
//
// As many straddling triangles at once as a register has lanes, four or eight: McGuire's cases in
// SIMD.
//
// A register holds one coordinate of one vertex of every triangle. Where a case moves vertices,
// lanes are blended, so that triangles of different cases go the same way: a cycle of the vertices
// brings the first one inside after one outside to the front, and two edges are cut. Triangles and
// quadrilaterals are cut so, plane after plane. Of new vertices it is noted between which two they
// lie, and at which t; whole vertices with attributes are made of that one triangle at a time, as
// cut-inl.hpp makes them. A polygon of five vertices that is to be cut again, a vertex on a plane
// and more than one run of outside vertices are left to cut-inl.hpp.
// Source: McGuire, "Efficient Triangle and Quadrilateral Clipping within Shaders", Journal of
// Graphics, GPU, and Game Tools 15(4), 2011, whose lanes are a processor's threads.
// Guarantees: the bits of homogeneous/mcguire, before its divide.
#if defined(CLIPSCOPE_BATCH_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_LANES_INL
#undef CLIPSCOPE_BATCH_LANES_INL
#else
#define CLIPSCOPE_BATCH_LANES_INL
#endif

#include "spaces/batch/cut-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

inline constexpr std::size_t kTriangleLanes = hn::MaxLanes(D8());

// Cuts the positions of a group of triangles and notes what became of each.
class LaneCutter {
 public:
  explicit LaneCutter(const std::array<CodePlane, kPlanes>& planes) : planes_(planes) {}

  // To be called before the survivors of another block.
  void forget() { filled_ = next_ = 0; }

  // The lane of survivor `at` of a block that has `count`, after its group was cut. To be called
  // for each survivor that needs(at) in turn. position(at, lane, v): where x y z w of vertex v of a
  // survivor lie.
  template <class Needs, class F>
  HWY_INLINE std::size_t lane_of(std::size_t at, std::size_t count, Needs&& needs, F&& position) {
    if (next_ == filled_) {
      std::size_t members[kTriangleLanes];
      filled_ = next_ = 0;
      for (; at < count && filled_ < kTriangleLanes; ++at) {
        if (needs(at)) members[filled_++] = at;
      }
      cut(filled_, [&](std::size_t lane, int v) { return position(members[lane], lane, v); });
    }
    return next_++;
  }

  // The position of a vertex of triangle t as it lies elsewhere, for position(at, lane, v).
  HWY_INLINE const float* hold(const TriangleStreams& in, std::size_t t, std::size_t lane, int v) {
    float* const to = held_[v][lane];
    for (std::size_t c = 0; c < 4; ++c) to[c] = in.positions[v][c][t];
    return to;
  }

  // The polygon of a lane, whose triangle this is: vertices written to `out`, or kGiveUp.
  template <class S>
  int write(const S& shape, std::size_t lane, const float* const vertex[3], float* out) const {
    if ((given_up_bits_ >> lane & 1) != 0) return kGiveUp;
    HWY_ALIGN float pool[2 * kPlanes][S::kWidth];
    const float* at[3 + 2 * kPlanes] = {vertex[0], vertex[1], vertex[2]};
    for (int p = 0; p < kPlanes; ++p) {
      if ((cut_bits_[p] >> lane & 1) == 0) continue;
      for (int i = 0; i < 2; ++i) {
        const NewVertex& made = made_[p][i];
        float* const to = pool[2 * p + i];
        meet<float>(shape, at[static_cast<int>(made.inside[lane])],
                    at[static_cast<int>(made.outside[lane])], made.t[lane], to);
        at[3 + 2 * p + i] = to;
      }
    }
    int kept = 0;
    for (int i = 0; i < static_cast<int>(sizes_[lane]); ++i) {
      const float* v = at[static_cast<int>(numbers_[i][lane])];
      if (v[3] > 0) copy_vertex(shape, v, out + kept++ * shape.floats());
    }
    return kept < 3 ? 0 : kept;
  }

 private:
  using V = hn::Vec<D8>;
  using M = hn::Mask<D8>;

  static constexpr int kSlots = 5;

  // A vertex of every triangle: coordinates, and its number: 0 to 2 are the original ones,
  // 3 + 2 p and 4 + 2 p those where the edges leave the inside of plane p and enter it. Its
  // constructor is written out, since GCC compiles implicit ones for no target.
  struct Corner {
    HWY_INLINE Corner() {}
    HWY_INLINE Corner(V x, V y, V z, V w, V n) : c{x, y, z, w}, number(n) {}

    V c[4];
    V number;
  };
  struct NewVertex {
    HWY_ALIGN float inside[8], outside[8], t[8];
  };

  static HWY_INLINE Corner either(M mask, const Corner& yes, const Corner& no) {
    Corner r;
    for (int i = 0; i < 4; ++i) r.c[i] = hn::IfThenElse(mask, yes.c[i], no.c[i]);
    r.number = hn::IfThenElse(mask, yes.number, no.number);
    return r;
  }

  template <class F>
  HWY_NOINLINE void cut(std::size_t count, F&& position) {
    static constexpr float kNothing[4] = {0, 0, 0, 0};
    for (int v = 0; v < 3; ++v) {
      const auto p = load_positions_at(
          kD8, [&](std::size_t lane) { return lane < count ? position(lane, v) : kNothing; });
      original_[v] = slots_[v] = {p.x, p.y, p.z, p.w, hn::Set(kD8, static_cast<float>(v))};
    }
    slots_[3] = slots_[4] = slots_[0];
    size_ = hn::Set(kD8, 3.0f);
    given_up_ = none();
    for (int p = 0; p < kPlanes; ++p) cut_by(p);
    for (int i = 0; i < kSlots; ++i) hn::Store(slots_[i].number, kD8, numbers_[i]);
    hn::Store(size_, kD8, sizes_);
    given_up_bits_ = mask_bits(kD8, given_up_);
  }

  static HWY_INLINE V distance(const CodePlane& plane, const Corner& v) {
    return hn::Add(hn::Mul(hn::Set(kD8, plane.w_weight), v.c[3]),
                   hn::Mul(hn::Set(kD8, plane.c_weight), v.c[plane.axis]));
  }
  static HWY_INLINE M none() { return hn::FirstN(kD8, 0); }
  static HWY_INLINE M is_negative(V d) { return hn::Lt(d, hn::Zero(kD8)); }
  static HWY_INLINE M is_outside(const CodePlane& plane, const Corner& v) {
    return is_negative(distance(plane, v));
  }
  HWY_INLINE M has_size(int size) const {
    return hn::Eq(size_, hn::Set(kD8, static_cast<float>(size)));
  }

  HWY_INLINE void cut_by(int p) {
    const CodePlane& plane = planes_[p];
    M crossed = is_outside(plane, original_[0]);
    for (int v = 1; v < 3; ++v) crossed = hn::Or(crossed, is_outside(plane, original_[v]));
    crossed = hn::AndNot(given_up_, crossed);
    cut_bits_[p] = 0;
    if (hn::AllFalse(kD8, crossed)) return;
    const M three = hn::And(crossed, has_size(3)), four = hn::And(crossed, has_size(4)),
            five = hn::And(crossed, has_size(5));
    if (!hn::AllFalse(kD8, five)) leave_five(plane, five);
    if (!hn::AllFalse(kD8, three)) clip<3>(p, three);
    if (!hn::AllFalse(kD8, four)) clip<4>(p, four);
  }

  HWY_INLINE void leave_five(const CodePlane& plane, M five) {
    M outside = is_outside(plane, slots_[0]);
    for (int i = 1; i < 5; ++i) outside = hn::Or(outside, is_outside(plane, slots_[i]));
    given_up_ = hn::Or(given_up_, hn::And(five, outside));
  }

  // Triangles or quadrilaterals, those of the mask.
  template <int kSize>
  HWY_INLINE void clip(int p, M mask) {
    Corner v[kSize];
    V d[kSize];
    M every = mask, some = none(), on_plane = some;
    for (int i = 0; i < kSize; ++i) {
      v[i] = slots_[i];
      d[i] = distance(planes_[p], v[i]);
      every = hn::And(every, is_negative(d[i]));
      some = hn::Or(some, is_negative(d[i]));
      on_plane = hn::Or(on_plane, hn::Eq(d[i], hn::Zero(kD8)));
    }
    size_ = hn::IfThenZeroElse(every, size_);
    M active = hn::AndNot(every, hn::And(mask, some));
    given_up_ = hn::Or(given_up_, hn::And(active, on_plane));
    cycle(v, d);
    const auto above = [&](int i) { return hn::Gt(d[i], hn::Zero(kD8)); };
    M torn = above(kSize - 1);  // more than one run
    if constexpr (kSize == 4) torn = hn::Or(torn, hn::AndNot(above(1), above(2)));
    given_up_ = hn::Or(given_up_, hn::And(active, torn));
    active = hn::AndNot(given_up_, active);
    if (hn::AllFalse(kD8, active)) return;
    write_case(p, active, v, d, above(1));
  }

  // Brings the first vertex inside after one outside to the front.
  template <int kSize>
  static HWY_INLINE void cycle(Corner (&v)[kSize], V (&d)[kSize]) {
    Corner from_v[kSize];
    V from_d[kSize];
    for (int i = 0; i < kSize; ++i) {
      from_v[i] = v[i];
      from_d[i] = d[i];
    }
    for (int first = 1; first < kSize; ++first) {
      const M comes_first = hn::AndNot(is_negative(from_d[first]), is_negative(from_d[first - 1]));
      for (int i = 0; i < kSize; ++i) {
        v[i] = either(comes_first, from_v[(i + first) % kSize], v[i]);
        d[i] = hn::IfThenElse(comes_first, from_d[(i + first) % kSize], d[i]);
      }
    }
  }

  // The edge from v0 back to the last vertex is always cut, and one other.
  template <int kSize>
  HWY_INLINE void write_case(int p, M active, const Corner (&v)[kSize], const V (&d)[kSize],
                             M second) {
    const M third = kSize == 4 ? hn::And(second, hn::Gt(d[2], hn::Zero(kD8))) : none();
    Corner in = either(second, v[1], v[0]), out = either(second, v[2], v[1]);
    V d_in = hn::IfThenElse(second, d[1], d[0]), d_out = hn::IfThenElse(second, d[2], d[1]);
    if constexpr (kSize == 4) {
      in = either(third, v[2], in);
      out = either(third, v[3], out);
      d_in = hn::IfThenElse(third, d[2], d_in);
      d_out = hn::IfThenElse(third, d[3], d_out);
    }
    const Corner leave = meet_at(active, in, out, d_in, d_out, p, 0);
    const Corner enter = meet_at(active, v[0], v[kSize - 1], d[0], d[kSize - 1], p, 1);
    cut_bits_[p] |= mask_bits(kD8, active);
    slots_[0] = either(active, v[0], slots_[0]);
    slots_[1] = either(active, either(second, v[1], leave), slots_[1]);
    slots_[2] = either(active, either(second, either(third, v[2], leave), enter), slots_[2]);
    slots_[3] = either(active, either(third, leave, enter), slots_[3]);
    slots_[4] = either(active, enter, slots_[4]);
    const V size = hn::IfThenElse(third, hn::Set(kD8, 5.0f),
                                  hn::IfThenElse(second, hn::Set(kD8, 4.0f), hn::Set(kD8, 3.0f)));
    size_ = hn::IfThenElse(active, size, size_);
  }

  // in + t (out - in), noted in the lanes of the mask as new vertex i of plane p.
  HWY_INLINE Corner meet_at(M mask, const Corner& in, const Corner& out, V d_in, V d_out, int p,
                            int i) {
    const V t = hn::Div(d_in, hn::Sub(d_in, d_out));
    Corner r;
    for (int c = 0; c < 4; ++c) r.c[c] = hn::Add(in.c[c], hn::Mul(t, hn::Sub(out.c[c], in.c[c])));
    r.number = hn::Set(kD8, static_cast<float>(3 + 2 * p + i));
    hn::BlendedStore(in.number, mask, kD8, made_[p][i].inside);
    hn::BlendedStore(out.number, mask, kD8, made_[p][i].outside);
    hn::BlendedStore(t, mask, kD8, made_[p][i].t);
    return r;
  }

  const std::array<CodePlane, kPlanes>& planes_;
  Corner original_[3], slots_[kSlots];
  V size_;
  M given_up_;
  NewVertex made_[kPlanes][2];
  unsigned cut_bits_[kPlanes] = {};
  HWY_ALIGN float numbers_[kSlots][8];
  HWY_ALIGN float sizes_[8];
  unsigned given_up_bits_ = 0;
  std::size_t filled_ = 0, next_ = 0;  // lanes of the group: those in use, those handed out
  HWY_ALIGN float held_[3][8][4];
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
