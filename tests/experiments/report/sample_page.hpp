// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run that never was, small, with everything that a page of results can hold.
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/machine/files.hpp"
#include "experiments/report/report.hpp"
#include "experiments/store/database.hpp"
#include "experiments/store/run_recorder.hpp"

namespace clipscope::experiments {

inline Table sample_claims() {
  Table table("claims", "Claims and verdicts",
              {{"number", "no"},
               {"claim", "claim"},
               {"verdict", "verdict"},
               {"because", "because"},
               {"experiment", "figures in"}});
  for (const char* verdict : {"confirmed", "true only when", "refuted", "undecided", "refuted"}) {
    const auto number = static_cast<std::int64_t>(table.rows().size() + 1);
    table.add_row(
        {number, std::string("Dividing before clipping turns what is behind the eye over."),
         std::string(verdict),
         std::string("12 of 4000 triangles, 0.3 %, at w between -1e-7 and 0; none elsewhere."),
         std::string(number % 2 == 1 ? "sample" : "elsewhere")});
  }
  return table;
}

// Numbers that sort wrongly as texts, and values that are no numbers.
inline Table sample_odd() {
  Table table("odd", "Odd <values> & \"quotes\"",
              {{"name", "name"}, {"value_px", "value [px]"}, {"count", "count"}});
  table.add_row({std::string("ten"), 10.0, std::int64_t{100}});
  table.add_row({std::string("not a number"), std::nan(""), std::int64_t{20}});
  table.add_row({std::string("nothing"), Cell(), Cell()});
  table.add_row({std::string("nine, \"9\""), 9.0, std::int64_t{3}});
  table.add_row({std::string("infinite"), INFINITY, std::int64_t{5}});
  table.add_row({std::string("tiny <b>bold</b>"), 1e-300, std::int64_t{-4}});
  table.add_row({std::string("below all"), -INFINITY, std::int64_t{6}});
  table.add_note("A note with <script>document.title = 'broken'</script> in it.");
  return table;
}

inline Table sample_long() {
  Table table("long", "160 rows, wide",
              {{"clipper", "clipper"},
               {"scalar", "scalar"},
               {"ns_per_triangle", "ns/tri"},
               {"ns_low", "95 % low"},
               {"ns_high", "high"},
               {"speedup_to_textbook", "x textbook"},
               {"speedup_low", "95 % low"},
               {"speedup_high", "high"}});
  for (int i = 0; i < 160; ++i) {
    const double ns = 1.0 + (i * 37) % 160;  // every whole number from 1 to 160 once
    table.add_row({std::string(i % 4 == 0 ? "homogeneous/sutherland_hodgman" : "cvv/near_first"),
                   std::string(i % 2 == 0 ? "float" : "double"), ns, ns * 0.9, ns * 1.1, 100 / ns,
                   90 / ns, 110 / ns});
  }
  return table;
}

// 1 x 1 px (PNG specification).
inline std::string sample_png() {
  static constexpr unsigned char kBytes[] = {
      0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48,
      0x44, 0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x02, 0x00, 0x00,
      0x00, 0x90, 0x77, 0x53, 0xde, 0x00, 0x00, 0x00, 0x0c, 0x49, 0x44, 0x41, 0x54, 0x78,
      0x9c, 0x63, 0x60, 0x60, 0x60, 0x00, 0x00, 0x00, 0x04, 0x00, 0x01, 0xf6, 0x17, 0x38,
      0x55, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
  return {reinterpret_cast<const char*>(kBytes), sizeof kBytes};
}

struct SampleFigure {
  StoredFigure figure;
  std::string bytes;  // of its file; empty: there is none
};

struct SampleExperiment {
  StoredExperiment experiment;
  std::vector<Table> tables = {};
  std::vector<SampleFigure> figures = {};
};

using SampleRun = std::vector<SampleExperiment>;

// plots: SVG files as write_plot leaves them.
inline SampleRun sample_run(const std::vector<std::string>& plots) {
  SampleExperiment sample{
      {"sample", "Does a < b & c > d hold?", "clipscope run sample --out 'my results'",
       "It holds for 3 of 4 <triangles>.", 2, true},
      {sample_odd(), sample_long(), Table("empty", "No rows", {{"a", "a"}, {"b", "b"}})}};
  for (const std::string& svg : plots) {
    const std::string number = std::to_string(sample.figures.size() + 1);
    sample.figures.push_back(
        {{FigureKind::plot, "sample/plot" + number + ".svg", "A plot", "What it shows"}, svg});
  }
  sample.figures.push_back(
      {{FigureKind::picture, "sample/a.png", "", "A \"picture\""}, sample_png()});
  sample.figures.push_back({{FigureKind::picture, "sample/gone.png", "", "Not there"}, ""});
  const SampleExperiment unfinished{{"unfinished", "", "", "", 0, false}};
  const SampleExperiment claims{
      {"claims", "Which claims hold?", "clipscope run claims", "One of five.", 0, true},
      {sample_claims()}};
  return {sample, unfinished, claims};
}

// The run's store in the file, or in memory without one; its figures in the folder.
inline ResultsStore store_of(const SampleRun& run, const std::filesystem::path& folder,
                             const std::filesystem::path& file = {}) {
  RunRecorder recorder(
      create_database(file,
                      {{"machine", "a processor <fast>"}, {"commit", "0123abc"}, {"flags", ""}}),
      file);
  std::int64_t position = 0;
  for (const auto& [experiment, tables, figures] : run) {
    recorder.begin(experiment, position++);
    for (const Table& table : tables) recorder.add(table);
    for (const auto& [figure, bytes] : figures) {
      recorder.add(figure);
      if (!bytes.empty()) write_file(folder / figure.file, bytes);
    }
    recorder.set_finding(experiment.finding);
    if (experiment.finished) recorder.finish(experiment.seconds);
  }
  return recorder.store();
}

}  // namespace clipscope::experiments
