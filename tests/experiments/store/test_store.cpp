// SPDX-License-Identifier: GPL-3.0-or-later
//
// What goes into a store comes out of it, to the bit, and what is no store is refused.
#include <SQLiteCpp/SQLiteCpp.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "experiments/machine/errors.hpp"
#include "experiments/machine/temporary_folder.hpp"
#include "experiments/store/database.hpp"
#include "experiments/store/results_store.hpp"
#include "experiments/store/run_folder.hpp"
#include "experiments/store/run_recorder.hpp"
#include "tests/catch.hpp"

namespace {

using namespace clipscope::experiments;
namespace fs = std::filesystem;

struct TestFolder : TemporaryFolder {
  fs::path store() const { return path() / kStoreFile; }
};

RunRecorder new_recorder(const fs::path& file) {
  return RunRecorder(create_database(file, {{"started", "2026-03-01T12:34:56Z"}}), file);
}

void begin(RunRecorder& recorder, const std::string& name, std::int64_t position = 0) {
  recorder.begin({name, "Why?", "clipscope run " + name, "", 0, false}, position);
}

Table small_table(const std::string& name = "small") {
  return Table(name, "A small table", {{"what", "what"}, {"value", "value [px]"}});
}

bool same_bits(const Cell& a, const Cell& b) {
  const auto *x = std::get_if<double>(&a), *y = std::get_if<double>(&b);
  if (x == nullptr || y == nullptr) return a == b;
  return std::bit_cast<std::uint64_t>(*x) == std::bit_cast<std::uint64_t>(*y);
}

const std::vector<Cell> kAllKinds = {
    std::monostate(),
    std::string(),
    std::string("nan"),
    std::string("it's \"quoted\", \n and \0 zero", 26),
    std::int64_t{0},
    std::numeric_limits<std::int64_t>::min(),
    std::numeric_limits<std::int64_t>::max(),
    0.0,
    -0.0,
    1.0,
    3.0e15,
    0.1,
    std::numeric_limits<double>::denorm_min(),
    -std::numeric_limits<double>::max(),
    std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::quiet_NaN(),
    -std::numeric_limits<double>::quiet_NaN(),
    std::bit_cast<double>(std::uint64_t{0x7ff8000000000123}),
};

}  // namespace

TEST_CASE("store: every kind of value comes back with its bits and its type") {
  const TestFolder folder;
  Table table = small_table();
  table.add_note("first note");
  table.add_note("second note");
  {
    RunRecorder recorder = new_recorder(folder.store());
    begin(recorder, "one");
    recorder.record("cell", {&table}, [&](PieceRecord&) {
      for (const Cell& value : kAllKinds) table.add_row({std::string("cell"), value});
    });
    for (const Cell& value : kAllKinds) table.add_row({std::string("plain"), value});
    recorder.add(table);
  }
  const Table stored = ResultsStore(folder.path()).table("small");
  CHECK(stored.title() == table.title());
  CHECK(stored.columns()[1].head == "value [px]");
  REQUIRE(stored.rows().size() == 2 * kAllKinds.size());
  for (std::size_t r = 0; r < stored.rows().size(); ++r) {
    INFO(r);
    CHECK(same_bits(stored.rows()[r][1], kAllKinds[r % kAllKinds.size()]));
  }
  CHECK(stored.to_csv() == table.to_csv());
  CHECK(stored.to_markdown() == table.to_markdown());  // with the notes
  CHECK(stored.to_latex() == table.to_latex());
}

TEST_CASE("store: a table of results is an SQL table of its name") {
  const TestFolder folder;
  {
    RunRecorder recorder = new_recorder(folder.store());
    begin(recorder, "one");
    Table table = small_table("table");  // a keyword of SQL
    recorder.record("first", {&table}, [&](PieceRecord&) {
      table.add_row({std::string("a"), 0.25});
    });
    recorder.record("second", {&table}, [&](PieceRecord&) {
      table.add_row({std::string("b"), std::int64_t{7}});
    });
    recorder.add(table);
  }
  const SQLite::Database database(folder.store().string());
  SQLite::Statement query(
      database,
      "SELECT t.value, c.name FROM \"table\" t JOIN cell c ON c.id = t.cell_id WHERE t.what = 'b'");
  REQUIRE(query.executeStep());
  CHECK(query.getColumn(0).getInt() == 7);
  CHECK(query.getColumn(1).getString() == "second");
  CHECK_FALSE(query.executeStep());
}

TEST_CASE("store: samples, worst inputs, figures, findings and notes are kept") {
  const TestFolder folder;
  {
    RunRecorder recorder = new_recorder(folder.store());
    begin(recorder, "one", 4);
    recorder.record("cell", {}, [&](PieceRecord& record) {
      record.samples.push_back({"textbook", "ns", {1.5, 2.5}});
      record.worst_inputs.push_back({"textbook", "float", "position_px", 0.5, "0x1p-1", "replay"});
      record.pictures.push_back({"a.png", "what is seen"});
    });
    recorder.add(StoredFigure{FigureKind::plot, "p.svg", "title", "caption"});
    recorder.set_finding("It is so.");
    recorder.finish(1.5);
    begin(recorder, "two", 1);
  }
  const ResultsStore store(folder.path());
  const auto experiments = store.experiments();
  REQUIRE(experiments.size() == 2);
  CHECK(experiments[0].name == "two");
  CHECK_FALSE(experiments[0].finished);
  CHECK(experiments[1].finished);
  CHECK(experiments[1].seconds == 1.5);
  CHECK(experiments[1].finding == "It is so.");
  const auto worst = store.worst_inputs("one");
  REQUIRE(worst.size() == 1);
  CHECK(worst[0].input == "0x1p-1");
  CHECK(worst[0].error == 0.5);
  const auto figures = store.figures("one");
  REQUIRE(figures.size() == 2);
  CHECK(figures[0].kind == FigureKind::plot);
  CHECK(figures[1].file == "a.png");
  CHECK(store.figures("two").empty());
  SQLite::Database database(folder.store().string());
  CHECK(
      database.execAndGet("SELECT sum(value) FROM sample WHERE series = 'textbook'").getDouble() ==
      4);
}

TEST_CASE("store: texts that are no UTF-8 are read with the replacement character") {
  const TestFolder folder;
  {
    RunRecorder recorder(create_database(folder.store(), {{"command", "clipscope \xFF"}}),
                         folder.store());
    begin(recorder, "one");
    recorder.add(StoredFigure{FigureKind::plot, "p.svg", "title", "caption \xFF"});
    recorder.set_finding("\xFF");
    recorder.finish(1);
  }
  const ResultsStore store(folder.path());
  const std::string mark = "\xEF\xBF\xBD";
  CHECK(value_of(store.run_info(), "command") == "clipscope " + mark);
  CHECK(store.experiments().at(0).finding == mark);
  CHECK(store.figures("one").at(0).caption == "caption " + mark);
}

TEST_CASE("store: runs under the clock are those of all pieces, by experiment or together") {
  RunRecorder recorder = new_recorder({});
  Table table = small_table();
  const auto time = [&](const char* piece, const Interruptions& runs) {
    recorder.record(piece, {&table}, [&](PieceRecord& record) { record.add(runs); });
  };
  begin(recorder, "first");
  time("a", {.runs = 100, .redone = 7, .disturbed = 2, .seconds = 4, .others_seconds = 0.5});
  time("b", {.runs = 50, .redone = 1});
  time("nothing timed", {});
  begin(recorder, "second", 1);
  table = small_table("other");
  time("a", {.runs = 10});
  const ResultsStore& store = recorder.store();
  CHECK(store.interruptions("first") == Interruptions{150, 8, 2, 4, 0.5});
  CHECK(store.interruptions("second") == Interruptions{.runs = 10});
  CHECK(store.interruptions("third") == Interruptions{});
  CHECK(store.interruptions() == Interruptions{160, 8, 2, 4, 0.5});
}

TEST_CASE("store: a cell that throws leaves nothing") {
  const TestFolder folder;
  RunRecorder recorder = new_recorder(folder.store());
  begin(recorder, "one");
  Table table = small_table();
  CHECK_THROWS_AS(recorder.record("cell", {&table},
                                  [&](PieceRecord&) {
                                    table.add_row({std::string("a"), 1.0});
                                    throw InputError("no");
                                  }),
                  InputError);
  CHECK(recorder.store().tables().empty());
  Table again = small_table();
  CHECK_FALSE(recorder.restore("cell", {&again}, folder.path()));
}

TEST_CASE("store: a cell comes back once stored, and again if its picture is gone") {
  const TestFolder folder;
  std::ofstream(folder.path() / "a.png") << "picture";
  const auto work = [](Table& table) {
    return [&table](PieceRecord& record) {
      table.add_row({std::string("a"), 1.0});
      record.pictures.push_back({"a.png", ""});
    };
  };
  {
    RunRecorder recorder = new_recorder(folder.store());
    begin(recorder, "one");
    Table table = small_table();
    recorder.record("cell", {&table}, work(table));
  }
  RunRecorder recorder(open_database(folder.store()), folder.store());
  begin(recorder, "one");
  Table table = small_table();
  REQUIRE(recorder.restore("cell", {&table}, folder.path()));
  CHECK(table.rows() == std::vector<std::vector<Cell>>{{std::string("a"), 1.0}});
  fs::remove(folder.path() / "a.png");
  begin(recorder, "one");
  Table again = small_table();
  REQUIRE_FALSE(recorder.restore("cell", {&again}, folder.path()));
  CHECK(again.rows().empty());
  recorder.record("cell", {&again}, work(again));
  CHECK(recorder.store().table("small").rows().size() == 1);
}

TEST_CASE("store: names that it needs itself, or that are taken, are refused") {
  RunRecorder recorder;
  begin(recorder, "one");
  const auto refused = [&](const Table& table, const std::string& reason) {
    CHECK_THROWS_WITH(recorder.add(table),
                      Catch::Contains(reason) && Catch::Contains(table.name()));
  };
  for (const char* name : {"cell", "Run", "sample", "result_table", "sqlite_master"}) {
    refused(small_table(name), "needs that name");
  }
  refused(Table("t", "", {{"cell_id", ""}}), "cell_id");
  refused(Table("t", "", {{"a", ""}, {"A", ""}}), "two columns");
  recorder.add(small_table());
  refused(Table("small", "", {{"what", ""}, {"other", ""}}), "other columns");
  begin(recorder, "two");
  refused(small_table("SMALL"), "experiment one");
}

TEST_CASE("store: a table is complete when it was added, not before") {
  RunRecorder recorder;
  begin(recorder, "one");
  Table table = small_table();
  recorder.record("cell", {&table}, [&](PieceRecord&) { table.add_row({std::string("a"), 1.0}); });
  CHECK_FALSE(recorder.added("small"));
  CHECK(recorder.store().table("small").rows().size() == 1);
  recorder.add(table);
  REQUIRE(recorder.added("small"));
  CHECK(recorder.added("small")->to_csv() == table.to_csv());
}

TEST_CASE("store: what is no store, of another version or damaged is refused with its path") {
  const TestFolder folder;
  CHECK_THROWS_WITH(ResultsStore(folder.path()), Catch::Contains("no such file"));
  std::ofstream(folder.store()) << "this is a text, not a database, and a long one at that";
  CHECK_THROWS_AS(ResultsStore(folder.path()), InputError);
  fs::remove(folder.store());
  SQLite::Database(folder.store().string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
      .exec("CREATE TABLE t(a)");
  CHECK_THROWS_WITH(ResultsStore(folder.path()), Catch::Contains("no results store"));
  fs::remove(folder.store());
  new_recorder(folder.store());
  SQLite::Database(folder.store().string(), SQLite::OPEN_READWRITE)
      .exec("PRAGMA user_version = 99");
  CHECK_THROWS_WITH(ResultsStore(folder.path()),
                    Catch::Contains("format 99") && Catch::Contains(kStoreFile));
}

TEST_CASE("store: a damaged page is an error of reading, not a wrong table") {
  const TestFolder folder;
  {
    RunRecorder recorder = new_recorder(folder.store());
    begin(recorder, "one");
    Table table = small_table();
    for (int i = 0; i < 5000; ++i) table.add_row({std::string("row"), 0.5 * i});
    recorder.add(table);
  }
  const auto size = fs::file_size(folder.store());
  fs::resize_file(folder.store(), size / 2);
  CHECK_THROWS_AS(ResultsStore(folder.path()).table("small"), InputError);
}

TEST_CASE("store: one process writes into a folder at a time") {
  const TestFolder folder;
  {
    const FolderLock lock(folder.path());
    CHECK_THROWS_AS(FolderLock(folder.path()), OutputError);
  }
  CHECK_NOTHROW(FolderLock(folder.path()));
}

TEST_CASE("store: an older one is kept under its date") {
  const TestFolder folder;
  new_recorder(folder.store());
  const OpenedStore second = start_store(folder.path(), {{"started", "later"}});
  CHECK(second.kept == folder.path() / "results-20260301-123456.sqlite");
  CHECK(ResultsStore(second.kept).run_info().at(0).second == "2026-03-01T12:34:56Z");
  CHECK(ResultsStore(folder.path()).run_info().at(0).second == "later");
}

TEST_CASE("store: the command of a run names every option of the camera that was given") {
  Selection selection;
  CameraOptions& camera = selection.camera;
  CHECK_FALSE(run_command(selection, "depth").find("--far") != std::string::npos);
  camera.eye = glm::dvec3(0, 2, 9);
  camera.orientation = {0, 0, 0, 1};
  camera.axes = CameraAxes::cv;
  camera.intrinsics = Intrinsics{525, 526, 319.5, 239.5, 640, 480};
  camera.near = 0.5;
  camera.far = std::numeric_limits<double>::infinity();
  camera.depth = clipscope::DepthRange::reversed;
  const std::string command = run_command(selection, "depth");
  for (const char* part :
       {"--eye 0.0,2.0,9.0", "--orientation 0.0,0.0,0.0,1.0", "--axes cv", "--far inf",
        "--intrinsics 525.0,526.0,319.5,239.5,640.0,480.0", "--depth reversed"}) {
    INFO(command);
    CHECK(command.find(part) != std::string::npos);
  }
  camera.intrinsics.reset();
  camera.frustum = clipscope::Frustum<double>{};
  camera.frustum->infinite_far = true;
  CHECK(run_command(selection, "").find("--frustum -1.0,1.0,-1.0,1.0,1.0,inf") !=
        std::string::npos);
}
