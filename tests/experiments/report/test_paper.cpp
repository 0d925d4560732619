// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "experiments/machine/errors.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/report/paper.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/report/sample_page.hpp"

using namespace clipscope::experiments;

namespace {

Table times() {
  Table table("times", "Times", {{"mix", "mix"}, {"clipper", "clipper"}, {"ns", "ns"}});
  table.add_row({std::string("soup"), std::string("textbook"), 60.0});
  table.add_row({std::string("soup"), std::string("homogeneous/sutherland_hodgman"), 20.0});
  table.add_row({std::string("soup"), std::string("cvv/naive"), 30.0});
  table.add_row({std::string("soup"), std::string("refused"), Cell()});
  table.add_row({std::string("hard"), std::string("homogeneous/sutherland_hodgman"), 50.0});
  table.add_row({std::string("hard"), std::string("textbook"), 0.0});
  return table;
}

// What the paper takes from a run with that table.
class Paper {
 public:
  Paper() { std::filesystem::create_directories(folder_); }
  ~Paper() { std::filesystem::remove_all(folder_); }
  Paper(const Paper&) = delete;
  Paper& operator=(const Paper&) = delete;

  std::string file(const std::string& contents, const std::string& name) const {
    SampleRun run = sample_run({});
    run.front().tables = {times()};
    run.front().experiment.finding = "Off by 1.6e-04 px at w <= 1e-05: 3 % of w_first_1e-5.";
    write_file(folder_ / "contents.json", contents);
    write_paper_inputs(store_of(run, folder_), folder_ / "contents.json", folder_);
    std::ifstream file(folder_ / name);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  // The text of a value of the soup; more: members of its entry.
  std::string value(const std::string& more) const {
    const std::string text = file(
        R"({"values": [{"name": "V", "table": "times", "where": {"mix": "soup"}, )" + more + "}]}",
        "values.tex");
    const std::string head = "\\newcommand{\\V}{";
    const std::size_t begin = text.find(head) + head.size();
    return text.substr(begin, text.rfind("}\n") - begin);
  }
  std::string table(const std::string& more) const {
    return file(R"({"names": {"soup": "game-like"}, "tables": [{"file": "t", "table": "times", )" +
                    more + "}]}",
                "t.tex");
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("clipscope-paper-" + std::to_string(getpid()));
};

}  // namespace

TEST_CASE("paper: a value is taken from the rows that its entry selects") {
  const Paper paper;
  CHECK(paper.value(R"("column": "ns")") == "60.0");
  CHECK(paper.value(R"("column": "ns", "take": "min")") == "20.0");
  CHECK(paper.value(R"("column": "ns", "take": "count", "format": ".0f")") == "3");
  CHECK(paper.value(R"("column": "ns", "where": {"mix": "hard"}, "format": ".1f")") == "50.0");
}

TEST_CASE("paper: the first of ordered rows has the name of the fastest, or of the slowest") {
  const Paper paper;
  CHECK(paper.value(R"("column": "clipper", "order": {"by": "ns"})") == "clip space");
  CHECK(paper.value(R"("column": "clipper", "order": {"by": "ns", "descending": true})") ==
        "the textbook clipper");
}

TEST_CASE("paper: a value over another one is a ratio or a percentage") {
  const Paper paper;
  const std::string both =
      R"("column": "ns", "over": {"where": {"mix": "soup", "clipper": "cvv/naive"}})";
  CHECK(paper.value(both) == "2.00");
  CHECK(paper.value(both + R"(, "as": "percent")") == "200");
  CHECK(paper.value(both + R"(, "as": "percent more")") == "100");
  CHECK_THROWS_AS(paper.value(both + R"(, "as": "parts")"), InputError);
  const std::string by_zero =
      R"("column": "ns", "over": {"where": {"mix": "hard", "clipper": "textbook"}})";
  CHECK_THROWS_WITH(paper.value(by_zero), Catch::Contains("is 0"));
}

TEST_CASE("paper: words follow the figure") {
  const Paper paper;
  const std::string say =
      R"("column": "ns", "say": [{"below": 30, "text": "fast"}, {"text": "slow, {} ns"}], )";
  CHECK(paper.value(say + R"("take": "min")") == "fast");
  CHECK(paper.value(say + R"("take": "max")") == "slow, 60.0 ns");
  CHECK_THROWS_WITH(paper.value(R"("column": "ns", "say": [{"below": 1, "text": "never"}])"),
                    Catch::Contains("no phrase for 60"));
}

TEST_CASE("paper: a table has the rows asked for, in that order, by the paper's names") {
  const Paper paper;
  const std::string soup =
      R"("columns": {"clipper": "method", "ns": "ns"}, "where": {"mix": "soup"}, )";
  const std::string head = "\\begin{tabular}{lr}\n\\toprule\nmethod & ns \\\\\n\\midrule\n";
  const std::string end = "\\bottomrule\n\\end{tabular}\n";
  CHECK(paper.table(soup +
                    R"("only": {"clipper": ["cvv/naive", "homogeneous/sutherland_hodgman"]})") ==
        head + "dividing first with affine attributes & 30.0 \\\\\nclip space & 20.0 \\\\\n" + end);
  CHECK(paper.table(soup + R"("order": {"by": "ns", "descending": true}, "top": 1)") ==
        head + "the textbook clipper & 60.0 \\\\\n" + end);
}

TEST_CASE("paper: a pivot keeps the order of its lists, and dashes what is not there") {
  CHECK(Paper().table(R"("pivot": {"rows": "clipper", "columns": "mix", "value": "ns"},
                         "only": {"clipper": ["cvv/naive", "homogeneous/sutherland_hodgman"], "mix": ["hard", "soup"]})") ==
        "\\begin{tabular}{lrr}\n\\toprule\n & hard & game-like \\\\\n\\midrule\n"
        "dividing first with affine attributes & -- & 30.0 \\\\\nclip space & 50.0 & 20.0 \\\\\n"
        "\\bottomrule\n\\end{tabular}\n");
}

TEST_CASE("paper: a finding is set as in print, and its names may break") {
  const std::string finding =
      R"({Off by $1.6\cdot10^{-4}$ px at w $\le$ $10^{-5}$: 3\,\% of w\_\allowbreak{}first\_\allowbreak{}1e-5.})";
  CHECK_THAT(Paper().file("{}", "values.tex"), Catch::Contains(finding));
}

TEST_CASE("paper: what the run has not is named") {
  const Paper paper;
  CHECK_THROWS_WITH(paper.value(R"("column": "px")"), Catch::Contains("px"));
  CHECK_THROWS_WITH(paper.table(R"("columns": {"ns": "ns"}, "only": {"clipper": ["gone"]})"),
                    Catch::Contains("no row with clipper gone"));
  CHECK_THROWS_WITH(
      paper.file(R"({"values": [{"name": "V", "table": "none", "column": "ns"}]})", "values.tex"),
      Catch::Contains("table none is not among the results"));
}

TEST_CASE("paper: what a run may not have is left out, or something else in its place") {
  const Paper paper;
  const std::string none = R"("columns": {"ns": "ns"}, "where": {"mix": "gone"})";
  CHECK_THROWS_WITH(paper.table(none), Catch::Contains("no row matches"));
  CHECK(paper.table(none + R"(, "else": "\\emph{none}")") == "\\emph{none}");
  CHECK(paper.file(R"({"figures": [{"if_there": "nowhere.png"}]})", "nowhere.png").empty());
  CHECK_THROWS_WITH(paper.file(R"({"figures": ["nowhere.png"]})", "nowhere.png"),
                    Catch::Contains("figure nowhere.png is not among the results"));
}
