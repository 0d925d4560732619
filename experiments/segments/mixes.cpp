// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/segments/mixes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "experiments/machine/errors.hpp"
#include "experiments/scenes/builtin.hpp"
#include "experiments/scenes/random.hpp"
#include "reference/exact_clip.hpp"

namespace clipscope::experiments::segments {
namespace {

using Ends = std::array<glm::dvec3, 2>;

// Proposes segments around a perspective frustum.
class Proposer {
 public:
  Proposer(const Frustum<float>& f, std::uint64_t seed)
      : f_(frustum_cast<double>(f)), random_(seed) {}

  Random& random() { return random_; }

  // extent: the side of the drawing over that of the window.
  Ends line(double extent) {
    const double x = random_.uniform(-extent, extent), y = random_.uniform(-extent, extent);
    const double length = 2 * extent * random_.across_magnitudes(1.0 / 64, 1);
    const glm::dvec3 direction = random_.direction();
    return between(x, y, x + length * direction.x, y + length * direction.y);
  }

  Ends long_line(double extent) {
    const double x = random_.uniform(-extent, extent), y = random_.uniform(-extent, extent);
    const double u = random_.uniform(-extent, extent), v = random_.uniform(-extent, extent);
    return between(x, y, u, v);
  }

  Ends beside() {
    const glm::dvec3 a = beyond(), b = beyond();
    return {a, b};
  }

  // From inside to just beyond one of the planes.
  Ends out_by_one() {
    const glm::dvec3 inside = within(1, depth());
    const double kind = random_.uniform();
    if (kind < 0.8) return shuffled({inside, within(3, depth())});
    const double end = kind < 0.9 ? f_.near * random_.uniform(0.25, 1) : f_.far * 1.5;
    return shuffled({inside, within(1, end)});
  }

  Ends across() {
    const double near_end = f_.near * random_.uniform(0.25, 4);
    const double far_end = random_.chance(0.5) ? f_.far * random_.uniform(0.5, 2) : depth();
    const glm::dvec3 a = within(4, near_end), b = within(4, far_end);
    return shuffled({a, b});
  }

  Ends across_eye() {
    const double d = depth();
    const double reach = d * random_.across_magnitudes(0.0625, 4);
    const glm::dvec3 inside = within(1, d);
    const glm::dvec3 behind = reach * random_.in_cube() + glm::dvec3(0, 0, 1.01 * reach);
    return shuffled({inside, behind});
  }

 private:
  glm::dvec3 at(double x_ndc, double y_ndc, double depth) const {
    return {x_ndc * f_.right * depth / f_.near, y_ndc * f_.top * depth / f_.near, -depth};
  }
  double depth() { return random_.across_magnitudes(2 * f_.near, f_.far / 2); }
  glm::dvec3 within(double side, double depth) {
    const double x = random_.uniform(-side, side), y = random_.uniform(-side, side);
    return at(x, y, depth);
  }
  glm::dvec3 beyond() {
    const double x = random_.sign() * random_.uniform(1, 4), y = random_.uniform(-4, 4);
    const bool is_x = random_.chance(0.5);
    return is_x ? at(x, y, depth()) : at(y, x, depth());
  }
  Ends between(double x, double y, double u, double v) {
    const double d = depth();
    const double e = d * random_.uniform(1, 2);
    return shuffled({at(x, y, d), at(u, v, std::min(e, f_.far / 2))});
  }
  Ends shuffled(Ends ends) {
    random_.shuffle(std::span<glm::dvec3>(ends));
    return ends;
  }

  Frustum<double> f_;
  Random random_;
};

struct Recipe {
  std::string_view name;
  Ends (*propose)(Proposer&);
  bool (*belongs)(const Facts&);
};

bool any(const Facts&) { return true; }

constexpr std::array kRecipes = {
    Recipe{"window_1_64", [](Proposer& p) { return p.line(64); }, any},
    Recipe{"window_1_8", [](Proposer& p) { return p.line(8); }, any},
    Recipe{"window_1_1", [](Proposer& p) { return p.line(1); }, any},
    Recipe{"window_4_1", [](Proposer& p) { return p.line(0.25); }, any},
    Recipe{"long_lines", [](Proposer& p) { return p.long_line(64); }, any},
    Recipe{"inside", [](Proposer& p) { return p.long_line(1); },
           [](const Facts& f) { return f.kind == Facts::accepted; }},
    Recipe{"outside", [](Proposer& p) { return p.beside(); },
           [](const Facts& f) { return f.share_plane; }},
    Recipe{"cross_one", [](Proposer& p) { return p.out_by_one(); },
           [](const Facts& f) { return f.ends_outside == 1 && f.crossings == 1; }},
    // Visible, in front of the eye, its ends outside three planes and more in all.
    Recipe{"cross_several", [](Proposer& p) { return p.across(); },
           [](const Facts& f) {
             return f.kind == Facts::shortened && f.crossings >= 3 && !f.behind_eye;
           }},
    // From inside to behind the eye.
    Recipe{"cross_w0", [](Proposer& p) { return p.across_eye(); },
           [](const Facts& f) { return f.ends_outside == 1 && f.behind_eye; }},
};

SceneSegment rounded(const Ends& ends, Random& random) {
  SceneSegment segment;
  for (std::size_t i = 0; i < 2; ++i) {
    segment[i].position = Vec3<float>(ends[i].x, ends[i].y, ends[i].z);
    for (int k = 0; k < kSceneAttributes; ++k) {
      segment[i].attributes[k] = static_cast<float>(random.uniform(-1, 1));
    }
  }
  return segment;
}

}  // namespace

std::vector<std::string> builtin_mixes() {
  std::vector<std::string> names;
  for (const Recipe& recipe : kRecipes) names.emplace_back(recipe.name);
  return names;
}

Mix make_mix(std::string_view name, std::size_t size, std::uint64_t seed) {
  const auto recipe = std::ranges::find(kRecipes, name, &Recipe::name);
  if (recipe == kRecipes.end()) {
    throw UsageError(fmt::format("no mix of segments is called '{}'; there are: {}", name,
                                 fmt::join(builtin_mixes(), ", ")));
  }
  SegmentView made{identity_view(), {}};
  const auto truth = reference::Truth::of_frustum(frustum_cast<double>(made.view.frustum));
  Proposer proposer(made.view.frustum, seed);
  while (made.segments.size() < size) {
    const Ends ends = recipe->propose(proposer);
    const SceneSegment segment = rounded(ends, proposer.random());
    if (recipe->belongs(facts_of(truth, segment))) made.segments.push_back(segment);
  }
  return {std::string(name), {made}};
}

Mix make_wireframe(const Scene& scene, std::size_t size) {
  // The first triangle that has an edge, and at which of its corners the edge starts.
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
  for (std::size_t t = 0; t < scene.mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto ends =
          std::minmax(scene.mesh.triangles[t][k], scene.mesh.triangles[t][(k + 1) % 3]);
      if (seen.insert(ends).second) edges.emplace_back(t, k);
    }
  }
  Mix mix{"wireframe " + scene.name, {}};
  const std::size_t wanted = std::max<std::size_t>(1, size / scene.views.size());
  for (const View& view : scene.views) {
    SegmentView& made = mix.views.emplace_back(SegmentView{view, {}});
    for (const auto& [t, k] : evenly_spaced(edges, wanted)) {
      SceneTriangle triangle;
      view_triangles(scene, view, t, std::span(&triangle, 1));
      made.segments.push_back({triangle[k], triangle[(k + 1) % 3]});
    }
  }
  return mix;
}

Mix thinned(Mix mix, std::size_t limit) {
  for (SegmentView& v : mix.views) v.segments = evenly_spaced(v.segments, limit);
  return mix;
}

Facts facts_of(const reference::Truth& truth, const SceneSegment& segment) {
  const std::array ends = {reference::input_vertex(segment[0]),
                           reference::input_vertex(segment[1])};
  return facts_of(truth, ends);
}

Facts facts_of(const reference::Truth& truth, std::span<const reference::InputVertex, 2> ends) {
  Facts facts;
  std::array<bool, 2> outside = {false, false};
  for (const reference::Truth::HalfSpace& half_space : truth.half_spaces()) {
    int beyond = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      const bool out = reference::sign(half_space.form, ends[i]) < 0;
      outside[i] = outside[i] || out;
      beyond += out;
    }
    facts.crossings += beyond;
    facts.share_plane = facts.share_plane || beyond == 2;
  }
  facts.ends_outside = outside[0] + outside[1];
  facts.behind_eye =
      reference::sign(truth.w(), ends[0]) < 0 || reference::sign(truth.w(), ends[1]) < 0;
  if (facts.ends_outside == 0) {
    facts.kind = Facts::accepted;
  } else if (!facts.share_plane && reference::clip(truth, ends, 0).vertices.size() == 2) {
    facts.kind = Facts::shortened;
  }
  return facts;
}

}  // namespace clipscope::experiments::segments
