// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope promote: what a hunt found and stored becomes hard cases.
#include <algorithm>
#include <string>
#include <vector>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/commands/measure_option.hpp"
#include "experiments/commands/options.hpp"
#include "experiments/hunt/rows.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/scenes/text_file.hpp"
#include "experiments/store/results_store.hpp"

namespace clipscope::experiments::commands {
namespace {

using hunt::HuntRow;

struct PromoteOptions {
  std::string run, corpus_out;
  std::vector<std::string> measures;
  bool as_found = false;
};

bool same_input(const HardCase& a, const HardCase& b) {
  const auto same = [](const reference::InputVertex& u, const reference::InputVertex& v) {
    return u.position == v.position && u.attributes == v.attributes;
  };
  return a.space == b.space && a.volume == b.volume &&
         (!has_frustum(a) || a.frustum == b.frustum) &&
         std::ranges::equal(a.vertices, b.vertices, same);
}

std::vector<HardCase> promoted_cases(const PromoteOptions& options) {
  const ResultsStore store(options.run);
  measures_of(options.measures);
  std::vector<HardCase> cases;
  for (const HuntRow& row : rows_of<HuntRow>(store.table(std::string(HuntRow::kName)))) {
    const bool is_asked =
        options.measures.empty() ||
        std::ranges::find(options.measures, row.measure) != options.measures.end();
    if (!is_asked) continue;
    const std::string& text = options.as_found ? row.worst_case : row.shrunk_case;
    for (HardCase& c : read_cases(store.file().string(), text)) cases.push_back(std::move(c));
  }
  return cases;
}

int promote(const PromoteOptions& options) {
  const std::vector<HardCase> cases = promoted_cases(options);
  const std::string before = read_if_there(options.corpus_out);
  std::vector<HardCase> there = read_cases(options.corpus_out, before);
  std::size_t added = 0;
  for (const HardCase& c : cases) {
    const auto is_same = [&](const HardCase& other) { return same_input(c, other); };
    if (std::ranges::any_of(there, is_same)) continue;
    there.push_back(append_case(options.corpus_out, c));
    ++added;
  }
  fmt::print("{} of {} added to {}{}\n", added, counted(cases.size(), "case", "cases"),
             options.corpus_out, added < cases.size() ? "; the others are there already" : "");
  return cases.empty() ? kExitNothingJudged : kExitOk;
}

}  // namespace

void add_promote_command(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, promote, "promote", "Add what a hunt found to a file of hard cases",
      R"(The file is made if there is none. What it holds stays, and inputs that it has already are not
added again. Whoever takes --corpus FILE (verify, explain) meets the cases from then on.)");
  add_option(command, "run", options.run, "DIR|FILE", "Folder of a hunt (its --out)")->required();
  add_option(command, "--corpus-out", options.corpus_out, "FILE", "The file of cases")->required();
  add_measure_option(command, options.measures, "all");
  command.add_flag("--as-found", options.as_found, "As they were found, not shrunk");
}

}  // namespace clipscope::experiments::commands
