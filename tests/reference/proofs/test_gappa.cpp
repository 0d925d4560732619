// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checks of proofs can fail, and they tell a goal that is not shown from a script that is
// wrong.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <stdexcept>

#include "reference/proofs/gappa.hpp"

using namespace clipscope::proofs;

namespace {

bool has_gappa() {
  if (is_gappa_installed()) return true;
  INFO("Gappa is not installed (on Debian: apt-get install gappa)");
  REQUIRE(std::getenv("CLIPSCOPE_REQUIRE_GAPPA") == nullptr);
  return false;
}

Script script(const char* text) { return {text, {}}; }

}  // namespace

TEST_CASE("proofs: what is true is proved, and what is false is not") {
  if (!has_gappa()) return;
  CHECK(is_proved(script("{ x in [0, 1b-1] -> x * x <= 1b-2 }")));
  CHECK_FALSE(is_proved(script("{ x in [0, 1b-1] -> x * x <= 1b-3 }")));
}

TEST_CASE("proofs: a script that Gappa can't read is no failed proof") {
  if (!has_gappa()) return;
  CHECK_THROWS_WITH(is_proved(script("x = ; { x in [0, 1] -> x <= 1 }")),
                    Catch::Contains("syntax error"));
}

TEST_CASE("proofs: a rewriting rule that is no identity is refused, whatever it proves") {
  if (!has_gappa()) return;
  CHECK_THROWS_WITH(is_proved(script("{ x in [0, 1] -> x * x <= 1b-1 }\nx * x -> x * 1b-2;")),
                    Catch::Contains("not trivially equal"));
}

TEST_CASE("proofs: a constant that makes no difference is reported") {
  if (!has_gappa()) return;
  const Constant unrelated{"kOwnVertexError", 3, Weakening::subtract, 1};
  CHECK_THROWS_WITH(steps_to_spare(proof("line_entry"), unrelated),
                    Catch::Contains("the same whatever kOwnVertexError is"));
}

TEST_CASE("proofs: scripts have the constants of the code, exactly") {
  const Script s = script_of(proof("certificate"), value_in_code);
  CHECK(s.constants == std::set<std::string_view>{"kDivisorCertainty", "kQuotientRoundings",
                                                  "kQuotientSlack", "kSmallestFiltered"});
  CHECK(s.text.find("k in [0, 1b-20]") != s.text.npos);  // 1 / kDivisorCertainty
  CHECK(s.text.find("(1 + 1b-18)") != s.text.npos);
  CHECK(s.text.find("z5 * 1b900") != s.text.npos);
  CHECK(s.text.find("z3 + 1b-50") != s.text.npos);
}

TEST_CASE("proofs: quotients of constants are rounded up") {
  const Script s = script_of(proof("affine_float"), value_in_code);
  CHECK(s.text.find("x in [0, 3002399751580331b-57]") != s.text.npos);  // 2 / 96
  CHECK(3002399751580331 * 0x1p-57 * 96 >= 2);
}

TEST_CASE("proofs: an unknown proof or constant is named") {
  CHECK_THROWS_WITH(proof("nonsense"), "there is no proof named nonsense");
  CHECK_THROWS_WITH(constant("kNonsense"), "there is no constant named kNonsense");
}
