// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/experiment.hpp"

#include <fmt/format.h>

#include "experiments/store/run_recorder.hpp"

namespace clipscope::experiments {

constexpr std::size_t kPrintedRows = 32;  // the files have them all

ExperimentContext::ExperimentContext(Selection selection, std::filesystem::path out,
                                     std::shared_ptr<RunRecorder> recorder)
    : selection_(std::move(selection)),
      out_(std::move(out)),
      recorder_(recorder ? std::move(recorder) : std::make_shared<RunRecorder>()) {}

void ExperimentContext::piece(const std::string& name, std::initializer_list<Table*> tables,
                              const std::function<void(PieceRecord&)>& work) const {
  if (!recorder_->restore(name, tables, out_)) recorder_->record(name, tables, work);
}

void ExperimentContext::emit(const Table& table) const {
  recorder_->add(table);
  table.write(out_);
  if (selection_.json) {
    fmt::print("{}\n", table.to_json().dump());
  } else {
    fmt::print("{}\n", table.to_text(kPrintedRows));
    emit_file(out_ / (table.name() + ".{md,csv,tex}"));
    fmt::print("\n");
  }
  std::fflush(stdout);
}

void ExperimentContext::emit(const Plot& plot) const {
  write_plot(plot, out_);
  recorder_->add(StoredFigure{FigureKind::plot, plot.name + ".svg", plot.title, plot.caption});
  emit_file(out_ / (plot.name + ".{svg,pdf,png}"));
}

void ExperimentContext::finding(const std::string& sentence) const {
  recorder_->set_finding(sentence);
  if (!selection_.json) fmt::print("Finding: {}\n\n", sentence);
}

std::optional<Table> ExperimentContext::emitted(const std::string& table_name) const {
  return recorder_->added(table_name);
}

void ExperimentContext::emit_file(const std::filesystem::path& path) const {
  if (!selection_.json) fmt::print("  written: {}\n", path.string());
}

}  // namespace clipscope::experiments
