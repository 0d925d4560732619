// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "experiments/commands/run_text.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

using namespace clipscope::experiments;
using commands::closing_text;

namespace {

Table answers(int count, const std::string& answer) {
  Table table("answers", "Where should a triangle be clipped?",
              {{"id", "id"}, {"question", "question"}, {"answer", "answer"}});
  for (int i = 0; i < count; ++i) {
    table.add_row({std::to_string(i), fmt::format("Question {}?", i), answer});
  }
  return table;
}

std::string closing(const std::optional<Table>& table) {
  return closing_text(table, "r/report.html", "r");
}

}  // namespace

TEST_CASE("run text: the answers come first, then the page and three ways to ask further") {
  const std::string text = closing(answers(2, "In clip space."));
  CHECK(text.starts_with("Question 0?\n  In clip space.\n"));
  CHECK(text.find("Question 1?") < text.find("r/report.html"));
  for (const char* command :
       {"clipscope table [NAME] --run r", "clipscope explain", "clipscope verify"}) {
    CHECK(text.find("r/report.html") < text.find(command));
  }
  CHECK_FALSE(contains(text, "more on the page"));
}

TEST_CASE("run text: it fits one screen, and counts the answers that do not") {
  const std::string sentence =
      "The answer depends on what the numbers of the triangle are made of. ";
  for (const int count : {1, 5, 9, 30}) {
    for (const int length : {1, 4, 12}) {
      std::string answer;
      for (int i = 0; i < length; ++i) answer += sentence;
      const std::string text = closing(answers(count, answer));
      INFO(count << " answers of " << length << " sentences\n" << text);
      CHECK(lines(text).size() <= commands::kScreenLines);
      for (const std::string& line : lines(text)) CHECK(line.size() <= 100);
      std::size_t told = 0;
      while (contains(text, fmt::format("Question {}?", told))) ++told;
      const std::string more = fmt::format("{} more on the page", count - static_cast<int>(told));
      CHECK(contains(text, more) == (told < static_cast<std::size_t>(count)));
    }
  }
}

TEST_CASE("run text: without answers it says where the page is") {
  for (const auto& none : {std::optional<Table>{}, std::optional(answers(0, ""))}) {
    CHECK(contains(closing(none), "r/report.html"));
    CHECK_FALSE(contains(closing(none), "Where should"));
  }
}
