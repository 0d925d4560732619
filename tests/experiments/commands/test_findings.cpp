// SPDX-License-Identifier: GPL-3.0-or-later
//
// The findings of a run, as a person reads them.
#include <nlohmann/json.hpp>

#include "experiments/machine/measuring.hpp"
#include "experiments/table/prose.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

using clipscope::experiments::busy_text;
using clipscope::experiments::faults_of_prose;

namespace {

// The finding that the run at a quoted path left for an experiment.
std::string finding_of(const Folder& folder, const std::string& run, const std::string& name) {
  const Result r = folder.run("table --run " + run + " --finding " + name);
  INFO(r.err);
  REQUIRE(r.code == 0);
  return r.out.substr(0, r.out.find('\n'));
}

}  // namespace

TEST_CASE("findings: each can be read at once, also where what it speaks of was not asked for",
          "[slow]") {
  const Folder folder;
  const std::string run = quoted((folder.path() / "results").string());
  const Result r = folder.run(
      "run --quick --sample 8 --scalar float --clipper view/sutherland_hodgman --out " + run);
  INFO(r.err);
  REQUIRE(r.code == 0);
  for (const auto& experiment : nlohmann::json::parse(folder.run("list experiments --json").out)) {
    const auto name = experiment["name"].get<std::string>();
    if (name == "claims" || name == "answers") continue;  // they sum up the others
    std::string finding = finding_of(folder, run, name);
    // Where tests run side by side the machine is busy, and that is said behind it.
    const std::size_t busy = finding.find(" " + busy_text({.runs = 1, .redone = 1}));
    if (busy != std::string::npos) finding.resize(busy);
    INFO(name << ": " << finding);
    CHECK(faults_of_prose(finding) == std::vector<std::string>{});
  }
}
