// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/effects/harm.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "experiments/contestants/contestant.hpp"
#include "spaces/effects/pipeline.hpp"

namespace clipscope::experiments {
namespace {

using Polygon4 = std::span<const NdcVertex<float, kSceneAttributes>>;

bool same_bits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

bool is_same(const EffectSet& effects, Polygon4 full, Polygon4 planned) {
  if (full.size() != planned.size()) return false;
  for (std::size_t i = 0; i < full.size(); ++i) {
    const auto &a = full[i], &b = planned[i];
    bool same = same_bits(a.position[0], b.position[0]) && same_bits(a.position[1], b.position[1]);
    same = same && (!effects.depth() || same_bits(a.position[2], b.position[2]));
    const bool has_w = effects.perspective() || !effects.divide();
    same = same && (!has_w || same_bits(a.position[3], b.position[3]));
    for (int k = 0; k < kSceneAttributes; ++k) {
      same = same && same_bits(a.attributes[k], b.attributes[k]);
    }
    if (!same) return false;
  }
  return true;
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

double affine_error(Polygon4 polygon) {
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

}  // namespace

Harm harm_of(const Plan<float>& plan, std::span<const SceneTriangle> triangles) {
  Harm harm;
  const EffectSet& effects = plan.effects();
  PolygonStream<float, kSceneAttributes> full, planned;
  const auto into = [](auto& stream) {
    return [&stream](const NdcPolygon<float, kSceneAttributes>& p) { stream.append(p); };
  };
  clip_fully(plan.projection(), triangles, into(full));
  clip_as_planned(plan, plan.revision(), triangles, into(planned));
  harm.polygons = triangles.size();
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    harm.changed += !is_same(effects, full[i], planned[i]);
    if (!effects.perspective()) {
      harm.attribute_error = std::max(harm.attribute_error, affine_error(full[i]));
    }
  }
  return harm;
}

}  // namespace clipscope::experiments
