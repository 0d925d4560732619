// SPDX-License-Identifier: MIT
//
// One straddling triangle whose new vertices come from its three own ones, in double: value =
// sum lambda_i v_i / sum lambda_i, in SIMD over the coordinates and attributes of a vertex.
//
// kCertain, of floats only: the value of each float is known to within a proved bound, and the floats
// nearest to both ends of that interval are the same; else the triangle is handed back, to be settled by
// expansions.
//
// Lemma (one plane). lambda of an edge is (-d_out, d_in), both positive: doubles within u = 2^-53 of the exact
// distances, relatively. The products of lambda and floats a and b carry one rounding more, their sum
// another, the sum of lambda two in all, its reciprocal and the quotient one each: the numerator is within
// 3 u, to first order, of lambda . (|a|, |b|), and the whole within 7 u of max(|a|, |b|), a convex combination
// being no larger. 16 u covers that, the terms of higher order and the rounding of the interval's ends.
// Nothing under- or overflows: exact_lines.hpp.
//
// Several planes: as in exact_corners.hpp, with corners as numbers in a list. A corner's side of a plane is
// certain if the determinant is larger than its bound, of exact_lines.hpp; a determinant of 0 is handed
// back, too. The methods give the bits of their plain twins: the same operations in the same order.
#if defined(CLIPSCOPE_BATCH_BARYCENTRIC_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_BARYCENTRIC_INL
#undef CLIPSCOPE_BATCH_BARYCENTRIC_INL
#else
#define CLIPSCOPE_BATCH_BARYCENTRIC_INL
#endif

#include "spaces/batch/cut-inl.hpp"
#include "spaces/batch/plain.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

// A triangle that one plane cuts has one vertex, the apex, alone on its side: both edges that are cut meet
// there. Polygon: apex, cut of apex-b, cut of apex-c if the apex is inside, else b, c, cut of apex-c, cut
// of apex-b. Looked up, since a branch would be mispredicted half of the time.
struct Apex {
  std::uint8_t apex, b, c;
  std::uint8_t first;       // vertex of the polygon
  std::uint8_t place_of_b;  // in the polygon: the cut of apex-b; that of apex-c is the third vertex
  std::uint8_t size;        // of the polygon
};
// By the mask of outside vertices, 1 to 6.
inline constexpr Apex kApex[7] = {{},
                                  {0, 1, 2, 1, 3, 4},
                                  {1, 2, 0, 2, 3, 4},
                                  {2, 0, 1, 2, 1, 3},
                                  {2, 0, 1, 0, 3, 4},
                                  {1, 2, 0, 1, 1, 3},
                                  {0, 1, 2, 0, 1, 3}};

template <bool kCertain, class S>
struct FromOriginals {
  const S& shape;

  using D = LanesOf<double, S>;
  using DF = hn::Rebind<float, D>;
  using DU = hn::Rebind<std::uint32_t, D>;
  using Bits = hn::Vec<DU>;

  template <class V>
  HWY_INLINE int cut_one_plane(const V* const vertex[3], const CodePlane& plane, V* out) const {
    const double d[3] = {distance<double>(plane, vertex[0]), distance<double>(plane, vertex[1]),
                         distance<double>(plane, vertex[2])};
    if (d[0] == 0 || d[1] == 0 || d[2] == 0) return kGiveUp;  // a vertex on the plane
    const Apex& order = kApex[outside_mask(d)];
    const std::size_t stride = shape.floats();
    copy_vertex(shape, vertex[order.first], out);
    copy_vertex(shape, vertex[order.c], out + stride);
    const bool certain =
        write_two_means(vertex, order, d, plane, out + order.place_of_b * stride, out + 2 * stride);
    return certain ? order.size : kGiveUp;
  }

  template <class V>
  HWY_INLINE int cut_planes(const Straddler<V>& s, const std::array<CodePlane, kPlanes>& planes,
                            V* out) const {
    Pool pool;
    List list{{0, 1, 2}, 3};
    for (int p = 0; p < kPlanes; ++p) {
      const CodePlane& plane = planes[(p + 2) % kPlanes];  // in the order of `kAllPlanes`
      if ((s.any >> plane.bit & 1) == 0) continue;
      for (int i = 0; i < 3; ++i) pool.lines[3 + p][i] = distance<double>(plane, s.vertex[i]);
      if (!cut(3 + p, pool, list)) return kGiveUp;
    }
    return list.size < 3 || write_corners(list, pool, s, planes, out) ? list.size : kGiveUp;
  }

 private:
  // Bits in which the floats nearest to two doubles differ; the nearest to `low` goes to out.
  static HWY_INLINE Bits store_between(hn::Vec<D> low, hn::Vec<D> high, float* out) {
    const auto a = hn::DemoteTo(DF(), low), b = hn::DemoteTo(DF(), high);
    hn::StoreU(a, DF(), out);
    return hn::Xor(hn::BitCast(DU(), a), hn::BitCast(DU(), b));
  }

  // Ones in the lanes of a vertex's first vector that have to be certain: all, or all but z, which is set where
  // it lies on its plane z = 0.
  static HWY_INLINE Bits first_lanes(bool sets_z) {
    HWY_ALIGN static constexpr std::uint32_t kBits[2][8] = {
        {~0u, ~0u, ~0u, ~0u, ~0u, ~0u, ~0u, ~0u}, {~0u, ~0u, 0, ~0u, ~0u, ~0u, ~0u, ~0u}};
    return hn::Load(DU(), kBits[sets_z]);
  }

  // Stores what is within `error` of q, rounded, and returns the bits that this leaves open.
  template <class V>
  static HWY_INLINE Bits store_rounded(hn::Vec<D> q, hn::Vec<D> error, V* out) {
    if constexpr (kCertain) {
      return store_between(hn::Sub(q, error), hn::Add(q, error), out);
    } else {
      store(D(), q, out);
      return hn::Zero(DU());
    }
  }

  static HWY_INLINE Bits add_doubt(Bits doubt, Bits more, std::size_t lane, Bits first) {
    return hn::Or(doubt, lane == 0 ? hn::And(more, first) : more);
  }

  // More than the error of a mean of a and b.
  static HWY_INLINE hn::Vec<D> edge_error(hn::Vec<D> a, hn::Vec<D> b) {
    return hn::Mul(hn::Max(hn::Abs(a), hn::Abs(b)), hn::Set(D(), 16 * 0x1p-53));
  }

  static HWY_INLINE bool is_certain(Bits doubt) {
    return !kCertain || hn::AllTrue(DU(), hn::Eq(doubt, hn::Zero(DU())));
  }

  // A sum of products that is 0 is +0. Where floats have to be certain a -0 is found out as such.
  static HWY_INLINE hn::Vec<D> without_minus_zero(hn::Vec<D> sum) {
    return kCertain ? sum : hn::Add(sum, hn::Zero(D()));
  }

  // Where a plane, at distances d of the vertices, cuts the edges from the apex to b and c.
  template <class V>
  HWY_INLINE bool write_two_means(const V* const vertex[3], const Apex& order, const double d_of[3],
                                  const CodePlane& plane, V* to_b, V* to_c) const {
    const D d;
    const double d_apex = std::abs(d_of[order.apex]), d_b = std::abs(d_of[order.b]),
                 d_c = std::abs(d_of[order.c]);
    const auto of_a_b = hn::Set(d, d_b), of_a_c = hn::Set(d, d_c), of_other = hn::Set(d, d_apex),
               over_b = hn::Set(d, 1 / (d_apex + d_b)), over_c = hn::Set(d, 1 / (d_apex + d_c));
    const V *a = vertex[order.apex], *b = vertex[order.b], *c = vertex[order.c];
    const Bits first = first_lanes(plane.w_weight == 0);
    Bits doubt = hn::Zero(DU());
    // Whole vectors that reach into the next vertex must not be written before it is.
    HWY_ALIGN V scratch[2][S::kWidth];
    V* const out_b = S::kLoadsInPlace ? to_b : scratch[0];
    V* const out_c = S::kLoadsInPlace ? to_c : scratch[1];
    for (std::size_t i = 0; i < shape.width(); i += hn::Lanes(d)) {
      const auto v_a = load(d, a + i), v_b = load(d, b + i), v_c = load(d, c + i);
      const auto sum_b = hn::Add(hn::Mul(of_a_b, v_a), hn::Mul(of_other, v_b)),
                 sum_c = hn::Add(hn::Mul(of_a_c, v_a), hn::Mul(of_other, v_c));
      const Bits open_b = store_rounded(hn::Mul(without_minus_zero(sum_b), over_b),
                                        edge_error(v_a, v_b), out_b + i);
      const Bits open_c = store_rounded(hn::Mul(without_minus_zero(sum_c), over_c),
                                        edge_error(v_a, v_c), out_c + i);
      doubt = add_doubt(doubt, hn::Or(open_b, open_c), i, first);
    }
    set_on_plane(plane, out_b);
    set_on_plane(plane, out_c);
    if constexpr (!S::kLoadsInPlace) {
      std::memcpy(to_b, out_b, shape.floats() * sizeof(V));
      std::memcpy(to_c, out_c, shape.floats() * sizeof(V));
    }
    return is_certain(doubt);
  }

  // The mean of vertices a and b with those weights, a point of an edge.
  template <class V>
  HWY_INLINE void write_mean(double of_a, int a, double of_b, int b, const V* const vertex[3],
                             bool sets_z, V* out, Bits& doubt) const {
    const D d;
    const auto l_a = hn::Set(d, of_a), l_b = hn::Set(d, of_b),
               reciprocal = hn::Set(d, 1 / (of_a + of_b));
    const Bits first = first_lanes(sets_z);
    for (std::size_t i = 0; i < shape.width(); i += hn::Lanes(d)) {
      const auto v_a = load(d, vertex[a] + i), v_b = load(d, vertex[b] + i);
      const auto sum = hn::Add(hn::Mul(l_a, v_a), hn::Mul(l_b, v_b));
      const auto q = hn::Mul(without_minus_zero(sum), reciprocal);
      doubt = add_doubt(doubt, store_rounded(q, edge_error(v_a, v_b), out + i), i, first);
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

  // lambda = line `from` x line `to`, see `barycentric::meet`. Lines 0 to 2 are the triangle's edges, each
  // opposite to its vertex, the others planes, 3 and on in the order of `kAllPlanes`.
  struct Corner {
    double lambda[3], magnitude[3];
    std::uint8_t from, to;
  };
  // Beyond `size` and the lines of planes that cut, nothing is set.
  struct Pool {
    Corner corners[3 + 2 * kPlanes];
    double lines[3 + kPlanes][3];
    int size = 3;

    Pool() {
      static constexpr Corner kVertices[3] = {
          {{1, 0, 0}, {1, 0, 0}, 1, 2}, {{0, 1, 0}, {0, 1, 0}, 2, 0}, {{0, 0, 1}, {0, 0, 1}, 0, 1}};
      static constexpr double kEdges[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
      std::memcpy(corners, kVertices, sizeof kVertices);
      std::memcpy(lines, kEdges, sizeof kEdges);
    }
  };

  // Whether all signs were certain and the outside corners one run.
  HWY_INLINE bool cut(int line, Pool& pool, List& list) const {
    const double* row = pool.lines[line];
    unsigned outside = 0, decided = 0;
    for (int i = 0; i < list.size; ++i) {
      const Corner& c = pool.corners[list.at[i]];
      const double d = c.lambda[0] * row[0] + c.lambda[1] * row[1] + c.lambda[2] * row[2];
      double error = 0;
      if constexpr (kCertain) {
        error = 10 * 0x1p-53 *
                (c.magnitude[0] * std::abs(row[0]) + c.magnitude[1] * std::abs(row[1]) +
                 c.magnitude[2] * std::abs(row[2]));
      }
      outside |= static_cast<unsigned>(d < 0) << i;
      decided |= static_cast<unsigned>(std::abs(d) > error) << i;
    }
    const unsigned all = (1u << list.size) - 1;
    if (decided != all) return false;
    if (outside == 0) return true;
    if (outside == all) {
      list.size = 0;
      return true;
    }
    const Crossing crossing = find_crossing(outside, list.size);
    if (!crossing.is_one_run) return false;
    List r = inside_run(list, crossing);
    add_corner(pool.corners[list.at[crossing.last_in]].to, line, pool, r);
    add_corner(line, pool.corners[list.at[crossing.first_in]].from, pool, r);
    list = r;
    return true;
  }

  static HWY_INLINE void add_corner(int from, int to, Pool& pool, List& list) {
    const double *a = pool.lines[from], *b = pool.lines[to];
    Corner& c = pool.corners[pool.size];
    const auto set = [&](int i, int j, int k) {
      const double first = a[j] * b[k], second = a[k] * b[j];
      c.lambda[i] = first - second;
      c.magnitude[i] = std::abs(first) + std::abs(second);
    };
    set(0, 1, 2);
    set(1, 2, 0);
    set(2, 0, 1);
    c.from = static_cast<std::uint8_t>(from);
    c.to = static_cast<std::uint8_t>(to);
    list.add(pool.size++);
  }

  // Whether all corners are certain and in front of the eye. The triangle's own vertices first, without a
  // branch: slots of others are filled later.
  template <class V>
  HWY_INLINE bool write_corners(const List& list, const Pool& pool, const Straddler<V>& s,
                                const std::array<CodePlane, kPlanes>& planes, V* out) const {
    const std::size_t stride = shape.floats();
    int slots[3 + 2 * kPlanes], count = 0;
    for (int i = 0; i < list.size; ++i) {
      const int number = list.at[i];
      copy_vertex(shape, s.vertex[number < 3 ? number : 0], out + i * stride);
      slots[count] = i;
      count += number >= 3;
    }
    Bits doubt = hn::Zero(DU());
    bool certain = true;
    for (int i = 0; i < count; ++i) {
      HWY_ALIGN V scratch[S::kWidth];
      V* const slot = out + slots[i] * stride;
      V* const v = S::kLoadsInPlace ? slot : scratch;
      certain = write_corner(pool.corners[list.at[slots[i]]], s, planes, v, doubt) && certain;
      if (!S::kLoadsInPlace) std::memcpy(slot, v, stride * sizeof(V));
    }
    for (int i = 0; i < list.size; ++i) certain = certain && out[i * stride + 3] > 0;
    return certain && is_certain(doubt);
  }

  // Of a corner on one plane or two; whether the sum of its weights is certain.
  template <class V>
  HWY_INLINE bool write_corner(const Corner& c, const Straddler<V>& s,
                               const std::array<CodePlane, kPlanes>& planes, V* out,
                               Bits& doubt) const {
    const int low = std::min(c.from, c.to), high = std::max(c.from, c.to);
    const auto plane_of = [&](int line) -> const CodePlane& {
      return planes[(line - 1) % kPlanes];
    };
    bool certain = true;
    if (low < 3) {
      const int a = low == 0 ? 1 : 0, b = low == 2 ? 1 : 2;
      write_mean(c.lambda[a], a, c.lambda[b], b, s.vertex, plane_of(high).w_weight == 0, out,
                 doubt);
    } else {
      const bool sets_z = plane_of(low).w_weight == 0 || plane_of(high).w_weight == 0;
      certain = write_mean(c, s, sets_z, out, doubt);
      set_on_plane(plane_of(low), out);
    }
    set_on_plane(plane_of(high), out);
    return certain;
  }

  // The mean of the three vertices at a meeting of two planes, with the bound of exact_lines.hpp,
  // `rounded_quotient`. Whether the sum of weights is certain.
  template <class V>
  HWY_INLINE bool write_mean(const Corner& c, const Straddler<V>& s, bool sets_z, V* out,
                             Bits& doubt) const {
    const D d;
    const double total = c.lambda[0] + c.lambda[1] + c.lambda[2],
                 total_error = 10 * 0x1p-53 * (c.magnitude[0] + c.magnitude[1] + c.magnitude[2]);
    if (kCertain && !(total > 0x1p20 * total_error)) return false;
    const auto reciprocal = hn::Set(d, 1 / total), weight = hn::Set(d, 1 / total * (1 + 0x1p-18)),
               of_total = hn::Set(d, total_error);
    const auto l_0 = hn::Set(d, c.lambda[0]), l_1 = hn::Set(d, c.lambda[1]),
               l_2 = hn::Set(d, c.lambda[2]), m_0 = hn::Set(d, c.magnitude[0]),
               m_1 = hn::Set(d, c.magnitude[1]), m_2 = hn::Set(d, c.magnitude[2]);
    const Bits first = first_lanes(sets_z);
    for (std::size_t i = 0; i < shape.width(); i += hn::Lanes(d)) {
      const auto v_0 = load(d, s.vertex[0] + i), v_1 = load(d, s.vertex[1] + i),
                 v_2 = load(d, s.vertex[2] + i);
      const auto sum = hn::Add(hn::Add(hn::Add(hn::Zero(d), hn::Mul(l_0, v_0)), hn::Mul(l_1, v_1)),
                               hn::Mul(l_2, v_2));
      const auto magnitude =
          hn::Add(hn::Add(hn::Mul(m_0, hn::Abs(v_0)), hn::Mul(m_1, hn::Abs(v_1))),
                  hn::Mul(m_2, hn::Abs(v_2)));
      const auto q = hn::Mul(sum, reciprocal), of_q = hn::Abs(q),
                 of_sum = hn::Mul(magnitude, hn::Set(d, 10 * 0x1p-53));
      const auto error = hn::Add(hn::Mul(hn::Add(of_sum, hn::Mul(of_q, of_total)), weight),
                                 hn::Mul(of_q, hn::Set(d, 0x1p-51)));
      doubt = add_doubt(doubt, store_rounded(q, error, out + i), i, first);
    }
    return true;
  }
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
