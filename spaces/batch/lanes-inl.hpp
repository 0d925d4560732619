// SPDX-License-Identifier: MIT
//
// As many straddling triangles at once as a register has lanes, four or eight: McGuire's cases in
// SIMD.
//
// A register holds the distance to one plane of one vertex of every triangle: all decisions are
// taken on these. Where a case moves vertices, lanes are blended, so that triangles of different
// cases go the same way: a cycle of the vertices brings the first one inside after one outside to
// the front, and two edges are cut. Triangles and quadrilaterals are cut so, plane after plane. Of
// new vertices it is noted between which two they lie, and at which t; vertices with coordinates
// and attributes are made of that one triangle at a time, as cut-inl.hpp makes them. A polygon of
// five vertices that is to be cut again, a vertex on a plane and more than one run of outside
// vertices are left to planes-inl.hpp.
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

// Cuts a group of triangles and notes what became of each.
class LaneCutter {
 public:
  explicit LaneCutter(const std::array<CodePlane, kPlanes>& planes) : planes_(planes) {}

  // Cuts so many triangles. position(lane, v): where x y z w of a vertex lie.
  template <class F>
  HWY_NOINLINE void cut(std::size_t count, F&& position) {
    static constexpr float kNothing[4] = {0, 0, 0, 0};
    for (int v = 0; v < 3; ++v) {
      const auto p = load_positions_at(
          kD8, [&](std::size_t lane) { return lane < count ? position(lane, v) : kNothing; });
      const V c[3] = {p.x, p.y, p.z};
      for (int i = 0; i < kPlanes; ++i) original_[v].d[i] = distance(planes_[i], c, p.w);
      original_[v].number = hn::Set(kD8, static_cast<float>(v));
      slots_[v] = original_[v];
    }
    slots_[3] = slots_[4] = slots_[0];
    size_ = hn::Set(kD8, 3.0f);
    given_up_ = none();
    for (int p = 0; p < kPlanes; ++p) cut_by(p);
    for (int i = 0; i < kSlots; ++i) hn::Store(slots_[i].number, kD8, numbers_[i]);
    hn::Store(size_, kD8, sizes_);
    left_bits_ = mask_bits(kD8, given_up_);
  }

  // Whether a lane's triangle is left to others.
  bool is_left(std::size_t lane) const { return (left_bits_ >> lane & 1) != 0; }

  // Of another lane, whose triangle this is: vertices written to `out`.
  template <class S>
  int write(const S& shape, std::size_t lane, const float* const vertex[3], float* out) const {
    HWY_ALIGN float pool[2 * kPlanes][S::kWidth];
    const float* at[3 + 2 * kPlanes] = {vertex[0], vertex[1], vertex[2]};
    for (int p = 0; p < kPlanes; ++p) {
      if ((cut_bits_[p] >> lane & 1) == 0) continue;
      for (int i = 0; i < 2; ++i) {
        const NewVertex& made = made_[p][i];
        float* const to = pool[2 * p + i];
        meet<float>(shape, at[static_cast<int>(made.from[lane])],
                    at[static_cast<int>(made.to[lane])], made.t[lane], to);
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

  // A vertex of every triangle: its distances, and its number: 0 to 2 are the original ones,
  // 3 + 2 p and 4 + 2 p those where the edges leave the inside of plane p and enter it. Its
  // constructor is written out, since GCC compiles implicit ones for no target.
  struct Corner {
    HWY_INLINE Corner() {}

    V d[kPlanes];
    V number;
  };
  struct NewVertex {
    HWY_ALIGN float from[8], to[8], t[8];
  };

  static HWY_INLINE Corner either(M mask, const Corner& yes, const Corner& no) {
    Corner r;
    for (int q = 0; q < kPlanes; ++q) r.d[q] = hn::IfThenElse(mask, yes.d[q], no.d[q]);
    r.number = hn::IfThenElse(mask, yes.number, no.number);
    return r;
  }

  static HWY_INLINE V distance(const CodePlane& plane, const V (&c)[3], V w) {
    return hn::Add(hn::Mul(hn::Set(kD8, plane.w_weight), w),
                   hn::Mul(hn::Set(kD8, plane.c_weight), c[plane.axis]));
  }
  static HWY_INLINE M none() { return hn::FirstN(kD8, 0); }
  static HWY_INLINE M is_negative(V d) { return hn::Lt(d, hn::Zero(kD8)); }
  HWY_INLINE M has_size(int size) const {
    return hn::Eq(size_, hn::Set(kD8, static_cast<float>(size)));
  }

  HWY_INLINE void cut_by(int p) {
    M crossed = is_negative(original_[0].d[p]);
    for (int v = 1; v < 3; ++v) crossed = hn::Or(crossed, is_negative(original_[v].d[p]));
    crossed = hn::AndNot(given_up_, crossed);
    cut_bits_[p] = 0;
    if (hn::AllFalse(kD8, crossed)) return;
    const M three = hn::And(crossed, has_size(3)), four = hn::And(crossed, has_size(4)),
            five = hn::And(crossed, has_size(5));
    if (!hn::AllFalse(kD8, five)) leave_five(p, five);
    if (!hn::AllFalse(kD8, three)) clip<3>(p, three);
    if (!hn::AllFalse(kD8, four)) clip<4>(p, four);
  }

  HWY_INLINE void leave_five(int p, M five) {
    M outside = is_negative(slots_[0].d[p]);
    for (int i = 1; i < 5; ++i) outside = hn::Or(outside, is_negative(slots_[i].d[p]));
    given_up_ = hn::Or(given_up_, hn::And(five, outside));
  }

  // Triangles or quadrilaterals, those of the mask.
  template <int kSize>
  HWY_INLINE void clip(int p, M mask) {
    Corner v[kSize];
    M every = mask, some = none(), on_plane = some;
    for (int i = 0; i < kSize; ++i) {
      v[i] = slots_[i];
      const V d = v[i].d[p];
      every = hn::And(every, is_negative(d));
      some = hn::Or(some, is_negative(d));
      on_plane = hn::Or(on_plane, hn::Eq(d, hn::Zero(kD8)));
    }
    size_ = hn::IfThenZeroElse(every, size_);
    M active = hn::AndNot(every, hn::And(mask, some));
    given_up_ = hn::Or(given_up_, hn::And(active, on_plane));
    cycle(v, p);
    const auto above = [&](int i) { return hn::Gt(v[i].d[p], hn::Zero(kD8)); };
    M torn = above(kSize - 1);  // more than one run
    if constexpr (kSize == 4) torn = hn::Or(torn, hn::AndNot(above(1), above(2)));
    given_up_ = hn::Or(given_up_, hn::And(active, torn));
    active = hn::AndNot(given_up_, active);
    if (hn::AllFalse(kD8, active)) return;
    write_case(p, active, v, above(1));
  }

  // Brings the first vertex inside after one outside to the front.
  template <int kSize>
  static HWY_INLINE void cycle(Corner (&v)[kSize], int p) {
    Corner from[kSize];
    for (int i = 0; i < kSize; ++i) from[i] = v[i];
    for (int first = 1; first < kSize; ++first) {
      const M comes_first =
          hn::AndNot(is_negative(from[first].d[p]), is_negative(from[first - 1].d[p]));
      for (int i = 0; i < kSize; ++i) v[i] = either(comes_first, from[(i + first) % kSize], v[i]);
    }
  }

  // The edge from v0 back to the last vertex is always cut, and one other.
  template <int kSize>
  HWY_INLINE void write_case(int p, M active, const Corner (&v)[kSize], M second) {
    const M third = kSize == 4 ? hn::And(second, hn::Gt(v[2].d[p], hn::Zero(kD8))) : none();
    Corner in = either(second, v[1], v[0]), out = either(second, v[2], v[1]);
    if constexpr (kSize == 4) {
      in = either(third, v[2], in);
      out = either(third, v[3], out);
    }
    const Corner leave = meet_at(active, in, out, p, 0);
    const Corner enter = meet_at(active, v[0], v[kSize - 1], p, 1);
    cut_bits_[p] |= mask_bits(kD8, active);
    const auto set = [&](int slot, const Corner& to) {
      slots_[slot] = either(active, to, slots_[slot]);
    };
    set(0, v[0]);
    set(1, either(second, v[1], leave));
    set(2, either(second, either(third, v[2], leave), enter));
    set(3, either(third, leave, enter));
    set(4, enter);
    const V size = hn::IfThenElse(third, hn::Set(kD8, 5.0f),
                                  hn::IfThenElse(second, hn::Set(kD8, 4.0f), hn::Set(kD8, 3.0f)));
    size_ = hn::IfThenElse(active, size, size_);
  }

  // The meeting of an edge with plane p, from the end nearer to it, noted in the lanes of the mask
  // as new vertex i of the plane.
  HWY_INLINE Corner meet_at(M mask, const Corner& in, const Corner& out, int p, int i) {
    const V d_in = in.d[p], beyond = hn::Neg(out.d[p]);
    const M is_outside = hn::Lt(beyond, d_in);
    const V t = hn::Div(hn::Min(d_in, beyond), hn::Sub(d_in, out.d[p]));
    // From the end outside t (in - out) is -t (out - in), but for the sign of 0, which no decision
    // looks at.
    const V along = hn::IfThenElse(is_outside, hn::Neg(t), t);
    Corner r;
    for (int q = 0; q < kPlanes; ++q) {
      const V from = hn::IfThenElse(is_outside, out.d[q], in.d[q]);
      r.d[q] = hn::Add(from, hn::Mul(along, hn::Sub(out.d[q], in.d[q])));
    }
    r.number = hn::Set(kD8, static_cast<float>(3 + 2 * p + i));
    const V from = hn::IfThenElse(is_outside, out.number, in.number),
            to = hn::IfThenElse(is_outside, in.number, out.number);
    hn::BlendedStore(from, mask, kD8, made_[p][i].from);
    hn::BlendedStore(to, mask, kD8, made_[p][i].to);
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
  unsigned left_bits_ = 0;
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
