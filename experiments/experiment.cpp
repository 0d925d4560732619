// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/experiment.hpp"

#include <fmt/format.h>

#include <array>

#include "experiments/store/run_recorder.hpp"

namespace clipscope::experiments {

namespace {

constexpr std::size_t kPrintedRows = 32;  // the files have them all

}  // namespace

ExperimentContext::ExperimentContext(Selection selection, std::filesystem::path out)
    : ExperimentContext(std::move(selection), std::move(out), std::make_shared<RunRecorder>()) {}

ExperimentContext::ExperimentContext(Selection selection, std::filesystem::path out,
                                     std::shared_ptr<RunRecorder> recorder)
    : selection_(std::move(selection)), out_(std::move(out)), recorder_(std::move(recorder)) {}

void ExperimentContext::cell(const std::string& name, std::initializer_list<Table*> tables,
                             const std::function<void(CellRecord&)>& work) const {
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

std::span<const Experiment> all_experiments() {
  static constexpr std::array<Experiment, 17> kAll = {{
      {"cost", "How long does each clipper take, by mix of triangles and scalar, against textbook?",
       run_cost},
      {"frontier", "What does accuracy cost in time: who is not beaten in both?", run_frontier},
      {"accuracy", "How far from the exact answer is each clipper, and in what way?", run_accuracy},
      {"budget", "How much of the error comes from the transform, how much from cut and divide?",
       run_budget},
      {"attributes",
       "What does clipping do to attributes, by planes crossed and interpolation mode?",
       run_attributes},
      {"perspective", "When does interpolation need perspective correction?", run_perspective},
      {"w_sign", "What happens where w <= 0, and what does a plane w >= epsilon cost?", run_w_sign},
      {"plane_order", "Does the order of the planes matter: for the result, the error, the time?",
       run_plane_order},
      {"watertight", "Do triangles that share an edge still share it after clipping?",
       run_watertight},
      {"segments", "Which line clipper is fastest, which divides least, and which is right?",
       run_segments},
      {"bounds",
       "How much do bounding volumes settle before any triangle is cut, and is nothing lost?",
       run_bounds},
      {"guard_band",
       "What does it save to cut near and far only and leave the sides to scissoring?",
       run_guard_band},
      {"depth", "How precise is depth, by depth convention and ratio of far to near?", run_depth},
      {"effects", "Which effects does a scene call for, and what does leaving out the rest save?",
       run_effects},
      {"hard_cases", "Which clipper gets which hard case wrong, and how?", run_hard_cases},
      {"pictures", "What does each clipper show on screen, and where is it wrong?", run_pictures},
      {"claims", "Which claims about clipping do the results confirm, which do they refute?",
       run_claims},
  }};
  return kAll;
}

}  // namespace clipscope::experiments
