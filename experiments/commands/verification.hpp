// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `clipscope verify` found, and the ways to say it: a table for people, JSON, JUnit's XML.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/survey/examination.hpp"

namespace clipscope::experiments::commands {

// What was found on triangles of one origin.
struct SourceFindings {
  std::string name;      // "the catalogue", "scene teapot"
  std::string options;   // what chooses it: "--catalogue", "--scene teapot"
  bool by_case = false;  // its triangles have names that --case knows
  Examination found;
};

struct Verification {
  bool is_named = false;                // what is asked was named by --promise
  std::vector<SourceFindings> sources;  // at least one
  // The smallest triangle found that breaks what the first counterexample does.
  std::optional<Counterexample> smallest = {};
};

// Of all sources.
Examination findings(const Verification& verification);

// 0 if all that is asked is kept, 1 if something is broken, 6 if nothing was judged, or a promise
// that was named on no triangle.
int exit_code(const Verification& verification);

// "no visible part lost, within the bound": what a kept promise says.
std::string_view question_text(Question question);

// A counterexample of that source: what was clipped, as `clip` reads it, and the command that asks
// about it again.
std::string hex_of(const Counterexample& counterexample);
std::string verify_command(const SourceFindings& source, const Counterexample& counterexample);
// The same with the triangle as text, whatever its source.
std::string verify_command(const Contestant& contestant, const Counterexample& counterexample);

// The first counterexample of what was asked for, shrunk: its triangle is a case for a corpus.
// Nothing if nothing is broken, or where it can't be shrunk: what depends on earlier calls, a
// triangle of doubles or against a matrix.
std::optional<Counterexample> smallest_of(const Verification& verification);

// The table, at most 100 columns wide, what is said beneath it, and a command that replays.
std::string text_of(const Verification& verification);
nlohmann::json json_of(const Verification& verification);
// A test case for each source and promise that is asked for. XML 1.0 in UTF-8.
std::string junit_of(const Verification& verification);

}  // namespace clipscope::experiments::commands
