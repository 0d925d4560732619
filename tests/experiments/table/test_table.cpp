// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>
#include <sstream>

#include "experiments/machine/errors.hpp"
#include "experiments/table/json_text.hpp"
#include "experiments/table/table.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;

namespace {

Table small_table() {
  Table table("small", "A small table", {{"name", "name"}, {"max_px", "max [px]"}, {"count", "n"}});
  table.add_row({std::string("a,b \"c\""), 0.125, std::int64_t{3}});
  table.add_row({std::string("d_e"), Cell(), std::int64_t{-12}});
  return table;
}

std::string read(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("table: numbers are shown with three digits, plain or with a power of ten") {
  CHECK(format_number(0) == "0");
  CHECK(format_number(0.125) == "0.125");
  CHECK(format_number(13.42) == "13.4");
  CHECK(format_number(1234.5) == "1234");
  CHECK(format_number(2.08e-7) == "2.1e-07");
  CHECK(format_number(3.2e8) == "3.2e+08");
  CHECK(format_number(-0.5) == "-0.500");
}

TEST_CASE("table: CSV quotes what needs it and leaves missing values empty") {
  CHECK(small_table().to_csv() == "name,max_px,count\n\"a,b \"\"c\"\"\",0.125,3\nd_e,,-12\n");
}

TEST_CASE("table: Markdown aligns numbers to the right") {
  const std::string text = small_table().to_markdown();
  CHECK(text.find("| name | max [px] | n |\n| --- | ---: | ---: |\n") != std::string::npos);
  CHECK(text.find("| d_e | - | -12 |") != std::string::npos);
}

TEST_CASE("table: LaTeX escapes what TeX would eat and uses booktabs rules") {
  const std::string text = small_table().to_latex();
  CHECK(text.find("d\\_e & - & -12 \\\\") != std::string::npos);
  CHECK(text.find("\\toprule") != std::string::npos);
  CHECK(text.find("{lrr}") != std::string::npos);
}

TEST_CASE("table: JSON keeps types") {
  const auto rows = small_table().to_json()["rows"];
  CHECK(rows[0]["max_px"] == 0.125);
  CHECK(rows[0]["count"] == 3);
  CHECK(rows[1]["max_px"].is_null());
}

TEST_CASE("table: a wide table is continued beneath, never wider than 100 columns") {
  std::vector<Column> columns = {{"name", "name"}};
  for (int i = 0; i < 30; ++i) {
    columns.push_back({"c" + std::to_string(i), "column " + std::to_string(i)});
  }
  Table table("wide", "A wide table", columns);
  std::vector<Cell> cells = {std::string("the row's name")};
  for (int i = 0; i < 30; ++i) cells.emplace_back(1.5 * i);
  table.add_row(cells);
  table.add_note(std::string(40, 'x') + " " + std::string(40, 'y') + " " + std::string(40, 'z'));
  std::istringstream lines(table.to_text());
  int with_name = 0;
  for (std::string line; std::getline(lines, line);) {
    CHECK(line.size() <= 100);
    with_name += line.starts_with("the row's name") ? 1 : 0;
  }
  CHECK(with_name > 1);
}

TEST_CASE("table: columns that say nothing are left out of the text and named, not of the files") {
  Table table("silent", "A table",
              {{"scene", "scene"},
               {"clipper", "clipper"},
               {"lost", "lost"},
               {"why", "why"},
               {"edges", "edges"},
               {"input", "input"}});
  for (const char* clipper : {"a", "b"}) {
    table.add_row({std::string("teapot"), std::string(clipper), std::int64_t{0}, Cell(),
                   std::int64_t{5}, std::string()});
  }
  CHECK(
      table.to_text() ==
      "A table\n\nclipper  edges\n-------  -----\na            5\nb            5\n"
      "  Left out: the same in every row: scene (teapot); 0 in every row: lost; nothing in any row: why,\n  input.\n");
  CHECK(table.to_csv().starts_with("scene,clipper,lost,why,edges,input\n"));
}

TEST_CASE("table: a column that says something in a row that is not shown stays") {
  Table table("tail", "A table", {{"name", "name"}, {"lost", "lost"}});
  table.add_row({std::string("a"), std::int64_t{0}});
  table.add_row({std::string("b"), std::int64_t{1}});
  CHECK(table.to_text(1).find("lost") != std::string::npos);
}

TEST_CASE("table: a table of which every column says nothing is shown as it is") {
  Table table("zero", "A table", {{"lost", "lost"}});
  table.add_row({std::int64_t{0}});
  CHECK(table.to_text() == "A table\n\nlost\n----\n   0\n");
}

TEST_CASE("table: a figure and its interval share a column of the text") {
  Table table("timed", "A table",
              {{"clipper", "clipper"},
               {"ns_per_triangle", "ns/tri"},
               {"ns_low", "95 % low"},
               {"ns_high", "high"}});
  table.add_row({std::string("a"), 65.5, 63.8, 69.0});
  table.add_row({std::string("b"), Cell(), Cell(), Cell()});
  const std::string text = table.to_text();
  CHECK(text.find("ns/tri [95 %]") != std::string::npos);
  CHECK(text.find("a        65.5 [63.8, 69.0]\n") != std::string::npos);
  CHECK(text.find("b                        -\n") != std::string::npos);
}

TEST_CASE("table: files are written whole into a folder that is made") {
  const auto folder = std::filesystem::temp_directory_path() / "clipscope-table-test" / "deep";
  std::filesystem::remove_all(folder.parent_path());
  small_table().write(folder);
  CHECK(read(folder / "small.csv") == small_table().to_csv());
  CHECK(std::filesystem::exists(folder / "small.md"));
  CHECK(std::filesystem::exists(folder / "small.tex"));
  CHECK_FALSE(std::filesystem::exists(folder / "small.csv.part"));
  std::filesystem::remove_all(folder.parent_path());
}

TEST_CASE("table: a folder that is a file is an error that names it") {
  const auto file = std::filesystem::temp_directory_path() / "clipscope-table-file";
  std::ofstream(file) << "in the way";
  CHECK_THROWS_AS(small_table().write(file), OutputError);
  CHECK(read(file) == "in the way");
  std::filesystem::remove(file);
}

TEST_CASE("table: bytes that are no UTF-8 become the replacement character in every form") {
  Table table("a\xFF", "b\xFF", {{"name", "name"}});
  table.add_row({std::string("c\xFF")});
  table.add_note("d\xFF");
  for (const std::string& text : {table.to_text(), table.to_markdown(), table.to_csv(),
                                  table.to_latex(), json_text(table.to_json())}) {
    CHECK(text.find('\xFF') == std::string::npos);
    CHECK(text.find("c\xEF\xBF\xBD") != std::string::npos);
  }
}

TEST_CASE("JSON: a string that is no UTF-8 ends no program") {
  CHECK(json_text(nlohmann::json{{"file", "a\xFF"}}) == "{\"file\":\"a\xEF\xBF\xBD\"}");
}
