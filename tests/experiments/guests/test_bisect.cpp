// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/bisect.hpp"

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

constexpr int kRetriesLeft = 128, kPrice = 4;

// A guest that fails on whatever range has one of these primitives, and answers one vertex for each
// other one: its number.
struct Fragile {
  std::set<std::size_t> bad;
  Failure::Kind kind = Failure::Kind::crashed;
  Answers answers{kFormat<float>, 1};
  std::vector<Range> asked = {};
  // Alone neither of them is bad.
  std::optional<std::pair<std::size_t, std::size_t>> bad_together = {};

  std::optional<Failure> ask(const Range& range) {
    asked.push_back(range);
    const auto found = bad.lower_bound(range.first);
    if (found != bad.end() && *found < range.first + range.count) return Failure{kind, "it broke"};
    if (bad_together && range.first <= bad_together->first &&
        bad_together->second < range.first + range.count) {
      return Failure{kind, "it broke"};
    }
    return std::nullopt;
  }
  void keep(const Range& range) {
    for (std::size_t i = range.first; i < range.first + range.count; ++i) {
      answers.add(static_cast<double>(i));
      answers.end_polygon();
    }
  }
  void clip(std::size_t count) {
    Retries retries{.left = kRetriesLeft, .endless_price = kPrice};
    Bisection([this](const Range& r) { return ask(r); }, [this](const Range& r) { keep(r); },
              answers, retries)({0, count});
  }
};

TEST_CASE("bisect: who does not fail is asked once") {
  Fragile guest{{}};
  guest.clip(1000);
  CHECK(guest.asked.size() == 1);
  CHECK(guest.answers.size() == 1000);
}

TEST_CASE("bisect: each primitive that fails is found, the others keep their answers in order") {
  for (const std::size_t count : {1, 2, 3, 7, 100, 4096}) {
    Fragile guest{{0, count / 2, count - 1}};
    guest.clip(count);
    CAPTURE(count);
    REQUIRE(guest.answers.size() == count);
    for (std::size_t i = 0; i < count; ++i) {
      const PolygonView polygon = guest.answers[i];
      REQUIRE((polygon.failure() != nullptr) == (guest.bad.count(i) == 1));
      if (polygon.failure() == nullptr) REQUIRE(polygon[0][0].value == static_cast<double>(i));
      if (polygon.failure() != nullptr) CHECK(polygon.failure()->reason == "it broke");
    }
  }
}

TEST_CASE("bisect: who fails on everything is not asked for ever, and the rest fails as a whole") {
  Fragile guest{{}};
  for (std::size_t i = 0; i < 4096; ++i) guest.bad.insert(i);
  guest.clip(4096);
  CHECK(guest.asked.size() == 1 + kRetriesLeft);
  REQUIRE(guest.answers.size() == 4096);
  CHECK(guest.answers[0].failure()->reason == "it broke");
  CHECK_THAT(guest.answers[4095].failure()->reason,
             Catch::Contains("it broke, in a batch of 2048 that was not"));
}

TEST_CASE("bisect: one that does not end is found, and not many are waited for") {
  Fragile one{{1234}, Failure::Kind::timed_out};
  one.clip(4096);
  CHECK(one.answers[1234].failure()->reason == "it broke");
  CHECK(one.answers[1235].failure() == nullptr);
  Fragile all{{}, Failure::Kind::timed_out};
  for (std::size_t i = 0; i < 4096; ++i) all.bad.insert(i);
  all.clip(4096);
  CHECK(all.asked.size() == 1 + kRetriesLeft / kPrice);
}

TEST_CASE(
    "bisect: what only two of them bring about is blamed on the second, others are answered") {
  for (const auto& [first, second] : {std::pair{3, 900}, {499, 500}, {0, 999}, {501, 700}}) {
    Fragile guest{{}};
    guest.bad_together = {first, second};
    guest.clip(1000);
    CAPTURE(first, second);
    REQUIRE(guest.answers.size() == 1000);
    const auto blamed = static_cast<std::size_t>(second);
    for (std::size_t i = 0; i < 1000; ++i) {
      REQUIRE((guest.answers[i].failure() != nullptr) == (i == blamed));
      if (i != blamed) REQUIRE(guest.answers[i][0][0].value == static_cast<double>(i));
    }
    CHECK_THAT(guest.answers[blamed].failure()->reason, Catch::Contains("before it, not alone"));
  }
}

}  // namespace
}  // namespace clipscope::experiments
