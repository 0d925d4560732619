// SPDX-License-Identifier: GPL-3.0-or-later
//
// JUnit's XML, as CI systems read it: there is no standard, so this keeps to what all of them know
// (testsuites, testsuite, testcase, failure, skipped).
#include <fmt/format.h>

#include <algorithm>

#include "experiments/commands/verification.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments::commands {
namespace {

struct TestCase {
  std::string source, promise;
  std::string failure = "", details = "";  // empty: it passed
  std::string skipped = "";                // why
};

std::string xml_of(const TestCase& test, const std::string& clipper) {
  const std::string head =
      fmt::format("    <testcase classname=\"{}\" name=\"{}\"",
                  xml_escaped(clipper + "." + test.source), xml_escaped(test.promise));
  if (!test.failure.empty()) {
    return fmt::format("{}>\n      <failure message=\"{}\">{}</failure>\n    </testcase>\n", head,
                       xml_escaped(test.failure), xml_escaped(test.details));
  }
  if (test.skipped.empty()) return head + "/>\n";
  return fmt::format("{}>\n      <skipped message=\"{}\"/>\n    </testcase>\n", head,
                     xml_escaped(test.skipped));
}

TestCase test_case(const SourceFindings& source, Question question) {
  const QuestionTally& tally = source.found.of(question);
  TestCase test{source.name, std::string(name_of(question))};
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

std::vector<TestCase> test_cases(const Verification& verification) {
  std::vector<TestCase> tests;
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
  const std::vector<TestCase> tests = test_cases(verification);
  const auto count = [&](std::string TestCase::*what) {
    return std::ranges::count_if(tests, [&](const TestCase& t) { return !(t.*what).empty(); });
  };
  const std::string clipper = name_of(verification.sources.front().found.contestant());
  const std::string counts =
      fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\"", tests.size(),
                  count(&TestCase::failure), count(&TestCase::skipped));
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {}>\n  <testsuite name=\"{}\" {}>\n",
      counts, xml_escaped("clipscope verify " + clipper), counts);
  for (const TestCase& test : tests) text += xml_of(test, clipper);
  return text + "  </testsuite>\n</testsuites>\n";
}

}  // namespace clipscope::experiments::commands
