// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope_attack: attacks the correctly rounded clipper with kinds of input for as long as it is
// told to. Exit code 1: it has a wrong bit, or a kind did not reach what it is there for.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "tests/spaces/attack/attack.hpp"

namespace clipscope::attack {
namespace {

struct Options {
  double seconds = 0;
  int batches = 100;
  std::uint64_t seed = 1;
  std::vector<std::string> kinds;  // all if there are none
  bool list = false, facts = false;
};

void print_list() {
  for (const Kind& kind : all_kinds()) {
    std::printf("%-24s %s\n", std::string(kind.name).c_str(), std::string(kind.what).c_str());
  }
}

void print_facts(const Facts& facts) {
  for (std::size_t i = 0; i < kFacts; ++i) {
    if (facts.counts[i] == 0) continue;
    std::printf("  %-24s %12lld\n", std::string(kFactNames[i]).c_str(),
                static_cast<long long>(facts.counts[i]));
  }
}

// Whether nothing is wrong with what a kind found.
bool report(const Kind& kind, const Attacked& attacked, const Options& options,
            std::span<const Contestant> all) {
  const Tally& tally = attacked.tally;
  const std::string name(kind.name);
  std::printf("%-24s %10lld triangles %12lld answers %14lld floats\n", name.c_str(),
              static_cast<long long>(tally.triangles), static_cast<long long>(tally.answers),
              static_cast<long long>(tally.floats));
  if (options.facts) print_facts(tally.facts);
  std::fflush(stdout);
  if (attacked.failure) {
    std::printf(
        "MISROUNDED by %s: clipscope_attack --kind %s --seed %llu --batches %d replays it\n%s",
        name.c_str(), name.c_str(), static_cast<unsigned long long>(options.seed), attacked.batches,
        describe(shrunk(*attacked.failure, all)).c_str());
    return false;
  }
  const std::string missing = missing_facts(kind, tally.facts);
  if (missing.empty()) return true;
  std::printf("%s did not reach: %s\n", name.c_str(), missing.c_str());
  return false;
}

bool run(const Options& options) {
  const std::vector<Contestant> all = contestants();
  bool ok = true;
  for (const Kind& kind : all_kinds()) {
    const auto is_this = [&](const std::string& name) { return name == kind.name; };
    if (!options.kinds.empty() && std::ranges::none_of(options.kinds, is_this)) continue;
    const auto begin = std::chrono::steady_clock::now();
    const auto goes_on = [&](int batches) {
      if (options.seconds == 0) return batches < options.batches;
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
      return passed.count() < options.seconds;
    };
    ok = report(kind, attack(kind, options.seed, all, goes_on), options, all) && ok;
  }
  return ok;
}

}  // namespace
}  // namespace clipscope::attack

int main(int argc, char** argv) {
  using namespace clipscope::attack;
  CLI::App app("Attacks the correctly rounded clipper, every bit against exact integers.");
  Options options;
  std::vector<std::string> names;
  for (const Kind& kind : all_kinds()) names.emplace_back(kind.name);
  app.add_option("--seconds", options.seconds, "how long for each kind of input")
      ->check(CLI::PositiveNumber);
  app.add_option("--batches", options.batches, "how many batches of each kind, without --seconds")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seed", options.seed, "of the random input")->capture_default_str();
  app.add_option("--kind", options.kinds, "these alone; --list names them")
      ->check(CLI::IsMember(names));
  app.add_flag("--facts", options.facts, "how often what is hard came about");
  app.add_flag("--list", options.list, "name the kinds of input and end");
  CLI11_PARSE(app, argc, argv);
  if (options.list) {
    print_list();
    return 0;
  }
  return run(options) ? 0 : 1;
}
