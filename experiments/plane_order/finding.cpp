// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said of the order of planes: whether it matters exactly, in float, and in time.
#include <fmt/format.h>

#include <algorithm>

#include "experiments/contestants/spoken.hpp"
#include "experiments/plane_order/rows.hpp"
#include "experiments/table/prose.hpp"

namespace clipscope::experiments::plane_order {
namespace {

constexpr double kNoticeable = 1.1;  // times as many wrong triangles

std::string exact_sentence(const ExactOrders& exact) {
  if (exact.triangles == 0) return "No order was tried in exact arithmetic.";
  if (exact.differs == 0 && exact.wrong == 0) {
    return fmt::format("In exact arithmetic the order of the planes does not matter{}.",
                       exact.mixed_w > 0 ? ", even where w <= 0" : "");
  }
  return fmt::format("Even in exact arithmetic the order of the planes matters, for {} triangles.",
                     quantity(static_cast<double>(std::max(exact.differs, exact.wrong)) /
                              static_cast<double>(exact.triangles)));
}

// Bits that change, and whether right answers do.
std::string float_sentence(const OrdersRow& all) {
  const OrdersRow::Rounded& rounded = all.in_float;
  if (all.triangles == 0) return "";
  if (rounded.differs == 0) return " In float it changes no bit.";
  const double first = rounded.wrong_near_first, last = rounded.wrong_near_last;
  const std::string_view wrong = last > kNoticeable * first   ? "more triangles are wrong with"
                                 : first > kNoticeable * last ? "fewer triangles are wrong with"
                                                              : "as many triangles are wrong with";
  return fmt::format(
      " In float it changes bits of {} % of the triangles and moves vertices by up to {} px; {} the near plane last {} with it first.",
      format_number(rounded.differs_percent), format_number(rounded.max_px), wrong,
      wrong.starts_with("as") ? "as" : "than");
}

// On which mixes the near plane last takes longer, or less long, beyond chance.
std::string time_sentence(const std::vector<TimeRow>& times) {
  std::vector<std::string> slower, faster;
  bool timed = false;
  for (const TimeRow& row :
       rows_where(times, &TimeRow::clipper, HomogeneousNearLast::name, &TimeRow::scalar, "float")) {
    if (!row.ratio) continue;
    timed = true;
    if (row.ratio->low > 1) slower.push_back(spoken_set(row.mix));
    if (row.ratio->high < 1) faster.push_back(spoken_set(row.mix));
  }
  if (!timed) return "";
  const std::string near_last = " With the near plane last clipping is ";
  if (slower.empty() && faster.empty()) return near_last + "as fast as with it first on every mix.";
  if (faster.empty()) return near_last + "slower on " + listed(slower) + ".";
  if (slower.empty()) return near_last + "faster on " + listed(faster) + ".";
  return fmt::format("{}slower on {} and faster on {}.", near_last, listed(slower), listed(faster));
}

}  // namespace

std::string finding(const OrdersRow& all, const std::vector<TimeRow>& times) {
  return exact_sentence(all.exact) + float_sentence(all) + time_sentence(times);
}

}  // namespace clipscope::experiments::plane_order
