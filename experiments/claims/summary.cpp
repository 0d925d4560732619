// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the verdicts on the claims say together.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "experiments/claims/ranking.hpp"

namespace clipscope::experiments::claims {
namespace {

// How many claims got each verdict.
class Tally {
 public:
  void add(const Row& row) { ++counts_[static_cast<std::size_t>(row.verdict)]; }
  int of(Verdict verdict) const { return counts_[static_cast<std::size_t>(verdict)]; }
  int judged() const {
    return of(Verdict::confirmed) + of(Verdict::conditional) + of(Verdict::refuted);
  }
  double refuted_share() const { return judged() == 0 ? 0 : 1.0 * of(Verdict::refuted) / judged(); }

 private:
  std::array<int, claims::names_of(Verdict{}).size()> counts_{};
};

bool is_ranking(const Row& row) {
  return std::ranges::any_of(published_rankings(),
                             [&](const Ranking& ranking) { return ranking.number == row.number; });
}

// Where the published winners win most often.
std::string winners_text(const Tally& rankings) {
  const int everywhere = rankings.of(Verdict::confirmed);
  const int somewhere = rankings.of(Verdict::conditional), nowhere = rankings.of(Verdict::refuted);
  if (nowhere >= std::max(everywhere, somewhere)) return "nowhere";
  return somewhere >= everywhere ? "on some mixes alone" : "everywhere";
}

std::string part_text(int part, int all) {
  if (2 * part == all) return "Half of";
  return 2 * part > all ? "Most of" : "Less than half of";
}

std::string comparison_text(const Tally& rankings, const Tally& others) {
  const double share = rankings.refuted_share(), other = others.refuted_share();
  if (share == other) return "as often as";
  return share > other ? "more often than" : "less often than";
}

}  // namespace

std::string finding_text(const std::vector<Row>& claims) {
  Tally all, rankings, others;
  for (const Row& row : claims) {
    all.add(row);
    (is_ranking(row) ? rankings : others).add(row);
  }
  const int confirmed = all.of(Verdict::confirmed), judged = all.judged();
  const bool busy = all.of(Verdict::unsettled) > 0;
  if (judged == 0) {
    return busy ? "No claim could be judged: the machine was busy."
                : "No claim could be judged, for want of figures.";
  }
  std::string text = fmt::format(
      "{} what is said about clipping holds as it stands: {} of {} claims are confirmed.",
      part_text(confirmed, judged), confirmed, judged);
  if (all.of(Verdict::conditional) > 0) {
    text += fmt::format(" {} of the others hold under a condition that the figures show.",
                        all.of(Verdict::conditional) > all.of(Verdict::refuted) ? "Most" : "Some");
  }
  if (rankings.judged() > 0 && others.judged() > 0) {
    text += fmt::format(
        " It depends on the kind of claim: published rankings of speed are refuted {} the rest, and their winners most often win {}.",
        comparison_text(rankings, others), winners_text(rankings));
  }
  if (busy) text += " Some claims are not settled, since the machine was busy.";
  if (all.of(Verdict::undecided) > 0) text += " Some claims are undecided for want of figures.";
  return text;
}

}  // namespace clipscope::experiments::claims
