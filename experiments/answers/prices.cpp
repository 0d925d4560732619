// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/answers/rows.hpp"
#include "experiments/contestants/spoken.hpp"

namespace clipscope::experiments::answers {

PriceList price_list(const std::vector<Offer>& offers) {
  PriceList list;
  const auto over = [](const Offer& offer, const MedianInterval& base) {
    return 100 * (offer.ns.median / base.median - 1);
  };
  for (const Offer& offer : offers) {
    const std::string name = spoken_contestant(offer.clipper, offer.scalar);
    const bool is_first = list.steps.empty();
    if (!is_first && !buys_something(list.steps.back().quality, offer.quality)) {
      list.idle.push_back(name);
      continue;
    }
    const MedianInterval fastest = is_first ? offer.ns : list.steps.front().ns,
                         last = is_first ? offer.ns : list.steps.back().ns;
    list.steps.push_back({.contract = offer.contract,
                          .step = name,
                          .clipper = offer.clipper,
                          .scalar = offer.scalar,
                          .ns = offer.ns,
                          .over_fastest_percent = over(offer, fastest),
                          .over_last_percent = over(offer, last),
                          .quality = offer.quality});
  }
  return list;
}

}  // namespace clipscope::experiments::answers
