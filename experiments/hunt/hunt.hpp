// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hunt: a search for the input on which a contestant is worst by one measure. Whatever it finds
// is a lower bound.
//
// Some islands breed prey, each against a setting of its own: chance, changes of what was worst
// there so far, mixtures of two (breeding.hpp). All prey of an island's litter is one batch. An
// island that finds nothing worse for some rounds starts anew with another setting, half of the
// time among the cases of the catalogue, sometimes where the worst of all was found.
//
// Source: Chiang, Gopalakrishnan, Rakamaric and Solovyev, "Efficient Search for Inputs Causing High
// Floating-point Errors", 2014, here with islands, and with changes that know the planes.
//
// Deterministic: a round has the same prey whatever the number of threads, so that the same seed
// and the same number of evaluations find the same. Time decides only how many rounds are made.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/hunt/evaluation.hpp"
#include "experiments/hunt/measure.hpp"

namespace clipscope::experiments::hunt {

struct HuntOptions {
  Measure measure = Measure::px;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> evaluations = {};  // triangles, or pairs of them; else as many as
  double seconds = 10;                            // go into this time, in whole rounds
  bool catalogue = true;                          // begin with the hard cases, too
  std::optional<Space> space = {};                // in this alone
  bool plain = false;                             // the closed volume of six planes alone
  // Triangles alone that the bounds of `covers` speak of (judge/questions.hpp): their numbers stay
  // in the format, and what is visible keeps away from the eye. For px, ulp, depth and attribute.
  bool in_domain = false;
  // The worst that is known: islands settle where it is, and only what is worse replaces it. Not
  // for crack.
  std::optional<HardCase> begin_with = {};
};

struct Trophy {
  double value = 0;             // of the measure, exact
  std::vector<HardCase> cases;  // the triangle; of `crack` its neighbour, too
};

struct Hunted {
  std::uint64_t evaluations = 0;
  double seconds = 0;
  std::optional<Trophy> worst = {};  // nothing if the measure was 0 throughout
  // The first primitive of each outcome that is a failure; not looked for by `crack`.
  std::array<std::optional<HardCase>, kOutcomes> failing = {};
};

// Pre-condition: the contestant takes triangles under the full contract. after_round is told how
// far the hunt is.
Hunted hunt(const Contestant& contestant, const HuntOptions& options,
            const std::function<void(const Hunted&)>& after_round = {});
// The same where another than the contestant's answers is rated; the measure says which numbers of
// the prey change, and no more.
Hunted hunt(const Contestant& contestant, const HuntOptions& options, const Rater& rater,
            const std::function<void(const Hunted&)>& after_round = {});

}  // namespace clipscope::experiments::hunt
