// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes scripts of templates and asks Gappa about them.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "reference/proofs/proofs.hpp"

namespace clipscope::proofs {

// The value of a constant by its name.
using Values = std::function<double(std::string_view)>;
double value_in_code(std::string_view name);

struct Script {
  std::string text;
  std::set<std::string_view> constants;  // that occur in it
};

// The names of all templates that there are.
std::set<std::string> templates();

// Throws std::runtime_error for a template that can't be read or that has an unknown name.
Script script_of(const Proof& proof, const Values& values);

bool is_gappa_installed();

// Whether Gappa proves the script. Throws std::runtime_error, with Gappa's words, for one that it
// warns of or that it can't read: only a goal that it could not show is a "no".
bool is_proved(const Script& script);

// The same of a proof with one constant weakened by so many steps.
bool is_proved_with(const Proof& proof, const Constant& weakened, int steps);

// Has Gappa write a certificate, and Coq check it. Throws std::runtime_error if either fails.
void certify(const Script& script);

// By how many of its steps a constant can be weakened so that the proof still passes. Throws
// std::runtime_error if it passes with all of them. Pre-condition: it passes with none.
int steps_to_spare(const Proof& proof, const Constant& c);

}  // namespace clipscope::proofs
