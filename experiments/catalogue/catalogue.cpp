// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/catalogue/catalogue.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <system_error>

#include "experiments/machine/errors.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {
namespace {

namespace fs = std::filesystem;

void require_unique_names(const std::vector<HardCase>& cases) {
  std::map<std::string_view, const HardCase*> seen;
  for (const HardCase& c : cases) {
    const auto [other, is_new] = seen.emplace(c.name, &c);
    if (is_new) continue;
    refuse(fmt::format("{}:{}", c.file, c.line),
           "case '{}' is already at {}:{}; expected another name", c.name, other->second->file,
           other->second->line);
  }
}

void append(std::vector<HardCase>& to, std::vector<HardCase> cases) {
  std::ranges::move(cases, std::back_inserter(to));
}

std::vector<fs::path> case_files(const fs::path& directory) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(directory, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().extension() == ".cases") files.push_back(entry->path());
  }
  if (error) refuse(directory.string(), "can't be read: {}", error.message());
  if (files.empty()) refuse(directory.string(), "found no file; expected files *.cases");
  std::ranges::sort(files);
  return files;
}

// The files of tests/corpus as they were at build time, by their names.
constexpr std::pair<const char*, std::string_view> kBuiltinFiles[] = {
#include "experiments/catalogue/builtin_files.inc"
};

std::vector<HardCase> read_builtin() {
  std::vector<HardCase> cases;
  for (const auto& [name, text] : kBuiltinFiles) append(cases, parse_catalogue(name, text));
  require_unique_names(cases);
  return cases;
}

constexpr std::size_t kSuggestions = 5;

std::string_view without_theme(std::string_view name) {
  return name.substr(name.find('/') + 1);  // npos + 1 is 0
}

// Letters to insert, delete or replace: Wagner and Fischer, "The String-to-String Correction
// Problem", 1974.
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

std::vector<std::string_view> names_like(std::span<const HardCase> cases, std::string_view given) {
  std::vector<std::string_view> names;
  for (const HardCase& c : cases) names.push_back(c.name);
  std::ranges::stable_sort(names, {}, [&](auto name) { return distance_of(given, name); });
  names.resize(std::min(names.size(), kSuggestions));
  return names;
}

}  // namespace

const std::vector<HardCase>& builtin_catalogue() {
  static const std::vector<HardCase> cases = read_builtin();
  return cases;
}

std::vector<HardCase> load_catalogue(const fs::path& path) {
  if (!fs::is_directory(path)) return parse_catalogue(path.string(), read_bytes(path));
  std::vector<HardCase> cases;
  for (const fs::path& file : case_files(path)) {
    append(cases, parse_catalogue(file.string(), read_bytes(file)));
  }
  require_unique_names(cases);
  return cases;
}

std::vector<HardCase> parse_catalogue(const std::string& file, std::string_view text) {
  std::vector<HardCase> cases = read_cases(file, text);
  if (cases.empty()) refuse(file, "found no case; expected lines from 'case NAME'");
  require_unique_names(cases);
  return cases;
}

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
