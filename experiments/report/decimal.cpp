// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/decimal.hpp"

#include <fmt/format.h>

#include <cmath>

namespace clipscope::experiments {
namespace {

using reference::Rational;

struct Decimal {
  bool negative = false;
  std::string digits;  // the point is after the first
  int exponent = 0;

  std::string text() const {
    return fmt::format("{}{}.{}e{:+03d}", negative ? "-" : "", digits[0], digits.substr(1),
                       exponent);
  }
};

// 10^n.
Rational power_of_ten(int n) {
  Rational power(1);
  const Rational ten(10);
  for (int i = 0; i < std::abs(n); ++i) power = power * ten;
  if (n < 0) return Rational(Rational(1) / power);
  return power;
}

// floor(log10(value)) for value > 0.
int decimal_exponent(const Rational& value) {
  int exponent = static_cast<int>(std::floor(std::log10(reference::round_to<double>(value))));
  while (value < power_of_ten(exponent)) --exponent;
  while (power_of_ten(exponent + 1) <= value) ++exponent;
  return exponent;
}

// Pre-condition: value is not zero and within the range of doubles.
Decimal to_decimal(const Rational& value, int digits) {
  Decimal decimal;
  decimal.negative = value < Rational(0);
  Rational rest = value;
  if (decimal.negative) rest = -value;
  decimal.exponent = decimal_exponent(rest);
  rest = rest / power_of_ten(decimal.exponent);
  for (int i = 0; i < digits; ++i) {
    int digit = static_cast<int>(reference::round_to<double>(rest));
    if (rest < Rational(digit)) --digit;
    decimal.digits += static_cast<char>('0' + digit);
    rest = (rest - Rational(digit)) * Rational(10);
  }
  return decimal;
}

}  // namespace

std::string decimal(const Rational& value, int digits) {
  if (value == Rational(0)) return "0";
  return to_decimal(value, digits).text();
}

std::string marked_decimal(const Rational& approximation, const Rational& exact, int digits) {
  if (approximation == exact || approximation == Rational(0)) return decimal(approximation, digits);
  const Decimal found = to_decimal(approximation, digits);
  std::size_t wrong = 0;
  if (exact != Rational(0)) {
    const Decimal right = to_decimal(exact, digits);
    if (right.negative == found.negative && right.exponent == found.exponent) {
      while (wrong < found.digits.size() && found.digits[wrong] == right.digits[wrong]) ++wrong;
    }
  }
  std::string text = found.text();
  if (wrong == found.digits.size()) return text;
  const std::size_t at = (found.negative ? 1 : 0) + wrong + (wrong > 0 ? 1 : 0);
  return text.substr(0, at) + "[" + text[at] + "]" + text.substr(at + 1);
}

}  // namespace clipscope::experiments
