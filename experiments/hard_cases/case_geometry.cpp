// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hard_cases/case_geometry.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/report/outcode_text.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments {
namespace {

using reference::Rational;
using reference::to_rational;

ExactPosition ndc_position(const reference::ExactVertex& v) {
  return {to_rational(v.x), to_rational(v.y), to_rational(v.z), to_rational(v.inv_w)};
}

// (x, y, z, 1) w. Pre-condition: 1/w isn't 0.
ExactPosition clip_position(const ExactPosition& ndc) {
  return {ndc[0] / ndc[3], ndc[1] / ndc[3], ndc[2] / ndc[3], Rational(1) / ndc[3]};
}

// Solves one row of the projection, scale * clip = own * view + z * view_z + one, for the view
// coordinate.
Rational unprojected(const reference::ProjectionForm& row, int own, const Rational& clip,
                     const Rational& view_z) {
  const auto coefficient = [&](int c) {
    return to_rational(row.coefficients[static_cast<std::size_t>(c)]);
  };
  Rational rest = to_rational(row.scale) * clip - coefficient(reference::kOne);
  if (own != 2) rest -= coefficient(2) * view_z;
  return rest / coefficient(own);
}

// Perspective: w = -z_view.
ExactPosition view_position(const HardCase& hard_case, const reference::Truth& truth,
                            const ExactPosition& clip) {
  const auto& rows = truth.projection();
  const bool perspective = hard_case.frustum.kind == ProjectionKind::perspective;
  const Rational z =
      perspective ? Rational(-clip[3]) : unprojected(rows[2], 2, clip[2], Rational(0));
  return {unprojected(rows[0], 0, clip[0], z), unprojected(rows[1], 1, clip[1], z), z, Rational(1)};
}

std::string place_of(const HardCase& hard_case, const reference::InputVertex& vertex,
                     const ExactPosition& clip) {
  const Vec4<Rational> position(clip[0], clip[1], clip[2], clip[3]);
  Outcode code = clip_outcode(hard_case.volume.depth, position) & planes_of(hard_case.volume);
  for (int i = 0; i < hard_case.volume.clip_distances; ++i) {
    if (vertex.attributes[static_cast<std::size_t>(i)] < 0) {
      code |= bit(static_cast<Plane>(kPlanes + i));
    }
  }
  // Where w = 0 only the planes of depth that a clamp leaves out can tell it from the point at 0.
  return code == 0 && clip[3] == 0 ? "outside by definition" : outcode_text(code);
}

void add_input(const HardCase& hard_case, const reference::Truth& truth, CaseGeometry& geometry) {
  for (const reference::InputVertex& v : hard_case.vertices) {
    const ExactPosition clip = truth.clip_position(v);
    geometry.input_clip.push_back(clip);
    geometry.behind.push_back(clip[3] <= 0);
    geometry.places.push_back(place_of(hard_case, v, clip));
    if (hard_case.space == Space::view) {
      const auto& p = v.position;
      geometry.input_view.push_back(
          {to_rational(p[0]), to_rational(p[1]), to_rational(p[2]), Rational(1)});
    }
  }
}

void add_visible(const HardCase& hard_case, const reference::Truth& truth,
                 const reference::ExactPolygon& polygon, CaseGeometry& geometry) {
  for (const reference::ExactVertex& v : polygon.vertices) {
    const ExactPosition ndc = ndc_position(v), clip = clip_position(ndc);
    geometry.visible_ndc.push_back(ndc);
    geometry.visible_clip.push_back(clip);
    if (hard_case.space == Space::view) {
      geometry.visible_view.push_back(view_position(hard_case, truth, clip));
    }
  }
}

void add_answer(const CaseAnswer& answer, CaseGeometry& geometry) {
  for (const std::array<double, 4>& v : answer.polygon) {
    // 1/w may overflow; nothing here shows it.
    if (std::all_of(v.begin(), v.begin() + 3, [](double x) { return std::isfinite(x); })) {
      const double inv_w = std::isfinite(v[3]) ? v[3] : 0.0;
      geometry.answer_ndc.push_back(
          {to_rational(v[0]), to_rational(v[1]), to_rational(v[2]), to_rational(inv_w)});
    } else {
      ++geometry.answer_not_finite;
    }
  }
}

double px_between(const ExactPosition& a, const ExactPosition& b) {
  const auto offset = to_screen(a, b);
  return std::hypot(CGAL::to_double(offset[0]), CGAL::to_double(offset[1]));
}

const ExactPosition& nearest(const ExactShape& shape, const ExactPosition& to) {
  return *std::ranges::min_element(shape, {},
                                   [&](const ExactPosition& p) { return px_between(p, to); });
}

// x z if coordinate is 0, y z if it is 1.
ExactShape frustum_outline(const HardCase& hard_case, double farthest, std::size_t coordinate) {
  const Frustum<double>& f = hard_case.frustum;
  const bool perspective = f.kind == ProjectionKind::perspective;
  const bool clamp = hard_case.volume.depth_clamp;
  const bool x = coordinate == 0;
  const Rational low = x ? f.left : f.bottom, high = x ? f.right : f.top;
  const Rational shear = x ? f.shear_x : f.shear_y;
  const Rational near = f.near;
  const Rational front = !clamp ? f.near : perspective ? 0.0 : -farthest;
  const Rational far = clamp || f.infinite_far || f.far > farthest ? farthest : f.far;
  const auto corner = [&](const Rational& bound, const Rational& depth) {
    ExactPosition p{Rational(0), Rational(0), Rational(-depth), Rational(1)};
    p[coordinate] = perspective ? Rational(bound * depth / near) : Rational(bound + shear * depth);
    return p;
  };
  return {corner(low, front), corner(high, front), corner(high, far), corner(low, far)};
}

}  // namespace

CaseGeometry case_geometry(const HardCase& hard_case, const TruthPolygon& truth,
                           const CaseAnswer& answer) {
  CaseGeometry geometry;
  const reference::Truth volume = truth_of(hard_case);
  add_input(hard_case, volume, geometry);
  add_visible(hard_case, volume, truth.exact, geometry);
  add_answer(answer, geometry);
  return geometry;
}

std::array<Rational, 2> to_screen(const ExactPosition& from, const ExactPosition& to) {
  return {(to[0] - from[0]) * Rational(kScreenWidth / 2),
          (to[1] - from[1]) * Rational(kScreenHeight / 2)};
}

std::optional<ScreenError> largest_screen_error(const CaseGeometry& geometry) {
  if (geometry.visible_ndc.empty() || geometry.answer_ndc.empty()) return {};
  ScreenError largest;
  const auto consider = [&](const ExactPosition& exact, const ExactPosition& answer) {
    const double px = px_between(exact, answer);
    if (px > largest.px) largest = {exact, answer, px};
  };
  for (const ExactPosition& v : geometry.answer_ndc) consider(nearest(geometry.visible_ndc, v), v);
  for (const ExactPosition& v : geometry.visible_ndc) consider(v, nearest(geometry.answer_ndc, v));
  if (largest.px == 0) return {};
  return largest;
}

ExactShape frustum_from_above(const HardCase& hard_case, double farthest) {
  return frustum_outline(hard_case, farthest, 0);
}

ExactShape frustum_from_the_side(const HardCase& hard_case, double farthest) {
  return frustum_outline(hard_case, farthest, 1);
}

}  // namespace clipscope::experiments
