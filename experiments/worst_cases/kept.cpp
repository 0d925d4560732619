// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/worst_cases/kept.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/machine/build_info.hpp"
#include "experiments/scenes/text_file.hpp"
#include "experiments/table/hex_float.hpp"
#include "experiments/table/table.hpp"

namespace clipscope::experiments::worst_cases {
namespace {

constexpr std::string_view kHeading =
    R"(# Worst cases, kept between runs and replayed by each: experiments/worst_cases/README.md.
# Written by `clipscope run worst_cases`. `why` begins with the figure, to the bit.
)";

constexpr std::pair<std::string_view, std::string_view> kBuiltinKept[] = {
#include "experiments/worst_cases/kept_files.inc"
};

double figure_in(const HardCase& c) {
  const std::string word = c.why.substr(0, c.why.find(' '));
  char* end = nullptr;
  const double figure = std::strtod(word.c_str(), &end);
  // An ulp next to 0 is so small in double that an error of many is infinite.
  if (word != "inf" && (!word.starts_with("0x") || *end != '\0')) {
    refuse(fmt::format("{}:{}", c.file, c.line),
           "why '{}' of case '{}'; expected the figure as a hex float first, such as 0x1.8p+1",
           c.why, c.name);
  }
  return figure;
}

// Without the theme, which is the file's name.
std::string own_name(const std::string& name) { return name.substr(name.find('/') + 1); }

}  // namespace

KeptFile::KeptFile(std::string file, std::string_view text) : file_(std::move(file)) {
  for (HardCase& c : read_cases(file_, text)) {
    const double figure = figure_in(c);
    c.name = own_name(c.name);
    if (find(c.name) != nullptr) {
      refuse(fmt::format("{}:{}", c.file, c.line), "case '{}' again; expected one of each name",
             c.name);
    }
    records_.push_back({figure, std::move(c)});
  }
}

const Record* KeptFile::find(std::string_view name) const {
  const auto found = std::ranges::find_if(
      records_, [&](const Record& record) { return record.hard_case.name == name; });
  return found == records_.end() ? nullptr : &*found;
}

void KeptFile::put(double figure, std::string_view unit, HardCase hard_case) {
  hard_case.why = fmt::format("{} {}, about {}", hex_float(figure), unit, format_number(figure));
  const auto place = std::ranges::find_if(
      records_, [&](const Record& r) { return r.hard_case.name == hard_case.name; });
  if (place == records_.end()) {
    records_.push_back({figure, std::move(hard_case)});
  } else {
    *place = {figure, std::move(hard_case)};
  }
}

std::string KeptFile::text() const {
  std::string text(kHeading);
  for (const Record& record : records_) text += "\n" + case_text(record.hard_case);
  return text;
}

std::string_view kept_text(std::string_view file) {
  return std::ranges::find(kBuiltinKept, file,
                           &std::pair<std::string_view, std::string_view>::first)
      ->second;
}

KeptFile builtin_kept(std::string_view file) { return {std::string(file), kept_text(file)}; }

std::string Search::text(std::string_view method) const {
  return fmt::format("{}, seed {}, sample {}, clipscope {} ({}, {})", method, seed, sample,
                     kVersion, kCommit, date);
}

}  // namespace clipscope::experiments::worst_cases
