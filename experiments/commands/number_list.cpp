// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/commands/number_list.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>

namespace clipscope::experiments {
namespace {

// Empty unless the whole text is numbers separated by single commas.
std::vector<double> parse_numbers(const std::string& text) {
  std::vector<double> numbers;
  const char* next = text.c_str();
  while (true) {
    char* end = nullptr;
    numbers.push_back(std::strtod(next, &end));
    if (end == next || (*end != ',' && *end != '\0')) return {};
    if (*end == '\0') return numbers;
    next = end + 1;
  }
}

}  // namespace

CLI::Option* add_number_list(CLI::App& command, const std::string& name, std::size_t count,
                             const std::string& type,
                             std::function<void(const std::vector<double>&)> set,
                             const std::string& help) {
  return command
      .add_option_function<std::string>(
          name,
          [=, set = std::move(set)](const std::string& text) {
            const std::vector<double> numbers = parse_numbers(text);
            if (numbers.size() != count) {
              throw CLI::ValidationError(
                  name, fmt::format("'{}' given, {} numbers expected: {}", text, count, type));
            }
            set(numbers);
          },
          help)
      ->type_name(type);
}

}  // namespace clipscope::experiments
