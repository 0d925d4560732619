// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hard_cases/case_geometry.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/contestants/scalars.hpp"
#include "experiments/judge/outcome.hpp"
#include "experiments/report/outcode_text.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments::hard_cases {
namespace {

using reference::Rational;
using reference::to_rational;

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
ExactPosition view_position(const HardCase& hard_case, const reference::Truth& volume,
                            const ExactPosition& clip) {
  const auto& rows = volume.projection();
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
  if (code == 0 && clip[3] == 0) return "outside by definition";
  if (code == 0 && is_beyond_open_side(hard_case.volume, std::array{position})) {
    return "on an open side";
  }
  return outcode_text(code);
}

double px_between(const ExactPosition& a, const ExactPosition& b) {
  const auto offset = to_screen(a, b);
  return std::hypot(nearest_double(offset[0]), nearest_double(offset[1]));
}

const ExactPosition& nearest(const ExactShape& shape, const ExactPosition& to) {
  return *std::ranges::min_element(shape, {},
                                   [&](const ExactPosition& p) { return px_between(p, to); });
}

}  // namespace

CaseGeometry case_geometry(const HardCase& hard_case, const reference::ExactPolygon& exact,
                           const std::vector<std::array<double, 4>>& answer) {
  CaseGeometry g;
  const reference::Truth volume = truth_of(hard_case);
  const bool in_view = has_frustum(hard_case);
  for (const reference::InputVertex& v : hard_case.vertices) {
    const auto& p = v.position;
    const ExactPosition& clip = g.input_clip.emplace_back(volume.clip_position(v));
    g.behind.push_back(clip[3] <= 0);
    g.places.push_back(place_of(hard_case, v, clip));
    if (in_view) g.input_view.push_back(position_at(p[0], p[1], p[2]));
  }
  for (const reference::ExactVertex& v : exact.vertices) {
    const ExactPosition& ndc = g.visible_ndc.emplace_back(
        ExactPosition{to_rational(v.x), to_rational(v.y), to_rational(v.z), to_rational(v.inv_w)});
    const ExactPosition& clip = g.visible_clip.emplace_back(
        ExactPosition{ndc[0] / ndc[3], ndc[1] / ndc[3], ndc[2] / ndc[3], Rational(1) / ndc[3]});
    if (in_view) g.visible_view.push_back(view_position(hard_case, volume, clip));
  }
  for (const auto& [x, y, z, inv_w] : answer) {
    if (std::isfinite(x) && std::isfinite(y) && std::isfinite(z)) {
      // 1/w may overflow; nothing here shows it.
      g.answer_ndc.push_back(position_at(x, y, z, std::isfinite(inv_w) ? inv_w : 0));
    } else {
      ++g.answer_not_finite;
    }
  }
  return g;
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

ExactShape frustum_outline(const HardCase& hard_case, double farthest, std::size_t coordinate) {
  const Frustum<double>& f = hard_case.frustum;
  const bool perspective = f.kind == ProjectionKind::perspective;
  const DepthClamp clamp = hard_case.volume.depth_clamp;
  const bool x = coordinate == 0;
  const double low = x ? f.left : f.bottom, high = x ? f.right : f.top;
  const Rational shear = x ? f.shear_x : f.shear_y;
  const double front = !clamp.near ? f.near : perspective ? 0.0 : -farthest;
  const double far = clamp.far || f.infinite_far || f.far > farthest ? farthest : f.far;
  const auto corner = [&](const Rational& bound, const Rational& depth) {
    ExactPosition p{Rational(0), Rational(0), Rational(-depth), Rational(1)};
    p[coordinate] =
        perspective ? Rational(bound * depth / f.near) : Rational(bound + shear * depth);
    return p;
  };
  return {corner(low, front), corner(high, front), corner(high, far), corner(low, far)};
}

}  // namespace clipscope::experiments::hard_cases
