// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/survey/lattice_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

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

SweepChunk lattice_chunk(const Lattice& lattice, std::size_t number) {
  SweepChunk chunk;
  chunk.volume.depth = lattice.depth();
  lattice.visit_chunk(number, [&](const LatticeTriangle& t) {
    chunk.clip.push_back(triangle_at<Space::clip>(t.vertices));
  });
  return chunk;
}

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

SweepPlan lattice_plan(const std::string& name, const Selection& selection) {
  const auto lattice = std::make_shared<const Lattice>(named_lattice(name));
  const std::size_t stride = selection.quick ? kQuickStride : 1;
  return {.name = "lattice_" + name,
          .title = fmt::format("Lattice {}: {} triangles in {} classes up to symmetry{}", name,
                               lattice->triangles(), lattice->classes(),
                               stride > 1 ? fmt::format(", every {}th chunk of them", stride) : ""),
          .source = {(lattice->chunks() + stride - 1) / stride,
                     [=](std::size_t i) { return lattice_chunk(*lattice, i * stride); }}};
}

SweepPlan random_plan(std::uint64_t triangles, const Selection& selection) {
  const auto chunk = [triangles, seed = selection.seed](std::size_t i) {
    const std::uint64_t left = triangles - i * kRandomChunk;
    return random_chunk(seed, i, std::min<std::uint64_t>(kRandomChunk, left));
  };
  return {
      .name = "sweep",
      .title = fmt::format("{} random triangles, seed {}", triangles, selection.seed),
      .notes = {"A search: the largest errors are lower bounds of the worst."},
      .source = {static_cast<std::size_t>((triangles + kRandomChunk - 1) / kRandomChunk), chunk}};
}

TableOf<SweepRow> SweepPlan::table() const {
  TableOf<SweepRow> table(name, title);
  for (const std::string& note : notes) table.add_note(note);
  return table;
}

Contestants swept_contestants(const Selection& selection) {
  std::vector<std::string> scalars;
  for (const std::string& s : selection.scalars) {
    if (s == kFormat<float>.name || s == kFormat<double>.name) scalars.push_back(s);
  }
  return select_contestants(selection, scalars);
}

std::vector<SweepRow> empty_rows(const Contestants& contestants) {
  std::vector<SweepRow> rows;
  for (const Contestant* c : contestants) {
    rows.push_back({std::string(c->clipper), std::string(c->scalar()), {}});
  }
  return rows;
}

void sweep(const SweepPlan& plan, ChunkNumbers chunks, const Contestants& contestants,
           Progress& progress, std::vector<SweepRow>& rows) {
  const std::vector<Tally> tallies = sweep(plan.source, chunks, contestants, progress);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].tally += tallies[i];
}

TableOf<SweepRow> whole_table(const SweepPlan& plan, const std::vector<SweepRow>& rows) {
  TableOf<SweepRow> table = plan.table();
  for (const SweepRow& row : rows) {
    if (!is_empty(row)) table.add(row);
  }
  return table;
}

TableOf<SweepRow> sweep(const SweepPlan& plan, const Selection& selection) {
  const Contestants contestants = swept_contestants(selection);
  Progress progress(plan.name, plan.source.chunks);
  std::vector<SweepRow> rows = empty_rows(contestants);
  const std::vector<Tally> tallies = sweep(plan.source, contestants, progress);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].tally = tallies[i];
  return whole_table(plan, rows);
}

}  // namespace clipscope::experiments
