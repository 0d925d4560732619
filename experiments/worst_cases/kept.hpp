// SPDX-License-Identifier: GPL-3.0-or-later
//
// Worst cases kept between runs: files of cases (tests/corpus/README.md), one record each, that
// are part of the program. `source` says which search found it, `why` begins with its figure as a
// hex float.
//
// Source of the idea: the files *.wc of Zimmermann et al., CORE-MATH, 2022.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"

namespace clipscope::experiments::worst_cases {

struct Record {
  double figure = 0;
  HardCase hard_case;  // its name without a theme
};

// How a record compares with the one that was kept.
enum class Standing : std::uint8_t { kept, improved, added, moved };
constexpr std::array<std::string_view, 4> names_of(Standing) {
  return {"as kept", "worse found", "new", "moved"};
}

class KeptFile {
 public:
  // file: "chains_float.cases", what stands before the cases, and its text. Errors: InputError
  // naming file and line, also where a figure is missing or two cases have one name.
  KeptFile(std::string file, std::string_view text);

  const std::string& name() const { return file_; }
  std::span<const Record> records() const { return records_; }
  // Null if there is none.
  const Record* find(std::string_view name) const;

  // In place of the one of that name, or behind all. unit: what the figure is.
  void put(double figure, std::string_view unit, HardCase hard_case);

  // As a file, with a heading that says what it is.
  std::string text() const;

 private:
  std::string file_;
  std::vector<Record> records_;
};

// As they were when the program was built. Pre-condition: there is a file of that name.
std::string_view kept_text(std::string_view file);
KeptFile builtin_kept(std::string_view file);

// Which search of this program found a record: "hunt, seed 7, 20000 evaluations, clipscope 0.1.0
// (12abc34, 2026-11-30)".
struct Search {
  std::uint64_t seed = 1;
  std::size_t sample = 0;
  std::string date = {};

  std::string text(std::string_view method) const;
};

}  // namespace clipscope::experiments::worst_cases
