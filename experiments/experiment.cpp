// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/experiment.hpp"

#include <fmt/format.h>

#include <array>

namespace clipscope::experiments {

namespace {

constexpr std::size_t kPrintedRows = 32;  // the files have them all

}  // namespace

ExperimentContext::ExperimentContext(Selection selection, std::filesystem::path out)
    : selection_(std::move(selection)), out_(std::move(out)) {}

void ExperimentContext::emit(const Table& table) const {
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

void ExperimentContext::emit_file(const std::filesystem::path& path) const {
  if (!selection_.json) fmt::print("  written: {}\n", path.string());
}

std::span<const Experiment> all_experiments() {
  static constexpr std::array<Experiment, 6> kAll = {{
      {"cost", "How long does each clipper take, by mix of triangles and scalar, against textbook?",
       run_cost},
      {"accuracy", "How far from the exact answer is each clipper, and in what way?", run_accuracy},
      {"budget", "How much of the error comes from the transform, how much from cut and divide?",
       run_budget},
      {"w_sign", "What happens where w <= 0, and what does a plane w >= epsilon cost?", run_w_sign},
      {"hard_cases", "Which clipper gets which hard case wrong, and how?", run_hard_cases},
      {"pictures", "What does each clipper show on screen, and where is it wrong?", run_pictures},
  }};
  return kAll;
}

}  // namespace clipscope::experiments
