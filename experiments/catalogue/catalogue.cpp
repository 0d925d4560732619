// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/catalogue/catalogue.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <system_error>

#include "experiments/catalogue/case_reader.hpp"
#include "experiments/catalogue/embedded.hpp"
#include "experiments/errors.hpp"
#include "experiments/scenes/file_bytes.hpp"

namespace clipscope::experiments {
namespace {

std::string place(const HardCase& hard_case) {
  return fmt::format("{}:{}", hard_case.file, hard_case.line);
}

void require_unique_names(const std::vector<HardCase>& cases) {
  std::map<std::string_view, const HardCase*> seen;
  for (const HardCase& hard_case : cases) {
    const auto [other, is_new] = seen.emplace(hard_case.name, &hard_case);
    if (!is_new) {
      throw InputError(fmt::format("{}: case '{}' is already at {}; expected another name",
                                   place(hard_case), hard_case.name, place(*other->second)));
    }
  }
}

void append(std::vector<HardCase>& to, std::vector<HardCase> cases) {
  std::ranges::move(cases, std::back_inserter(to));
}

std::vector<std::filesystem::path> case_files(const std::filesystem::path& directory) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(directory, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().extension() == ".cases") {
      files.push_back(entry->path());
    }
  }
  if (error) {
    throw InputError(fmt::format("{}: can't be read: {}", directory.string(), error.message()));
  }
  if (files.empty()) {
    throw InputError(fmt::format("{}: found no file; expected files *.cases", directory.string()));
  }
  std::ranges::sort(files);
  return files;
}

std::vector<HardCase> read_builtin() {
  std::vector<HardCase> cases;
  for (const EmbeddedFile& file : embedded_case_files()) {
    append(cases, parse_catalogue(std::string(file.name), file.text));
  }
  require_unique_names(cases);
  return cases;
}

}  // namespace

const std::vector<HardCase>& builtin_catalogue() {
  static const std::vector<HardCase> cases = read_builtin();
  return cases;
}

std::vector<HardCase> load_catalogue(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) {
    return parse_catalogue(path.string(), read_bytes(path));
  }
  std::vector<HardCase> cases;
  for (const std::filesystem::path& file : case_files(path)) {
    append(cases, parse_catalogue(file.string(), read_bytes(file)));
  }
  require_unique_names(cases);
  return cases;
}

std::vector<HardCase> parse_catalogue(const std::string& file, std::string_view text) {
  std::vector<HardCase> cases = read_cases(file, text);
  if (cases.empty()) {
    throw InputError(fmt::format("{}: found no case; expected lines from 'case NAME'", file));
  }
  require_unique_names(cases);
  return cases;
}

}  // namespace clipscope::experiments
