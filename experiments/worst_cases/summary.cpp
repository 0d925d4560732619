// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/contestants/spoken.hpp"
#include "experiments/table/prose.hpp"
#include "experiments/worst_cases/rows.hpp"

namespace clipscope::experiments::worst_cases {
namespace {

// What is left of double-double's 106 bits behind those of a float.
constexpr double kDoubleDoubleBits = 106 - 24;

std::optional<double> in_ulp_of_largest(const std::optional<double>& relative,
                                        std::string_view scalar) {
  if (!relative) return std::nullopt;
  const Format& format = scalar == kFormat<float>.name ? kFormat<float> : kFormat<double>;
  return *relative / format.ulp_at(1);
}

// In the first scalar.
std::string chain_sentence(const std::vector<WorstRow>& worst) {
  using R = WorstRow;
  if (worst.empty()) return "";
  std::vector<R> rows =
      rows_where(worst, &R::scalar, worst.front().scalar, &R::inputs, Inputs::in_domain);
  std::erase_if(rows, [](const R& row) { return !row.px; });
  if (rows.empty()) return "";
  const auto [best, last] = std::ranges::minmax_element(rows, {}, [](const R& r) { return *r.px; });
  std::string text = fmt::format("In {}, away from the eye, the largest known error on screen is ",
                                 spoken_scalar(best->scalar));
  if (rows.size() == 1) {
    return text +
           fmt::format("{} px with {}.", format_number(*best->px), spoken_clipper(best->clipper));
  }
  return text + fmt::format("the smallest with {}, {} px, and the largest with {}, {} px.",
                            spoken_clipper(best->clipper), format_number(*best->px),
                            spoken_clipper(last->clipper), format_number(*last->px));
}

bool reaches_limit(const TieRow& row) {
  constexpr double kNextTo = 4;
  return row.one_exponent_ulp && *row.one_exponent_ulp <= kNextTo * row.limit_ulp;
}

std::string limit_sentence(const std::vector<TieRow>& ties) {
  const double share = static_cast<double>(std::ranges::count_if(ties, reaches_limit)) /
                       static_cast<double>(ties.size());
  return fmt::format(
      " Where coordinates have one exponent, numbers can come no nearer to a tie than their divisors allow, and {} kinds are known within a factor of four of that.",
      quantity(share));
}

std::string digits_sentence(const std::vector<TieRow>& ties) {
  const auto beyond = [](const auto bits) {
    return [bits](const TieRow& row) {
      return std::invoke(bits, row).value_or(0) > kDoubleDoubleBits;
    };
  };
  const bool in_one = std::ranges::any_of(ties, beyond(&TieRow::one_exponent_bits));
  const bool in_any = std::ranges::any_of(ties, beyond(&TieRow::any_exponents_bits));
  if (in_one) return " Double-double has too few bits to round these.";
  return in_any ? " Double-double has bits enough for these, and too few where exponents differ."
                : " Double-double has bits enough for all that were found.";
}

// Of the ties, and of the campaigns of the correctly rounded clipper and of its batch form.
std::string rounding_sentence(const std::vector<TieRow>& ties,
                              const std::vector<CampaignRow>& campaigns) {
  if (!std::ranges::all_of(ties, &TieRow::is_right)) {
    return " The correctly rounded clipper rounds some of them WRONG.";
  }
  std::vector<CampaignRow> rounded;
  std::ranges::copy_if(campaigns, std::back_inserter(rounded), [](const CampaignRow& row) {
    return row.clipper.starts_with(correctly_rounded().clipper);
  });
  std::string text = " The correctly rounded clipper rounds all of them right, exact ties too";
  if (rounded.empty()) return text + ".";
  return text + (std::ranges::all_of(rounded, [](auto& row) { return row.misrounded == 0; })
                     ? ", and all that long campaigns tried."
                     : ", but not all that long campaigns tried.");
}

}  // namespace

std::optional<double> TieRow::bits_of(std::optional<double> ulp) {
  return ulp ? std::optional(-std::log2(*ulp)) : std::nullopt;
}

std::string spoken_kind(const TieKind& kind) {
  return fmt::format("{}, {} of {}", kind.space == Space::view ? "view" : "clip",
                     experiments::name_of(kind.quantity), experiments::name_of(kind.place));
}

std::vector<WorstRow> worst_rows(const std::vector<ChainRow>& records) {
  std::vector<WorstRow> rows;
  for (const ChainRow& r : records) {
    const bool is_next = rows.empty() || rows.back().clipper != r.clipper ||
                         rows.back().scalar != r.scalar || rows.back().inputs != r.inputs;
    if (is_next) rows.push_back({r.clipper, r.scalar, r.inputs, {}, {}, {}, {}});
    WorstRow& row = rows.back();
    switch (r.measure) {
      case hunt::Measure::px: row.px = r.worst; break;
      case hunt::Measure::ulp: row.ulp = r.worst; break;
      case hunt::Measure::depth: row.depth_ulp = r.worst; break;
      default: row.attribute_ulp = in_ulp_of_largest(r.worst, r.scalar); break;
    }
  }
  return rows;
}

Plot tie_plot(const std::vector<TieRow>& ties) {
  Plot plot{
      .name = "worst_cases_ties",
      .title = "How many bits behind the float decide how it is rounded",
      .caption =
          "By chance: random triangles. One exponent: constructed, and close to the limit of what is possible. Any exponents: the nearest to a tie that was found. Exact ties are left out.",
      .x = {.label = "number"},
      .y = {.label = "-log2 of the distance to a tie [ulp]"}};
  plot.categories = distinct(ties, &TieRow::kind);
  add_bars(plot, "by chance", ties, &TieRow::chance_bits, &TieRow::kind);
  add_bars(plot, "one exponent", ties, &TieRow::one_exponent_bits, &TieRow::kind);
  add_bars(plot, "any exponents", ties, &TieRow::any_exponents_bits, &TieRow::kind);
  return plot;
}

std::string finding(const std::vector<WorstRow>& worst, const std::vector<TieRow>& ties,
                    const std::vector<CampaignRow>& campaigns) {
  std::string text = chain_sentence(worst);
  if (!ties.empty()) {
    text += limit_sentence(ties) + digits_sentence(ties) + rounding_sentence(ties, campaigns);
  }
  if (text.empty()) return "No error was found, or no clipper was asked for that has records.";
  return text.starts_with(' ') ? text.substr(1) : text;
}

}  // namespace clipscope::experiments::worst_cases
