// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/decimal.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;
using clipscope::reference::Rational;

namespace {

Rational ratio(int a, int b) { return Rational(Rational(a) / Rational(b)); }

}  // namespace

TEST_CASE("decimal: digits are those of the exact expansion, truncated") {
  CHECK(decimal(ratio(1, 3), 5) == "3.3333e-01");
  CHECK(decimal(ratio(-2, 3), 4) == "-6.666e-01");
  CHECK(decimal(Rational(1000), 4) == "1.000e+03");
  CHECK(decimal(ratio(999999, 1000), 3) == "9.99e+02");
  CHECK(decimal(Rational(0), 9) == "0");
}

TEST_CASE("decimal: the first wrong digit is marked") {
  CHECK(marked_decimal(ratio(33334, 100000), ratio(1, 3), 5) == "3.333[4]e-01");
  CHECK(marked_decimal(ratio(1, 3), ratio(1, 3), 5) == "3.3333e-01");
  CHECK(marked_decimal(Rational(2), Rational(3), 2) == "[2].0e+00");
  CHECK(marked_decimal(Rational(-3), Rational(3), 2) == "-[3].0e+00");
  CHECK(marked_decimal(ratio(-334, 1000), ratio(-1, 3), 3) == "-3.3[4]e-01");
  CHECK(marked_decimal(Rational(30), Rational(3), 2) == "[3].0e+01");
}
