// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "experiments/survey/verdicts.hpp"
#include "experiments/w_sign/measure.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::w_sign;

namespace {

ClipTriangle<float, kSceneAttributes> clip_triangle(const std::array<std::array<float, 4>, 3>& p) {
  ClipTriangle<float, kSceneAttributes> t{};
  for (std::size_t i = 0; i < 3; ++i) t[i].position = {p[i][0], p[i][1], p[i][2], p[i][3]};
  return t;
}

const WPlaneClipper& with_epsilon(std::optional<float> epsilon) {
  for (const WPlaneClipper& clipper : w_plane_clippers()) {
    if (clipper.epsilon == epsilon) return clipper;
  }
  throw std::logic_error("no such clipper");
}

Hazards hazards_of(const std::array<std::array<float, 4>, 3>& p, std::optional<float> epsilon) {
  SweepChunk chunk;
  chunk.clip = {clip_triangle(p)};
  return count_hazards(std::span(&chunk, 1), with_epsilon(epsilon));
}

Kind kind_of(float w) {
  if (w == 0) return std::signbit(w) ? Kind::minus_zero : Kind::zero;
  if (w < 0) return Kind::negative;
  return w <= 1e-5f ? Kind::tiny : Kind::positive;
}

}  // namespace

TEST_CASE("patterns: 35 of them, each with a name of its own") {
  std::set<std::string> names;
  for (const Pattern& pattern : all_patterns()) names.insert(pattern_name(pattern));
  CHECK(names.size() == 35);
  CHECK(names.contains("- +0 tiny"));
}

TEST_CASE("patterns: every triangle has the kinds of w that its pattern says") {
  for (const Pattern& pattern : all_patterns()) {
    for (const auto& triangle : pattern_chunk(pattern, 8, 5).clip) {
      std::multiset<Kind> found;
      for (const auto& v : triangle) found.insert(kind_of(v.position[3]));
      CHECK(found == std::multiset<Kind>(pattern.begin(), pattern.end()));
    }
  }
}

TEST_CASE("patterns: the same for a seed, others for another") {
  const Pattern pattern = {Kind::negative, Kind::tiny, Kind::positive};
  const auto first_x = [&](std::uint64_t seed) {
    return pattern_chunk(pattern, 1, seed).clip[0][0].position[0];
  };
  CHECK(first_x(4) == first_x(4));
  CHECK(first_x(4) != first_x(5));
}

TEST_CASE("hazards: 0 0 0 0 is met, unless a w-plane above 0 cuts it off") {
  const std::array<std::array<float, 4>, 3> p = {{{0, 0, 0, 0}, {1, 0, 0, 2}, {0, 1, 0, 2}}};
  CHECK(hazards_of(p, std::nullopt).zero_w == 1);
  CHECK(hazards_of(p, 0.0f).zero_w == 1);
  CHECK(hazards_of(p, 1e-5f).total() == 0);
}

TEST_CASE("hazards: 1/w overflows for a subnormal w, unless a plane at FLT_MIN cuts it off") {
  const float w = 1e-40f;
  const std::array<std::array<float, 4>, 3> p = {{{0, 0, 0, w}, {1, 0, 0, 2}, {0, 1, 0, 2}}};
  CHECK(hazards_of(p, std::nullopt).overflow == 1);
  // From the end nearer to that plane the w of the new vertex is w + t (2 - w); from the other one
  // it would be 2 + t (w - 2), which rounds to 0.
  CHECK(hazards_of(p, std::numeric_limits<float>::min()).total() == 0);
  CHECK(hazards_of(p, 1e-5f).total() == 0);
}

TEST_CASE("hazards: a triangle in front of the eye has none") {
  CHECK(hazards_of({{{0, 0, 0, 1}, {3, 0, 0, 1}, {0, 1, 0, 1}}}, std::nullopt).total() == 0);
}

TEST_CASE("loss: half a square missing is half its area, and the depth in front of it") {
  TruthPolygon truth;
  truth.approximation = {{-1, -1, 0, 1}, {1, -1, 0, 1}, {1, 1, 0, 0.5}, {-1, 1, 0, 0.5}};
  const std::vector<std::array<double, 4>> drawn = {
      {-1, 0, 0, 0.75}, {1, 0, 0, 0.75}, {1, 1, 0, 0.5}, {-1, 1, 0, 0.5}};
  const Loss loss = loss_of(truth, drawn);
  CHECK(loss.visible_px2 == 3840.0 * 2160.0);
  CHECK(loss.lost_px2 == 3840.0 * 2160.0 / 2);
  CHECK(loss.lost_depth.value() == Approx(4.0 / 3 - 1));
  CHECK_FALSE(loss_of(truth, {}).lost_depth);
}

TEST_CASE("surfaces: the near plane hides their nearest part, with depth clamp it is seen") {
  for (const Surface& surface : kSurfaces) {
    const auto nearest = [&](bool depth_clamp) {
      const TruthPolygon truth = truth_polygon(case_of(surface, 1, depth_clamp));
      return loss_of(truth, {}).nearest_visible.value();
    };
    CHECK(nearest(false) == Approx(0.01));
    CHECK(nearest(true) < 0.003);
  }
}

TEST_CASE("w-planes: epsilon costs nothing beyond it, and a slice of depth where it is nearer") {
  const Scene scene = [] {
    Scene s;
    s.mesh.positions = {{-50, -0.1f, 2}, {50, -0.1f, 2}, {0, -0.1f, -80}};
    s.mesh.attributes.resize(3);
    s.mesh.triangles = {{0, 1, 2}};
    View view;
    view.frustum = {
        .left = -0.1f, .right = 0.1f, .bottom = -0.1f, .top = 0.1f, .near = 0.1f, .far = 100};
    s.views = {view};
    return s;
  }();
  const auto lost = [&](double scale) {
    const LossTally tally = tally_loss(scaled_chunks(scene, scale, false, 10), with_epsilon(1e-5f));
    return tally.lost_px2 / tally.visible_px2;
  };
  CHECK(lost(1) < 1e-3);
  CHECK(lost(1e-5) > 0.5);
}

TEST_CASE("side by side: as many rows as pictures, the panels where they belong") {
  FrameBuffer empty(64, 32, DepthRange::minus_one_to_one), drawn = empty;
  const std::array<ScreenVertex, 3> triangle = {
      {{-3, -3, 0, 1, {}}, {3, -3, 0, 1, {}}, {0, 6, 0, 1, {}}}};
  draw_polygon(drawn, triangle, 0);
  const std::array pictures = {Picture{"scene", empty, drawn, {}}};
  const Image one = side_by_side(pictures);
  const std::array twice = {pictures[0], pictures[0]};
  CHECK(one.width == 2 * 64 + 3 * 16);
  CHECK(side_by_side(twice).height > one.height);
  const auto pixel = [&](int x, int y) {
    return one.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(one.width) +
                      static_cast<std::size_t>(x)];
  };
  CHECK(pixel(16 + 32, 8 + 30 + 16) != pixel(2 * 16 + 64 + 32, 8 + 30 + 16));
}
