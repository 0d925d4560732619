// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "experiments/contestants/spoken.hpp"
#include "experiments/pictures/rows.hpp"
#include "experiments/table/prose.hpp"

namespace clipscope::experiments::pictures {

std::string finding(const std::vector<Row>& rows, std::uint64_t pixels) {
  const auto worst = std::ranges::max_element(rows, {}, &Row::wrong_px);
  if (worst == rows.end()) return "No clipper was asked for.";
  const auto right = std::ranges::count(rows, std::uint64_t(0), &Row::wrong_px);
  const std::string text = fmt::format("The side that is there shows in every pixel of {}.",
                                       some_of(right, std::ranges::ssize(rows), "pictures"));
  if (worst->wrong_px() == 0) return text;
  const double share = static_cast<double>(worst->wrong_px()) / static_cast<double>(pixels);
  return text +
         fmt::format(
             " The worst is that of {} on {}: {} pixels are holes, cover what is not there or show the wrong side.",
             spoken_clipper(worst->clipper), spoken_set(worst->scene),
             quantity(std::min(share, 1.0)));
}

}  // namespace clipscope::experiments::pictures
