// SPDX-License-Identifier: GPL-3.0-or-later
#include <span>

#include "experiments/scenes/builtin.hpp"
#include "experiments/scenes/scene.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;

TEST_CASE("samples: views are the same each time, shuffled, and within the limit") {
  const auto views = [] {
    return sampled_views(make_builtin_scene("soup", {.seed = 1, .quick = true}), 2000);
  };
  const auto a = views(), b = views();
  REQUIRE(a.size() == b.size());
  CHECK(a[0].triangles.size() <= 2000);
  CHECK(a[0].triangles.size() > 1000);
  CHECK(a[0].triangles[5][1].position == b[0].triangles[5][1].position);
  CHECK_FALSE(std::is_sorted(a[0].numbers.begin(), a[0].numbers.end()));
}

TEST_CASE("samples: evenly spaced values begin with the first and are no more than asked for") {
  const std::vector<int> values = {0, 1, 2, 3, 4, 5, 6};
  CHECK(evenly_spaced(values, 7) == values);
  CHECK(evenly_spaced(values, 100) == values);
  CHECK(evenly_spaced(values, 4) == std::vector<int>{0, 2, 4, 6});
  CHECK(evenly_spaced(values, 3) == std::vector<int>{0, 3, 6});
  CHECK(evenly_spaced(values, 1) == std::vector<int>{0});
  CHECK(evenly_spaced(std::vector<int>{}, 3).empty());
}

TEST_CASE("samples: views know the numbers of their triangles in the mesh") {
  const Scene scene = make_builtin_scene("slivers", {.seed = 1, .quick = true});
  for (const SampledView& v : sampled_views(scene, 300)) {
    REQUIRE(v.numbers.size() == v.triangles.size());
    for (std::size_t i = 0; i < v.numbers.size(); ++i) {
      SceneTriangle triangle;
      view_triangles(scene, v.view, v.numbers[i], std::span(&triangle, 1));
      REQUIRE(triangle[1].position == v.triangles[i][1].position);
    }
  }
}
