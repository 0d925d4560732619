// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/promise.hpp"
#include "experiments/segments/mixes.hpp"
#include "experiments/selection/select.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;
using namespace clipscope::experiments::segments;

TEST_CASE("segment promise: every clipper keeps its own on every mix, in every scalar") {
  std::vector<std::string> scalars;
  for (const std::string_view scalar : scalar_names()) scalars.emplace_back(scalar);
  for (const std::string& name : builtin_mixes()) {
    const SegmentView made = make_mix(name, 20, 2).views.front();
    const Batch batch = made.batch();
    const PromiseChecker checker(batch.frustum);
    for (const Contestant* contestant : select_contestants("*", scalars, 2)) {
      const Answers answers = clip(*contestant, batch);
      REQUIRE(answers.size() == made.segments.size());
      for (std::size_t i = 0; i < answers.size(); ++i) {
        const PromiseCheck result = checker.check(contestant->promise, input_vertices(batch, i),
                                                  batch.attributes, answers[i]);
        INFO(name << " " << name_of(*contestant) << " segment " << i << ": " << result.reason);
        CHECK(result.verdict != PromiseVerdict::broken);
      }
    }
  }
}
