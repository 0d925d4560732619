// SPDX-License-Identifier: GPL-3.0-or-later
//
// write_sample_page FOLDER folder|single: plots and report.html of that form, for a browser to be
// tried on.
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string_view>

#include "experiments/report/plot.hpp"
#include "tests/experiments/report/sample_page.hpp"

using namespace clipscope::experiments;

namespace {

std::string drawn(const Plot& plot, const std::filesystem::path& folder) {
  write_plot(plot, folder);
  std::ostringstream text;
  text << std::ifstream(folder / (plot.name + ".svg"), std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace

int main(int argc, char* argv[]) {
  if (argc != 3) {
    std::cerr << "usage: write_sample_page FOLDER folder|single\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  try {
    const Plot lines{.name = "lines",
                     .title = "A line <and> its \"interval\"",
                     .caption = "It rises",
                     .x = {.label = "n", .logarithmic = true},
                     .y = {.label = "t [ns]"},
                     .series = {{.name = "a_b", .x = {1, 10, 100}, .y = {1, 2, 3}}}};
    const Plot bars{.name = "bars",
                    .title = "Bars",
                    .caption = "They differ",
                    .x = {},
                    .y = {.label = "t [ns]"},
                    .series = {{.name = "float", .x = {}, .y = {1, 2}}},
                    .categories = {"one", "two & <three>"}};
    Plot hero = lines;
    hero.name = "answers_frontier";
    SampleRun run = sample_run({drawn(lines, folder), drawn(bars, folder)});
    run.push_back(sample_answers(drawn(hero, folder)));
    write_report(store_of(run, folder), folder,
                 std::string_view(argv[2]) == "single" ? PageForm::single_file : PageForm::folder);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
