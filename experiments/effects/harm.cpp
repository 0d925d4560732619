// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/contestants/polygon_stream.hpp"
#include "experiments/effects/rows.hpp"
#include "experiments/judge/cycle.hpp"
#include "experiments/judge/promise.hpp"
#include "spaces/effects/pipeline.hpp"

namespace clipscope::experiments::effects {
namespace {

using Polygon4 = NdcPolygon<float, kSceneAttributes>;
using Vertices4 = std::span<const NdcVertex<float, kSceneAttributes>>;
using Stream4 = PolygonStream<float, kSceneAttributes>;

constexpr std::size_t kChecked = 64;  // triangles of a view

// Whether all bits are the same but those of z and 1/w that the effects leave out.
bool is_same(const EffectSet& effects, Vertices4 full, Vertices4 planned) {
  const bool has_w = effects.perspective() || !effects.divide();
  const std::array compared = {true, true, effects.depth(), has_w};
  return std::ranges::equal(full, planned, [&](const auto& a, const auto& b) {
    for (int i = 0; i < 4; ++i) {
      const bool same = same_number(a.position[i], b.position[i], Likeness::by_bits);
      if (compared[static_cast<std::size_t>(i)] && !same) return false;
    }
    return same_vertex(a.attributes.values, b.attributes.values, Likeness::by_bits);
  });
}

using Barycentric = std::array<double, 3>;

// How far affine interpolation is off at a point of a triangle.
double affine_error(const std::array<const NdcVertex<float, kSceneAttributes>*, 3>& triangle,
                    const Barycentric& b) {
  Barycentric lambda;
  double q = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    lambda[i] = b[i] * double{triangle[i]->position[3]};
    q += lambda[i];
  }
  double worst = 0;
  for (int k = 0; k < kSceneAttributes; ++k) {
    double error = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      error += (b[i] - lambda[i] / q) * double{triangle[i]->attributes[k]};
    }
    worst = std::max(worst, std::abs(error));
  }
  return worst;
}

double affine_error(Vertices4 polygon) {
  constexpr int kGrid = 4;
  double worst = 0;
  for (std::size_t n = 2; n < polygon.size(); ++n) {
    const std::array triangle = {&polygon[0], &polygon[n - 1], &polygon[n]};
    for (int i = 0; i <= kGrid; ++i) {
      for (int j = 0; i + j <= kGrid; ++j) {
        const double u = double(i) / kGrid, v = double(j) / kGrid;
        worst = std::max(worst, affine_error(triangle, {u, v, 1 - u - v}));
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      // Between q_i and q_j the error peaks at b_i = sqrt(q_j) / (sqrt(q_i) + sqrt(q_j)).
      const double a = std::sqrt(double{triangle[i]->position[3]});
      const double c = std::sqrt(double{triangle[j]->position[3]});
      Barycentric b{};
      b[i] = c / (a + c);
      b[j] = a / (a + c);
      worst = std::max(worst, affine_error(triangle, b));
    }
  }
  return worst;
}

// What the full polygons of the first triangles break of their clipper's promise.
std::string broken_promise(const PlannedView& view, const Stream4& full) {
  const PromiseChecker checker(frustum_cast<double>(view.view.frustum));
  for (std::size_t i = 0; i < std::min(kChecked, full.size()); ++i) {
    Answers answer(kFormat<float>, 4 + kSceneAttributes);
    add_polygon(full[i], answer);
    const PromiseCheck check =
        checker.check(HomogeneousSutherlandHodgman::promise,
                      reference::input_triangle(view.triangles[i]), answer[0]);
    if (check.verdict == PromiseVerdict::broken) return check.reason;
  }
  return "";
}

}  // namespace

Harm harm_of(const PlannedView& view) {
  const EffectSet& effects = view.plan.effects();
  Stream4 full, planned;
  const auto into = [](Stream4& stream) {
    return [&stream](const Polygon4& polygon) { stream.append(polygon); };
  };
  const std::span<const SceneTriangle> triangles(view.triangles);
  clip_fully(view.plan.projection(), triangles, into(full));
  clip_as_planned(view.plan, view.plan.revision(), triangles, into(planned));
  Harm harm{.polygons = triangles.size(), .broken = broken_promise(view, full)};
  for (std::size_t i = 0; i < harm.polygons; ++i) {
    harm.changed += !is_same(effects, full[i], planned[i]);
    if (effects.perspective()) continue;
    harm.attribute_error = std::max(harm.attribute_error, affine_error(full[i]));
  }
  return harm;
}

Harm harm_of(std::span<const PlannedView> views) {
  Harm all;
  for (const PlannedView& view : views) all += harm_of(view);
  return all;
}

Harm& Harm::operator+=(const Harm& other) {
  polygons += other.polygons;
  changed += other.changed;
  attribute_error = std::max(attribute_error, other.attribute_error);
  if (broken.empty()) broken = other.broken;
  return *this;
}

std::string Harm::text(double tolerance) const {
  if (!broken.empty() || (changed == 0 && attribute_error <= tolerance)) return broken;
  return fmt::format("{} of {} polygons are changed, attributes by {} at most", changed, polygons,
                     attribute_error);
}

}  // namespace clipscope::experiments::effects
