// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/results_readme.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "experiments/machine/files.hpp"
#include "experiments/report/page_source.hpp"
#include "experiments/report/report.hpp"
#include "experiments/store/run_folder.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kFewFiles = 4;  // more are told by their number

constexpr const char* kIntroduction = R"(# Results of a run of clipscope

{7}- [{0}]({0}) shows everything on one page.
- Each experiment has a folder: every table as Markdown, CSV and LaTeX, every plot as SVG, PDF and PNG, pictures as PNG, and some as EXR.
- [{1}]({1}) has all tables, findings and samples: `clipscope table --run .` lists the tables, `clipscope table NAME --run .` prints one.

The command was `{2}`, begun {3} on {4}, built with {5} from commit {6}.{8}

| experiment | question | tables, the answer first | plots | pictures |
|---|---|---|---|---|
)";

// What would end a cell of a Markdown table is escaped.
std::string markdown_cell(const std::string& text) {
  std::string cell;
  for (const char c : text) {
    if (c == '|') cell += '\\';
    cell += c == '\n' ? ' ' : c;
  }
  return cell;
}

std::string link(const std::string& file) {
  return fmt::format("[{}]({})", std::filesystem::path(file).stem().string(), file);
}

// Links to the files, or to the folder if they are many.
std::string links(const std::string& folder, const std::vector<std::string>& files) {
  if (files.size() > kFewFiles) return fmt::format("[{} files]({}/)", files.size(), folder);
  std::vector<std::string> links;
  for (const std::string& file : files) links.push_back(link(file));
  return fmt::format("{}", fmt::join(links, ", "));
}

std::string tables_cell(const ResultsStore& store, const std::string& experiment) {
  std::vector<std::string> tables;
  for (const StoredTable& table : store.tables()) {
    if (table.experiment != experiment || !table.complete) continue;
    const bool answers = table.name == experiment;
    tables.insert(answers ? tables.begin() : tables.end(),
                  link(fmt::format("{}/{}.md", experiment, table.name)));
  }
  return fmt::format("{}", fmt::join(tables, ", "));
}

// The machine, and how it was asked to measure.
std::string machine_text(const RunInfo& run) {
  const std::string measuring = value_of(run, "measuring");
  return value_of(run, "machine") + (measuring.empty() ? "" : fmt::format(" ({})", measuring));
}

// How quiet the machine was; empty where nothing was timed.
std::string clock_sentence(const ResultsStore& store) {
  const Interruptions runs = store.interruptions();
  if (runs.runs == 0) return "";
  const std::string busy = busy_text(runs);
  return fmt::format(" Of what was timed {}.{}{}", runs.text(), busy.empty() ? "" : " ", busy);
}

// A line for each answer of the run, with the folder of its evidence; empty without answers.
std::string answers_list(const ResultsStore& store) {
  if (!store.has_table(kAnswers)) return "";
  const Table answers = store.table(kAnswers);
  std::string list;
  for (const std::vector<Cell>& row : answers.rows()) {
    const auto text = [&](const char* key) { return full_text(row[place_of(answers, key)]); };
    list += fmt::format("- **{0}** {1} ([{2}]({2}/))\n", text("question"), text("answer"),
                        text("experiment"));
  }
  return list + "\n";
}

std::string line(const ResultsStore& store, const StoredExperiment& experiment) {
  std::vector<std::string> plots, pictures;
  for (const StoredFigure& figure : store.figures(experiment.name)) {
    (figure.kind == FigureKind::plot ? plots : pictures).push_back(figure.file);
  }
  return fmt::format("| [{0}]({0}/) | {1}{2} | {3} | {4} | {5} |\n", experiment.name,
                     markdown_cell(experiment.question), experiment.finished ? "" : " (unfinished)",
                     tables_cell(store, experiment.name), links(experiment.name, plots),
                     links(experiment.name, pictures));
}

}  // namespace

std::string results_readme(const ResultsStore& store) {
  const RunInfo run = store.run_info();
  std::string text =
      fmt::format(kIntroduction, kReportFile, kStoreFile, value_of(run, "command"),
                  value_of(run, "started"), machine_text(run), value_of(run, "compiler"),
                  value_of(run, "commit"), answers_list(store), clock_sentence(store));
  for (const StoredExperiment& experiment : store.experiments()) text += line(store, experiment);
  return text;
}

void write_results_readme(const ResultsStore& store, const std::filesystem::path& directory) {
  write_file(directory / "README.md", results_readme(store));
}

}  // namespace clipscope::experiments
