// SPDX-License-Identifier: MIT
//
// The full contract of the method correctly_rounded. Triangles that are inside, or that one plane cuts, are
// projected, cut and divided in double; where a proved bound leaves only one nearest float for each
// coordinate and attribute, that is it. The others that survive go to the plain version.
//
// Sides are exact: a distance is a sum of two products of floats, or of two floats, in double, and rounding
// keeps its sign. That of a sheared projection has three terms, so all of its triangles go to the plain
// version.
//
// Lemma (own vertices). u = 2^-53. An entry of the matrix passes through at most three roundings, its product
// with a float through one more, the sum through two: a clip coordinate is within 6 u m, to first order,
// m = |own c| + |z_weight z| + |one|; w is exact. With the roundings of 1/w and of the product the
// quotient is within 8 u m / w. 16 u m / w covers that, the terms of higher order and the rounding of
// the interval's ends.
//
// Lemma (a cut edge). The weights, distances, are within u. Hence the numerator, l_a c_a + l_b c_b, is within
// 9 u M, M = l_a m_a + l_b m_b, and the denominator D = l_a w_a + l_b w_b within 3 u W, W of |w|. If D is
// certain to twenty bits, q is within (9 u M + |q| 3 u W) / D (1 + 2^-19) + 2 u |q|. Attributes are as
// in barycentric-inl.hpp.
#if defined(CLIPSCOPE_BATCH_FULL_ROUNDED_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_FULL_ROUNDED_INL
#undef CLIPSCOPE_BATCH_FULL_ROUNDED_INL
#else
#define CLIPSCOPE_BATCH_FULL_ROUNDED_INL
#endif

#include "spaces/barycentric/exact_corners.hpp"
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
  // By the bit of a plane.
  HWY_ALIGN double own_[8] = {}, z_weight_[8] = {}, constant_[8] = {};
};

// The places of a triangle's vertices that one plane cuts in the order of the plain version: of kApex's first, of
// its c if that is inside, and of the cuts of apex-b and apex-c. By the mask of outside vertices, 1 to 6.
struct Places {
  std::uint8_t first, c, cut_b, cut_c;
};
inline constexpr Places kPlaces[7] = {{},           {1, 2, 0, 3}, {3, 0, 2, 1}, {1, 0, 2, 0},
                                      {0, 1, 3, 2}, {1, 0, 2, 0}, {0, 0, 1, 2}};

template <int K>
class FullRoundedClipper {
 public:
  FullRoundedClipper(const Projection<float>& projection, int attributes)
      : projection_(projection),
        attributes_(K == kRunTime ? static_cast<std::size_t>(attributes) : K),
        sides_(projection.frustum),
        lanes_(Projection<double>(frustum_cast<double>(projection.frustum))) {
    const auto planes = view_code_planes(projection.frustum);  // in the order of `kAllPlanes`
    for (std::size_t i = 0; i < kPlanes; ++i) {
      cuts_[planes[i].bit] = {planes[i],
                              barycentric::plane_form(projection.volume.depth, kAllPlanes[i])};
    }
  }

  void operator()(const ViewVertexArray& in, Output& out) const {
    const OutputAccess access{out};
    access.begin(in.attributes);
    const std::size_t triangles = in.count / 3;
    for (std::size_t first = 0; first < triangles; first += kBlock) {
      const std::size_t count = std::min(kBlock, triangles - first);
      Writer writer = access.block(count);
      for (std::size_t t = first; t < first + count; ++t) {
        clip(in.data + 3 * t * stride_in(), t, writer, access.tally());
      }
      access.commit(writer);
    }
  }

 private:
  using D = hn::CappedTag<double, 4>;

  // A plane of the frustum, and the coordinate that it fixes in NDC.
  struct Cut {
    ViewCodePlane plane;
    barycentric::PlaneForm fixed;
  };

  // A vertex in clip space, and the magnitudes m of the lemma; w last.
  struct Point {
    HWY_ALIGN double clip[4], magnitude[4];
  };

  std::size_t stride_in() const { return 3 + attributes_; }
  std::size_t stride_out() const { return 4 + attributes_; }

  HWY_INLINE void clip(const float* triangle, std::size_t number, Writer& writer,
                       Tally& tally) const {
    HWY_ALIGN float memory[3][4] = {};
    const float* vertex[3];
    for (std::size_t i = 0; i < 3; ++i) {
      vertex[i] = triangle + i * stride_in();
      if (attributes_ == 0) {  // there is no fourth float behind the last vertex
        std::memcpy(memory[i], vertex[i], 3 * sizeof(float));
        vertex[i] = memory[i];
      }
    }
    const unsigned a = sides_.code(vertex[0]), b = sides_.code(vertex[1]),
                   c = sides_.code(vertex[2]), any = a | b | c;
    if ((a & b & c) != 0) {
      ++tally.rejected;
      return;
    }
    int count = (any & (any - 1)) == 0 ? clip_in_double(vertex, any, writer.next) : kGiveUp;
    ++(count == kGiveUp ? tally.plain : any == 0 ? tally.inside : tally.one_plane);
    if (count == kGiveUp) {
      count = plain::cut_full(Method::correctly_rounded, projection_, static_cast<int>(attributes_),
                              triangle, writer.next);
    }
    writer.add(number, count);
  }

  // any: no plane or one.
  HWY_INLINE int clip_in_double(const float* const vertex[3], unsigned any, float* out) const {
    Point points[3];
    for (int i = 0; i < 3; ++i) {
      lanes_.project(vertex[i], points[i].clip, points[i].magnitude);
      if (!is_finite(points[i])) return kGiveUp;
    }
    if (any != 0) return cut(vertex, points, cuts_[std::countr_zero(any)], out);
    bool certain = true;
    for (int i = 0; i < 3; ++i) {
      certain = write_own(vertex[i], points[i], out + i * stride_out()) && certain;
    }
    return certain ? 3 : kGiveUp;
  }

  // Finite floats give numbers far below this, times an entry of the matrix.
  static HWY_INLINE bool is_finite(const Point& p) {
    const D d;
    bool finite = true;
    for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
      finite = finite && hn::AllTrue(d, hn::Le(hn::Load(d, p.magnitude + i), hn::Set(d, 0x1p600)));
    }
    return finite;
  }

  HWY_INLINE int cut(const float* const vertex[3], const Point* points, const Cut& cut,
                     float* out) const {
    const double d[3] = {distance<double>(cut.plane, vertex[0]),
                         distance<double>(cut.plane, vertex[1]),
                         distance<double>(cut.plane, vertex[2])};
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
                        vertex[end], points[end], cut, at(place));
    };
    certain = write(order.b, places.cut_b) && certain;
    certain = write(order.c, places.cut_c) && certain;
    return certain ? order.size : kGiveUp;
  }

  // Stores the float nearest to all between the ends; whether there is only one. Fixed lanes are of no matter.
  static HWY_INLINE bool store_nearest(hn::Vec<D> low, hn::Vec<D> high, hn::Mask<D> fixed,
                                       float* out) {
    const D d;
    const hn::Rebind<float, D> df;
    const hn::Rebind<std::uint32_t, D> du;
    const auto a = hn::DemoteTo(df, low), b = hn::DemoteTo(df, hn::IfThenElse(fixed, low, high));
    hn::StoreU(a, df, out);
    return hn::AllTrue(du, hn::Eq(hn::BitCast(du, a), hn::BitCast(du, b)));
  }

  HWY_INLINE bool write_own(const float* vertex, const Point& p, float* out) const {
    const D d;
    const double reciprocal = 1 / p.clip[3];
    const auto one = hn::Set(d, 1.0), by = hn::Set(d, reciprocal),
               weight = hn::Set(d, 16 * 0x1p-53 * reciprocal);
    bool certain = true;
    for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
      const auto is_coordinate = hn::FirstN(d, 3 - i);
      const auto n = hn::IfThenElse(is_coordinate, hn::Load(d, p.clip + i), one),
                 m = hn::IfThenElse(is_coordinate, hn::Load(d, p.magnitude + i), one);
      const auto error = hn::Mul(m, weight);
      certain = store_nearest(hn::MulSub(n, by, error), hn::MulAdd(n, by, error), hn::FirstN(d, 0),
                              out + i) &&
                certain;
    }
    for (std::size_t k = 0; k < attributes_; ++k) out[4 + k] = vertex[3 + k] + 0.0f;  // zeros: +0
    return certain;
  }

  // A point of the edge between vertices a and b, on the plane.
  HWY_INLINE bool write_mean(double l_a, const float* a, const Point& p_a, double l_b,
                             const float* b, const Point& p_b, const Cut& cut, float* out) const {
    constexpr double u = 0x1p-53;
    const D d;
    const double w = l_a * p_a.clip[3] + l_b * p_b.clip[3],
                 w_error = 4 * u * (l_a * p_a.magnitude[3] + l_b * p_b.magnitude[3]);
    if (!(w > 0x1p20 * w_error)) return false;
    const double reciprocal = 1 / w;
    const auto v_a = hn::Set(d, l_a), v_b = hn::Set(d, l_b), one = hn::Set(d, 1.0),
               by = hn::Set(d, reciprocal), of_m = hn::Set(d, 12 * u * reciprocal),
               of_q = hn::Set(d, 2 * w_error * reciprocal + 8 * u);
    bool certain = true;
    for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
      const auto is_coordinate = hn::FirstN(d, 3 - i);
      const auto at = [&](const double* lanes) {
        return hn::IfThenElse(is_coordinate, hn::Load(d, lanes + i), one);
      };
      const auto q = hn::Mul(hn::MulAdd(v_a, at(p_a.clip), hn::Mul(v_b, at(p_b.clip))), by);
      const auto m = hn::MulAdd(v_a, at(p_a.magnitude), hn::Mul(v_b, at(p_b.magnitude)));
      const auto error = hn::MulAdd(m, of_m, hn::Mul(hn::Abs(q), of_q));
      const auto fixed = hn::Eq(hn::Iota(d, static_cast<double>(i)),
                                hn::Set(d, static_cast<double>(cut.fixed.axis)));
      certain = store_nearest(hn::Sub(q, error), hn::Add(q, error), fixed, out + i) && certain;
    }
    out[cut.fixed.axis] = cut.fixed.bound;
    return write_mean_attributes(l_a, a + 3, l_b, b + 3, out + 4) && certain;
  }

  HWY_INLINE bool write_mean_attributes(double l_a, const float* a, double l_b, const float* b,
                                        float* out) const {
    const double reciprocal = 1 / (l_a + l_b);
    bool certain = true;
    for (std::size_t k = 0; k < attributes_; ++k) {
      const double v_a = a[k], v_b = b[k], q = (l_a * v_a + l_b * v_b) * reciprocal,
                   error = std::max(std::abs(v_a), std::abs(v_b)) * kEdgeError;
      const float low = static_cast<float>(q - error), high = static_cast<float>(q + error);
      out[k] = low;
      certain &= std::bit_cast<std::uint32_t>(low) == std::bit_cast<std::uint32_t>(high);
    }
    return certain;
  }

  const Projection<float>& projection_;
  const std::size_t attributes_;
  const ExactSides sides_;
  const ProjectionLanes<double> lanes_;
  std::array<Cut, 8> cuts_{};  // by the bit of a plane
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
