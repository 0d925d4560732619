// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/commands/run_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/table/terminal.hpp"

namespace clipscope::experiments::commands {
namespace {

std::size_t lines_of(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

std::string further_text(const std::string& page, const std::string& folder) {
  return fmt::format(R"(
The page with all of this, its evidence and pictures: {}
To ask further:
  one of its tables, or their list     clipscope table [NAME] --run {}
  one triangle of yours, step by step  clipscope explain FILE
  whether a clipper keeps its promise  clipscope verify --clipper NAME
)",
                     page, folder);
}

// As many answers as fit into so many lines.
std::string answers_text(const Table& answers, std::size_t room) {
  const std::size_t question = place_of(answers, "question"), answer = place_of(answers, "answer");
  std::string text;
  std::size_t told = 0;
  for (const auto& row : answers.rows()) {
    const std::string block =
        fmt::format("{}{}\n{}", told == 0 ? "" : "\n", format_cell(row[question]),
                    indented(format_cell(row[answer])));
    const bool last = told + 1 == answers.rows().size();
    if (lines_of(text + block) + (last ? 0 : 2) > room) break;
    text += block;
    ++told;
  }
  const std::size_t more = answers.rows().size() - told;
  if (more > 0) text += fmt::format("\n{} more on the page.\n", more);
  return text;
}

}  // namespace

std::string closing_text(const std::optional<Table>& answers, const std::string& page,
                         const std::string& folder) {
  const std::string further = further_text(page, folder);
  if (!answers || answers->rows().empty()) return further;
  return answers_text(*answers, kScreenLines - lines_of(further)) + further;
}

}  // namespace clipscope::experiments::commands
