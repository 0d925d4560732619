// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/experiment.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "experiments/machine/files.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/store/run_recorder.hpp"
#include "experiments/table/json_text.hpp"
#include "experiments/table/terminal.hpp"

namespace clipscope::experiments {

namespace {

constexpr std::size_t kPrintedRows = 32;   // the files have them all
constexpr std::size_t kPrintedFiles = 12;  // the page shows them all

}  // namespace

ExperimentContext::ExperimentContext(Selection selection, std::filesystem::path results,
                                     std::shared_ptr<RunRecorder> recorder)
    : selection_(std::move(selection)),
      results_(std::move(results)),
      recorder_(recorder ? std::move(recorder) : std::make_shared<RunRecorder>()) {}

std::filesystem::path ExperimentContext::out() const { return results_ / recorder_->experiment(); }

void ExperimentContext::piece(const std::string& name, std::initializer_list<Table*> tables,
                              const std::function<void(PieceRecord&)>& work) const {
  if (!recorder_->takes_next_piece()) return;
  if (recorder_->restore(name, tables, results_)) return;
  recorder_->record(name, tables, [&](PieceRecord& record) {
    make_folder(out());
    const Interruptions before = interruptions_so_far();
    work(record);
    record.add(interruptions_so_far() - before);
    for (Picture& picture : record.pictures) picture.file = in_results(picture.file);
  });
}

std::string ExperimentContext::in_results(const std::string& file) const {
  return fmt::format("{}/{}", recorder_->experiment(), file);
}

// Of some pieces there are no whole tables, and nothing that is made of these.
void ExperimentContext::emit(const Table& table) const {
  if (recorder_->is_part()) return;
  recorder_->add(table);
  table.write(out());
  if (selection_.json || selection_.tables) clear_progress_line();
  if (selection_.json) {
    fmt::print("{}\n", json_text(table.to_json()));
  } else if (selection_.tables) {
    fmt::print("{}\n", table.to_text(kPrintedRows));
  }
  emit_file(out() / (table.name() + ".{md,csv,tex}"));
  std::fflush(stdout);
}

void ExperimentContext::emit(const Plot& plot) const {
  if (recorder_->is_part()) return;
  write_plot(plot, out());
  recorder_->add(
      StoredFigure{FigureKind::plot, in_results(plot.name + ".svg"), plot.title, plot.caption});
  emit_file(out() / (plot.name + ".{svg,pdf,png}"));
}

void ExperimentContext::finding(const std::string& sentence) const {
  if (recorder_->is_part()) return;
  const std::string busy = busy_text(recorder_->store().interruptions(recorder_->experiment()));
  recorder_->set_finding(busy.empty() ? sentence : sentence + " " + busy);
}

Interruptions ExperimentContext::interruptions(const std::string& table_name) const {
  for (const StoredTable& table : recorder_->store().tables()) {
    if (table.name == table_name) return recorder_->store().interruptions(table.experiment);
  }
  return {};
}

std::optional<Table> ExperimentContext::emitted(const std::string& table_name) const {
  return recorder_->added(table_name);
}

void ExperimentContext::emit_file(const std::filesystem::path& path) const {
  written_.push_back(path.lexically_proximate(out()).string());
}

void ExperimentContext::tell_files() const {
  std::vector<std::string> names = std::exchange(written_, {});
  if (selection_.json || names.empty()) return;
  const std::size_t more = names.size() > kPrintedFiles ? names.size() - kPrintedFiles : 0;
  names.resize(names.size() - more);
  fmt::print("{}", indented(fmt::format("in {}: {}{}", out().string(), fmt::join(names, ", "),
                                        more > 0 ? fmt::format(" and {} more", more) : "")));
  std::fflush(stdout);
}

}  // namespace clipscope::experiments
