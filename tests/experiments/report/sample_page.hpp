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

// The figures of the first two.
inline Table sample_evidence() {
  Table table("claims_evidence", "Figures behind claims",
              {{"claim", "claim"}, {"case", "case"}, {"figure", "figure"}});
  table.add_row({std::int64_t{1}, std::string("a < b"), 0.25});
  table.add_row({std::int64_t{1}, std::string("b < c"), 4.5});
  table.add_row({std::int64_t{2}, std::string("c < d"), 1.0});
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
  std::vector<WorstInput> worst_inputs = {};
};

using SampleRun = std::vector<SampleExperiment>;

// What experiments/answers leaves, its columns by the keys that the page reads.
inline Table sample_sentences() {
  Table table("answers", "Where should a triangle be clipped?",
              {{"id", "id"},
               {"question", "question"},
               {"answer", "answer"},
               {"experiment", "experiment"},
               {"table", "table"}});
  const auto add = [&](const char* id, const char* question, const char* answer,
                       const char* experiment, const char* evidence) {
    table.add_row({std::string(id), std::string(question), std::string(answer),
                   std::string(experiment), std::string(evidence)});
  };
  add("space", "Where should a triangle be clipped?", "In clip space, if a < b.", "sample", "odd");
  add("price", "What does accuracy cost?", "52 % more time.", "sample", "answers_prices");
  add("w", "What about w <= 0?", "Clip first.", "sample", "gone");
  add("lost", "And without evidence?", "This run does not say.", "elsewhere", "gone");
  return table;
}

inline Table sample_prices() {
  Table table("answers_prices", "What accuracy costs in time",
              {{"step", "step"},
               {"clipper", "clipper"},
               {"ns_per_triangle", "ns/tri"},
               {"ns_low", "95 % low"},
               {"ns_high", "high"},
               {"over_fastest_percent", "over fastest [%]"}});
  table.add_row({std::string("fastest"), std::string("a/b"), 20.0, 19.0, 21.0, 0.0});
  table.add_row({std::string("exact"), std::string("c/d"), 30.5, 30.0, 31.0, 52.5});
  return table;
}

// sample/a.png is a picture of the sample.
inline Table sample_readers() {
  Table table("answers_readers", "Which clipper for whom",
              {{"reader", "for"},
               {"needs", "needs"},
               {"recommended", "recommended"},
               {"clipper", "clipper"},
               {"scalar", "scalar"},
               {"order", "order"},
               {"guard", "guard"},
               {"ns_per_triangle", "ns/tri"},
               {"over_fastest_percent", "over fastest [%]"},
               {"otherwise", "otherwise"},
               {"picture", "picture"}});
  for (const char* picture : {"sample/a.png", ""}) {
    table.add_row({std::string("a rasteriser that indexes <memory>"), std::string("stays in range"),
                   std::string("clip space"), std::string("homogeneous/sutherland_hodgman"),
                   std::string("float"), std::string("near first"), std::string("guard"), 21.25,
                   6.5, std::string("writes out of bounds"), std::string(picture)});
  }
  return table;
}

inline Table sample_stability() {
  Table table("answers_stability", "Which methods stay right",
              {{"method", "method"},
               {"scalar", "scalar"},
               {"all", "all"},
               {"w_sign", "w sign"},
               {"sliver", "sliver"}});
  const auto count = [](std::int64_t n) { return Cell(n); };
  table.add_row({std::string("cases"), Cell(), count(60), count(20), count(40)});
  table.add_row({std::string("good"), std::string("float"), count(0), count(0), count(0)});
  table.add_row({std::string("fair"), std::string("float"), count(4), count(0), count(4)});
  table.add_row({std::string("poor"), std::string("float"), count(5), Cell(), count(5)});
  return table;
}

inline Table sample_effects() {
  Table table("answers_effects", "Which effects each scene calls for",
              {{"scene", "scene"}, {"saved_percent", "time saved [%]"}});
  table.add_row({std::string("floor"), 18.0});
  return table;
}

// A triangle that the explorer can show, and a segment, which it can't.
inline std::vector<WorstInput> sample_worst_inputs() {
  return {
      {"cvv/naive", "float", "position_px", 12.5,
       "--space view --frustum -0x1p+0,0x1p+0,-0x1p+0,0x1p+0,0x1p+0,0x1.4p+3 --depth gl --attributes 4 : -0x1p+1 -0x1p+0 -0x1p+2 0x1p+0 0x0p+0 0x0p+0 0x1p+0 0x1.8p+1 -0x1p-1 0x1p+1 0x0p+0 0x1p+0 0x0p+0 0x1p+0 0x0p+0 0x1.4p+1 -0x1.4p+2 0x0p+0 0x0p+0 0x1p+0 0x1p+0",
       "clipscope explain --scene floor --triangle 3"},
      {"homogeneous/liang_barsky", "float", "position_px", 0.5,
       "--space clip --primitive segment --depth gl --attributes 0 : 0x1p+1 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0",
       "clipscope clip --primitive segment"}};
}

inline SampleExperiment sample_answers(const std::string& hero) {
  return {
      {"answers", "Where, and at what price?", "clipscope run answers", "In clip space.", 1, true},
      {sample_sentences(), sample_effects(), sample_stability(), sample_readers(), sample_prices()},
      {{{FigureKind::plot, "answers/answers_frontier.svg", "A plot", "What it shows"}, hero}}};
}

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
  sample.worst_inputs = sample_worst_inputs();
  const SampleExperiment unfinished{{"unfinished", "", "", "", 0, false}};
  const SampleExperiment claims{
      {"claims", "Which claims hold?", "clipscope run claims", "One of five.", 0, true},
      {sample_claims(), sample_evidence()}};
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
  for (const auto& [experiment, tables, figures, worst_inputs] : run) {
    recorder.begin(experiment, position++);
    const auto& worst = worst_inputs;
    if (!worst.empty()) {
      recorder.record("all", {}, [&](PieceRecord& record) { record.worst_inputs = worst; });
    }
    for (const Table& table : tables) recorder.add(table);
    for (const auto& [figure, bytes] : figures) {
      recorder.add(figure);
      if (bytes.empty()) continue;
      const std::filesystem::path path = folder / figure.file;
      write_file(path, bytes);
      // A plot is three files.
      if (figure.kind == FigureKind::plot) {
        write_file(std::filesystem::path(path).replace_extension(".png"), sample_png());
      }
    }
    recorder.set_finding(experiment.finding);
    if (experiment.finished) recorder.finish(experiment.seconds);
  }
  return recorder.store();
}

}  // namespace clipscope::experiments
