// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/survey/lattice_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/catalogue/lattice.hpp"
#include "experiments/scenes/random.hpp"
#include "experiments/survey/sweep.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kRandomChunk = 2048;  // triangles
constexpr std::size_t kQuickStride = 16;

// Attributes are the barycentric coordinates and 1.
template <Space S>
Vertex<S, float, kSceneAttributes> vertex_at(std::size_t i, const std::array<float, 4>& p) {
  Vertex<S, float, kSceneAttributes> v;
  for (int c = 0; c < Vertex<S, float, 0>::kDimension; ++c) {
    v.position[c] = p[static_cast<std::size_t>(c)];
  }
  for (int k = 0; k < kSceneAttributes; ++k) {
    v.attributes[k] = k == 3 || k == static_cast<int>(i) ? 1.0f : 0.0f;
  }
  return v;
}

template <Space S>
Triangle<S, float, kSceneAttributes> triangle_at(const std::array<std::array<float, 4>, 3>& p) {
  return {vertex_at<S>(0, p[0]), vertex_at<S>(1, p[1]), vertex_at<S>(2, p[2])};
}

void add_tallies(const Contestants& contestants, const std::vector<Tally>& tallies,
                 TableOf<SweepRow>& table) {
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    const Tally& t = tallies[i];
    if (t.primitives == 0) continue;  // the method does not take this space
    table.add({.clipper = std::string(contestants[i]->clipper),
               .scalar = std::string(contestants[i]->scalar()),
               .triangles = t.primitives,
               .failures = t.failures,
               .outcomes = view_outcomes(t.outcomes),
               .max_px = t.max_px,
               .max_ulp = t.max_ulp,
               .max_attribute = t.max_attribute,
               .worst = t.worst,
               .failing = t.failing});
  }
}

Contestants float_and_double(const Selection& selection) {
  std::vector<std::string> scalars;
  for (const std::string& s : selection.scalars) {
    if (s == kFormat<float>.name || s == kFormat<double>.name) scalars.push_back(s);
  }
  return select_contestants(selection, scalars);
}

using Corners = std::array<std::array<float, 4>, 3>;

float uniform_float(Random& random, double size) {
  return static_cast<float>(random.uniform(-size, size));
}

// A point of the closed volume, or a few ulps from one of its planes.
void move_to_a_plane(Random& random, std::array<float, 4>& p) {
  const std::uint64_t axis = random.below(3);
  const std::uint64_t ulps = random.below(5);
  p[3] = std::abs(p[3]) + 0.125f;
  float x = random.sign() > 0 ? p[3] : -p[3];
  for (std::uint64_t i = 0; i < ulps; ++i) x = std::nextafter(x, i % 2 == 0 ? 0.0f : 2 * x);
  p[axis] = x;
}

void scale(Random& random, Corners& corners, bool together) {
  int exponent = static_cast<int>(random.below(61)) - 30;
  for (auto& p : corners) {
    if (!together) exponent = static_cast<int>(random.below(31)) - 15;
    for (float& x : p) x = std::ldexp(x, exponent);
  }
}

Corners random_clip_corners(Random& random) {
  Corners corners;
  const std::uint64_t kind = random.below(6);
  for (auto& p : corners) {
    for (float& x : p) x = uniform_float(random, 2);
    if (kind != 1) p[3] = std::abs(p[3]);  // mixed signs of w in one kind only
  }
  if (kind == 2) {
    for (auto& p : corners) move_to_a_plane(random, p);
  }
  if (kind == 3 || kind == 4) scale(random, corners, kind == 3);
  if (kind == 5) {  // a sliver: the third vertex nearly between the others
    for (std::size_t c = 0; c < 4; ++c) {
      corners[2][c] = std::nextafter((corners[0][c] + corners[1][c]) / 2, uniform_float(random, 9));
    }
  }
  return corners;
}

Corners random_view_corners(Random& random) {
  Corners corners;
  const std::uint64_t kind = random.below(4);
  const double size = kind == 0 ? 12 : 0.5;
  const double x = random.uniform(-4, 4), y = random.uniform(-4, 4), z = random.uniform(-6, 0.5);
  for (auto& p : corners) {
    const double reach = kind == 2 ? random.across_magnitudes(1e-3, 1e4) : size;
    p = {static_cast<float>(x + random.uniform(-reach, reach)),
         static_cast<float>(y + random.uniform(-reach, reach)),
         static_cast<float>(z + random.uniform(-reach, reach)), 1};
    if (kind == 3) p[0] = random.sign() > 0 ? p[2] : std::nextafter(p[2], 0.0f);  // on the sides
  }
  return corners;
}

std::size_t stride_of(const Selection& selection) { return selection.quick ? kQuickStride : 1; }

}  // namespace

SweepChunk random_chunk(std::uint64_t seed, std::size_t index, std::size_t count) {
  Random random(seed * 0x9E3779B97F4A7C15u + index);
  SweepChunk chunk;
  chunk.volume.depth = static_cast<DepthRange>(random.below(3));
  if (index % 2 == 0) {
    Frustum<float> frustum;
    frustum.depth = chunk.volume.depth;
    if (random.chance(0.25)) frustum.far = 1000;
    if (random.chance(0.25)) frustum.infinite_far = true;
    chunk.frustum = frustum;
    for (std::size_t i = 0; i < count; ++i) {
      chunk.view.push_back(triangle_at<Space::view>(random_view_corners(random)));
    }
  } else {
    for (std::size_t i = 0; i < count; ++i) {
      chunk.clip.push_back(triangle_at<Space::clip>(random_clip_corners(random)));
    }
  }
  return chunk;
}

TableOf<SweepRow> lattice_table(const std::string& name, const Selection& selection) {
  const Lattice lattice = named_lattice(name);
  const std::size_t stride = stride_of(selection);
  return {"lattice_" + name,
          fmt::format("Lattice {}: {} triangles in {} classes up to symmetry{}", name,
                      lattice.triangles(), lattice.classes(),
                      stride > 1 ? fmt::format(", every {}th chunk of them", stride) : "")};
}

void add_lattice(const std::string& name, const Selection& selection, TableOf<SweepRow>& table) {
  const Lattice lattice = named_lattice(name);
  const std::size_t stride = stride_of(selection);
  const Contestants contestants = float_and_double(selection);
  const std::size_t chunks = (lattice.chunks() + stride - 1) / stride;
  Progress progress(fmt::format("lattice {}", name), chunks);
  const auto make_chunk = [&](std::size_t i) {
    SweepChunk chunk;
    chunk.volume.depth = lattice.depth();
    lattice.visit_chunk(i * stride, [&](const LatticeTriangle& t) {
      chunk.clip.push_back(triangle_at<Space::clip>(t.vertices));
    });
    return chunk;
  };
  add_tallies(contestants, sweep(chunks, make_chunk, contestants, progress), table);
}

TableOf<SweepRow> sweep_random(std::uint64_t triangles, const Selection& selection) {
  const Contestants contestants = float_and_double(selection);
  const auto chunks = static_cast<std::size_t>((triangles + kRandomChunk - 1) / kRandomChunk);
  Progress progress("sweep", chunks);
  const auto make_chunk = [&](std::size_t i) {
    const std::uint64_t left = triangles - i * kRandomChunk;
    return random_chunk(selection.seed, i, std::min<std::uint64_t>(kRandomChunk, left));
  };
  TableOf<SweepRow> table("sweep",
                          fmt::format("{} random triangles, seed {}", triangles, selection.seed));
  add_tallies(contestants, sweep(chunks, make_chunk, contestants, progress), table);
  table.add_note("A search: the largest errors are lower bounds of the worst.");
  return table;
}

}  // namespace clipscope::experiments
