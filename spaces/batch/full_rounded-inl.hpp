// SPDX-License-Identifier: MIT
//
// The full contract of correctly rounded methods. Triangles are projected, cut and divided in
// double; where a proved bound leaves only one nearest float for each coordinate and attribute, and
// only one side of a plane for each corner, that is it. The others that survive go to the plain
// version.
//
// Sides are exact: a distance is a sum of two products of floats, or of two floats, in double, and
// rounding keeps its sign. That of a sheared projection has three terms, so all of its triangles go
// to the plain version.
//
// Lemma (own vertices). u = 2^-53. An entry of the matrix passes through at most three roundings,
// its product with a float through one more, the sum through two: a clip coordinate is within 6 u
// m, to first order, m = |own c| + |z_weight z| + |one|; w is exact. With the roundings of 1/w and
// of the product the quotient is within 8 u m / w. 16 u m / w covers that, the terms of higher
// order and the rounding of the interval's ends.
//
// Lemma (a cut edge). The weights, distances, are within u. Hence the numerator, l_a c_a + l_b c_b,
// is within 9 u M, M = l_a m_a + l_b m_b, and the denominator D = l_a w_a + l_b w_b within 3 u W, W
// of |w|. If D is certain to twenty bits, q is within (9 u M + |q| 3 u W) / D (1 + 2^-19) + 2 u
// |q|. Attributes are as in barycentric-inl.hpp.
//
// Lemma (a meeting of two planes). Each weight is a difference of two products of distances, within
// 4 u, to first order, of the sum of their magnitudes. In sums of three products with these the
// numerator is within 13 u M and the denominator within 7 u W, M and W now with the magnitudes of
// the weights; the quotient follows as on an edge. Sides and attributes are as in
// barycentric-inl.hpp. A denominator above kSmallestDenominator keeps whatever underflows, below
// 2^-1070, far from any float's half. Why zeros have the right sign: reference/proofs/README.md.
#if defined(CLIPSCOPE_BATCH_FULL_ROUNDED_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_FULL_ROUNDED_INL
#undef CLIPSCOPE_BATCH_FULL_ROUNDED_INL
#else
#define CLIPSCOPE_BATCH_FULL_ROUNDED_INL
#endif

#include "spaces/barycentric/exact_corners.hpp"
#include "spaces/batch/error_bounds.hpp"
#include "spaces/batch/full-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

// The exact outcode of a view-space vertex, of which four floats have to be readable.
class ExactSides {
  using D = hn::CappedTag<double, 4>;

 public:
  explicit ExactSides(const Frustum<float>& frustum) {
    for (const ViewCodePlane& plane : view_code_planes(frustum)) {
      own_[plane.bit] = plane.own;
      z_weight_[plane.bit] = plane.z_weight;
      constant_[plane.bit] = plane.constant;
    }
  }

  HWY_INLINE unsigned code(const float* v) const {
    const D d;
    const auto z = hn::Set(d, static_cast<double>(v[2]));
    unsigned inside = 0;
    for (std::size_t lane = 0; lane < 8; lane += hn::Lanes(d)) {
      const auto sum = hn::Add(hn::Mul(hn::Load(d, own_ + lane), load(d, v + lane % 4)),
                               hn::Mul(hn::Load(d, z_weight_ + lane), z));
      const auto distance = hn::Add(sum, hn::Load(d, constant_ + lane));
      inside |= mask_bits(d, hn::Le(hn::Zero(d), distance)) << lane;
    }
    return ~inside & kPlaneBits;
  }

 private:
  // Indexed by the bit of a plane.
  HWY_ALIGN double own_[8] = {}, z_weight_[8] = {}, constant_[8] = {};
};

// The places of a triangle's vertices that one plane cuts in the order of the plain version: of
// kApex's first, of its c if that is inside, and of the cuts of apex-b and apex-c. Indexed by the
// mask of outside vertices, 1 to 6.
struct Places {
  std::uint8_t first, c, cut_b, cut_c;
};
inline constexpr Places kPlaces[7] = {{},           {1, 2, 0, 3}, {3, 0, 2, 1}, {1, 0, 2, 0},
                                      {0, 1, 3, 2}, {1, 0, 2, 0}, {0, 0, 1, 2}};

template <class M, int K>
class FullRoundedClipper {
 public:
  // Distances to the planes of a sheared volume are not exact in double.
  static bool takes(const Frustum<float>& f) { return f.shear_x == 0 && f.shear_y == 0; }

  FullRoundedClipper(const Projection<float>& projection, int attributes)
      : projection_(projection),
        attributes_(K == kRunTime ? static_cast<std::size_t>(attributes) : K),
        planes_(view_code_planes(projection.frustum)),
        sides_(projection.frustum),
        lanes_(Projection<double>(frustum_cast<double>(projection.frustum))) {
    for (std::size_t i = 0; i < kPlanes; ++i) {
      fixed_[i] = barycentric::plane_form(projection.volume.depth, kAllPlanes[i]);
      by_bit_[planes_[i].bit] = i;
    }
  }

  void operator()(const ViewVertexArray& in, Output& out) {
    const OutputAccess access{out};
    access.begin(in.attributes);
    const std::size_t triangles = in.count / 3;
    for (std::size_t first = 0; first < triangles; first += kBlock) {
      const std::size_t count = std::min(kBlock, triangles - first);
      clip_block(in.data + 3 * first * stride_in(), first, count, access);
    }
  }

 private:
  using D = hn::CappedTag<double, 4>;

  using Lanes = CornerLanes<true, float, ViewCodePlane>;
  using Fixed = barycentric::PlaneForm;  // the coordinate that a plane fixes in NDC

  // A vertex in clip space, and the magnitudes m of the lemma; w last.
  struct Point {
    HWY_ALIGN double clip[4], magnitude[4];
  };

  std::size_t stride_in() const { return 3 + attributes_; }
  std::size_t stride_out() const { return 4 + attributes_; }

  // Triangles from number `first` on.
  HWY_INLINE void clip_block(const float* triangles, std::size_t first, std::size_t count,
                             const OutputAccess& access) {
    const float* const vertices = readable(triangles, count);
    classify(vertices, count);
    Writer writer = access.block(survivors_.count);
    access.tally().rejected += count - survivors_.count;
    queue_.begin(Cuts(survivors_).other);
    for (std::size_t i = 0; i < survivors_.count; ++i) {
      const std::size_t t = survivors_.triangle[i];
      int size = clip_in_double(vertices, i, writer.next);
      const unsigned any = survivors_.any[i];
      Tally& tally = access.tally();
      ++(size == kGiveUp     ? tally.plain
         : any == 0          ? tally.inside
         : is_one_plane(any) ? tally.one_plane
                             : tally.planes);
      if (size == kGiveUp) {
        size = plain::cut_full(kMethod<M>, projection_, static_cast<int>(attributes_),
                               triangles + 3 * t * stride_in(), writer.next);
      }
      writer.add(first + t, size);
    }
    access.commit(writer);
  }

  // The triangles so that four floats of each vertex may be read.
  HWY_INLINE const float* readable(const float* triangles, std::size_t count) {
    if (attributes_ != 0) return triangles;
    for (std::size_t v = 0; v < 3 * count; ++v) {
      std::memcpy(positions_[v], triangles + 3 * v, 3 * sizeof(float));
    }
    return positions_[0];
  }
  const float* vertex(const float* vertices, std::size_t t, int v) const {
    return vertices + (3 * t + static_cast<std::size_t>(v)) * std::max<std::size_t>(4, stride_in());
  }

  HWY_INLINE void classify(const float* vertices, std::size_t count) {
    survivors_.count = 0;
    for (std::size_t t = 0; t < count; ++t) {
      const unsigned a = sides_.code(vertex(vertices, t, 0)),
                     b = sides_.code(vertex(vertices, t, 1)),
                     c = sides_.code(vertex(vertices, t, 2));
      survivors_.add(t, {a & b & c, a | b | c});
    }
  }

  // Survivor i.
  HWY_INLINE int clip_in_double(const float* vertices, std::size_t i, float* out) {
    const auto at = [&](std::size_t survivor, int v) {
      return vertex(vertices, survivors_.triangle[survivor], v);
    };
    const float* const own[3] = {at(i, 0), at(i, 1), at(i, 2)};
    const unsigned any = survivors_.any[i];
    Point points[3];
    bool finite = true;
    for (int v = 0; v < 3; ++v) {
      lanes_.project(own[v], points[v].clip, points[v].magnitude);
      finite = finite && is_finite(points[v]);
    }
    if (any != 0 && !is_one_plane(any)) {
      const std::size_t lane = next_lane(at);
      return finite ? cut_planes(own, points, lane, out) : kGiveUp;
    }
    if (!finite) return kGiveUp;
    if (any != 0) return cut(own, points, by_bit_[std::countr_zero(any)], out);
    bool certain = true;
    for (int v = 0; v < 3; ++v) {
      certain = write_own(own[v], points[v], out + v * stride_out()) && certain;
    }
    return certain ? 3 : kGiveUp;
  }

  template <class At>
  HWY_INLINE std::size_t next_lane(At& at) {
    return queue_.next([&](std::span<const std::size_t> members) {
      corners_.cut(planes_, members.size(),
                   [&](std::size_t in, int v) { return at(members[in], v); });
    });
  }

  // Finite floats give numbers far below this, times an entry of the matrix.
  static HWY_INLINE bool is_finite(const Point& p) {
    const D d;
    bool finite = true;
    for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
      finite = finite && hn::AllTrue(d, hn::Le(hn::Load(d, p.magnitude + i), hn::Set(d, 0x1p400)));
    }
    return finite;
  }

  // plane: its place in `planes_`.
  HWY_INLINE int cut(const float* const vertex[3], const Point* points, std::size_t plane,
                     float* out) const {
    const double d[3] = {distance<double>(planes_[plane], vertex[0]),
                         distance<double>(planes_[plane], vertex[1]),
                         distance<double>(planes_[plane], vertex[2])};
    if (d[0] == 0 || d[1] == 0 || d[2] == 0) return kGiveUp;  // a vertex on the plane
    const unsigned outside = outside_mask(d);
    const Apex& order = kApex[outside];
    const Places& places = kPlaces[outside];
    const auto at = [&](int place) { return out + place * stride_out(); };
    bool certain = write_own(vertex[order.first], points[order.first], at(places.first));
    if (order.size == 4) {
      certain = write_own(vertex[order.c], points[order.c], at(places.c)) && certain;
    }
    const auto write = [&](int end, int place) {
      const int apex = order.apex;
      return write_mean(std::abs(d[end]), vertex[apex], points[apex], std::abs(d[apex]),
                        vertex[end], points[end], fixed_[plane], at(place));
    };
    certain = write(order.b, places.cut_b) && certain;
    certain = write(order.c, places.cut_c) && certain;
    return certain ? order.size : kGiveUp;
  }

  // A triangle in a lane.
  HWY_NOINLINE int cut_planes(const float* const vertex[3], const Point* points, std::size_t lane,
                              float* out) const {
    if (!corners_.is_certain(lane)) return kGiveUp;
    const int size = corners_.size(lane);
    bool certain = true;
    for (int i = 0; i < size; ++i, out += stride_out()) {
      const int own = corners_.own(lane, i);
      certain = certain && (own >= 0 ? write_own(vertex[own], points[own], out)
                                     : write_corner(corners_.corner(lane, i), vertex, points, out));
    }
    return certain ? size : kGiveUp;
  }

  HWY_INLINE bool write_corner(const typename Lanes::Corner& c, const float* const vertex[3],
                               const Point* points, float* out) const {
    const int low = std::min(c.from, c.to), high = std::max(c.from, c.to);
    if (low < 3) {
      const int a = low == 0 ? 1 : 0, b = low == 2 ? 1 : 2;
      return write_mean(c.lambda[a], vertex[a], points[a], c.lambda[b], vertex[b], points[b],
                        fixed_of(high), out);
    }
    const bool certain = write_meeting(c, points, fixed_of(low), fixed_of(high), out);
    return certain && write_meeting_attributes(c, vertex, out + 4);
  }

  // Stores the float nearest to all between the ends; whether there is only one. Fixed lanes are of
  // no matter.
  static HWY_INLINE bool store_nearest(hn::Vec<D> low, hn::Vec<D> high, hn::Mask<D> fixed,
                                       float* out) {
    const hn::Rebind<float, D> df;
    const hn::Rebind<std::uint32_t, D> du;
    const auto a = hn::DemoteTo(df, low), b = hn::DemoteTo(df, hn::IfThenElse(fixed, low, high));
    hn::StoreU(a, df, out);
    return hn::AllTrue(du, hn::Eq(hn::BitCast(du, a), hn::BitCast(du, b)));
  }

  HWY_INLINE bool write_own(const float* vertex, const Point& p, float* out) const {
    const D d;
    const double reciprocal = 1 / p.clip[3];
    const auto by = hn::Set(d, reciprocal), weight = hn::Set(d, kOwnVertexError * reciprocal);
    bool certain = true;
    for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
      const auto n = lanes_or_one(p.clip, i);
      const auto error = hn::Mul(lanes_or_one(p.magnitude, i), weight);
      certain = store_nearest(hn::MulSub(n, by, error), hn::MulAdd(n, by, error), hn::FirstN(d, 0),
                              out + i) &&
                certain;
    }
    for (std::size_t k = 0; k < attributes_; ++k) out[4 + k] = vertex[3 + k] + 0.0f;  // zeros: +0
    return certain;
  }

  // Lanes from i on of x, y, z and of 1 for w.
  static HWY_INLINE hn::Vec<D> lanes_or_one(const double* lanes, std::size_t i) {
    const D d;
    return hn::IfThenElse(hn::FirstN(d, 3 - i), hn::Load(d, lanes + i), hn::Set(d, 1.0));
  }

  // Sums of terms over w, which is certain within w_error, the sums within m_error of those of
  // magnitudes; whether all lanes but the fixed ones are certain. Each function gives lanes from i
  // on.
  template <class Sums, class Magnitudes, class FixedLanes>
  static HWY_INLINE bool write_quotients(Sums&& sums, Magnitudes&& magnitudes, double w,
                                         double w_error, double m_error, FixedLanes&& fixed,
                                         float* out) {
    const D d;
    const double reciprocal = 1 / w;
    const auto by = hn::Set(d, reciprocal), of_m = hn::Set(d, m_error * reciprocal),
               of_q = hn::Set(d, kOfDenominator * w_error * reciprocal + kFullQuotientRoundings);
    bool certain = true;
    for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
      const auto q = hn::Mul(sums(i), by);
      const auto error = hn::MulAdd(magnitudes(i), of_m, hn::Mul(hn::Abs(q), of_q));
      certain = store_nearest(hn::Sub(q, error), hn::Add(q, error), fixed(i), out + i) && certain;
    }
    return certain;
  }

  // A point of the edge between vertices a and b, on the plane.
  HWY_INLINE bool write_mean(double l_a, const float* a, const Point& p_a, double l_b,
                             const float* b, const Point& p_b, const Fixed& fixed,
                             float* out) const {
    const D d;
    const double w = l_a * p_a.clip[3] + l_b * p_b.clip[3],
                 w_error =
                     kEdgeDenominatorError * (l_a * p_a.magnitude[3] + l_b * p_b.magnitude[3]);
    if (!(w > barycentric::kDivisorCertainty * w_error)) return false;
    const auto v_a = hn::Set(d, l_a), v_b = hn::Set(d, l_b);
    const auto sums = [&](const double* of_a, const double* of_b, std::size_t i) {
      return hn::MulAdd(v_a, lanes_or_one(of_a, i), hn::Mul(v_b, lanes_or_one(of_b, i)));
    };
    const bool certain = write_quotients(
        [&](std::size_t i) { return sums(p_a.clip, p_b.clip, i); },
        [&](std::size_t i) { return sums(p_a.magnitude, p_b.magnitude, i); }, w, w_error,
        kEdgeNumeratorError, [&](std::size_t i) { return lane_of(fixed, i); }, out);
    out[fixed.axis] = fixed.bound;
    return write_mean_attributes(l_a, a + 3, l_b, b + 3, out + 4) && certain;
  }

  HWY_INLINE bool write_mean_attributes(double l_a, const float* a, double l_b, const float* b,
                                        float* out) const {
    const double reciprocal = 1 / (l_a + l_b);
    bool certain = true;
    for (std::size_t k = 0; k < attributes_; ++k) {
      const double v_a = a[k], v_b = b[k], q = (l_a * v_a + l_b * v_b) * reciprocal,
                   error = std::max(std::abs(v_a), std::abs(v_b)) * kEdgeError;
      certain &= store_nearest(q - error, q + error, out[k]);
    }
    return certain;
  }

  // Lanes from i on: that of the coordinate which is fixed.
  static HWY_INLINE hn::Mask<D> lane_of(const Fixed& fixed, std::size_t i) {
    const D d;
    return hn::Eq(hn::Iota(d, static_cast<double>(i)), hn::Set(d, static_cast<double>(fixed.axis)));
  }

  const Fixed& fixed_of(int line) const { return fixed_[static_cast<std::size_t>(line - 3)]; }

  // The position of a point of the triangle on two planes.
  HWY_INLINE bool write_meeting(const typename Lanes::Corner& c, const Point* points,
                                const Fixed& first, const Fixed& second, float* out) const {
    const auto sum = [&](const double* weights, auto of) {
      return weights[0] * of(points[0]) + weights[1] * of(points[1]) + weights[2] * of(points[2]);
    };
    const double w = sum(c.lambda, [](const Point&p) { return p.clip[3]; }),
                 w_error = kMeetingDenominatorError *
                           sum(c.magnitude, [](const Point&p) { return p.magnitude[3]; });
    if (!(w > barycentric::kDivisorCertainty * w_error && w > kSmallestDenominator)) return false;
    const D d;
    const auto sums = [&](const double* weights, double(Point::*of)[4], std::size_t i) {
      const auto term = [&](int v) { return lanes_or_one(points[v].*of, i); };
      return hn::MulAdd(
          hn::Set(d, weights[2]), term(2),
          hn::MulAdd(hn::Set(d, weights[1]), term(1), hn::Mul(hn::Set(d, weights[0]), term(0))));
    };
    const bool certain = write_quotients(
        [&](std::size_t i) { return sums(c.lambda, &Point::clip, i); },
        [&](std::size_t i) { return sums(c.magnitude, &Point::magnitude, i); }, w, w_error,
        kMeetingNumeratorError,
        [&](std::size_t i) { return hn::Or(lane_of(first, i), lane_of(second, i)); }, out);
    out[first.axis] = first.bound;
    out[second.axis] = second.bound;
    return certain;
  }

  HWY_INLINE bool write_meeting_attributes(const typename Lanes::Corner& c,
                                           const float* const vertex[3], float* out) const {
    const double total = c.lambda[0] + c.lambda[1] + c.lambda[2],
                 total_error =
                     kMeetingWeightError * (c.magnitude[0] + c.magnitude[1] + c.magnitude[2]);
    if (!(total > barycentric::kDivisorCertainty * total_error)) return false;
    const double reciprocal = 1 / total,
                 of_largest = total_error / total * kMeanError + kMeanRoundings;
    bool certain = true;
    for (std::size_t k = 3; k < 3 + attributes_; ++k) {
      const double v[3] = {vertex[0][k], vertex[1][k], vertex[2][k]},
                   q = (c.lambda[0] * v[0] + c.lambda[1] * v[1] + c.lambda[2] * v[2]) * reciprocal,
                   error = of_largest *
                           std::max(std::abs(v[0]), std::max(std::abs(v[1]), std::abs(v[2])));
      certain &= store_nearest(q - error, q + error, *out++);
    }
    return certain;
  }

  // The same of one float.
  static HWY_INLINE bool store_nearest(double low, double high, float& out) {
    out = static_cast<float>(low);
    return std::bit_cast<std::uint32_t>(out) ==
           std::bit_cast<std::uint32_t>(static_cast<float>(high));
  }

  const Projection<float>& projection_;
  const std::size_t attributes_;
  const std::array<ViewCodePlane, kPlanes> planes_;  // in the order of `kAllPlanes`
  const ExactSides sides_;
  const ProjectionLanes<double> lanes_;
  std::array<Fixed, kPlanes> fixed_{};   // by the place in `planes_`
  std::array<std::size_t, 8> by_bit_{};  // places in `planes_`
  Survivors survivors_;                  // of a block
  Lanes corners_;
  LaneQueue<Lanes::kLanes> queue_;
  float positions_[3 * kBlock][4] = {};  // without attributes
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
