// SPDX-License-Identifier: MIT
//
// One straddling triangle whose new vertices come from its three own ones, in double: value =
// sum lambda_i v_i / sum lambda_i, in SIMD over the coordinates and attributes of a vertex.
//
// kCertain, of floats only: the value of each float is known to within a proved bound, and the
// floats nearest to both ends of that interval are the same; else the plain version writes the
// vertex again, with expansions. If already a decision is in doubt the triangle is handed back.
//
// Lemma (one plane). lambda of an edge is (-d_out, d_in), both positive: doubles within u = 2^-53
// of the exact distances, relatively. The products of lambda and floats a and b carry one rounding
// more, their sum another, the sum of lambda two in all, its reciprocal and the quotient one each:
// the numerator is within 3 u, to first order, of lambda . (|a|, |b|), and the whole within 7 u of
// max(|a|, |b|), a convex combination being no larger. 16 u covers that, the terms of higher order
// and the rounding of the interval's ends. Nothing under- or overflows: exact_lines.hpp.
//
// The mean of equal values is their value where two planes meet, whose sums may cancel.
//
// Several planes: corners-inl.hpp. The methods give the bits of their plain twins: the same
// operations in the same order.
#if defined(CLIPSCOPE_BATCH_BARYCENTRIC_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_BARYCENTRIC_INL
#undef CLIPSCOPE_BATCH_BARYCENTRIC_INL
#else
#define CLIPSCOPE_BATCH_BARYCENTRIC_INL
#endif

#include "spaces/batch/corners-inl.hpp"
#include "spaces/batch/plain.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

inline constexpr double kEdgeError = 16 * 0x1p-53;  // of the lemma

// A triangle that one plane cuts has one vertex, the apex, alone on its side: both edges that are
// cut meet there. Polygon: apex, cut of apex-b, cut of apex-c if the apex is inside, else b, c, cut
// of apex-c, cut of apex-b. Looked up, since a branch would be mispredicted half of the time.
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

// The vertices at the ends of an edge.
inline constexpr std::uint8_t kEnds[3][2] = {{1, 2}, {0, 2}, {0, 1}};

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

  template <class V>
  HWY_INLINE int cut_one_plane(const V* const vertex[3], const CodePlane& plane, V* out) const {
    const double d[3] = {distance<double>(plane, vertex[0]), distance<double>(plane, vertex[1]),
                         distance<double>(plane, vertex[2])};
    if (d[0] == 0 || d[1] == 0 || d[2] == 0) return cut_at_vertex(vertex, d, plane, out);
    const Apex& order = kApex[outside_mask(d)];
    const std::size_t stride = shape.floats();
    copy_vertex(shape, vertex[order.first], out);
    copy_vertex(shape, vertex[order.c], out + stride);
    write_two_means(vertex, order, d, plane, out + order.place_of_b * stride, out + 2 * stride);
    return order.size;
  }

  template <class V>
  HWY_INLINE int cut_planes(const Straddler<V>& s, V* out) const {
    if ((s.any & kPlaneBits) == 0) return kGiveUp;  // vertices (0, 0, 0, 0)
    Corners<kCertain> corners;
    if (!corners.cut(planes, s)) return kGiveUp;
    const int size = corners.list().size;
    return size < 3 || write_corners(corners, s, out) ? size : kGiveUp;
  }

 private:
  using Corner = typename Corners<kCertain>::Corner;

  // The plane of a line, numbered as Corners does.
  const CodePlane& plane_of(int line) const { return planes[line - 3]; }
  int line_of(const CodePlane& plane) const {
    int line = 3;
    while (plane_of(line).bit != plane.bit) ++line;
    return line;
  }

  // The same where a vertex lies on the plane: its distance is 0, exactly.
  template <class V>
  HWY_NOINLINE int cut_at_vertex(const V* const vertex[3], const double d[3],
                                 const CodePlane& plane, V* out) const {
    if constexpr (kCertain) {
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

  // Bits in which the floats nearest to two doubles differ; the nearest to `low` goes to out.
  static HWY_INLINE Bits store_between(hn::Vec<D> low, hn::Vec<D> high, float* out) {
    const auto a = hn::DemoteTo(DF(), low), b = hn::DemoteTo(DF(), high);
    hn::StoreU(a, DF(), out);
    return hn::Xor(hn::BitCast(DU(), a), hn::BitCast(DU(), b));
  }

  // Ones in the lanes of a vertex's first vector that have to be certain: all, or all but z, which
  // is set where it lies on its plane z = 0.
  static HWY_INLINE Bits first_lanes(bool sets_z) {
    HWY_ALIGN static constexpr std::uint32_t kBits[2][8] = {
        {~0u, ~0u, ~0u, ~0u, ~0u, ~0u, ~0u, ~0u}, {~0u, ~0u, 0, ~0u, ~0u, ~0u, ~0u, ~0u}};
    return hn::Load(DU(), kBits[sets_z]);
  }

  // Stores sum / total, rounded, and returns the bits that this leaves open: it is within `error`
  // times the largest of the values that it is a mean of. Fused multiplications, where there are
  // some, round less.
  template <class V>
  static HWY_INLINE Bits store_mean(hn::Vec<D> sum, hn::Vec<D> reciprocal,
                                    [[maybe_unused]] hn::Vec<D> largest,
                                    [[maybe_unused]] hn::Vec<D> error, V* out) {
    if constexpr (kCertain) {
      const auto off = hn::Mul(largest, error);
      return store_between(hn::MulSub(sum, reciprocal, off), hn::MulAdd(sum, reciprocal, off), out);
    } else {
      store(D(), hn::Mul(sum, reciprocal), out);
      return hn::Zero(DU());
    }
  }

  // The floats of a vertex that are left open: where there are ones in some bits.
  struct Doubt {
    Bits some;
    HWY_ALIGN std::uint32_t open[S::kWidth];

    HWY_INLINE Doubt() : some(hn::Zero(DU())) {}
    HWY_INLINE void add(Bits more, std::size_t lane, Bits first) {
      if (!kCertain) return;
      if (lane == 0) more = hn::And(more, first);
      some = hn::Or(some, more);
      hn::Store(more, DU(), open + lane);
    }
    HWY_INLINE bool is_none() const {
      return !kCertain || hn::AllTrue(DU(), hn::Eq(some, hn::Zero(DU())));
    }
    void set_all() {
      some = hn::Set(DU(), 1);
      std::fill(open, open + S::kWidth, 1);
    }
  };

  // l_a a + l_b b. A sum that is 0 is +0; where floats have to be certain a -0 is found out as
  // such.
  static HWY_INLINE hn::Vec<D> sum_of(hn::Vec<D> l_a, hn::Vec<D> a, hn::Vec<D> l_b, hn::Vec<D> b) {
    if constexpr (kCertain) {
      return hn::MulAdd(l_a, a, hn::Mul(l_b, b));
    } else {
      return hn::Add(hn::Add(hn::Mul(l_a, a), hn::Mul(l_b, b)), hn::Zero(D()));
    }
  }

  static HWY_INLINE hn::Vec<D> larger(hn::Vec<D> a, hn::Vec<D> b) {
    return hn::Max(hn::Abs(a), hn::Abs(b));
  }

  // Where a plane, at distances d of the vertices, cuts the edges from the apex to b and c.
  template <class V>
  HWY_INLINE void write_two_means(const V* const vertex[3], const Apex& order, const double d_of[3],
                                  const CodePlane& plane, V* to_b, V* to_c) const {
    const D d;
    const double d_apex = std::abs(d_of[order.apex]), d_b = std::abs(d_of[order.b]),
                 d_c = std::abs(d_of[order.c]);
    const auto of_a_b = hn::Set(d, d_b), of_a_c = hn::Set(d, d_c), of_other = hn::Set(d, d_apex),
               over_b = hn::Set(d, 1 / (d_apex + d_b)), over_c = hn::Set(d, 1 / (d_apex + d_c)),
               error = hn::Set(d, kEdgeError);
    const V *a = vertex[order.apex], *b = vertex[order.b], *c = vertex[order.c];
    const Bits first = first_lanes(plane.w_weight == 0);
    Doubt doubt_b, doubt_c;
    // Whole vectors that reach into the next vertex must not be written before it is.
    HWY_ALIGN V scratch[2][S::kWidth];
    V* const out_b = S::kLoadsInPlace ? to_b : scratch[0];
    V* const out_c = S::kLoadsInPlace ? to_c : scratch[1];
    for (std::size_t i = 0; i < shape.width(); i += hn::Lanes(d)) {
      const auto v_a = load(d, a + i), v_b = load(d, b + i), v_c = load(d, c + i);
      const Bits open_b = store_mean(sum_of(of_a_b, v_a, of_other, v_b), over_b, larger(v_a, v_b),
                                     error, out_b + i);
      const Bits open_c = store_mean(sum_of(of_a_c, v_a, of_other, v_c), over_c, larger(v_a, v_c),
                                     error, out_c + i);
      doubt_b.add(open_b, i, first);
      doubt_c.add(open_c, i, first);
    }
    set_on_plane(plane, out_b);
    set_on_plane(plane, out_c);
    if constexpr (!S::kLoadsInPlace) {
      std::memcpy(to_b, out_b, shape.floats() * sizeof(V));
      std::memcpy(to_c, out_c, shape.floats() * sizeof(V));
    }
    if constexpr (kCertain) {
      if (hn::AllTrue(DU(), hn::Eq(hn::Or(doubt_b.some, doubt_c.some), hn::Zero(DU())))) return;
      const int line = line_of(plane);
      const bool inside = d_of[order.apex] > 0;  // then the polygon is the apex, to_b, to_c
      if (!doubt_b.is_none()) {
        write_again(vertex, inside ? order.c : line, inside ? line : order.c, doubt_b, to_b);
      }
      if (!doubt_c.is_none()) {
        write_again(vertex, inside ? line : order.b, inside ? order.b : line, doubt_c, to_c);
      }
    }
  }

  // The vertex where the polygon goes over from one line to the other: what is in doubt, by
  // expansions where need be.
  HWY_NOINLINE void write_again(const float* const vertex[3], int from, int to, const Doubt& doubt,
                                float* out) const {
    ++tally.exact_vertices;
    plain::write_corner(depth, shape.floats(), vertex, from, to, doubt.open, out);
  }

  // The mean of vertices a and b with those weights, a point of an edge.
  template <class V>
  HWY_INLINE void write_mean(double of_a, int a, double of_b, int b, const V* const vertex[3],
                             bool sets_z, Doubt& doubt, V* out) const {
    const D d;
    const auto l_a = hn::Set(d, of_a), l_b = hn::Set(d, of_b),
               reciprocal = hn::Set(d, 1 / (of_a + of_b)), error = hn::Set(d, kEdgeError);
    const Bits first = first_lanes(sets_z);
    for (std::size_t i = 0; i < shape.width(); i += hn::Lanes(d)) {
      const auto v_a = load(d, vertex[a] + i), v_b = load(d, vertex[b] + i);
      const Bits open =
          store_mean(sum_of(l_a, v_a, l_b, v_b), reciprocal, larger(v_a, v_b), error, out + i);
      doubt.add(open, i, first);
    }
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

  // Whether all corners are in front of the eye; the triangle's own ones are, inside planes that
  // are not met. These come first, without a branch: slots of others are filled later.
  template <class V>
  HWY_INLINE bool write_corners(const Corners<kCertain>& corners, const Straddler<V>& s,
                                V* out) const {
    const List& list = corners.list();
    const std::size_t stride = shape.floats();
    int slots[3 + 2 * kPlanes], count = 0;
    for_each_place(list, [&](int i) {
      const int number = list.at(i);
      copy_vertex(shape, s.vertex[number < 3 ? number : 0], out + i * stride);
      slots[count] = i;
      count += number >= 3;
    });
    bool in_front = true;
    for (const int place : std::span(slots, count)) {
      HWY_ALIGN V scratch[S::kWidth];
      const Corner& corner = corners[list.at(place)];
      V* const slot = out + place * stride;
      V* const v = S::kLoadsInPlace ? slot : scratch;
      Doubt doubt;
      write_corner(corner, s, doubt, v);
      if (!S::kLoadsInPlace) std::memcpy(slot, v, stride * sizeof(V));
      if constexpr (kCertain) {
        if (!doubt.is_none()) write_again(s.vertex, corner.from, corner.to, doubt, slot);
      }
      in_front = in_front && slot[3] > 0;
    }
    return in_front;
  }

  // Writes a corner that lies on one plane or two.
  template <class V>
  HWY_INLINE void write_corner(const Corner& c, const Straddler<V>& s, Doubt& doubt, V* out) const {
    const int low = std::min(c.from, c.to), high = std::max(c.from, c.to);
    if (low < 3) {
      const int a = kEnds[low][0], b = kEnds[low][1];
      write_mean(c.lambda[a], a, c.lambda[b], b, s.vertex, plane_of(high).w_weight == 0, doubt,
                 out);
    } else {
      const bool sets_z = plane_of(low).w_weight == 0 || plane_of(high).w_weight == 0;
      write_mean(c, s, sets_z, doubt, out);
      set_on_plane(plane_of(low), out);
    }
    set_on_plane(plane_of(high), out);
  }

  // The mean of the three vertices at a meeting of two planes. The bound is that of
  // `rounded_quotient` (exact_lines.hpp): lambda . |v| and |q| times the sum of lambda are no more
  // than the largest |v| times that of the magnitudes.
  template <class V>
  HWY_INLINE void write_mean(const Corner& c, const Straddler<V>& s, bool sets_z, Doubt& doubt,
                             V* out) const {
    const D d;
    const double total = c.lambda[0] + c.lambda[1] + c.lambda[2],
                 total_error = 10 * 0x1p-53 * (c.magnitude[0] + c.magnitude[1] + c.magnitude[2]);
    if (kCertain && !(total > 0x1p20 * total_error)) return doubt.set_all();
    const auto reciprocal = hn::Set(d, 1 / total),
               error = hn::Set(d, 2 * total_error / total * (1 + 0x1p-17) + 0x1p-50);
    const auto l_0 = hn::Set(d, c.lambda[0]), l_1 = hn::Set(d, c.lambda[1]),
               l_2 = hn::Set(d, c.lambda[2]);
    const Bits first = first_lanes(sets_z);
    for (std::size_t i = 0; i < shape.width(); i += hn::Lanes(d)) {
      const auto v_0 = load(d, s.vertex[0] + i), v_1 = load(d, s.vertex[1] + i),
                 v_2 = load(d, s.vertex[2] + i);
      auto sum = hn::Add(sum_of(l_0, v_0, l_1, v_1), hn::Mul(l_2, v_2));
      auto factor = reciprocal;
      if constexpr (!kCertain) {
        const auto same = hn::And(hn::Eq(v_0, v_1), hn::Eq(v_1, v_2));
        sum = hn::IfThenElse(same, hn::Add(v_0, hn::Zero(d)), sum);
        factor = hn::IfThenElse(same, hn::Set(d, 1.0), reciprocal);
      }
      const Bits open =
          store_mean(sum, factor, hn::Max(larger(v_0, v_1), hn::Abs(v_2)), error, out + i);
      doubt.add(open, i, first);
    }
  }
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
