// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of cost, and that altered figures say otherwise.
#include "experiments/cost/rows.hpp"
#include "experiments/table/prose.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;
using namespace clipscope::experiments::cost;

namespace {

constexpr const char* kView = "view/sutherland_hodgman";
constexpr const char* kClip = "homogeneous/sutherland_hodgman";
constexpr const char* kCvv = "cvv/near_first";

struct Measured {
  std::vector<Row> times;
  std::vector<OperationsRow> operations;

  void add(const char* mix, const char* clipper, double ns, double arithmetic, double divisions) {
    Timing timing;
    timing.ns = {ns, ns - 1, ns + 1};
    times.push_back({mix, clipper, "float", timing});
    operations.push_back({mix, clipper, arithmetic - divisions, 0, divisions, 0});
  }
  std::string finding() const {
    const std::string text = space_finding(space_rows(times, operations));
    CHECK(faults_of_prose(text).empty());
    return text;
  }
};

CertaintyRow certainty_on(const char* mix, double price, Contract contract = Contract::copy,
                          InputFrom from = InputFrom::memory) {
  return {.mix = mix,
          .contract = contract,
          .from = from,
          .fastest = "homogeneous/batch",
          .price = {price, price - 0.02, price + 0.02}};
}

}  // namespace

TEST_CASE("cost: the finding says which space is the fastest, by the figures") {
  Measured measured;
  measured.add("soup", kView, 30, 80, 8);
  measured.add("soup", kClip, 20, 50, 8);
  measured.add("soup", kCvv, 25, 60, 12);
  CHECK(
      measured.finding() ==
      "Clip space is the fastest of three spaces: on the game-like mix dividing behind a near cut takes 1.25 times as long and view space 1.5 times. View space needs the most arithmetic, dividing behind a near cut the most divisions.");
  measured.times[0].timing->ns = {10, 9, 11};
  measured.operations[2].additions = 1000;
  CHECK(
      measured.finding() ==
      "View space is the fastest of three spaces: on the game-like mix clip space takes 2 times as long and dividing behind a near cut 2.5 times. Dividing behind a near cut needs the most arithmetic and the most divisions.");
}

TEST_CASE("cost: spaces whose intervals meet are equally fast") {
  Measured measured;
  measured.add("soup", kView, 30, 80, 8);
  measured.add("soup", kClip, 20, 50, 9);
  measured.add("soup", kCvv, 21, 60, 8);
  CHECK(measured.finding().starts_with(
      "Clip space and dividing behind a near cut are equally fast on the game-like mix, where view space takes 1.5 times as long."));
  measured.times[0].timing->ns = {21, 19, 22};
  CHECK(measured.finding().find("as long") == std::string::npos);
}

TEST_CASE("cost: the finding names the mixes on which another space is ahead") {
  Measured measured;
  for (const char* mix : {"soup", "soup_straddling"}) {
    measured.add(mix, kView, 30, 80, 8);
    measured.add(mix, kClip, 20, 50, 9);
  }
  CHECK(measured.finding().find("No other space is ahead on any other mix.") != std::string::npos);
  measured.times[2].timing->ns = {10, 9, 11};
  CHECK(measured.finding().find(
            "The order depends on the mix: view space is ahead on straddling triangles.") !=
        std::string::npos);
}

TEST_CASE("cost: the finding does without what is missing") {
  Measured measured;
  CHECK(measured.finding() == "None of the three spaces was timed.");
  measured.add("soup", kView, 30, 80, 8);
  CHECK(measured.finding() == "View space was compared with no other space on the game-like mix.");
}

TEST_CASE("cost: the table of spaces has the ratios to clip space on the same mix") {
  Measured measured;
  measured.add("soup", kView, 30, 80, 8);
  measured.add("soup", kClip, 20, 50, 16);
  const std::vector<SpaceRow> rows = space_rows(measured.times, measured.operations);
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].time == Approx(1.5));
  CHECK(rows[0].arithmetic == Approx(1.6));
  CHECK(rows[0].divisions == Approx(0.5));
  CHECK(rows[1].time == Approx(1));
}

TEST_CASE(
    "stage tables: the finding says where correct rounding is free, and where it is dearest") {
  CHECK(certainty_finding({}) == "");
  std::vector<CertaintyRow> rows = {
      certainty_on("game_like", 1.01), certainty_on("straddling", 1.1),
      certainty_on("straddling", 1.4, Contract::number, InputFrom::cache)};
  const auto checked = [&] {
    const std::string text = certainty_finding(rows);
    CHECK(faults_of_prose(text, {.figures = 0, .sentences = 1}).empty());
    return text;
  };
  CHECK(
      checked() ==
      "In a renderer's stage correct rounding is free on the game-like mix, and costs most on straddling triangles by number, from cache.");
  rows[1].price = {1.5, 1.45, 1.55};
  CHECK(checked().ends_with("costs most on straddling triangles by copy, from memory."));
  rows[0].price = {1.2, 1.1, 1.3};
  CHECK(checked().find("costs time on every mix, and most on") != std::string::npos);
  for (CertaintyRow& row : rows) row.price = {1.2, 0.99, 1.4};  // beyond chance it is not
  CHECK(checked().ends_with("is free on every mix, from memory and from cache."));
}
