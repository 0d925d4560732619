// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/global_control.h>

#include "experiments/scenes/builtin.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/survey/accuracy.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;

namespace {

std::vector<AccuracyTally> tallies(const std::string& scene_name, const std::string& clipper,
                                   const std::vector<std::string>& scalars,
                                   const AccuracyOptions& options = {.triangles_per_view = 100}) {
  const Scene scene = make_builtin_scene(scene_name, {.seed = 1, .quick = true});
  const auto contestants = select_contestants(clipper, scalars);
  std::vector<AccuracyTally> result(contestants.size());
  Progress progress("", sampled_triangles(scene, options));
  measure_accuracy(scene, contestants, options, result, progress);
  return result;
}

std::size_t place(Outcome outcome) { return static_cast<std::size_t>(outcome); }

}  // namespace

TEST_CASE("accuracy: clippers in exact arithmetic are exact on every scene") {
  for (const SceneInfo& info : builtin_scenes()) {
    for (const char* clipper : {"textbook", "view/*", "homogeneous/*", "cvv/near_first"}) {
      const AccuracyTally tally = tallies(std::string(info.name), clipper, {"exact"}).front();
      INFO(info.name << " " << clipper);
      CHECK(tally.outcomes[place(Outcome::exact)] == sum_of(tally.outcomes));
      CHECK(tally.attribute.max() == 0);
    }
  }
}

TEST_CASE("accuracy: more bits are more accurate") {
  const auto result = tallies("slivers", "homogeneous/*", {"float", "double", "double_double"});
  CHECK(result[0].position_px.quantile(0.5) > 1e6 * result[1].position_px.quantile(0.5));
  CHECK(result[1].position_px.quantile(0.5) > 1e6 * result[2].position_px.quantile(0.5));
}

TEST_CASE("accuracy: against the matrix's truth a float matrix costs nothing") {
  const auto frustum = tallies("teapot", "homogeneous/*", {"double"});
  const auto matrix =
      tallies("teapot", "homogeneous/*", {"double"},
              {.truth = clipscope::reference::TruthKind::matrix, .triangles_per_view = 100});
  // A double clipper uses a double matrix: judged by the float matrix it is as wrong as that is.
  CHECK(matrix[0].position_px.quantile(0.5) > 1e3 * frustum[0].position_px.quantile(0.5));
}

TEST_CASE("accuracy: whole-triangle dropping misses what it must and naive division goes astray") {
  const auto whole = tallies("corridor", "whole/any_outside", {"float"}).front();
  CHECK(whole.outcomes[place(Outcome::missing)] > 0);
  const auto naive = tallies("soup_behind", "cvv/naive", {"float"}).front();
  CHECK(naive.outcomes[place(Outcome::exact)] + naive.outcomes[place(Outcome::faithful)] +
            naive.outcomes[place(Outcome::subpixel)] <
        sum_of(naive.outcomes));
}

TEST_CASE("accuracy: the same table whatever the number of threads") {
  const auto many = tallies("soup", "*", {"float"});
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const auto one = tallies("soup", "*", {"float"});
  for (std::size_t i = 0; i < many.size(); ++i) {
    CHECK(many[i].outcomes == one[i].outcomes);
    CHECK(many[i].position_px.max() == one[i].position_px.max());
    CHECK(many[i].position_ulp.quantile(0.5) == one[i].position_ulp.quantile(0.5));
    CHECK(many[i].worst_position.triangle == one[i].worst_position.triangle);
  }
}
