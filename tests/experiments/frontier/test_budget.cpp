// SPDX-License-Identifier: GPL-3.0-or-later
//
// The error budget: its parts sum to the total, and each is made by the step that it is named after.
#include <tbb/global_control.h>

#include "experiments/budget/budget.hpp"
#include "experiments/measure/batches.hpp"
#include "experiments/measure/compare.hpp"
#include "experiments/report/row_view.hpp"
#include "experiments/scenes/builtin.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using reference::Fraction;
using reference::Rational;

namespace {

Scene scene_named(const std::string& name) {
  return make_builtin_scene(name, {.seed = 1, .quick = true});
}

template <class T>
StagedView<T> staged_view(const Scene& scene, std::size_t triangles) {
  const Sample sample = sample_of(scene, triangles);
  return StagedView<T>(scene.views[0],
                       sampled_view_triangles(scene, scene.views[0], sample, 0, sample.count));
}

// Calls f(stages, answer) for each triangle that has a budget; returns how many have.
template <class T, class F>
int for_each_budget(const std::string& clipper, const StagedView<T>& view, F&& f) {
  const auto* contestant =
      std::get<const Contestant<T>*>(find_contestant(clipper, std::string(ScalarTraits<T>::name)));
  PolygonStream<T, kSceneAttributes> answers;
  contestant->view(view.projection(), view.triangles(), answers);
  int count = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (!view.is_visible(i)) continue;
    if (const auto stages = view.stages(*contestant, i, answers[i])) {
      f(*stages, answers[i]);
      ++count;
    }
  }
  return count;
}

std::vector<BudgetTally> tallies(const std::string& scene_name, const std::string& clipper,
                                 const std::vector<std::string>& scalars = {"float"}) {
  const Scene scene = scene_named(scene_name);
  const auto contestants = budget_contestants(clipper, scalars);
  Progress progress("", 1);
  return measure_budget(scene, contestants, 150, progress);
}

const LogHistogram& px(const BudgetTally& tally, BudgetPart part) {
  return tally.parts[static_cast<std::size_t>(part)].px;
}

}  // namespace

TEST_CASE("budget: the way leads from the exact answer to the clipper's, bit for bit") {
  const std::string clipper =
      GENERATE(as<std::string>{}, "textbook", "view/sutherland_hodgman", "view/exact_sign",
               "homogeneous/sutherland_hodgman", "homogeneous/pipeline", "homogeneous/blinn_newell",
               "cvv/near_first", "barycentric/distance_matrix");
  const auto view = staged_view<float>(scene_named("soup_straddling"), 150);
  const int count = for_each_budget(clipper, view, [](const auto& way, const auto& answer) {
    REQUIRE(way.polygons.size() == way.parts.size() + 1);
    for (std::size_t v = 0; v < answer.size(); ++v) {
      for (std::size_t c = 0; c < 4; ++c) {
        const double last = answer[v].position[static_cast<int>(c)];
        REQUIRE(to_rational(way.polygons.back()[v][c]) == Rational(last));
        Rational sum = to_rational(way.polygons.front()[v][c]);
        for (std::size_t s = 0; s < way.parts.size(); ++s) {
          sum +=
              Rational(to_rational(way.polygons[s + 1][v][c]) - to_rational(way.polygons[s][v][c]));
        }
        REQUIRE(sum == Rational(last));
      }
    }
  });
  INFO(clipper);
  CHECK(count > (clipper == "cvv/near_first" ? 100 : 140));  // not those across the near plane
}

TEST_CASE("budget: before the divide the quotients round to the answer, once") {
  const auto view = staged_view<double>(scene_named("soup_behind"), 100);
  for (const char* clipper :
       {"textbook", "homogeneous/sutherland_hodgman", "homogeneous/pipeline"}) {
    const int count = for_each_budget(clipper, view, [](const auto& way, const auto& answer) {
      const StagePolygon& before = way.polygons[way.polygons.size() - 2];
      for (std::size_t v = 0; v < answer.size(); ++v) {
        for (std::size_t c = 0; c < 4; ++c) {
          REQUIRE(reference::round_to<double>(before[v][c]) ==
                  answer[v].position[static_cast<int>(c)]);
        }
      }
    });
    CHECK(count > 50);
  }
}

TEST_CASE("budget: the divide costs half an ulp at most, wherever it comes last") {
  for (const char* clipper : {"view/sutherland_hodgman", "homogeneous/sutherland_hodgman"}) {
    const BudgetTally tally = tallies("soup_straddling", clipper).front();
    const auto& ulp = tally.parts[static_cast<std::size_t>(BudgetPart::divide)].ulp;
    CHECK(ulp.max() > 0.25);
    CHECK(ulp.max() <=
          1.0);  // half an ulp of the quotient, whose ulp may be twice the exact value's
  }
}

TEST_CASE("budget: what is not cut costs nothing to cut") {
  for (const char* clipper :
       {"view/sutherland_hodgman", "homogeneous/sutherland_hodgman", "cvv/near_first"}) {
    const BudgetTally tally = tallies("soup_inside", clipper).front();
    CHECK(tally.triangles > 100);
    CHECK(tally.left_out == 0);
    CHECK(px(tally, BudgetPart::cut).max() == 0);
    CHECK(px(tally, BudgetPart::transform).max() > 0);
    CHECK(px(tally, BudgetPart::total).max() > 0);
  }
}

TEST_CASE("budget: the total is what compare calls the position error") {
  const auto view = staged_view<float>(scene_named("soup_straddling"), 100);
  const auto truth = reference::Truth::of_frustum(
      frustum_cast<double>(scene_named("soup_straddling").views[0].frustum));
  const auto* contestant = std::get<const Contestant<float>*>(
      find_contestant("homogeneous/sutherland_hodgman", "float"));
  PolygonStream<float, kSceneAttributes> answers;
  contestant->view(view.projection(), view.triangles(), answers);
  int count = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const auto errors = view.errors(*contestant, i, answers[i]);
    if (!errors) continue;
    const Comparison expected = compare<float, kSceneAttributes>(
        answers[i], truth_polygon(truth, reference::input_triangle(view.source(i))));
    const PartError& total = (*errors)[static_cast<std::size_t>(BudgetPart::total)];
    CHECK(total.px == Approx(expected.position_px).epsilon(0x1p-20));
    CHECK(total.ulp == Approx(expected.position_ulp).epsilon(0x1p-20));
    ++count;
  }
  CHECK(count > 90);
}

TEST_CASE("budget: a double's parts are smaller by what its precision promises") {
  const auto result = tallies("teapot", "homogeneous/sutherland_hodgman", {"float", "double"});
  for (const BudgetPart part : {BudgetPart::transform, BudgetPart::total}) {
    const double ratio = px(result[0], part).quantile(0.5) / px(result[1], part).quantile(0.5);
    CHECK(ratio > 0x1p26);
    CHECK(ratio < 0x1p32);
  }
}

TEST_CASE("budget: an answer with a vertex too many has none") {
  const auto view = staged_view<float>(scene_named("soup_inside"), 20);
  const auto* contestant = std::get<const Contestant<float>*>(
      find_contestant("homogeneous/sutherland_hodgman", "float"));
  PolygonStream<float, kSceneAttributes> answers;
  contestant->view(view.projection(), view.triangles(), answers);
  std::vector<NdcVertex<float, kSceneAttributes>> altered(answers[0].begin(), answers[0].end());
  REQUIRE(view.stages(*contestant, 0, altered));
  altered.push_back(altered[0]);
  CHECK_FALSE(view.stages(*contestant, 0, altered));
  altered.pop_back();
  altered[0].position[0] += 0.25f;  // not what the clipper says when asked again
  CHECK_FALSE(view.stages(*contestant, 0, altered));
}

TEST_CASE("budget: methods that do not cut, or cut by other planes, have none") {
  for (const AnyContestant& any : budget_contestants("*", {"float"})) {
    const std::string name(clipper_name(any));
    CHECK_FALSE(name.starts_with("whole/"));
    CHECK(name != "homogeneous/guard_band");
    CHECK(name != "homogeneous/w_first_1e-5");
  }
  CHECK(budget_contestants("*", {"exact"}).empty());
}

TEST_CASE("budget: the same whatever the number of threads") {
  const auto many = tallies("slivers", "*");
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const auto one = tallies("slivers", "*");
  for (std::size_t i = 0; i < many.size(); ++i) {
    CHECK(many[i].triangles == one[i].triangles);
    CHECK(many[i].left_out == one[i].left_out);
    CHECK(many[i].worst_triangle == one[i].worst_triangle);
    for (const BudgetPart part : kBudgetParts)
      CHECK(px(many[i], part).max() == px(one[i], part).max());
  }
}
