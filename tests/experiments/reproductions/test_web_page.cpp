// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "experiments/guests/process.hpp"
#include "experiments/machine/files.hpp"
#include "tests/experiments/reproductions/cases.hpp"

namespace clipscope::experiments {
namespace {

namespace fs = std::filesystem;

// The first word of the page's title once it has drawn.
std::string verdict_of(const std::string& page) {
  const fs::path folder = fs::temp_directory_path() / "clipscope-page";
  write_file(folder / "page.html", page);
  std::string command = "chromium --dump-dom file://" + (folder / "page.html").string() +
                        " --user-data-dir=" + (folder / "profile").string();
  for (const char* option :
       {"--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
        "--enable-unsafe-swiftshader", "--virtual-time-budget=5000"}) {
    command += std::string(" ") + option;
  }
  const ProcessResult run = run_process(command, "", {}, "CLIPSCOPE", {.seconds = 60});
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  const std::size_t at = run.output.find("<title>");
  if (at == std::string::npos) return run.output + run.errors;
  return run.output.substr(at + 7, run.output.find(' ', at) - at - 7);
}

TEST_CASE("web page: a right browser passes it, and fails where the claim is turned round") {
  if (!is_there_or_not_required("chromium", "CLIPSCOPE_REQUIRE_CHROMIUM")) return;
  for (const Claim& claim : right_claims()) {
    const std::string right = text_of(claim, ".html");
    CAPTURE(claim.name, right);
    if (right.empty()) {
      CHECK(claim.wrong.quantity == Quantity::primitive_id);  // which WebGL does not have
      continue;
    }
    CHECK(verdict_of(right) == "PASS");
    CHECK(verdict_of(text_of(turned(claim), ".html")) == "FAIL");
  }
}

TEST_CASE("web page: what the browser can't draw is neither right nor wrong") {
  if (!is_there_or_not_required("chromium", "CLIPSCOPE_REQUIRE_CHROMIUM")) return;
  Claim claim = right_claims().front();
  std::string page = text_of(claim, ".html");
  const std::string needs = "needs: []";
  REQUIRE(page.find(needs) != std::string::npos);
  page.replace(page.find(needs), needs.size(), "needs: ['WEBGL_of_tomorrow']");
  CHECK(verdict_of(page) == "NOT");
}

}  // namespace
}  // namespace clipscope::experiments
