// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the next step costs, and when it buys something.
#include "tests/catch.hpp"
#include "tests/experiments/answers/sample_run.hpp"

namespace clipscope::experiments::answers {
namespace {

Offer offer(const std::string& clipper, double ns, const Quality& quality) {
  return {Contract::full, clipper, "float", {ns, ns, ns}, quality};
}

}  // namespace

TEST_CASE("prices: a step halves a figure and doubles none") {
  const Quality q{.game_px = 1, .hard_px = 1, .hard_wrong = 100};
  Quality half = q, nearly = q, mixed = q;
  half.hard_wrong = 50;
  nearly.hard_wrong = 51;
  mixed.hard_wrong = 0;
  mixed.game_px = 2.01;
  CHECK(buys_something(q, half));
  CHECK_FALSE(buys_something(q, nearly));
  CHECK_FALSE(buys_something(q, mixed));
  CHECK_FALSE(buys_something(q, q));
}

TEST_CASE("prices: errors beneath the rounding of the result are alike, but for 0") {
  const Quality rounded{.game_px = kRoundingPx, .hard_px = kRoundingPx},
      finer{.game_px = 1e-20, .hard_px = 1e-20}, none{};
  CHECK_FALSE(buys_something(rounded, finer));
  CHECK_FALSE(buys_something(finer, rounded));
  CHECK(buys_something(rounded, none));
}

TEST_CASE("prices: the list goes from the fastest on, and names who buys nothing") {
  const PriceList list =
      price_list({offer(kBatch, 10, kFloatQuality), offer(kClip, 20, kFloatQuality),
                  offer(kRoundedBatch, 15, kCertain), offer(kClip, 30, {})});
  REQUIRE(list.steps.size() == 3);
  CHECK(list.steps[0].over_fastest_percent == 0);
  CHECK(list.steps[1].clipper == kRoundedBatch);
  CHECK(list.steps[1].over_last_percent == Approx(50));
  CHECK(list.steps[2].over_fastest_percent == Approx(200));
  CHECK(list.steps[2].over_last_percent == Approx(100));
  CHECK(list.idle == std::vector<std::string>{"clip space in float"});
  CHECK(price_list({}).steps.empty());
}

TEST_CASE("prices: offers are joined from both sets, by time, timed ones alone") {
  Fabricated run = sample_run();
  CHECK(Contest(run.results()).offers(Contract::full).front().clipper == kBatch);
  CHECK(Contest(run.results()).offers(Contract::copy).size() == 2);
  run.alter<frontier::Row>([](frontier::Row& r) { r.timing.reset(); }, &frontier::Row::contract,
                           Contract::copy);
  const std::vector<Offer> offers = Contest(run.results()).offers(Contract::copy);
  REQUIRE(offers.size() == 1);
  CHECK(offers[0].clipper == kRoundedBatch);
}

TEST_CASE("hero: the steps are named, their prices stand on the line between them") {
  const Fabricated run = sample_run();
  const Results results = run.results();
  const std::vector<Offer> offers = Contest(results).offers(Contract::full);
  const PriceList prices = price_list(offers);
  REQUIRE(prices.steps.size() == 3);
  const Plot plot = hero_plot(offers, prices);
  std::size_t names = 0;
  for (const Series& series : plot.series) {
    if (series.marks != Marks::points || series.labels.empty()) continue;
    for (const std::string& label : series.labels) names += label.empty() ? 0 : 1;
  }
  CHECK(names == 3);
  const Series& line = plot.series.back();
  REQUIRE(line.x.size() == 5);
  CHECK(line.labels[1] == "+125 % time");
  CHECK(line.labels[3] == "333 times the time");
  CHECK(plot.y.lowest == "none");
  CHECK(line.x[0] < line.x[1]);
  CHECK(line.x[1] < line.x[2]);
}

}  // namespace clipscope::experiments::answers
