// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rounding bounds that the clippers rely on, and the Gappa scripts that prove them.
//
// A script is a template: @NAME@ in it stands for a constant, read here from the code that uses it,
// @N/NAME@ for N over it, rounded up to a double, and @NAME/2@ for its half. Gappa is Melquiond's:
// Boldo, Melquiond, "Computer Arithmetic and Formal Proofs", 2017.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace clipscope::proofs {

// How a constant becomes less than what the code has, in the smallest steps that are of interest.
enum class Weakening { subtract, add, halve, twice };

struct Constant {
  std::string_view name;
  double value = 0;
  Weakening weakening = Weakening::subtract;
  double step = 1;  // to subtract or to add

  // After so many steps.
  double weakened(int steps) const;
  // So many steps make sense at most.
  int most_steps() const;
};

// Those of the code first, then those that one script proves and others take for granted.
std::span<const Constant> constants();
// Throws std::runtime_error where there is none.
const Constant& constant(std::string_view name);

// A number as in a README: 14 u, 2^-900, 96.
std::string text_of(const Constant& c, double value);

// Stands for @name@ in a template.
struct Parameter {
  std::string_view name, text;
};

struct Proof {
  std::string_view name;
  std::string_view script;  // NAME.g.in
  std::vector<Parameter> parameters;
  // Of the constants that are not the code's, those that this proves, as others take them.
  std::vector<std::string_view> links;
};

std::span<const Proof> proofs();
const Proof& proof(std::string_view name);

}  // namespace clipscope::proofs
