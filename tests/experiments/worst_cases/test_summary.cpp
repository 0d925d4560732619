// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/table/prose.hpp"
#include "experiments/worst_cases/rows.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::worst_cases;

namespace {

std::string checked(const std::vector<WorstRow>& worst, const std::vector<TieRow>& ties,
                    const std::vector<CampaignRow>& campaigns = {}) {
  const std::string text = finding(worst, ties, campaigns);
  INFO(text);
  CHECK(faults_of_prose(text).empty());
  return text;
}

WorstRow row(const char* clipper, double px) {
  return {clipper, "float", Inputs::in_domain, px, {}, {}, {}};
}

}  // namespace

TEST_CASE("worst cases: the finding follows the rows") {
  const std::vector<WorstRow> worst = {row("textbook", 5), row("cvv/naive", 7),
                                       row("view/sutherland_hodgman", 2)};
  TieRow near{.kind = "a",
              .one_exponent_ulp = 0x1p-50,
              .any_exponents_ulp = 0x1p-90,
              .limit_ulp = 0x1p-51,
              .is_right = true};
  TieRow far = near;
  far.one_exponent_ulp = 0x1p-40;
  CHECK(
      checked(worst, {near, far}) ==
      "In float, away from the eye, the largest known error on screen is the smallest with view space, 2.00 px, and the largest with dividing first with affine attributes, 7.00 px. Where coordinates have one exponent, numbers can come no nearer to a tie than their divisors allow, and most kinds are known within a factor of four of that. Double-double has bits enough for these, and too few where exponents differ. The correctly rounded clipper rounds all of them right, exact ties too.");
  CampaignRow campaign;
  campaign.clipper = "barycentric/correctly_rounded_batch";
  CHECK(checked({}, {near}, {campaign}).ends_with("too, and all that long campaigns tried."));
  campaign.misrounded = 1;
  CHECK(checked({}, {near}, {campaign}).ends_with("too, but not all that long campaigns tried."));
  campaign.clipper = "textbook";
  CHECK(checked({}, {near}, {campaign}).ends_with("right, exact ties too."));
  far.is_right = false;
  CHECK(checked({}, {near, far}).ends_with("rounds some of them WRONG."));
  near.any_exponents_ulp = far.any_exponents_ulp = 0x1p-60;
  CHECK(checked({}, {near}).find("enough for all that were found") != std::string::npos);
  CHECK(
      checked({row("textbook", 5)}, {}) ==
      "In float, away from the eye, the largest known error on screen is 5.00 px with the textbook clipper.");
  CHECK(checked({}, {}) == "No error was found, or no clipper was asked for that has records.");
}

TEST_CASE("worst cases: attributes are told in ulp of the largest") {
  const std::vector<WorstRow> rows =
      worst_rows({{"textbook", "float", Inputs::any, hunt::Measure::px, {}, 3.0, {}},
                  {"textbook", "float", Inputs::any, hunt::Measure::attribute, {}, 0x1p-20, {}},
                  {"textbook", "double", Inputs::any, hunt::Measure::attribute, {}, 0x1p-50, {}}});
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].px == 3.0);
  CHECK(rows[0].attribute_ulp == 8.0);
  CHECK(rows[1].attribute_ulp == 4.0);
  CHECK_FALSE(rows[1].px);
}

TEST_CASE("worst cases: bits are the logarithm of the distance") {
  const TieRow row{.kind = "a", .one_exponent_ulp = 0x1p-50, .chance_ulp = 0.25};
  CHECK(row.one_exponent_bits() == 50.0);
  CHECK(row.chance_bits() == 2.0);
  CHECK_FALSE(row.any_exponents_bits());
}
