// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of accuracy and time, and that altered figures say otherwise.
#include "experiments/frontier/rows.hpp"
#include "experiments/table/prose.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;
using namespace clipscope::experiments::frontier;

namespace {

constexpr const char* kFast = "homogeneous/batch";
constexpr const char* kDouble = "homogeneous/batch_double";
constexpr const char* kRounded = "barycentric/correctly_rounded_batch";

Row row(const char* set, Contract contract, const char* clipper, double ns, double misrounded) {
  Row r;
  r.set = set;
  r.contract = contract;
  r.clipper = clipper;
  r.scalar = "float";
  r.timing = Timing{};
  r.timing->ns = {ns, ns, ns};
  r.misrounded_percent = misrounded;
  r.by_px.standing = Standing::frontier;
  return r;
}

std::vector<Row> stage() {
  return {row("soup", Contract::copy, kFast, 100, 1), row("soup", Contract::copy, kRounded, 104, 0),
          row("slivers", Contract::copy, kFast, 100, 1),
          row("slivers", Contract::copy, kDouble, 130, 0),
          row("slivers", Contract::copy, kRounded, 140, 0)};
}

std::string checked_finding(const std::vector<Row>& rows) {
  const std::string text = finding(rows);
  INFO(text);
  CHECK(faults_of_prose(text).empty());
  return text;
}

}  // namespace

TEST_CASE("frontier: the finding names the price of correct rounding, by the times") {
  std::vector<Row> rows = stage();
  CHECK(
      checked_finding(rows) ==
      "In the stage of a renderer correct rounding is nearly free on the game-like mix, where it takes 4 % more time than the fastest clipper. On slivers it costs less than half as much time again, at 40 % more time. What it buys is the proof: on slivers the double batch clipper has every coordinate right, too, and is faster.");
  rows.back().timing->ns.median = 300;
  CHECK(checked_finding(rows).find(
            "On slivers it more than doubles the time, at 200 % more time.") != std::string::npos);
  rows.back().timing->ns.median = 106;
  CHECK(
      checked_finding(rows) ==
      "In the stage of a renderer correct rounding is nearly free on the game-like mix, where it takes 4 % more time than the fastest clipper. On no set is it dearer than on slivers, at 6 % more time.");
  rows.back().timing->ns.median = 101;
  CHECK(
      checked_finding(rows) ==
      "In the stage of a renderer correct rounding is nearly free on the game-like mix, where it takes 4 % more time than the fastest clipper.");
}

TEST_CASE("frontier: the dearest set may be one from cache") {
  std::vector<Row> rows = stage();
  for (const auto& [clipper, ns] : {std::pair{kFast, 50}, std::pair{kRounded, 80}}) {
    rows.push_back(row("slivers", Contract::copy, clipper, ns, clipper == kFast ? 1 : 0));
    rows.back().from = InputFrom::cache;
  }
  CHECK(checked_finding(rows).find(
            "On slivers from cache it costs less than twice the time, at 60 % more time.") !=
        std::string::npos);
}

TEST_CASE("frontier: without the stage the price is that from view space on") {
  const std::vector<Row> rows = {row("soup", Contract::full, kFast, 100, 1),
                                 row("soup", Contract::full, kRounded, 180, 0)};
  CHECK(checked_finding(rows).starts_with(
      "From view space on correct rounding costs less than twice the time on the game-like mix, where it takes 80 % more time than the fastest clipper."));
}

TEST_CASE("frontier: the finding says by which scalars the frontier leads, and who is beaten") {
  std::vector<Row> rows = {row("soup", Contract::full, kFast, 10, 1),
                           row("soup", Contract::full, "homogeneous/sutherland_hodgman", 20, 1),
                           row("soup", Contract::full, "view/sutherland_hodgman", 30, 1)};
  rows[1].scalar = "double";
  rows[2].by_px.standing = Standing::dominated;
  CHECK(
      checked_finding(rows) ==
      "No clipper that promises correct rounding was timed. From view space on, on the game-like mix, smaller errors are bought by going from float to double; some contestants are beaten in both error and time.");
  rows[1].by_px.standing = Standing::dominated;
  CHECK(checked_finding(rows).find(
            "all that is worth its time computes in float; most contestants") != std::string::npos);
}
