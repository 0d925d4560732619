// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "experiments/contestants/spoken.hpp"
#include "experiments/judge/compare.hpp"
#include "experiments/judge/promise.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/selection/select.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

// Ours under another name, in double alone, for OpenGL depth.
Contestant guest_called(std::string_view name) {
  Contestant guest = find_contestant("homogeneous/sutherland_hodgman", "double");
  guest.clipper = name;
  guest.promise = no_promise();
  guest.is_guest = true;
  guest.depths = {true, false, false};
  guest.most_attributes = 1;
  return guest;
}

std::size_t times_selected(std::string_view name, const Contestants& contestants) {
  return static_cast<std::size_t>(
      std::ranges::count(contestants, name, [](const Contestant* c) { return c->clipper; }));
}

}  // namespace

TEST_CASE("guests: one is a contestant like any other, under its own name") {
  const std::size_t before = all_contestants().size();
  const Contestant* first = all_contestants().data();
  add_guest(guest_called("neighbours_clip"));
  CHECK(all_contestants().size() == before + 1);
  CHECK(all_contestants().data() == first);
  CHECK(find_contestant("neighbours_clip", "double").is_guest);
  CHECK_THROWS_AS(find_contestant("neighbours_clip", "float"), UsageError);
  CHECK(spoken_contestant("neighbours_clip", "double") == "neighbours_clip");
}

TEST_CASE("guests: one is selected beside whatever else is, once, in the scalars that it has") {
  add_guest(guest_called("pattern_guest"));
  Selection selection;
  selection.guests = {"pattern_guest"};
  for (const char* pattern : {"*", "cvv/*", "textbook", "pattern_guest"}) {
    CAPTURE(pattern);
    selection.clipper = pattern;
    const Contestants selected = selected_contestants(selection);
    CHECK(times_selected("pattern_guest", selected) == 1);
    CHECK(selected.back()->is_guest);
  }
  selection.clipper = "*";
  CHECK(times_selected("pattern_guest", selected_contestants(selection, 2)) == 0);
  CHECK_THROWS_AS(select_contestants("no_such_clipper", {"double"}), UsageError);
  constexpr std::array<std::string_view, 2> kNames = {"textbook", "cvv/naive"};
  selection.clipper = Selection{}.clipper;
  CHECK(times_selected("pattern_guest", named_contestants(selection, kNames)) == 1);
  selection.scalars = {"float"};
  CHECK(times_selected("pattern_guest", selected_contestants(selection)) == 0);
}

TEST_CASE("guests: a name that there is already is an error") {
  add_guest(guest_called("twice"));
  CHECK_THROWS_AS(add_guest(guest_called("twice")), GuestError);
  CHECK_THROWS_AS(add_guest(guest_called("homogeneous/sutherland_hodgman")), GuestError);
  Contestant in_float = guest_called("twice");
  in_float.format = &kFormat<float>;
  CHECK_NOTHROW(add_guest(in_float));
}

TEST_CASE("guests: one is asked only for what it takes") {
  const Contestant guest = guest_called("modest");
  const Batch batch{.space = Space::clip, .attributes = 1};
  CHECK(guest.takes(batch));
  Batch other = batch;
  other.volume.depth = DepthRange::zero_to_one;
  CHECK_FALSE(guest.takes(other));
  other = batch;
  other.attributes = 2;  // the second one is left out
  CHECK(guest.takes(other));
  other = batch;
  other.planes = {{1, 0, 0, 0}};  // becomes an attribute, in place of the batch's own
  CHECK(guest.takes(other));
  other.planes.push_back({0, 1, 0, 0});  // which can't be left out
  CHECK_FALSE(guest.takes(other));
}

TEST_CASE("failures: where there is no answer an outcome says why, and every promise is broken") {
  const reference::Truth truth = reference::Truth::of_clip(DepthRange::minus_one_to_one);
  const std::vector<float> numbers = {0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 1};
  const Batch batch{.space = Space::clip, .numbers = std::span<const float>(numbers)};
  const std::vector<TruthPolygon> truths = truth_polygons(truth, batch);
  const std::pair<Failure::Kind, Outcome> kinds[] = {
      {Failure::Kind::crashed, Outcome::crashed},
      {Failure::Kind::timed_out, Outcome::timed_out},
      {Failure::Kind::malformed, Outcome::malformed}};
  for (const auto& [kind, outcome] : kinds) {
    Answers answers(kFormat<float>, 4);
    answers.fail({kind, "it stumbled"});
    REQUIRE(answers.size() == 1);
    CHECK(answers[0].empty());
    CHECK(answers[0].failure()->reason == "it stumbled");
    const Comparison comparison = compare(answers[0], truths[0]);
    CHECK(comparison.outcome == outcome);
    CHECK(is_failure(comparison.outcome));
    const PromiseCheck check =
        PromiseChecker(batch).check(no_promise(), input_vertices(batch, 0), 0, answers[0]);
    CHECK(check.verdict == PromiseVerdict::broken);
    CHECK(check.reason == "it stumbled");
  }
}

TEST_CASE("failures: other primitives of the answers have theirs") {
  Answers answers(kFormat<float>, 4);
  answers.end_polygon();
  answers.fail({Failure::Kind::crashed, "signal 11"});
  answers.end_polygon();
  CHECK(answers[0].failure() == nullptr);
  CHECK(answers[1].failure() != nullptr);
  CHECK(answers[2].failure() == nullptr);
}

TEST_CASE("no promise: whatever is answered keeps it") {
  const std::vector<float> numbers = {0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 1};
  const Batch batch{.space = Space::clip, .numbers = std::span<const float>(numbers)};
  Answers nothing(kFormat<float>, 4);
  nothing.end_polygon();
  const PromiseCheck check =
      PromiseChecker(batch).check(no_promise(), input_vertices(batch, 0), 0, nothing[0]);
  CHECK(check.verdict == PromiseVerdict::kept);
}

}  // namespace clipscope::experiments
