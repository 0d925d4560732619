// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cases as batches, and what is added up of many examined triangles.
#include "experiments/catalogue/catalogue.hpp"
#include "experiments/judge/cycle.hpp"
#include "experiments/survey/case_batch.hpp"
#include "experiments/survey/examination.hpp"
#include "experiments/survey/guest_verdicts.hpp"
#include "experiments/survey/lattice_sweep.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/judge/guest.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

const char* const kChain = "homogeneous/sutherland_hodgman";
const Spoil kHonest = [](const GuestCall&, Numbers&) {};

std::vector<const HardCase*> triangles_of_catalogue() {
  std::vector<const HardCase*> cases;
  for (const HardCase& c : builtin_catalogue()) {
    if (c.primitive == Primitive::triangle) cases.push_back(&c);
  }
  return cases;
}

Examination examined(const Contestant& guest, std::size_t chunk, const Questions& asked) {
  Examination examination(guest, Questions::all(), asked);
  const SweepChunk triangles = random_chunk(1, chunk, 300);
  examination.add(triangles.batch(), [](std::size_t i) { return "triangle " + std::to_string(i); });
  return examination;
}

}  // namespace

TEST_CASE("case batch: a case is given as alone, whichever group it is in") {
  const auto cases = triangles_of_catalogue();
  const Contestant& contestant = find_contestant(kChain, "float");
  std::size_t seen = 0;
  const auto groups = alike(cases, 50);
  CHECK(groups.size() < cases.size() / 2);
  for (const auto& group : groups) {
    CHECK(group.size() <= 50);
    const CaseBatch batch(group);
    REQUIRE(batch.size() == group.size());
    const Answers together = clip(contestant, batch);
    for (std::size_t i = 0; i < group.size(); ++i, ++seen) {
      const Answers alone = clip(contestant, CaseBatch(*group[i]));
      REQUIRE(alone[0].size() == together[i].size());
      for (std::size_t v = 0; v < alone[0].size(); ++v) {
        CHECK(same_vertex(alone[0][v], together[i][v], Likeness::by_bits));
      }
      const HardCase again = case_of(batch, i, group[i]->name);
      CHECK(again.volume == group[i]->volume);
      CHECK(again.vertices[2].position == group[i]->vertices[2].position);
    }
  }
  CHECK(seen == cases.size());
}

TEST_CASE("examination: what is counted is counted once, and the first counterexample is kept") {
  const Contestant guest = guest_like(
      kChain,
      [](const GuestCall& call, Numbers& polygon) {
        if (call.primitive % 10 == 3 && polygon.size() > 3) polygon.pop_back();
      },
      [](const GuestCall& call) { return call.primitive == 7 && call.batch.size() == 300; });
  const Questions asked = {Question::total, Question::covers};
  Examination found = examined(guest, 1, asked);
  CHECK(found.triangles == 300);
  CHECK(found.unanswered == 1);
  CHECK(found.judged + found.outside_domain + found.not_taken == 300);
  const QuestionTally& covers = found.of(Question::covers);
  REQUIRE(covers.broken > 0);
  CHECK(covers.first->triangle.name.ends_with("3"));
  CHECK(covers.first->violation.question == Question::covers);
  CHECK(found.broken == covers.broken + 1);
  CHECK(found.first_broken() == &*found.of(Question::total).first);
  CHECK_FALSE(found.kept().contains(Question::total));
  CHECK(found.kept().contains(Question::contained));

  const Examination next = examined(guest, 3, asked);
  const std::size_t both = found.broken + next.broken;
  const std::string first = covers.first->triangle.name;
  found += next;
  CHECK(found.triangles == 600);
  CHECK(found.broken == both);
  CHECK(found.of(Question::covers).first->triangle.name == first);
}

TEST_CASE("examination: what the bounds don't speak of is compared all the same") {
  std::vector<float> numbers = {0, 0, 0, 1, 3e38f, 0, 0, 1, 0, 3e38f, 0, 1};
  const Batch batch{.space = Space::clip, .numbers = std::span<const float>(numbers)};
  Examination found(find_contestant("textbook", "float"), {Question::covers}, {Question::covers});
  found.add(batch, [](std::size_t) { return "far"; });
  CHECK(found.outside_domain == 1);
  CHECK(found.judged == 0);
  CHECK(sum_of(found.wrong_outside) == 1);
  const Contestant nothing = guest_like(kChain, [](const GuestCall&, Numbers& p) { p.clear(); });
  Examination lost(nothing, {Question::covers}, {Question::covers});
  lost.add(batch, [](std::size_t) { return "far"; });
  CHECK(lost.wrong_outside[static_cast<std::size_t>(Outcome::missing)] == 1);
}

TEST_CASE("examination: who does not take a batch is not judged on it") {
  Contestant guest = guest_like(kChain, kHonest);
  guest.depths = {true, false, false};
  std::size_t not_taken = 0;
  for (std::size_t chunk = 0; chunk < 8; ++chunk) {
    const Examination found = examined(guest, chunk, {Question::total});
    not_taken += found.not_taken;
    CHECK(found.judged + found.not_taken + found.outside_domain == 300);
  }
  CHECK(not_taken > 0);
  CHECK(not_taken < 8 * 300);
}

TEST_CASE("guest verdicts: batches give what case after case gives") {
  const auto cases = triangles_of_catalogue();
  const Contestant& ours = find_contestant(kChain, "float");
  const Contestant guest = guest_like(kChain, kHonest);
  const std::vector<CaseVerdict> verdicts = judge_in_batches(guest, cases);
  REQUIRE(verdicts.size() == cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    INFO(cases[i]->name);
    const Comparison expected = judge_case(ours, *cases[i], truth_polygon(*cases[i]));
    CHECK(verdicts[i].comparison.outcome == expected.outcome);
    CHECK(verdicts[i].comparison.position_px == expected.position_px);
  }
}

TEST_CASE("guest verdicts: a guest stands in the columns of judge_cases and judge_families") {
  const Contestant spoiled = guest_like(kChain, [](const GuestCall&, Numbers& p) { p.clear(); });
  CaseSet set{
      Primitive::triangle, triangles_of_catalogue(), {&find_contestant(kChain, "float"), &spoiled}};
  set.cases.resize(12);
  Progress progress("", 0);
  const auto verdicts = judge_cases(set, progress);
  std::size_t missing = 0;
  for (const auto& row : verdicts) missing += row[1].comparison.outcome == Outcome::missing;
  CHECK(missing > 0);
  const auto tallies = judge_families(set, progress);
  CHECK(tallies[1].variants == tallies[0].variants);
  CHECK(tallies[1].failures > tallies[0].failures);
  CHECK(tallies[1].broken > 0);
  CHECK_FALSE(tallies[1].offender.empty());
  const auto policy = judge_special_values(set, progress);
  CHECK(policy[1].inputs == policy[0].inputs);
  CHECK(policy[1].drawn == 0);
}
