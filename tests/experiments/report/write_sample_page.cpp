// SPDX-License-Identifier: GPL-3.0-or-later
//
// write_sample_page FOLDER: two plots and report.html, for a browser to be tried on.
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>

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
  if (argc != 2) {
    std::cerr << "usage: write_sample_page FOLDER\n";
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
    const SampleRun run = sample_run({drawn(lines, folder), drawn(bars, folder)});
    write_report(store_of(run, folder), folder);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
