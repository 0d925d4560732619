// SPDX-License-Identifier: GPL-3.0-or-later
//
// SIMD against the plain version, bit for bit, on every instruction set that this processor has.
#include <optional>
#include <random>

#include "tests/catch.hpp"
#include "tests/spaces/batch/inputs.hpp"
#include "tests/spaces/batch/on_every_target.hpp"
#include "tests/spaces/hard_set.hpp"

namespace clipscope::batch::tests {
namespace {

constexpr DepthRange kDepths[] = {DepthRange::minus_one_to_one, DepthRange::zero_to_one,
                                  DepthRange::reversed};

template <class Input>
void check_twins(Method method, const ClipVolume& volume, const Input& input) {
  Output plain, simd;
  clip(method, volume, input, plain, Build::plain);
  clip(method, volume, input, simd);
  CHECK(first_difference(plain, simd) == std::nullopt);
}

// All layouts, methods and depth ranges.
void check_soups(Numbers numbers, int attributes, std::size_t triangles) {
  Random random(static_cast<std::uint64_t>(attributes) + 1);
  const Soup soup = make_soup(random, numbers, attributes, triangles);
  for (const Method method : kStageMethods) {
    for (const DepthRange depth : kDepths) {
      INFO(name(method) << ", numbers " << static_cast<int>(numbers) << ", depth "
                        << static_cast<int>(depth) << ", attributes " << attributes);
      const ClipVolume volume{.depth = depth};
      check_twins(method, volume, soup.array());
      check_twins(method, volume, soup.streams());
      check_twins(method, volume, soup.mesh());
    }
  }
}

// So many triangles inside every volume, one of any kind, the next run and so on.
Soup make_runs_inside(Random& random, int attributes, std::span<const std::size_t> runs) {
  std::size_t triangles = 0;
  for (const std::size_t run : runs) triangles += run + 1;
  Soup soup = make_soup(random, Numbers::near_volume, attributes, triangles);
  std::size_t t = 0;
  for (const std::size_t run : runs) {
    for (const std::size_t end = t + run; t < end; ++t) {
      for (std::size_t i = 0; i < 12; ++i) {
        const float x = i % 4 == 3 ? 1.0f : uniform(random, 0.25f, 0.75f);
        soup.coordinates[i][t] = x;
        soup.vertices[(3 * t + i / 4) * soup.array().stride() + i % 4] = x;
      }
    }
    ++t;
  }
  return soup;
}

}  // namespace

TEST_CASE("batch: SIMD gives the bits of the plain version, whatever the numbers") {
  on_every_target([] {
    for (const Numbers numbers : kNumbers) check_soups(numbers, 4, 1500);
  });
}

// Halves of sums of floats: many lie half-way between two floats.
TEST_CASE("batch: ties are rounded as the plain version does") {
  Random random(7);
  for (const int attributes : {4, 7}) {
    const Soup soup = make_soup(random, Numbers::lattice, attributes, 3000, Numbers::near_volume);
    Output plain;
    clip(Method::correctly_rounded, {}, soup.array(), plain, Build::plain);
    on_every_target([&] {
      Output simd;
      clip(Method::correctly_rounded, {}, soup.array(), simd);
      CHECK(first_difference(plain, simd) == std::nullopt);
      CHECK((target_name() == "plain" || simd.tally().exact_vertices > 100));
    });
  }
}

TEST_CASE("batch: SIMD gives the bits of the plain version for any number of attributes") {
  on_every_target([] {
    for (const int attributes : {0, 1, 2, 3, 5, 8, 12, 31, 32}) {
      check_soups(Numbers::near_volume, attributes, 300);
    }
  });
}

TEST_CASE("batch: SIMD gives the bits of the plain version for any number of triangles") {
  on_every_target([] {
    for (const std::size_t triangles : {0, 1, 2, 7, 8, 9, 255, 256, 257, 1023, 1024, 1025, 2305}) {
      check_soups(Numbers::near_volume, 4, triangles);
    }
  });
}

// Runs around the numbers of lanes and of triangles in a block.
TEST_CASE("batch: SIMD gives the bits of the plain version for runs of triangles inside") {
  const std::size_t runs[] = {1, 7, 8, 9, 15, 16, 17, 47, 48, 49, 255, 256, 257, 511, 512, 513};
  for (const int attributes : {0, 3, 4}) {
    Random random(9);
    const Soup soup = make_runs_inside(random, attributes, runs);
    on_every_target([&] {
      for (const Method method : kStageMethods) {
        INFO(name(method) << ", attributes " << attributes);
        for (const DepthRange depth : kDepths) {
          check_twins(method, {.depth = depth}, soup.array());
          check_twins(method, {.depth = depth}, soup.streams());
        }
      }
    });
  }
}

// A triangle in the plane x + y + z = 0, which meets the volume in a hexagon, cuts three corners
// off it. Lists of corners have eight places; the ninth is the plain version's.
TEST_CASE("batch: a polygon of nine corners has the bits of the plain version") {
  const float a = 1.8f;
  const float vertices[] = {-a, a, 0, 1, 0, -a, a, 1, a, 0, -a, 1};
  const VertexArray triangle{.data = vertices, .count = 3};
  on_every_target([&] {
    for (const Method method : kStageMethods) {
      INFO(name(method));
      Output plain, simd;
      clip(method, {}, triangle, plain, Build::plain);
      clip(method, {}, triangle, simd);
      REQUIRE(plain.polygons().size() == 1);
      CHECK(plain.polygons()[0].end == 9);
      CHECK(first_difference(plain, simd) == std::nullopt);
    }
  });
}

// Few triangles are left to the plain version: of nine corners, or torn by rounding.
TEST_CASE("batch: triangles across several planes are cut in SIMD") {
  Random random(10);
  const Soup soup = make_soup(random, Numbers::near_volume, 4, 3000);
  on_every_target([&] {
    for (const Method method : kStageMethods) {
      INFO(name(method));
      Output out;
      clip(method, {}, soup.array(), out);
      if (target_name() == "plain") continue;
      CHECK(out.tally().planes > 500);
      CHECK(out.tally().plain + out.tally().exact < 10);
    }
  });
}

namespace {

Soup hard_soup(std::size_t triangles) {
  clipscope::tests::HardSet set(18);
  Random random(19);
  Soup soup{4, {}, std::vector<std::vector<float>>(12), {}, {}};
  for (std::size_t i = 0; i < 12 * triangles; ++i) {
    soup.attribute_values.push_back(uniform(random, -1, 1));
  }
  for (std::size_t v = 0; v < 3 * triangles; ++v) {
    soup.indices.push_back(static_cast<std::uint32_t>(v));
  }
  for (std::size_t t = 0; t < triangles; ++t) {
    const clipscope::tests::HardTriangle triangle = set.next();
    for (std::size_t v = 0; v < 3; ++v) {
      for (std::size_t c = 0; c < 4; ++c) {
        soup.vertices.push_back(triangle[v][c]);
        soup.coordinates[4 * v + c].push_back(triangle[v][c]);
      }
      const auto from = soup.attribute_values.begin() + static_cast<std::ptrdiff_t>(12 * t + 4 * v);
      soup.vertices.insert(soup.vertices.end(), from, from + 4);
    }
  }
  return soup;
}

}  // namespace

TEST_CASE("batch: SIMD gives the bits of the plain version on the hard set") {
  const Soup soup = hard_soup(20000);
  on_every_target([&] {
    for (const Method method : kStageMethods) {
      for (const DepthRange depth : kDepths) {
        INFO(name(method) << ", depth " << static_cast<int>(depth));
        check_twins(method, {.depth = depth}, soup.array());
      }
    }
  });
}

TEST_CASE("batch: a triangle in each lane gets the bits that it gets alone") {
  Random random(8);
  for (const Numbers numbers : kNumbers) {
    if (numbers == Numbers::special) continue;  // no such promise where something overflows
    const Soup soup = make_soup(random, numbers, 4, 3000);
    for (const DepthRange depth : kDepths) {
      Output alone;
      clip(Method::homogeneous, {.depth = depth}, soup.array(), alone);
      on_every_target([&] {
        Output in_lanes;
        clip(Method::mcguire, {.depth = depth}, soup.array(), in_lanes);
        CHECK(first_difference(alone, in_lanes) == std::nullopt);
      });
    }
  }
}

TEST_CASE("batch: options of the volume are clipped as the plain version does") {
  Random random(5);
  const Soup soup = make_soup(random, Numbers::near_volume, 4, 500);
  const Soup lattice = make_soup(random, Numbers::lattice, 4, 500);
  for (const Method method : kStageMethods) {
    check_twins(method, {.clip_distances = 2}, soup.array());
    check_twins(method, {.depth_clamp = true}, soup.streams());
    check_twins(method, {.depth_clamp = kClampNear}, soup.array());
    check_twins(method, {.open_sides = true}, lattice.array());
    check_twins(method, {.open_sides = true}, lattice.streams());
  }
}

namespace {

std::vector<Frustum<float>> some_frusta() {
  std::vector<Frustum<float>> frusta(6);
  frusta[1].depth = DepthRange::reversed;
  frusta[1].infinite_far = true;
  frusta[2].left = -0.5f;
  frusta[2].top = 2.25f;
  frusta[2].depth = DepthRange::zero_to_one;
  frusta[3].infinite_far = true;
  frusta[4].kind = frusta[5].kind = ProjectionKind::parallel;
  frusta[5].shear_x = 0.25f;
  frusta[5].shear_y = -3;
  return frusta;
}

// View-space vertices in the volume, x and y stretched.
std::vector<float> vertices_about(const Frustum<float>& f, float stretch, Random& random,
                                  std::size_t count, int attributes, Numbers of_attributes) {
  const float far = f.infinite_far ? 100 : f.far;
  std::vector<float> r;
  for (std::size_t i = 0; i < count; ++i) {
    const float w = uniform(random, f.near, far),
                size = f.kind == ProjectionKind::perspective ? w / f.near : 1;
    r.push_back(uniform(random, f.left, f.right) * size * stretch);
    r.push_back(uniform(random, f.bottom, f.top) * size * stretch);
    r.push_back(-w);
    for (int k = 0; k < attributes; ++k) r.push_back(number(random, of_attributes));
  }
  return r;
}

}  // namespace

TEST_CASE("batch: in the full contract floats are rounded correctly without the plain version") {
  Random random(10);
  for (const Frustum<float>& frustum : some_frusta()) {
    const Projection<float> projection(frustum);
    for (const int attributes : {0, 3, 4}) {
      for (const float stretch : {1.0f, 1.2f}) {
        CAPTURE(attributes, stretch);
        const std::vector<float> vertices =
            vertices_about(frustum, stretch, random, 3000, attributes, Numbers::near_volume);
        const ViewVertexArray input{vertices.data(), 3000, attributes};
        Output plain;
        clip(Method::correctly_rounded, projection, input, plain, Build::plain);
        on_every_target([&] {
          Output simd;
          clip(Method::correctly_rounded, projection, input, simd);
          CHECK(first_difference(plain, simd) == std::nullopt);
          CHECK(
              std::ranges::equal(plain.vertices(), simd.vertices(), same_bits));  // the order, too
          const Tally& tally = simd.tally();
          const bool is_plain = frustum.shear_x != 0 || target_name() == "plain";
          if (is_plain) return;
          CHECK(tally.plain < 10);
          CHECK(tally.inside > (stretch == 1 ? 990 : 200));
          CHECK(tally.inside + tally.one_plane > (stretch == 1 ? 950 : 600));
          CHECK((stretch == 1 || (tally.one_plane > 200 && tally.planes > 100)));
        });
      }
    }
  }
}

TEST_CASE("batch: in the full contract, too, SIMD gives the bits of the plain version") {
  Random random(9);
  const std::vector<Frustum<float>> frusta = some_frusta();
  for (const int attributes : {0, 3, 4, 7}) {
    for (const Numbers numbers : kNumbers) {
      std::vector<float> vertices(600 * (3 + static_cast<std::size_t>(attributes)));
      for (float& x : vertices) x = 2 * number(random, numbers);
      const ViewVertexArray input{vertices.data(), 600, attributes};
      on_every_target([&] {
        for (const Frustum<float>& frustum : frusta) {
          for (const Method method : kFullMethods) {
            INFO(name(method) << ", attributes " << attributes << ", numbers "
                              << static_cast<int>(numbers));
            Output plain, simd;
            const Projection<float> projection(frustum);
            clip(method, projection, input, plain, Build::plain);
            clip(method, projection, input, simd);
            CHECK(first_difference(plain, simd) == std::nullopt);
          }
        }
      });
    }
  }
}

// Not run by default: `clipscope_batch_tests '[.long]'`, each time with other triangles.
TEST_CASE("batch: a long comparison of SIMD with the plain version", "[.long]") {
  const std::uint64_t seed = std::random_device()();
  CAPTURE(seed);
  Random random(seed);
  std::uint64_t coordinates = 0;
  for (int round = 0; round < 200; ++round) {
    const Soup soup = make_soup(random, kNumbers[round % kNumbers.size()], 4, 20000);
    for (const Method method : kStageMethods) {
      Output plain, simd;
      clip(method, {}, soup.array(), plain, Build::plain);
      clip(method, {}, soup.array(), simd);
      REQUIRE(first_difference(plain, simd) == std::nullopt);
      coordinates += simd.vertices().size();
    }
  }
  for (int round = 0; round < 200; ++round) {
    std::vector<Frustum<float>> frusta = some_frusta();
    const Frustum<float>& frustum = frusta[random() % (frusta.size() - 1)];  // not the sheared one
    const Projection<float> projection(frustum);
    const std::vector<float> vertices =
        vertices_about(frustum, 1.2f, random, 30000, 4, kNumbers[round % kNumbers.size()]);
    const ViewVertexArray input{vertices.data(), 30000, 4};
    for (const Method method : kFullMethods) {
      Output plain, simd;
      clip(method, projection, input, plain, Build::plain);
      clip(method, projection, input, simd);
      REQUIRE(first_difference(plain, simd) == std::nullopt);
      coordinates += simd.vertices().size();
    }
  }
  WARN(coordinates << " coordinates and attributes have equal bits");
}

}  // namespace clipscope::batch::tests
