// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "experiments/commands/junit.hpp"
#include "experiments/commands/verification.hpp"
#include "experiments/machine/errors.hpp"

namespace clipscope::experiments::commands {
namespace {

JUnitTest test_case(const SourceFindings& source, Question question) {
  const QuestionTally& tally = source.found.of(question);
  JUnitTest test{source.name, std::string(name_of(question))};
  if (tally.first) {
    const Counterexample& c = *tally.first;
    test.failure = fmt::format("{}: {}", c.triangle.name, c.violation.reason);
    test.details = fmt::format("broken on {} of {} triangles\n{}\n{}\n", tally.broken, tally.judged,
                               hex_of(c), verify_command(source, c));
  } else if (tally.judged == 0) {
    test.skipped = fmt::format("judged on none of {} triangles", source.found.triangles);
  }
  return test;
}

std::vector<JUnitTest> test_cases(const Verification& verification) {
  std::vector<JUnitTest> tests;
  for (const SourceFindings& source : verification.sources) {
    Questions asked = source.found.asked();
    if (source.found.unanswered > 0) asked.add(Question::total);
    for (const Question q : asked.list()) tests.push_back(test_case(source, q));
  }
  if (exit_code(verification) == kExitNothingJudged) {
    const Examination all = findings(verification);
    tests.push_back({"all sources", "something was judged",
                     all.judged == 0 ? "no triangle was judged"
                                     : "a promise that was asked for was judged on no triangle",
                     fmt::format("{} triangles: {} outside the promise's domain, {} not taken\n",
                                 all.triangles, all.outside_domain, all.not_taken)});
  }
  return tests;
}

}  // namespace

std::string junit_of(const Verification& verification) {
  const std::string clipper = name_of(verification.sources.front().found.contestant());
  std::vector<JUnitTest> tests = test_cases(verification);
  for (JUnitTest& test : tests) test.class_name.insert(0, clipper + ".");
  return junit_text("clipscope verify " + clipper, tests);
}

}  // namespace clipscope::experiments::commands
