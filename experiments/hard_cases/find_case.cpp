// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hard_cases/find_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "experiments/errors.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kSuggestions = 5;

std::string_view without_theme(std::string_view name) {
  return name.substr(name.find('/') + 1);  // npos + 1 is 0
}

// Letters to insert, delete or replace: Wagner and Fischer, "The String-to-String Correction Problem",
// 1974.
std::size_t edits_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row[b.size()];
}

// 0 where one contains the other.
std::size_t distance_of(std::string_view given, std::string_view name) {
  if (name.find(given) != std::string_view::npos) return 0;
  return std::min(edits_between(given, name), edits_between(given, without_theme(name)));
}

std::vector<std::string> names_like(std::span<const HardCase> cases, std::string_view given) {
  std::vector<std::pair<std::size_t, std::string>> ranked;
  for (const HardCase& c : cases) ranked.emplace_back(distance_of(given, c.name), c.name);
  std::ranges::stable_sort(ranked, {}, &std::pair<std::size_t, std::string>::first);
  std::vector<std::string> names;
  for (const auto& [distance, name] : ranked) {
    if (names.size() < kSuggestions) names.push_back(name);
  }
  return names;
}

}  // namespace

const HardCase& find_case(std::span<const HardCase> cases, std::string_view name) {
  const auto whole = std::ranges::find(cases, name, &HardCase::name);
  if (whole != cases.end()) return *whole;
  std::vector<const HardCase*> same;
  for (const HardCase& c : cases) {
    if (without_theme(c.name) == name) same.push_back(&c);
  }
  if (same.size() == 1) return *same.front();
  throw UsageError(fmt::format("--case: {} '{}'; most like it are: {}",
                               same.empty() ? "no case is called" : "several cases are called",
                               name, fmt::join(names_like(cases, name), ", ")));
}

}  // namespace clipscope::experiments
