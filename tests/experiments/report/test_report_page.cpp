// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "experiments/machine/errors.hpp"
#include "experiments/report/explorer_link.hpp"
#include "experiments/report/html.hpp"
#include "experiments/report/report.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/report/sample_page.hpp"

using namespace clipscope::experiments;

namespace {

const std::string kSvg = "<?xml version=\"1.0\"?>\n<svg viewBox=\"0 0 30 20\"><path/></svg>";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

ReportPage whole_page_of(const SampleRun& run, PageForm form = PageForm::folder) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("clipscope-page-" + std::to_string(getpid()));
  const ReportPage page = report_page(store_of(run, folder), folder, form);
  std::filesystem::remove_all(folder);
  return page;
}

std::string page_of(const SampleRun& run, PageForm form = PageForm::folder) {
  return whole_page_of(run, form).html;
}

SampleRun with_answers() {
  SampleRun run = sample_run({});
  run.push_back(sample_answers(kSvg));
  return run;
}

}  // namespace

TEST_CASE("html: base64 as RFC 4648 has it") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xff\xfe\x00") == "//4=");
}

TEST_CASE("table in a page: numbers keep their full value, odd ones too") {
  const std::string html = table_html(sample_odd());
  CHECK(contains(html, "<td class=\"n\" data-v=\"1e-300\">1.0e-300</td>"));
  CHECK(contains(html, "<td class=\"n\" data-v=\"NaN\">nan</td>"));
  CHECK(contains(html, "<td class=\"n\" data-v=\"Infinity\">inf</td>"));
  CHECK(contains(html, "<td class=\"n\" data-v=\"-Infinity\">-inf</td>"));
  CHECK(contains(html, "<td class=\"n nothing\">–</td>"));
  CHECK(contains(html, "<th scope=\"row\">tiny &lt;b&gt;bold&lt;/b&gt;</th>"));
  CHECK(contains(html, "Odd &lt;values&gt; &amp; &quot;quotes&quot;"));
  CHECK_FALSE(contains(html, "<script>"));
}

TEST_CASE("table in a page: a table without rows has its head and no row") {
  const std::string html = table_html(Table("empty", "Nothing", {{"a_px", "a [px]"}}));
  CHECK(contains(html, "data-key=\"a_px\"><button type=\"button\">a [px]</button></th>"));
  CHECK(contains(html, "<tbody>\n</tbody>"));
}

TEST_CASE("table in a page: an experiment is a link only if the page has it") {
  const std::string html = table_html(sample_claims(), {.parts = {"sample"}});
  CHECK(contains(html, "<a href=\"#sample\">sample</a>"));
  CHECK(contains(html, ">elsewhere</td>"));
  CHECK(contains(html, "<span class=\"verdict refuted\">refuted</span>"));
  CHECK(contains(html, "<span class=\"verdict partly\">true only when</span>"));
  CHECK(contains(html, "<span class=\"verdict\">undecided</span>"));
}

TEST_CASE("page: claims come first, then the findings, then the experiments in their order") {
  const std::string page = page_of(sample_run({}));
  const auto at = [&](const std::string& id) { return page.find("<section id=\"" + id + "\""); };
  CHECK(at("claims") < at("findings"));
  CHECK(at("findings") < at("sample"));
  CHECK(at("sample") < at("unfinished"));
  CHECK(at("unfinished") != std::string::npos);
}

TEST_CASE("page: verdicts are counted from the table of claims") {
  const std::string page = page_of(sample_run({}));
  CHECK(contains(page, "<li>2 <span class=\"verdict refuted\">"));
  CHECK(contains(page, "<li>1 <span class=\"verdict confirmed\">"));
  SampleRun altered = sample_run({});
  altered.back().tables[0].add_row(
      {std::int64_t{6}, std::string("c"), std::string("refuted"), std::string("b"), Cell()});
  CHECK(contains(page_of(altered), "<li>3 <span class=\"verdict refuted\">"));
}

TEST_CASE("page: the figures of a claim stand beneath its reason, and no other's") {
  const std::string page = page_of(sample_run({}));
  std::size_t folded = 0;
  for (std::size_t at = 0; (at = page.find("<summary>Figures", at)) != std::string::npos; ++at) {
    ++folded;
  }
  CHECK(folded == 2);  // of five claims
  CHECK(contains(
      page, "<tr><th scope=\"row\">a &lt; b</th><td class=\"n\" data-v=\"0.25\">0.250</td></tr>"));
  SampleRun without = sample_run({});
  without.back().tables.pop_back();
  CHECK_FALSE(contains(page_of(without), "<summary>Figures"));
}

TEST_CASE("page: what is missing is said, not left out") {
  const std::string page = page_of(sample_run({}));
  CHECK(contains(page, "in the middle of this experiment"));
  CHECK(contains(page, "sample/gone.png can't be read"));
  SampleRun content = sample_run({});
  content[0].experiment.finding.clear();
  CHECK(contains(page_of(content), "left no finding"));
  CHECK(contains(page_of({}), "left no finding"));
  CHECK(contains(page_of(sample_run({"no picture"}), PageForm::single_file),
                 "sample/plot1.svg can't be read"));
}

TEST_CASE(
    "page: plots and pictures are shown where they lie, with their sizes, and none is in it") {
  const std::string page = page_of(sample_run({kSvg}));
  CHECK(contains(
      page, "alt=\"A plot. What it shows\" width=\"1\" height=\"1\" src=\"sample/plot1.png\">"));
  CHECK(
      contains(page, "<a href=\"sample/plot1.svg\">SVG</a> <a href=\"sample/plot1.pdf\">PDF</a>"));
  CHECK(contains(page,
                 "alt=\"A &quot;picture&quot;\" width=\"1\" height=\"1\" src=\"sample/a.png\""));
  for (const char* part : {"base64", "<svg", "data:"}) CHECK_FALSE(contains(page, part));
}

TEST_CASE("page: the rows of a long table lie in a script beside it, whose size the page has not") {
  SampleRun run = sample_run({});
  const ReportPage page = whole_page_of(run);
  REQUIRE(page.scripts.size() == 1);
  const auto& [file, script] = *page.scripts.begin();
  CHECK(file == "report/long.js");
  CHECK(script.starts_with("clipscopeRows(\"long\", \"<tr>"));
  CHECK(contains(page.html, "data-rows=\"160\" data-script=\"report/long.js\""));
  CHECK(contains(page.html, "<noscript>"));
  Table& table = run[0].tables[1];
  for (int i = 0; i < 3000; ++i) table.add_row(std::vector<Cell>(table.rows()[0]));
  const ReportPage longer = whole_page_of(run);
  CHECK(longer.html.size() < page.html.size() + 10);
  CHECK(longer.scripts.at(file).size() > 10 * script.size());
}

TEST_CASE("page: a single file has plots, pictures as WebP and all rows in it, and loads nothing") {
  const ReportPage page = whole_page_of(sample_run({kSvg}), PageForm::single_file);
  CHECK(page.scripts.empty());
  CHECK(contains(page.html, "<svg role=\"img\" aria-label=\"A plot. What it shows\" viewBox="));
  CHECK_FALSE(contains(page.html, "<?xml"));
  CHECK(contains(page.html,
                 "width=\"1\" height=\"1\" src=\"data:image/webp;base64,UklGR"));  // "RIFF"
  for (const char* part : {"src=\"sample", "href=\"sample", "data-script", "'self'"}) {
    CHECK_FALSE(contains(page.html, part));
  }
  std::size_t rows = 0;
  for (std::size_t at = 0; (at = page.html.find("<tr>", at)) != std::string::npos; ++at) ++rows;
  CHECK(rows > 160);
}

TEST_CASE("page: a file's name is an address, whatever is in it") {
  CHECK(url_of("pictures/floor-cvv_near.png") == "pictures/floor-cvv_near.png");
  CHECK(url_of("a b#1/%\"<é") == "a%20b%231/%25%22%3C%C3%A9");
}

TEST_CASE("page: the answers lead, each sentence with its evidence if the page has it") {
  const std::string page = page_of(with_answers());
  CHECK(page.find("<section id=\"answers\"") < page.find("<section id=\"claims\""));
  CHECK(contains(
      page,
      "<p class=\"lead\">In clip space, if a &lt; b. <a class=\"evidence\" href=\"#table-odd\">"));
  CHECK(
      contains(page, "<dd>52 % more time. <a class=\"evidence\" href=\"#table-answers_prices\">"));
  CHECK(contains(page, "<dd>Clip first. <a class=\"evidence\" href=\"#sample\">"));
  CHECK(contains(page, "<dd>This run does not say.</dd>"));
  CHECK_FALSE(contains(page, "id=\"answers-head\""));  // not among the experiments again
  CHECK_FALSE(contains(page_of(sample_run({})), "\"answers\""));
}

TEST_CASE("page: the first screen's tables stand in one order, whatever that of the store") {
  const std::string page = page_of(with_answers());
  std::size_t last = 0;
  for (const char* name : {"prices", "readers", "stability", "effects"}) {
    const std::size_t at = page.find(std::string("id=\"table-answers_") + name);
    REQUIRE(at != std::string::npos);
    CHECK(at > last);
    last = at;
  }
  CHECK_FALSE(contains(page, "a/b"));  // the price list names steps
  CHECK(contains(page, "a rasteriser that indexes &lt;memory&gt;"));
  CHECK(contains(page, "21.2 ns per triangle, 6.50 % over the fastest"));
}

TEST_CASE("page: the matrix is coloured by the share of its theme's cases that a method fails on") {
  SampleRun run = with_answers();
  const auto shown = [&](const std::string& part) { return contains(page_of(run), part); };
  CHECK(shown("<td class=\"n few\">4</td>"));   // of 60 and of 40
  CHECK(shown("<td class=\"n many\">5</td>"));  // of 40
  CHECK(shown("<td class=\"n right\">0</td>"));
  Table& matrix = run.back().tables[2];
  matrix.add_row(
      {std::string("new"), std::string("float"), std::int64_t{7}, std::int64_t{7}, Cell()});
  CHECK(shown("<td class=\"n many\">7</td>"));
}

TEST_CASE("page: a first pass says so, another does not") {
  const auto page = [](const RunInfo& info) {
    return report_page(ResultsStore(create_database({}, info), {}), {}).html;
  };
  CHECK(contains(page({{"pass", "first"}}), "<b>First pass.</b>"));
  CHECK_FALSE(contains(page({{"machine", "a"}}), "First pass"));
}

TEST_CASE("page: many pictures are folded") {
  SampleRun content = sample_run({});
  CHECK_FALSE(contains(page_of(content), "<details class=\"album\">"));
  auto& figures = content[0].figures;
  for (int i = 0; i < 20; ++i) {
    figures.push_back(figures[0]);
    figures.back().figure.file = "sample/" + std::to_string(i) + ".png";
  }
  CHECK(contains(page_of(content), "<summary>22 pictures</summary>"));
}

TEST_CASE("page: nothing of the results is read as the template's") {
  SampleRun content = sample_run({});
  content[0].experiment.finding = "{{script}} {{nothing}}";
  CHECK(contains(page_of(content), "{{script}} {{nothing}}"));
}

TEST_CASE("page: it leads to the explorer where that lies beside it, and only there") {
  const auto folder =
      std::filesystem::temp_directory_path() / ("clipscope-explorer-" + std::to_string(getpid()));
  const ResultsStore store = store_of(sample_run({}), folder);
  const auto page = [&](PageForm form) { return report_page(store, folder, form).html; };
  CHECK_FALSE(contains(page(PageForm::folder), "explorer"));
  write_file(folder / "explorer.html", "");
  const std::string html = page(PageForm::folder);
  CHECK(contains(html, "<a href=\"explorer.html\">The explorer</a>"));
  const std::string fragment = explorer_fragment("sample", sample_worst_inputs().front());
  REQUIRE_FALSE(fragment.empty());
  std::size_t escaped = 0;  // of its ampersands, as an attribute has them
  for (std::size_t at = html.find("explorer.html#v1&amp;"); at < html.find('"', at + 1);
       at = html.find("&amp;", at + 1)) {
    ++escaped;
  }
  CHECK(escaped > 5);
  CHECK(contains(html, "\">see it in the explorer</a></td>"));
  CHECK(html.find("see it in the explorer") == html.rfind("see it in the explorer"));
  CHECK_FALSE(contains(page(PageForm::single_file), "explorer.html"));
  std::filesystem::remove_all(folder);
}

TEST_CASE("page: a folder that is a file is an error that names it") {
  const auto file = std::filesystem::temp_directory_path() / "clipscope-page-file";
  std::ofstream(file) << "in the way";
  CHECK_THROWS_WITH(write_report(store_of({}, {}), file),
                    Catch::Contains((file / "report.html").string()));
  CHECK_THROWS_AS(write_report(store_of({}, {}), file), OutputError);
  std::filesystem::remove(file);
}
