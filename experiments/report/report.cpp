// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/report.hpp"

#include <fstream>
#include <sstream>

namespace clipscope::experiments {
namespace {

// What people ask of a run; the store keeps more, to compare runs by.
constexpr const char* kShown[] = {"machine", "compiler", "flags",   "version",
                                  "commit",  "seed",     "started", "command"};

std::string read_file(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::string type_of(const std::filesystem::path& path) {
  return path.extension() == ".svg" ? "image/svg+xml" : "image/png";
}

ReportFigure figure_of(const StoredFigure& stored, const std::filesystem::path& directory) {
  const std::filesystem::path path = directory / stored.file;
  return {.plot = stored.kind == FigureKind::plot,
          .type = type_of(path),
          .bytes = read_file(path),
          .file = stored.file,
          .title = stored.title,
          .caption = stored.caption};
}

Table table_of(const std::string& experiment, const std::vector<WorstInput>& inputs) {
  Table table(experiment + "_worst_inputs", "Inputs on which each contestant was farthest off",
              {{"clipper", "clipper"},
               {"scalar", "scalar"},
               {"measure", "measure"},
               {"error", "error"},
               {"input", "input"},
               {"replay", "command that shows it"}});
  for (const WorstInput& w : inputs) {
    table.add_row({w.clipper, w.scalar, w.measure, w.error, w.input, w.replay});
  }
  return table;
}

ReportExperiment experiment_of(const ResultsStore& store, const StoredExperiment& stored,
                               const std::filesystem::path& directory) {
  ReportExperiment experiment{.name = stored.name,
                              .question = stored.question,
                              .command = stored.command,
                              .finding = stored.finding,
                              .seconds = stored.seconds,
                              .finished = stored.finished,
                              .tables = {}};
  for (const std::string& name : store.table_names(stored.name)) {
    experiment.tables.push_back(store.table(name));
  }
  for (const StoredFigure& figure : store.figures(stored.name)) {
    experiment.figures.push_back(figure_of(figure, directory));
  }
  const std::vector<WorstInput> inputs = store.worst_inputs(stored.name);
  if (!inputs.empty()) experiment.more_tables.push_back(table_of(stored.name, inputs));
  return experiment;
}

}  // namespace

ReportContent content_of(const ResultsStore& store, const std::filesystem::path& directory) {
  ReportContent content;
  const RunInfo info = store.run_info();
  for (const char* name : kShown) {
    for (const auto& [key, value] : info) {
      if (key == name) content.run.emplace_back(key, value);
    }
  }
  for (const StoredExperiment& stored : store.experiments()) {
    content.experiments.push_back(experiment_of(store, stored, directory));
  }
  return content;
}

void write_report(const ResultsStore& store, const std::filesystem::path& directory) {
  write_report_page(content_of(store, directory), directory / kReportFile);
}

}  // namespace clipscope::experiments
