// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the answers are decided from: who was timed and judged on the same triangles, and who fails
// on which of the catalogue's themes.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/contestants/contract.hpp"
#include "experiments/table/results.hpp"
#include "experiments/table/statistics.hpp"

namespace clipscope::experiments::answers {

inline constexpr const char* kGameLike = "soup";  // as the frontier and cost call the mix
inline constexpr const char* kHard = "slivers";

struct Quality {
  double game_px = 0, hard_px = 0;        // the largest error on 3840 x 2160
  double game_wrong = 0, hard_wrong = 0;  // triangles with wrong vertices in a million
  double hard_misrounded = 0;             // percent of the coordinates
};

// Half the diagonal of 3840 x 2160, in px: how far 1 in NDC is from the middle of the screen.
inline constexpr double kHalfDiagonal = 2202.9;
// What rounding a result to float may move it by: coordinates in NDC by half an ulp, 2^-25; clip
// coordinates by 2^-24 of themselves each, x as well as w, 2^-23 of x/w together.
inline constexpr double kRoundingPx = kHalfDiagonal / (1 << 23);

// Whether `better` halves a figure of `worse` and doubles none; errors up to kRoundingPx are the
// same but for 0.
bool buys_something(const Quality& worse, const Quality& better);

// Ends of sentences that begin with who errs: "gets 8660 of a million hard triangles wrong".
std::string wrong_text(double per_million, std::string_view triangles);
std::string misrounded_text(double percent);

// A contestant that was timed on the game-like mix and judged there and on hard triangles.
struct Offer {
  Contract contract = Contract::full;
  std::string clipper, scalar;
  MedianInterval ns = {};
  Quality quality = {};
};

struct Tally {
  std::int64_t cases = 0, failures = 0;  // of those that the method takes

  Tally& operator+=(const Tally& other) {
    cases += other.cases;
    failures += other.failures;
    return *this;
  }
  double failed_percent() const {
    return cases == 0 ? 0 : 100 * static_cast<double>(failures) / static_cast<double>(cases);
  }
};

using Name = std::pair<std::string, std::string>;  // clipper, scalar

// The scalar contestant whose answers a batch clipper gives, rounded to float; any other itself.
// The catalogue's cases are mostly in clip space, which batch clippers take in a stage alone.
Name judged_as(const std::string& clipper, const std::string& scalar);

// Who was timed and judged on the same triangles.
class Contest {
 public:
  // Errors: MissingFigure, if the run has no frontier.
  explicit Contest(const Results& results);

  // Of a contract, by time.
  std::vector<Offer> offers(Contract contract) const;
  // Under that contract, or the full one if it was not timed in that. Errors: MissingFigure, if it
  // was timed in neither.
  const Offer& offer(const Name& name, Contract contract) const;

 private:
  std::vector<Offer> offers_;
};

// Who fails on which of the hard cases.
class Catalogue {
 public:
  // Errors: MissingFigure, if the run has no verdicts.
  explicit Catalogue(const Results& results);

  // In the order of the catalogue.
  const std::vector<std::string>& themes() const { return themes_; }
  // The number of cases in a theme.
  std::int64_t cases(const std::string& theme) const { return cases_.at(theme); }
  // How a contestant did on a theme, or on all; nothing counted if it was not asked.
  Tally tally(const Name& name, const std::string& theme) const;
  Tally tally(const Name& name) const;

 private:
  std::vector<std::string> themes_;
  std::map<std::string, std::int64_t> cases_;
  std::map<Name, std::map<std::string, Tally>> tallies_;
};

}  // namespace clipscope::experiments::answers
