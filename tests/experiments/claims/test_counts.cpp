// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/claims/rows.hpp"

#include <map>

#include "experiments/claims/random_cases.hpp"
#include "reference/exact_clip.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::claims {
namespace {

std::map<std::string, CountRow> counts_of(int claim) {
  std::map<std::string, CountRow> counts;
  for (const CountingTask& task : counting_tasks()) {
    if (task.claim != claim) continue;
    for (const CountRow& row : count_cases(task, 1, 200)) counts[row.quantity] = row;
  }
  return counts;
}

TEST_CASE("claims: every count has cases, and the same seed gives the same") {
  for (const CountingTask& task : counting_tasks()) {
    INFO("claim " << task.claim);
    const auto first = count_cases(task, 7, 50), second = count_cases(task, 7, 50);
    REQUIRE(first.size() == second.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
      CHECK(first[i].claim == task.claim);
      CHECK(first[i].title == task.title);
      CHECK(first[i].cases > 0);
      CHECK(first[i].count <= first[i].cases);
      CHECK(first[i].cases == second[i].cases);
      CHECK(first[i].count == second[i].count);
    }
  }
}

TEST_CASE("claims: theorems have no counterexample and false claims have some") {
  CHECK(counts_of(5)["disagrees, depth [-1, 1]"].count == 0);
  CHECK(counts_of(5)["disagrees, depth [0, 1]"].count > 0);
  CHECK(counts_of(9)["attribute at t in clip space is wrong"].count == 0);
  CHECK(counts_of(9)["attribute at t after the divide is wrong"].count > 0);
  CHECK(counts_of(10)["corners off the plane, aspect 1"].count == 0);
  CHECK(counts_of(10)["corners off the plane, aspect not 1"].count > 0);
  CHECK(counts_of(16)["a convex polygon leaves one that is not"].count == 0);
  CHECK(counts_of(16)["a concave polygon leaves several"].count > 0);
  CHECK(counts_of(25)["denominator 0"].count == 0);
  CHECK(counts_of(26)["9 vertices"].count > 0);
  CHECK(counts_of(26)["more than 9 vertices"].count == 0);
}

TEST_CASE("claims: a vertex outside one plane leaves four vertices, or fewer with another on it") {
  for (const CountingTask& task : counting_tasks()) {
    if (task.claim != 8) continue;
    const auto counts = count_cases(task, 1, 4000);  // as many as a full run
    CHECK(counts[0].count + counts[1].count == counts[0].cases);
    CHECK(counts[1].count > 0);
    CHECK(counts[2].count == 0);
  }
}

TEST_CASE("claims: the generator of single outsiders keeps its word") {
  Random random(3);
  const auto truth = reference::Truth::of_clip(DepthRange::minus_one_to_one);
  for (int i = 0; i < 200; ++i) {
    const auto t = one_vertex_outside(random);
    for (std::size_t v = 0; v < 3; ++v) {
      const auto verdict = reference::classify(truth, std::span(&t.vertices[v], 1), 0);
      CHECK((verdict == reference::Verdict::accepted) == (v > 0));
    }
    const auto axis = static_cast<std::size_t>(outside_axis(t.vertices[0]));
    CHECK(std::abs(t.vertices[0].position[axis]) > t.vertices[0].position[3]);
  }
}

TEST_CASE("claims: convex polygons have their whole picture in front of the eye") {
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    for (const auto& v : convex_clip_polygon(random)) CHECK(v.position[3] > Exact(0));
  }
}

}  // namespace
}  // namespace clipscope::experiments::claims
