// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <sstream>

#include "experiments/guests/process.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/machine/temporary_folder.hpp"
#include "tests/experiments/reproductions/cases.hpp"

namespace clipscope::experiments {
namespace {

namespace fs = std::filesystem;

// Shows the pages in frames of one and tells their titles.
std::string frames(const fs::path& folder, const std::vector<std::string>& pages) {
  std::string text = R"(<!DOCTYPE html><pre id="titles"></pre>
<script>
addEventListener('message', (event) => { document.getElementById('titles').textContent += event.data + '\n'; });
</script>
)";
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const std::string name = std::to_string(i);
    write_file(folder / (name + ".html"), pages[i] + "<script>parent.postMessage('" + name +
                                              " ' + document.title.split(' ')[0], '*');</script>");
    text += "<iframe src=\"" + name + ".html\"></iframe>\n";
  }
  return text;
}

// The first word of each page's title once it has drawn, or all that the browser said.
std::vector<std::string> verdicts_of(const std::vector<std::string>& pages) {
  const TemporaryFolder folder;
  write_file(folder / "frames.html", frames(folder.path(), pages));
  std::string command = "chromium --dump-dom file://" + (folder / "frames.html").string() +
                        " --user-data-dir=" + (folder / "profile").string();
  for (const char* option :
       {"--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
        "--enable-unsafe-swiftshader", "--virtual-time-budget=20000"}) {
    command += std::string(" ") + option;
  }
  const ProcessResult run = run_process(command, "", {}, "CLIPSCOPE", {.seconds = 120});
  std::vector<std::string> verdicts(pages.size(), run.output + run.errors);
  std::istringstream titles(run.output.substr(run.output.find("titles\">") + 8));
  std::size_t number = 0;
  for (std::string verdict; titles >> number >> verdict;) verdicts.at(number) = verdict;
  return verdicts;
}

TEST_CASE("web page: a right browser passes it, and fails where the claim is turned round") {
  if (!is_there_or_not_required("chromium", "CLIPSCOPE_REQUIRE_CHROMIUM")) return;
  std::vector<std::string> names, pages;
  for (const Claim& claim : right_claims()) {
    const std::string right = text_of(claim, ".html");
    // Which WebGL does not have.
    CHECK(right.empty() == (claim.wrong.quantity == Quantity::primitive_id));
    if (right.empty()) continue;
    names.push_back(claim.name);
    pages.push_back(right);
    pages.push_back(text_of(turned(claim), ".html"));
  }
  const std::vector<std::string> verdicts = verdicts_of(pages);
  for (std::size_t i = 0; i < names.size(); ++i) {
    CAPTURE(names[i]);
    CHECK(verdicts[2 * i] == "PASS");
    CHECK(verdicts[2 * i + 1] == "FAIL");
  }
}

TEST_CASE("web page: what the browser can't draw is neither right nor wrong") {
  if (!is_there_or_not_required("chromium", "CLIPSCOPE_REQUIRE_CHROMIUM")) return;
  std::string page = text_of(right_claims().front(), ".html");
  const std::string needs = "needs: []";
  REQUIRE(page.find(needs) != std::string::npos);
  page.replace(page.find(needs), needs.size(), "needs: ['WEBGL_of_tomorrow']");
  CHECK(verdicts_of({page}) == std::vector<std::string>{"NOT"});
}

}  // namespace
}  // namespace clipscope::experiments
