// SPDX-License-Identifier: GPL-3.0-or-later
//
// A plug-in is asked what our clippers are asked: ours, as a plug-in, has their bits.
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "experiments/contestants/same_bits.hpp"
#include "experiments/guests/plugin.hpp"
#include "experiments/scenes/random.hpp"
#include "experiments/selection/select.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/guests/marked_batch.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kTriangles = 500;

const Contestant& own_plugin(std::string_view scalar) {
  static const std::string_view name = add_plugin(CLIPSCOPE_OWN_PLUGIN);
  return find_contestant(name, scalar);
}

// So many numbers, some of them 0 or far away.
std::vector<double> random_numbers(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> numbers(count);
  for (double& x : numbers) {
    const std::uint64_t kind = random.below(16);
    x = kind == 0 ? 0 : random.uniform(-4, 4) * (kind == 1 ? 1e6 : 1);
  }
  return numbers;
}

// Of the same numbers in both scalars.
void check_same_bits(Batch batch, const std::string& what) {
  const std::vector<double> numbers = random_numbers(3 * kTriangles * batch.stride(), 7);
  batch.numbers = std::span<const double>(numbers);
  for (const char* scalar : {"float", "double"}) {
    const Contestant& guest = own_plugin(scalar);
    const Contestant& ours = find_contestant("homogeneous/sutherland_hodgman", scalar);
    REQUIRE(guest.takes(batch));
    const Answers answers = clip(guest, batch), expected = clip(ours, batch);
    REQUIRE(answers.size() == expected.size());
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      CAPTURE(what, scalar, i);
      REQUIRE(answers[i].failure() == nullptr);
      REQUIRE(has_same_bits(answers[i], expected[i]));
      drawn += !answers[i].empty();
    }
    CHECK(drawn > 0);
  }
}

}  // namespace

TEST_CASE("plug-in: ours has the bits of our clipper in view space, whatever the projection") {
  const Frustum<double> centred{.far = 9};
  check_same_bits({.frustum = centred, .attributes = 4}, "centred");
  Frustum<double> other = centred;
  other.left = -0.25;
  check_same_bits({.frustum = other, .attributes = 2}, "off-centre");
  other.infinite_far = true;
  check_same_bits({.frustum = other}, "infinite far");
  Frustum<double> parallel{.kind = ProjectionKind::parallel, .near = -3, .far = 9};
  check_same_bits({.frustum = parallel}, "orthographic");
  parallel.shear_x = 0.1;
  check_same_bits({.frustum = parallel}, "oblique");
  const MatrixRows<double> matrix = {Vec4<double>(1, 0.5, 0, 0), Vec4<double>(0, 1, 0.3, 0),
                                     Vec4<double>(0, 0, -1.2, -2), Vec4<double>(0.1, 0, -1, 0)};
  check_same_bits({.matrix = matrix, .attributes = 1}, "matrix");
}

TEST_CASE("plug-in: ours has the bits of our clipper in clip space, whatever the volume") {
  for (const DepthRange depth :
       {DepthRange::minus_one_to_one, DepthRange::zero_to_one, DepthRange::reversed}) {
    check_same_bits({.space = Space::clip, .volume = {.depth = depth}, .attributes = 4}, "depth");
  }
  check_same_bits({.space = Space::clip, .volume = {.depth_clamp = kClampNear}}, "near clamp");
  check_same_bits({.space = Space::clip, .volume = {.depth_clamp = true}}, "depth clamp");
  check_same_bits({.space = Space::clip, .volume = {.open_sides = true}}, "open sides");
  check_same_bits({.space = Space::clip, .volume = {.clip_distances = 2}, .attributes = 3},
                  "clip distances");
  check_same_bits({.space = Space::clip, .attributes = 2, .planes = {{1, 0.5, 0, 0.25}}},
                  "a plane of the user's");
}

TEST_CASE("plug-in: ours has the bits of our clipper with any number of attributes") {
  for (int attributes = 0; attributes <= kMaxAttributes; attributes += 4) {
    check_same_bits({.space = Space::clip, .attributes = attributes}, std::to_string(attributes));
  }
}

TEST_CASE("plug-in: one that takes clip space alone is asked about view space there") {
  // The plug-in copies its input, which is in clip space where it answers there.
  const std::vector<float> numbers = {0, 0, -2, 5, 1, 0, -4, 6, 0, 1, -3, 7};
  const Frustum<double> frustum{.far = 9};
  const Batch batch{.frustum = frustum, .attributes = 1, .numbers = std::span(numbers)};
  const Answers answers = clip(misbehaving_guest("in_clip_space"), batch);
  REQUIRE(answers.size() == 1);
  REQUIRE(answers[0].size() == 3);
  const Projection<float> projection(frustum_cast<float>(frustum));
  for (std::size_t v = 0; v < 3; ++v) {
    const float* p = &numbers[4 * v];
    const Vec4<float> ndc = to_ndc(to_clip(projection, Vec3<float>(p[0], p[1], p[2])));
    for (int k = 0; k < 4; ++k) CHECK(answers[0][v].position(k).value == ndc[k]);
    CHECK(answers[0][v].attribute(0).value == p[3]);
  }
}

TEST_CASE("plug-in: where it answers in clip space, (0, 0, 0, 0) is outside") {
  const std::vector<float> numbers = {0, 0, 0, 0, 1, 0, 0, 2, 0, 1, 0, 4};
  const Batch batch{.space = Space::clip, .numbers = std::span(numbers)};
  const Answers answers = clip(misbehaving_guest("in_clip_space"), batch);
  REQUIRE(answers[0].size() == 2);
  CHECK(answers[0][0].position(0).value == 0.5);
  CHECK(answers[0][1].position(3).value == 0.25);
}

TEST_CASE("plug-in: points, segments and polygons are asked, too") {
  const std::vector<float> numbers = {0, 0, 0, 1, 1, 0, 0, 1, 1, 1, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1};
  Batch batch{.space = Space::clip, .vertices = 1, .numbers = std::span(numbers)};
  CHECK(clip(misbehaving_guest("none", 1), batch).size() == 5);
  batch.numbers = std::span(numbers).first(16);
  batch.vertices = 2;
  const Answers segments = clip(misbehaving_guest("none", 2), batch);
  REQUIRE(segments.size() == 2);
  CHECK(segments[1][0].position(1).value == 1);
  const std::vector<std::size_t> ends = {3, 5};
  batch.numbers = std::span(numbers);
  batch.vertices = 0;
  batch.ends = ends;
  const Answers polygons = clip(misbehaving_guest("none", 0), batch);
  REQUIRE(polygons.size() == 2);
  CHECK(polygons[0].size() == 3);
  CHECK(polygons[1].size() == 2);
  CHECK(polygons[1][1].position(2).value == 1);
}

TEST_CASE("plug-in: it is asked what it says that it takes, and nothing else") {
  const Contestant& guest = misbehaving_guest("none");
  Batch batch{.space = Space::clip};
  CHECK(guest.takes(batch));
  batch.volume.depth_clamp = true;
  CHECK_FALSE(guest.takes(batch));
  batch.volume = {.depth = DepthRange::reversed};
  CHECK_FALSE(guest.takes(batch));
  batch.volume = {};
  batch.planes = {{1, 0, 0, 1}};
  CHECK_FALSE(guest.takes(batch));
}

}  // namespace clipscope::experiments
