// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/answers/rows.hpp"
#include "experiments/table/prose.hpp"

namespace clipscope::experiments::answers {
namespace {

struct Colour {
  std::string_view folder, name;
};
// In the order of a plot's colours.
constexpr std::array kColours = {Colour{"homogeneous", "clip space"},
                                 Colour{"cvv", "after the divide"}, Colour{"view", "view space"},
                                 Colour{"barycentric", "barycentric"}};

// Nobody is wrong by so little on a set of thousands of triangles: the line beneath all others.
constexpr double kNone = 10;

double height(double wrong_per_million) { return std::max(wrong_per_million, kNone); }

std::string folder_of(const std::string& clipper) { return clipper.substr(0, clipper.find('/')); }

// The name of the step that an offer is, without an article; empty if it is none.
std::string step_name(const PriceList& prices, const Offer& offer) {
  const PriceRow* step =
      find_row(prices.steps, &PriceRow::clipper, offer.clipper, &PriceRow::scalar, offer.scalar);
  if (step == nullptr) return "";
  return step->step.starts_with("the ") ? step->step.substr(4) : step->step;
}

// "+41 % time", or how many times as long where percents become hard to read.
std::string price_text(double percent) {
  if (percent < 300) return fmt::format("+{:.0f} % time", percent);
  return times_text(1 + percent / 100) + " the time";
}

// Points of one folder's clippers, the steps of the price list with their names.
Series points_of(const std::string_view folder, const std::string_view name,
                 const std::vector<Offer>& offers, const PriceList& prices) {
  Series series{.name = std::string(name), .marks = Marks::points};
  for (const Offer& offer : offers) {
    if (folder_of(offer.clipper) != folder) continue;
    series.add(offer.ns.median, height(offer.quality.hard_wrong));
    series.labels.push_back(step_name(prices, offer));
  }
  return series;
}

// From step to step, with what each costs over the one before at the middle of its stretch.
Series price_line(const PriceList& prices) {
  Series line{.name = "price list", .marks = Marks::line};
  const auto add = [&](double ns, double wrong, const std::string& label) {
    line.add(ns, wrong);
    line.labels.push_back(label);
  };
  for (std::size_t i = 0; i < prices.steps.size(); ++i) {
    const PriceRow& step = prices.steps[i];
    const double at = height(step.quality.hard_wrong);
    if (i > 0) {
      const PriceRow& last = prices.steps[i - 1];
      const double middle_ns = std::sqrt(last.ns.median * step.ns.median),
                   middle = std::sqrt(height(last.quality.hard_wrong) * at);
      add(middle_ns, middle, price_text(step.over_last_percent));
    }
    add(step.ns.median, at, "");
  }
  return line;
}

}  // namespace

Plot hero_plot(const std::vector<Offer>& offers, const PriceList& prices) {
  Plot plot{
      .name = "answers_frontier",
      .title = "What accuracy costs in time",
      .caption =
          "Each point is a clipper in a scalar, from view space to NDC: its time on the game-like mix, and how many of a million hard triangles it gets wrong; those on the bottom line get none wrong. The line joins the steps of the price list.",
      .x = {.label = "time on the game-like mix [ns per triangle]", .logarithmic = true},
      .y = {.label = "hard triangles wrong, in a million", .logarithmic = true, .lowest = "none"}};
  for (const auto& [folder, name] : kColours) {
    Series series = points_of(folder, name, offers, prices);
    if (!series.x.empty()) plot.series.push_back(std::move(series));
  }
  Series others{.name = "others", .marks = Marks::points, .muted = true};
  for (const Offer& offer : offers) {
    const std::string folder = folder_of(offer.clipper);
    if (std::ranges::find(kColours, folder, &Colour::folder) != kColours.end()) continue;
    others.add(offer.ns.median, height(offer.quality.hard_wrong));
  }
  plot.series.push_back(std::move(others));
  plot.series.push_back(price_line(prices));
  return plot;
}

}  // namespace clipscope::experiments::answers
