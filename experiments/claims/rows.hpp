// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the claims' tables, and what makes them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/scenes/random.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/survey/draw_scene.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::claims {

// What the results say of a claim.
enum class Verdict : std::uint8_t {
  confirmed,    // in everything that was measured
  conditional,  // true only when ...
  refuted,      // in everything that was measured, or by a counterexample
  unsettled,    // rests on times, and the machine was busy when these were taken
  undecided     // a figure that it needs is not among the results
};
constexpr std::array<std::string_view, 5> names_of(Verdict) {
  return {"confirmed", "true only when", "refuted", "not settled", "undecided"};
}

struct Row {
  int number = 0;
  std::string statement;
  Verdict verdict = Verdict::undecided;
  std::string because, experiment;

  static constexpr std::string_view kName = "claims";
  static constexpr std::string_view kTitle = "Claims about clipping and the verdict of this run";
  static constexpr auto columns() {
    return std::tuple(
        column("number", "no", &Row::number), column("claim", "claim", &Row::statement, 30),
        column("verdict", &Row::verdict), column("because", "because", &Row::because, 35),
        column("experiment", "figures in", &Row::experiment));
  }
};

// So many of some exact cases have the quality that `quantity` names.
struct CountRow {
  int claim = 0;
  std::string title, quantity;
  std::int64_t cases = 0, count = 0;

  void add(bool has_it) {
    ++cases;
    count += has_it;
  }

  static constexpr std::string_view kName = "claims_counts";
  static constexpr std::string_view kTitle = "Exact cases for and against claims of geometry";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Rational arithmetic on random input, many coordinates on planes and at w = 0."};
  static constexpr auto columns() {
    using R = CountRow;
    return std::tuple(column("claim", &R::claim), column("title", "about", &R::title),
                      column("quantity", &R::quantity), column("cases", &R::cases),
                      column("count", &R::count));
  }
};

// A scene's picture made in two ways; see clipless.cpp.
struct PictureRow {
  std::string scene;
  std::optional<double> clipped_ns = {}, clipless_ns = {};
  std::optional<MedianInterval> speedup = {};
  std::int64_t clipped_wrong_px = 0, clipless_wrong_px = 0;

  static constexpr std::string_view kName = "claims_clipless";
  static constexpr std::string_view kTitle =
      "A picture by cutting, and by homogeneous edge functions alone";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "First view of each scene, 960 x 540, float, one core. Wrong: covered, but not in the exact picture, or the other way round; pixel centres on edges count as covered here, so a few are."};
  static constexpr auto columns() {
    using R = PictureRow;
    return std::tuple(column("scene", &R::scene),
                      column("clipped_ns", "cut [ns/tri]", &R::clipped_ns),
                      column("clipless_ns", "uncut [ns/tri]", &R::clipless_ns),
                      interval("speedup", "speedup", "x faster uncut", &R::speedup),
                      column("clipped_wrong_px", "cut: wrong [px]", &R::clipped_wrong_px),
                      column("clipless_wrong_px", "uncut: wrong [px]", &R::clipless_wrong_px));
  }
};

struct CountingTask {
  int claim = 0;
  std::string_view title;
  // Counts one random input, or all there are, in a row for each quantity.
  void (*count)(Random&, std::span<CountRow>);
  std::size_t times = 1;  // inputs for each one asked for; 0: counted once
  std::vector<std::string_view> quantities;
};

std::vector<CountingTask> counting_tasks();

// `size`: about how many random inputs. The same seed and size give the same counts.
std::vector<CountRow> count_cases(const CountingTask& task, std::uint64_t seed, std::size_t size);

// The scene as seen from the view. Pre-condition: its depth range is [-1, 1].
PictureRow time_clipless(const Scene& scene, const View& view, const PictureSize& size, int rounds);

}  // namespace clipscope::experiments::claims
