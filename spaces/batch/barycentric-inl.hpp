// SPDX-License-Identifier: MIT
//
// One straddling triangle whose new vertices come from its three own ones, in double: value =
// sum lambda_i v_i / sum lambda_i, in SIMD over the coordinates and attributes of a vertex.
//
// kCertain, of floats only: the value of each float is known to within a proved bound, and the floats nearest to both ends
// of that interval are the same; else the triangle is handed back, to be settled by expansions.
//
// Lemma (one plane). lambda of an edge is (-d_out, d_in), both positive: doubles within u = 2^-53 of the exact
// distances, relatively. The products of lambda and floats a and b carry one rounding more, their sum
// another, the sum of lambda two in all, its reciprocal and the quotient one each: the numerator is within
// 3 u, to first order, of lambda . (|a|, |b|), and the whole within 7 u of max(|a|, |b|), a convex combination
// being no larger. 16 u covers that, the terms of higher order and the rounding of the interval's ends.
// Nothing under- or overflows: exact_lines.hpp.
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

template <bool kCertain, class S>
struct FromOriginals {
  const S& shape;
  DepthRange depth;

  using D = LanesOf<double, S>;
  using DF = hn::Rebind<float, D>;
  using DU = hn::Rebind<std::uint32_t, D>;
  using Bits = hn::Vec<DU>;

  template <class V>
  HWY_INLINE int cut_one_plane(const Straddler<V>& s, const CodePlane& plane, V* out) const {
    const OnePlane& order = kOnePlane[s.outside(plane.bit)];
    const V *leave_in = s.vertex[order.leave_in], *leave_out = s.vertex[order.leave_out],
            *enter_in = s.vertex[order.enter_in], *enter_out = s.vertex[order.enter_out];
    const double d_leave = distance<double>(plane, leave_in),
                 d_enter = distance<double>(plane, enter_in);
    if (d_leave == 0 || d_enter == 0) return kGiveUp;  // an inside vertex on the plane
    const std::size_t stride = shape.floats();
    copy_vertex(shape, s.vertex[order.first], out);
    copy_vertex(shape, s.vertex[order.second], out + stride);
    V* cut = out + order.inside * stride;
    Bits doubt = hn::Zero(DU());
    const V w = meet_edge(plane, leave_in, leave_out, d_leave, cut, doubt);
    const V next_w = meet_edge(plane, enter_in, enter_out, d_enter, cut + stride, doubt);
    const bool certain = !kCertain || hn::AllTrue(DU(), hn::Eq(doubt, hn::Zero(DU())));
    return certain && w > 0 && next_w > 0 ? order.inside + 2 : kGiveUp;
  }

  // Pre-condition: the cut has three corners or more.
  template <class V>
  HWY_NOINLINE int write(const barycentric::CutTriangle& cut, const Straddler<V>& s, V* out) const {
    int kept = 0;
    for (const barycentric::Corner& corner : cut.corners) {
      V* v = out + kept * shape.floats();
      const int own = barycentric::own_vertex(corner.at);
      if (own >= 0) {
        copy_vertex(shape, s.vertex[own], v);
      } else if (!write_meeting(corner.at, s, v)) {
        return kGiveUp;
      }
      if (v[3] > 0) {
        ++kept;
      } else if (kCertain) {
        return kGiveUp;  // 0, or rounded to it
      }
    }
    return kept < 3 ? 0 : kept;
  }

 private:
  // Bits in which the floats nearest to two doubles differ; the nearest to `low` goes to out.
  static HWY_INLINE Bits store_between(hn::Vec<D> low, hn::Vec<D> high, float* out) {
    const auto a = hn::DemoteTo(DF(), low), b = hn::DemoteTo(DF(), high);
    hn::StoreU(a, DF(), out);
    return hn::Xor(hn::BitCast(DU(), a), hn::BitCast(DU(), b));
  }

  // Ones in all lanes but z's: there it lies on its plane z = 0 and is set.
  static HWY_INLINE Bits but_z() {
    HWY_ALIGN static constexpr std::uint32_t kBits[8] = {~0u, ~0u, 0, ~0u, ~0u, ~0u, ~0u, ~0u};
    return hn::Load(DU(), kBits);
  }

  // Of the edge and the plane; returns w.
  template <class V>
  HWY_INLINE V meet_edge(const CodePlane& plane, const V* in, const V* out_vertex, double d_in,
                         V* out, Bits& doubt) const {
    const double of_in = -distance<double>(plane, out_vertex), of_out = d_in;
    const D d;
    const auto l_in = hn::Set(d, of_in), l_out = hn::Set(d, of_out),
               reciprocal = hn::Set(d, 1 / (of_in + of_out));
    for (std::size_t i = 0; i < shape.width(); i += hn::Lanes(d)) {
      const auto a = load(d, in + i), b = load(d, out_vertex + i);
      const auto sum = hn::Add(hn::Add(hn::Mul(l_in, a), hn::Mul(l_out, b)), hn::Zero(d));
      const auto q = hn::Mul(sum, reciprocal);
      if constexpr (kCertain) {
        const auto error = hn::Mul(hn::Max(hn::Abs(a), hn::Abs(b)), hn::Set(d, 16 * 0x1p-53));
        Bits differ = store_between(hn::Sub(q, error), hn::Add(q, error), out + i);
        if (i == 0 && plane.w_weight == 0) differ = hn::And(differ, but_z());
        doubt = hn::Or(doubt, differ);
      } else {
        store(d, q, out + i);
      }
    }
    const V w = out[3];
    out[plane.axis] = plane.w_weight == 0 ? V(0) : -plane.c_weight * w;
    return w;
  }

  // sum lambda_i v_i / sum lambda_i with the bound of exact_lines.hpp, `rounded_quotient`. Whether that is
  // certain.
  template <class V>
  HWY_INLINE bool write_meeting(const barycentric::Meeting& m, const Straddler<V>& s,
                                V* out) const {
    const barycentric::Bounded sum = barycentric::dot(m, barycentric::kOnes);
    if (kCertain && !(sum.value > 0x1p20 * sum.error)) return false;
    const double reciprocal = 1 / sum.value;
    const D d;
    const auto weight = hn::Set(d, reciprocal * (1 + 0x1p-18)), of_sum = hn::Set(d, sum.error);
    Bits doubt = hn::Zero(DU());
    const bool has_zero_plane = depth != DepthRange::minus_one_to_one;
    for (std::size_t i = 0; i < shape.width(); i += hn::Lanes(d)) {
      auto n = hn::Zero(d), magnitude = hn::Zero(d);
      for (int k = 0; k < 3; ++k) {
        if (m.magnitude[k] == 0) continue;  // takes no part, whatever its attributes
        const auto v = load(d, s.vertex[k] + i);
        n = hn::Add(n, hn::Mul(hn::Set(d, m.lambda[k]), v));
        if (kCertain) {
          magnitude = hn::Add(magnitude, hn::Mul(hn::Set(d, m.magnitude[k]), hn::Abs(v)));
        }
      }
      const auto q = hn::Mul(n, hn::Set(d, reciprocal));
      if constexpr (kCertain) {
        const auto of_n = hn::Mul(magnitude, hn::Set(d, 10 * 0x1p-53));
        const auto error = hn::Add(hn::Mul(hn::Add(of_n, hn::Mul(hn::Abs(q), of_sum)), weight),
                                   hn::Mul(hn::Abs(q), hn::Set(d, 0x1p-51)));
        Bits differ = store_between(hn::Sub(q, error), hn::Add(q, error), out + i);
        if (i == 0 && has_zero_plane && is_on_zero(m)) differ = hn::And(differ, but_z());
        doubt = hn::Or(doubt, differ);
      } else {
        store(d, q, out + i);
      }
    }
    set_on_planes(m, out);
    return !kCertain || hn::AllTrue(DU(), hn::Eq(doubt, hn::Zero(DU())));
  }

  HWY_INLINE bool is_on_zero(const barycentric::Meeting& m) const {
    const Plane zero = depth == DepthRange::reversed ? Plane::far : Plane::near;
    return (barycentric::planes_of(m) & bit(zero)) != 0;
  }

  template <class V>
  HWY_INLINE void set_on_planes(const barycentric::Meeting& m, V* out) const {
    for (const Plane plane : kAllPlanes) {
      if ((barycentric::planes_of(m) & bit(plane)) == 0) continue;
      const auto [axis, bound] = barycentric::plane_form(depth, plane);
      out[axis] = bound == 0 ? V(0) : bound * out[3];
    }
  }
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
