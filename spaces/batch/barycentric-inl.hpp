// SPDX-License-Identifier: MIT
//
// Straddling triangles whose new vertices come from their three own ones, in double: value =
// sum lambda_i v_i / sum lambda_i, in SIMD over the coordinates and attributes of a vertex. What
// that takes but the vertices comes from one_plane-inl.hpp and corners-inl.hpp.
//
// kCertain, of floats only: the value of each float is known to within a proved bound, and the
// floats nearest to both ends of that interval are the same. Else, where one plane cuts, the value
// is compared with the midpoint of the two by fused multiplications; what that leaves open the
// plain version writes again, with expansions. If already a decision is in doubt the triangle is
// handed back.
//
// Lemma (one plane). lambda of an edge is (-d_out, d_in), both positive: doubles within u = 2^-53
// of the exact distances, relatively. The products of lambda and floats a and b carry one rounding
// more, their sum another, the sum of lambda two in all, its reciprocal and the quotient one each:
// the numerator is within 3 u, to first order, of lambda . (|a|, |b|), and the whole within 7 u of
// max(|a|, |b|), a convex combination being no larger. 16 u covers that, the terms of higher order
// and the rounding of the interval's ends. Nothing under- or overflows: exact_lines.hpp.
//
// Lemma (a corner). With N and the 12 u of corners-inl.hpp, which covers the fewer roundings of
// floats in the place of a line's entries as well, the numerator is within 12 u N N max |v_i| and
// the sum of lambda within 12 u N N. If that sum is certain to twenty bits the quotient is within
// twice 12 u N N over it, times max |v_i|, as in `rounded_quotient`: 1 + 2^-17 covers the
// denominator's own error and the roundings of this bound, 2^-50 those of the reciprocal, the
// quotient and the ends. At an edge of the triangle the third weight is exactly 0, and the largest
// magnitude that of its ends.
//
// Lemma (a tie). Between neighbouring floats with the midpoint m, the mean of a and b is above m if
// of_a (a - m) + of_b (b - m) > 0. Where the weights and both differences are exact, so is each
// product as head + tail of a fused multiplication. Heads that do not cancel decide, rounding being
// monotone; else the tails do.
//
// The mean of equal values is their value where two planes meet, whose sums may cancel. The methods
// give the bits of their plain twins: without certainty by the same operations in the same order.
#if defined(CLIPSCOPE_BATCH_BARYCENTRIC_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_BARYCENTRIC_INL
#undef CLIPSCOPE_BATCH_BARYCENTRIC_INL
#else
#define CLIPSCOPE_BATCH_BARYCENTRIC_INL
#endif

#include "spaces/batch/corners-inl.hpp"
#include "spaces/batch/error_bounds.hpp"
#include "spaces/batch/one_plane-inl.hpp"
#include "spaces/batch/plain.hpp"
#include "spaces/bounds/enclosure_arithmetic.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

template <bool kCertain, class S>
struct FromOriginals {
  const S& shape;
  const std::array<CodePlane, kPlanes>& planes;  // in the order of `kAllPlanes`
  DepthRange depth;
  Tally& tally;

  using D = LanesOf<double, S>;
  using DF = hn::Rebind<float, D>;
  using DU = hn::Rebind<std::uint32_t, D>;
  using Bits = hn::Vec<DU>;
  using Vec = hn::Vec<D>;

  // Both return the number of vertices, or kGiveUp.
  template <class V, class Splits>
  HWY_INLINE int cut_one_plane(const V* const vertex[3], const CodePlane& plane,
                               const Splits& splits, std::size_t lane, V* out) const {
    const unsigned outside = splits.outside(lane);
    if (outside == 0) return cut_at_vertex(vertex, plane, out);
    const Apex& order = kApex[outside];
    const std::size_t stride = shape.floats();
    copy_vertex(shape, vertex[order.first], out);
    copy_vertex(shape, vertex[order.c], out + stride);
    const Edge b{splits.b(lane), splits.apex(lane), splits.over_b(lane)},
        c{splits.c(lane), splits.apex(lane), splits.over_c(lane)};
    write_two_means(vertex, order, b, c, plane, out + order.place_of_b * stride, out + 2 * stride);
    return order.size;
  }

  // A triangle in a lane.
  template <class V, class Lanes>
  HWY_INLINE int cut_planes(const V* const vertex[3], const Lanes& lanes, std::size_t lane,
                            V* out) const {
    if (!lanes.is_certain(lane)) return kGiveUp;
    const int size = lanes.size(lane);
    return size == 0 || write_corners(vertex, lanes, lane, out) ? size : kGiveUp;
  }

 private:
  // The plane of a line, numbered as CornerLanes does.
  const CodePlane& plane_of(int line) const { return planes[static_cast<std::size_t>(line - 3)]; }
  int line_of(const CodePlane& plane) const {
    int line = 3;
    while (plane_of(line).bit != plane.bit) ++line;
    return line;
  }

  // A vertex lies on the plane: its distance is 0, exactly.
  template <class V>
  HWY_NOINLINE int cut_at_vertex(const V* const vertex[3], const CodePlane& plane, V* out) const {
    if constexpr (kCertain) {
      const double d[3] = {distance<double>(plane, vertex[0]), distance<double>(plane, vertex[1]),
                           distance<double>(plane, vertex[2])};
      const std::size_t stride = shape.floats();
      Doubt all;
      all.set_all();
      int size = 0;
      for (int i = 0; i < 3; ++i) {
        const int next = (i + 1) % 3, edge = (i + 2) % 3, line = line_of(plane);
        const bool leaves = d[i] > 0 && d[next] < 0, enters = d[i] < 0 && d[next] > 0;
        if (d[i] >= 0) copy_vertex(shape, vertex[i], out + size++ * stride);
        if (leaves) write_again(vertex, edge, line, all, out + size++ * stride);
        if (enters) write_again(vertex, line, edge, all, out + size++ * stride);
      }
      return size < 3 ? 0 : size;
    } else {
      return kGiveUp;
    }
  }

  // The floats of a vertex that are left open: where there are ones in some bits.
  struct Doubt {
    HWY_ALIGN std::uint32_t open[S::kWidth];

    void set_all() { std::fill(open, open + S::kWidth, 1); }
  };

  // Ones in the lanes of a vertex's first vector that have to be certain: all, or all but z, which
  // is set where it lies on its plane z = 0.
  static HWY_INLINE Bits lanes_in_doubt(std::size_t lane, bool sets_z) {
    HWY_ALIGN static constexpr std::uint32_t kBits[2][8] = {
        {~0u, ~0u, ~0u, ~0u, ~0u, ~0u, ~0u, ~0u}, {~0u, ~0u, 0, ~0u, ~0u, ~0u, ~0u, ~0u}};
    return hn::Load(DU(), kBits[sets_z && lane < 8] + lane % 8);
  }
  static HWY_INLINE bool is_none(Bits open) {
    return !kCertain || hn::AllTrue(DU(), hn::Eq(open, hn::Zero(DU())));
  }

  // A mean: sum / total lies between both, if floats have to be certain.
  struct Interval {
    Vec low, high;
  };

  // It is within `error` times the largest of the values that it is a mean of. Fused
  // multiplications, where there are some, round less.
  static HWY_INLINE Interval interval(Vec sum, Vec reciprocal, [[maybe_unused]] Vec largest,
                                      [[maybe_unused]] Vec error) {
    if constexpr (kCertain) {
      const auto off = hn::Mul(largest, error);
      return {hn::MulSub(sum, reciprocal, off), hn::MulAdd(sum, reciprocal, off)};
    } else {
      const auto q = hn::Mul(sum, reciprocal);
      return {q, q};
    }
  }

  // Stores the float nearest to the low end; bits in which that nearest to the high end differs.
  template <class V>
  static HWY_INLINE Bits store_mean(const Interval& mean, V* out) {
    if constexpr (kCertain) {
      const auto a = hn::DemoteTo(DF(), mean.low), b = hn::DemoteTo(DF(), mean.high);
      hn::StoreU(a, DF(), out);
      return hn::Xor(hn::BitCast(DU(), a), hn::BitCast(DU(), b));
    } else {
      store(D(), mean.low, out);
      return hn::Zero(DU());
    }
  }

  // Weights of the ends of an edge, and one over their sum: where they are kept, so that they are
  // loaded into all lanes at once.
  struct Edge {
    const double &of_a, &of_b, &reciprocal;
  };

  // The mean of a and b, lanes from i on. A sum that is 0 is +0; where floats have to be certain a
  // -0 is found out as such.
  static HWY_INLINE Interval mean(const Edge& edge, Vec a, Vec b) {
    const D d;
    const auto of_a = hn::Set(d, edge.of_a), of_b = hn::Set(d, edge.of_b),
               reciprocal = hn::Set(d, edge.reciprocal);
    Vec sum;
    if constexpr (kCertain) {
      sum = hn::MulAdd(of_a, a, hn::Mul(of_b, b));
    } else {
      sum = hn::Add(hn::Add(hn::Mul(of_a, a), hn::Mul(of_b, b)), hn::Zero(d));
    }
    return interval(sum, reciprocal, hn::Max(hn::Abs(a), hn::Abs(b)), hn::Set(d, kEdgeError));
  }

  // Where a plane cuts the edges from the apex to b and c.
  template <class V>
  HWY_INLINE void write_two_means(const V* const vertex[3], const Apex& order, const Edge& edge_b,
                                  const Edge& edge_c, const CodePlane& plane, V* to_b,
                                  V* to_c) const {
    const D d;
    const V *a = vertex[order.apex], *b = vertex[order.b], *c = vertex[order.c];
    const bool sets_z = plane.w_weight == 0;
    // Whole vectors that reach into the next vertex must not be written before it is.
    HWY_ALIGN V scratch[2][S::kWidth];
    V* const out_b = S::kLoadsInPlace ? to_b : scratch[0];
    V* const out_c = S::kLoadsInPlace ? to_c : scratch[1];
    Bits open = hn::Zero(DU());
    for (std::size_t i = 0; i < shape.width(); i += hn::Lanes(d)) {
      const auto v_a = load(d, a + i), v_b = load(d, b + i), v_c = load(d, c + i);
      const Interval of_b = mean(edge_b, v_a, v_b), of_c = mean(edge_c, v_a, v_c);
      const Bits some = hn::Or(store_mean(of_b, out_b + i), store_mean(of_c, out_c + i));
      open = hn::Or(open, hn::And(some, lanes_in_doubt(i, sets_z)));
    }
    set_on_plane(plane, out_b);
    set_on_plane(plane, out_c);
    if constexpr (!S::kLoadsInPlace) {
      std::memcpy(to_b, out_b, shape.floats() * sizeof(V));
      std::memcpy(to_c, out_c, shape.floats() * sizeof(V));
    }
    if constexpr (kCertain) {
      if (HWY_LIKELY(is_none(open))) return;
      settle_two_means(vertex, order, edge_b, edge_c, plane, to_b, to_c);
    }
  }

  // Whatever is open of them.
  HWY_NOINLINE void settle_two_means(const float* const vertex[3], const Apex& order,
                                     const Edge& edge_b, const Edge& edge_c, const CodePlane& plane,
                                     float* to_b, float* to_c) const {
    const int line = line_of(plane);
    const bool inside = order.size == 3;  // then the polygon is the apex, to_b, to_c
    settle(vertex, order.apex, order.b, edge_b, plane, inside ? order.c : line,
           inside ? line : order.c, to_b);
    settle(vertex, order.apex, order.c, edge_c, plane, inside ? line : order.b,
           inside ? order.b : line, to_c);
  }

  // What is open of the mean of vertices a and b, where the polygon goes over from one line to the
  // other: most are ties, which fused multiplications tell.
  HWY_INLINE void settle(const float* const vertex[3], int a, int b, const Edge& edge,
                         const CodePlane& plane, int from, int to, float* out) const {
    const D d;
    Doubt doubt;
    Bits open = hn::Zero(DU());
    const bool exact = is_exact(plane, vertex[a]) && is_exact(plane, vertex[b]);
    HWY_ALIGN float nearest[S::kWidth];
    for (std::size_t i = 0; i < shape.width(); i += hn::Lanes(d)) {
      const auto v_a = load(d, vertex[a] + i), v_b = load(d, vertex[b] + i);
      const Interval q = mean(edge, v_a, v_b);
      Bits some = hn::And(store_mean(q, nearest + i), lanes_in_doubt(i, plane.w_weight == 0));
      if (exact) some = choose_nearer(q, edge, v_a, v_b, some, nearest + i);
      hn::Store(some, DU(), doubt.open + i);
      open = hn::Or(open, some);
    }
    const float z = out[2];
    std::memcpy(out, nearest, shape.floats() * sizeof(float));
    if (plane.w_weight == 0) out[2] = z;
    if (!is_none(open)) write_again(vertex, from, to, doubt, out);
  }

  // Whether the distance of a vertex is exact as it is.
  static bool is_exact(const CodePlane& plane, const float* v) {
    return bounds::two_sum(double{plane.w_weight} * v[3], double{plane.c_weight} * v[plane.axis])
               .second == 0;
  }

  // The bits that remain open once values between two neighbouring floats have been compared with
  // their midpoint m: the sign of of_a (a - m) + of_b (b - m). The differences are exact, or their
  // lane stays open; the products are, as head and tail, and heads that don't cancel decide.
  static HWY_INLINE Bits choose_nearer(const Interval& q, const Edge& edge, Vec a, Vec b, Bits open,
                                       float* nearest) {
#if !HWY_NATIVE_FMA
    return open;
#else
    const D d;
    const auto low = hn::DemoteTo(DF(), q.low), high = hn::DemoteTo(DF(), q.high);
    const auto m = hn::Mul(hn::Set(d, 0.5), hn::Add(hn::PromoteTo(d, low), hn::PromoteTo(d, high)));
    const auto lost = [&](Vec v, Vec difference) {
      const auto back = hn::Add(difference, m);  // exact where nothing is lost
      const auto rest = hn::Sub(v, difference);
      return hn::Or(hn::Ne(back, v), hn::Ne(rest, m));
    };
    const auto d_a = hn::Sub(a, m), d_b = hn::Sub(b, m), of_a = hn::Set(d, edge.of_a),
               of_b = hn::Set(d, edge.of_b);
    const auto head_a = hn::Mul(of_a, d_a), head_b = hn::Mul(of_b, d_b),
               head = hn::Add(head_a, head_b),
               tail = hn::Add(hn::MulSub(of_a, d_a, head_a), hn::MulSub(of_b, d_b, head_b)),
               sign = hn::IfThenElse(hn::Eq(head, hn::Zero(d)), tail, head);
    // 1, 0 or -1, and NaN where a difference is not exact, as floats.
    const auto compared =
        hn::DemoteTo(DF(), hn::IfThenElse(hn::Or(lost(a, d_a), lost(b, d_b)),
                                          hn::Set(d, std::numeric_limits<double>::quiet_NaN()),
                                          hn::Sub(one_where(hn::Gt(sign, hn::Zero(d))),
                                                  one_where(hn::Lt(sign, hn::Zero(d))))));
    const auto bits_low = hn::BitCast(DU(), low), bits_high = hn::BitCast(DU(), high);
    const auto one = hn::Set(DU(), 1), none = hn::Zero(DU());
    const auto is_next = hn::Or(hn::Eq(hn::Sub(bits_high, bits_low), one),
                                hn::Eq(hn::Sub(bits_low, bits_high), one));
    const auto is_known = hn::And(hn::RebindMask(DU(), hn::Eq(compared, compared)), is_next);
    const auto is_tie = hn::RebindMask(DU(), hn::Eq(compared, hn::Zero(DF())));
    const auto is_odd = hn::Eq(hn::And(bits_low, one), one);
    const auto is_above = hn::RebindMask(DU(), hn::Gt(compared, hn::Zero(DF())));
    const auto is_high =
        hn::And(hn::And(is_known, hn::Ne(open, none)), hn::Or(is_above, hn::And(is_tie, is_odd)));
    hn::StoreU(hn::IfThenElse(hn::RebindMask(DF(), is_high), high, low), DF(), nearest);
    return hn::IfThenZeroElse(is_known, open);
#endif
  }

  static HWY_INLINE Vec one_where(hn::Mask<D> mask) {
    return hn::IfThenElseZero(mask, hn::Set(D(), 1.0));
  }

  // The vertex where the polygon goes over from one line to the other: what is in doubt, by
  // expansions where need be.
  HWY_NOINLINE void write_again(const float* const vertex[3], int from, int to, const Doubt& doubt,
                                float* out) const {
    ++tally.exact_vertices;
    plain::write_corner(depth, shape.floats(), vertex, from, to, doubt.open, out);
  }

  // Floats that are certain lie on their plane by themselves, unless it is z = 0.
  template <class V>
  static HWY_INLINE void set_on_plane(const CodePlane& plane, V* out) {
    if (plane.w_weight == 0) {
      out[plane.axis] = 0;
    } else if (!kCertain) {
      out[plane.axis] = -plane.c_weight * out[3];
    }
  }

  // The largest magnitudes of a triangle's values: of all three, and at 1, 2 and 4 of the ends of
  // edges 0, 1 and 2.
  struct Largest {
    HWY_ALIGN double of[5][S::kWidth];

    template <class V>
    HWY_INLINE Largest(const S& shape, const V* const vertex[3]) {
      const D d;
      for (std::size_t i = 0; i < shape.width(); i += hn::Lanes(d)) {
        const auto v_0 = hn::Abs(load(d, vertex[0] + i)), v_1 = hn::Abs(load(d, vertex[1] + i)),
                   v_2 = hn::Abs(load(d, vertex[2] + i));
        const auto of_0 = hn::Max(v_1, v_2);
        hn::Store(hn::Max(v_0, of_0), d, of[0] + i);
        hn::Store(of_0, d, of[1] + i);
        hn::Store(hn::Max(v_0, v_2), d, of[2] + i);
        hn::Store(hn::Max(v_0, v_1), d, of[4] + i);
      }
    }
  };

  // Whether all corners are in front of the eye; the triangle's own ones are, inside planes that
  // are not met. These come first, without a branch: places of others are filled later.
  template <class V, class Lanes>
  HWY_INLINE bool write_corners(const V* const vertex[3], const Lanes& lanes, std::size_t lane,
                                V* out) const {
    const std::size_t stride = shape.floats();
    const int size = lanes.size(lane);
    for_each_corner(
        size, [&](int i) { copy_vertex(shape, vertex[lanes.own_of(lane, i)], out + i * stride); });
    const Largest largest(shape, vertex);
    bool in_front = true;
    for (std::uint64_t rest = lanes.made(lane); rest != 0; rest &= rest - 1) {
      const int i = std::countr_zero(rest) / 8;
      V* const to = out + i * stride;
      write_corner(vertex, lanes, lane, i, largest, to);
      in_front = in_front && to[3] > 0;
    }
    return in_front;
  }

  // A corner that lies on one plane or two.
  template <class V, class Lanes>
  HWY_INLINE void write_corner(const V* const vertex[3], const Lanes& lanes, std::size_t lane,
                               int i, const Largest& largest, V* to) const {
    const int from = lanes.from(lane, i), next = lanes.to(lane, i);
    const unsigned lines = 1u << from | 1u << next;
    const bool sets_z = (lines & lines_of_zero()) != 0;
    HWY_ALIGN V scratch[S::kWidth];
    V* const out = S::kLoadsInPlace ? to : scratch;
    Doubt doubt;
    Bits open = write_mean(vertex, lanes, lane, i, largest.of[lines & 7], sets_z, doubt, out);
    if constexpr (kCertain) {
      if (sets_z) out[2] = 0;
    } else {
      for (unsigned rest = lines >> 3; rest != 0; rest &= rest - 1) {
        set_on_plane(planes[static_cast<std::size_t>(std::countr_zero(rest))], out);
      }
    }
    if (!S::kLoadsInPlace) std::memcpy(to, out, shape.floats() * sizeof(V));
    if constexpr (kCertain) {
      if (HWY_LIKELY(is_none(open) && lanes.has_sum(lane, i))) return;
      if (!lanes.has_sum(lane, i)) doubt.set_all();
      write_again(vertex, from, next, doubt, to);
    }
  }

  // The lines of planes z = 0, as bits.
  unsigned lines_of_zero() const {
    return depth == DepthRange::minus_one_to_one ? 0
           : depth == DepthRange::reversed       ? 1u << (3 + static_cast<int>(Plane::far))
                                                 : 1u << (3 + static_cast<int>(Plane::near));
  }

  // The mean of the three vertices with the corner's weights; that of equal values is their value.
  // Returns what is open.
  template <class V, class Lanes>
  HWY_INLINE Bits write_mean(const V* const vertex[3], const Lanes& lanes, std::size_t lane, int i,
                             const double* largest, bool sets_z, Doubt& doubt, V* out) const {
    const D d;
    const auto l_0 = hn::Set(d, lanes.lambda(lane, i, 0)),
               l_1 = hn::Set(d, lanes.lambda(lane, i, 1)),
               l_2 = hn::Set(d, lanes.lambda(lane, i, 2)),
               reciprocal = hn::Set(d, lanes.reciprocal(lane, i)),
               error = hn::Set(d, lanes.error(lane, i));
    Bits open = hn::Zero(DU());
    for (std::size_t k = 0; k < shape.width(); k += hn::Lanes(d)) {
      const auto v_0 = load(d, vertex[0] + k), v_1 = load(d, vertex[1] + k),
                 v_2 = load(d, vertex[2] + k);
      auto factor = reciprocal;
      Vec sum;
      if constexpr (kCertain) {
        sum = hn::MulAdd(l_2, v_2, hn::MulAdd(l_1, v_1, hn::Mul(l_0, v_0)));
      } else {
        sum = hn::Add(hn::Add(hn::Mul(l_0, v_0), hn::Mul(l_1, v_1)), hn::Mul(l_2, v_2));
        const auto same = hn::And(hn::Eq(v_0, v_1), hn::Eq(v_1, v_2));
        sum = hn::Add(hn::IfThenElse(same, v_0, sum), hn::Zero(d));
        factor = hn::IfThenElse(same, hn::Set(d, 1.0), reciprocal);
      }
      const Bits some =
          hn::And(store_mean(interval(sum, factor, hn::Load(d, largest + k), error), out + k),
                  lanes_in_doubt(k, sets_z));
      if constexpr (kCertain) hn::Store(some, DU(), doubt.open + k);
      open = hn::Or(open, some);
    }
    return open;
  }
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
