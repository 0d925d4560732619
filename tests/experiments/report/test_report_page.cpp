// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "experiments/machine/errors.hpp"
#include "experiments/report/report.hpp"
#include "experiments/table/utf8.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/report/sample_page.hpp"

using namespace clipscope::experiments;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string page_of(const SampleRun& run) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("clipscope-page-" + std::to_string(getpid()));
  const std::string page = report_page(store_of(run, folder), folder);
  std::filesystem::remove_all(folder);
  return page;
}

}  // namespace

TEST_CASE("html: what HTML would read as markup is escaped") {
  CHECK(html_escape("<a href=\"x\">'&amp;'</a>") ==
        "&lt;a href=&quot;x&quot;&gt;&#39;&amp;amp;&#39;&lt;/a&gt;");
  CHECK(html_escape("naïve ≤ 1") == "naïve ≤ 1");
  CHECK(html_escape(std::string_view("a\0b\x1b\n", 5)) == "a b \n");
}

TEST_CASE("html: bytes that are no UTF-8 become the replacement character") {
  const std::string mark = "\xEF\xBF\xBD";
  CHECK(valid_utf8(std::string("a\xff") + "b") == "a" + mark + "b");
  CHECK(valid_utf8("\xc0\xaf") == mark + mark);                        // overlong /
  CHECK(valid_utf8("\xed\xa0\x80") == mark + mark + mark);             // a surrogate
  CHECK(valid_utf8("\xe2\x82") == mark + mark);                        // cut off
  CHECK(valid_utf8("\xf4\x90\x80\x80") == mark + mark + mark + mark);  // past U+10FFFF
  CHECK(valid_utf8("€ 𝄞 \xed\x9f\xbf") == "€ 𝄞 \xed\x9f\xbf");
}

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
  CHECK(contains(html, "<th scope=\"row\" class=\"short\">tiny &lt;b&gt;bold&lt;/b&gt;</th>"));
  CHECK(contains(html, "Odd &lt;values&gt; &amp; &quot;quotes&quot;"));
  CHECK_FALSE(contains(html, "<script>"));
}

TEST_CASE("table in a page: a table without rows has its head and no row") {
  const std::string html = table_html(Table("empty", "Nothing", {{"a_px", "a [px]"}}));
  CHECK(contains(html, "data-key=\"a_px\"><button type=\"button\">a [px]</button></th>"));
  CHECK(contains(html, "<tbody>\n</tbody>"));
}

TEST_CASE("table in a page: an experiment is a link only if the page has it") {
  const std::string html = table_html(sample_claims(), {"sample"});
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

TEST_CASE("page: what is missing is said, not left out") {
  const std::string page = page_of(sample_run({}));
  CHECK(contains(page, "in the middle of this experiment"));
  CHECK(contains(page, "sample/gone.png can't be read"));
  SampleRun content = sample_run({});
  content[0].experiment.finding.clear();
  CHECK(contains(page_of(content), "left no finding"));
  CHECK(contains(page_of({}), "left no finding"));
  CHECK(contains(page_of(sample_run({"no picture"})), "sample/plot1.svg can't be read"));
}

TEST_CASE("page: a plot stands in it as it is, a picture in base64 with its size") {
  const std::string page =
      page_of(sample_run({"<?xml version=\"1.0\"?>\n<svg viewBox=\"0 0 1 1\"><path/></svg>"}));
  CHECK(contains(page,
                 "<svg role=\"img\" aria-label=\"A plot. What it shows\" viewBox=\"0 0 1 1\">"));
  CHECK_FALSE(contains(page, "<?xml"));
  CHECK(contains(page,
                 "width=\"1\" height=\"1\" src=\"data:image/png;base64," + base64(sample_png())));
  CHECK(contains(page, "alt=\"A &quot;picture&quot;\""));
}

TEST_CASE("page: many pictures are folded") {
  SampleRun content = sample_run({});
  CHECK_FALSE(contains(page_of(content), "<details class=\"album\">"));
  auto& figures = content[0].figures;
  for (int i = 0; i < 20; ++i) {
    figures.push_back(figures[0]);
    figures.back().figure.file = std::to_string(i) + ".png";
  }
  CHECK(contains(page_of(content), "<summary>22 pictures</summary>"));
}

TEST_CASE("page: nothing of the results is read as the template's") {
  SampleRun content = sample_run({});
  content[0].experiment.finding = "{{script}} {{nothing}}";
  CHECK(contains(page_of(content), "{{script}} {{nothing}}"));
}

TEST_CASE("page: a folder that is a file is an error that names it") {
  const auto file = std::filesystem::temp_directory_path() / "clipscope-page-file";
  std::ofstream(file) << "in the way";
  CHECK_THROWS_WITH(write_report(store_of({}, {}), file),
                    Catch::Contains((file / "report.html").string()));
  CHECK_THROWS_AS(write_report(store_of({}, {}), file), OutputError);
  std::filesystem::remove(file);
}
