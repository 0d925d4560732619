// SPDX-License-Identifier: GPL-3.0-or-later
//
// A results folder: where an experiment's files go, what its README says, where the paper finds its
// figures.
#include <filesystem>
#include <memory>

#include "experiments/machine/errors.hpp"
#include "experiments/machine/temporary_folder.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/report/paper.hpp"
#include "experiments/report/results_readme.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/report/sample_page.hpp"

using namespace clipscope::experiments;
namespace fs = std::filesystem;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// What an experiment leaves that draws one picture in one piece and one plot. work: how often it
// was done.
void run_small(const ExperimentContext& context, int& work) {
  Table table("small", "A small table", {{"what", "what"}});
  context.piece("all", {&table}, [&](PieceRecord& record) {
    ++work;
    table.add_row({std::string("a")});
    write_file(context.out() / "a.png", sample_png());
    record.pictures.push_back({"a.png", "A picture"});
  });
  context.emit(table);
  context.emit(Plot{.name = "line",
                    .title = "A line",
                    .caption = "It rises",
                    .x = {.label = "n"},
                    .y = {.label = "t"},
                    .series = {{.name = "a", .x = {1, 2}, .y = {1, 2}}}});
}

}  // namespace

TEST_CASE("results: an experiment's files lie in its folder, and the store names them by that") {
  const TemporaryFolder folder;
  const auto recorder = std::make_shared<RunRecorder>(
      create_database(folder.path() / kStoreFile, {}), folder.path() / kStoreFile);
  const ExperimentContext context({}, folder.path(), recorder);
  int work = 0;
  for (const char* name : {"one", "two"}) {
    recorder->begin({name, "", "", "", 0, false}, 0);
    CHECK(context.out() == folder.path() / name);
  }
  run_small(context, work);
  for (const char* file : {"small.csv", "small.md", "a.png", "line.svg", "line.pdf", "line.png"}) {
    CHECK(fs::exists(folder.path() / "two" / file));
  }
  CHECK_FALSE(fs::exists(folder.path() / "one"));
  const auto figures = recorder->store().figures("two");
  REQUIRE(figures.size() == 2);
  CHECK(figures[0].file == "two/line.svg");
  CHECK(figures[1].file == "two/a.png");

  recorder->begin({"two", "", "", "", 0, false}, 0);
  run_small(context, work);
  CHECK(work == 1);  // the picture is where the store says
  fs::remove(folder.path() / "two" / "a.png");
  recorder->begin({"two", "", "", "", 0, false}, 0);
  run_small(context, work);
  CHECK(work == 2);
}

TEST_CASE("results: a context without a recorder writes into a folder of its own, too") {
  const TemporaryFolder folder;
  const ExperimentContext context({}, folder.path());
  int work = 0;
  run_small(context, work);
  CHECK(work == 1);
  CHECK(context.out().parent_path() == folder.path());
  CHECK(fs::exists(context.out() / "small.csv"));
}

TEST_CASE("results: the README names every experiment with its question and its files") {
  const TemporaryFolder folder;
  SampleRun run = sample_run({"<svg/>"});
  run[0].experiment.name = "one";
  run[0].tables.push_back(Table("one", "The answer", {{"a", "a"}}));
  const std::string readme = results_readme(store_of(run, folder.path()));
  INFO(readme);
  CHECK(contains(
      readme, "| [one](one/) | Does a < b & c > d hold? | [one](one/one.md), [odd](one/odd.md), "));
  CHECK(contains(readme, "| [plot1](sample/plot1.svg) | [a](sample/a.png), [gone]"));
  CHECK(contains(readme, "| [unfinished](unfinished/) |  (unfinished) |"));
  CHECK(
      contains(readme, "| [claims](claims/) | Which claims hold? | [claims](claims/claims.md), "));
  CHECK(contains(readme, "on a processor <fast>"));
  run[0].experiment.question = "a | b";
  CHECK(contains(results_readme(store_of(run, folder.path())), "| a \\| b |"));
}

TEST_CASE("results: the README begins with the answers, if the run has them") {
  const TemporaryFolder folder;
  SampleRun run = sample_run({});
  const std::string without = results_readme(store_of(run, folder.path()));
  CHECK(without.starts_with("# Results of a run of clipscope\n\n- [report.html](report.html) "));
  CHECK(contains(without, "from commit 0123abc.\n"));
  run.push_back(sample_answers("<svg/>"));
  const std::string with = results_readme(store_of(run, folder.path()));
  CHECK(with.starts_with(
      "# Results of a run of clipscope\n\n- **Where should a triangle be clipped?** In clip space, if a < b. ([sample](sample/))\n"));
  CHECK(contains(with, "\n\n- [report.html](report.html) "));
}

namespace {

// A finding, README and page of a run of one timed piece.
struct TimedRun {
  std::string finding, readme, page;

  TimedRun(const Interruptions& runs, const fs::path& folder) {
    const auto recorder = std::make_shared<RunRecorder>(create_database({}, {}), fs::path());
    recorder->begin({"timed", "How long?", "", "", 0, false}, 0);
    const ExperimentContext context({}, folder, recorder);
    Table table("times", "Times", {{"ns", "ns"}});
    context.piece("all", {&table}, [&](PieceRecord&) { count_runs(runs); });
    context.emit(table);
    CHECK(context.interruptions("times") == runs);
    CHECK(context.interruptions("untold") == Interruptions{});
    context.finding("It takes long.");
    finding = recorder->store().experiments().front().finding;
    readme = results_readme(recorder->store());
    page = report_page(recorder->store(), folder).html;
  }
};

}  // namespace

TEST_CASE("results: a run on a busy machine says so in its findings, its README and its page") {
  const TemporaryFolder folder;
  const TimedRun busy({.runs = 100, .redone = 30}, folder.path());
  CHECK(busy.finding.starts_with("It takes long. The machine was busy"));
  CHECK(contains(busy.readme, "30 of 100 runs under the clock lost the processor"));
  CHECK(contains(busy.readme, "The machine was busy"));
  CHECK(contains(busy.page, "<b>Not settled.</b>"));
  const TimedRun quiet({.runs = 100, .redone = 3}, folder.path());
  CHECK(quiet.finding == "It takes long.");
  CHECK(contains(quiet.readme, "3 of 100 runs under the clock lost the processor"));
  CHECK_FALSE(contains(quiet.page, "Not settled"));
  CHECK(contains(quiet.page, "<dt>timing</dt><dd>3 of 100 runs"));
}

TEST_CASE("results: many pictures are a link to the folder") {
  const TemporaryFolder folder;
  SampleRun run = sample_run({});
  for (int i = 0; i < 20; ++i) {
    run[0].figures.push_back(run[0].figures[0]);
    run[0].figures.back().figure.file = "sample/" + std::to_string(i) + ".png";
  }
  CHECK(contains(results_readme(store_of(run, folder.path())), "| [22 files](sample/) |"));
}

TEST_CASE("results: the paper finds its figures by their names, whatever folder they lie in") {
  const TemporaryFolder folder;
  SampleRun run = sample_run({"<svg/>"});
  store_of(run, folder.path(), folder.path() / kStoreFile);
  write_file(folder.path() / "sample" / "plot1.pdf", "a plot");
  const ResultsStore store(folder.path());
  const fs::path contents = folder.path() / "contents.json", out = folder.path() / "out";
  write_file(contents, R"({"figures": ["plot1", "a.png"]})");
  write_paper_inputs(store, contents, out);
  CHECK(read_bytes(out / "plot1.pdf") == "a plot");
  CHECK(read_bytes(out / "a.png") == sample_png());
  write_file(contents, R"({"figures": ["plot2"]})");
  CHECK_THROWS_WITH(write_paper_inputs(store, contents, out),
                    Catch::Contains("figure plot2 is not among the results"));
}
