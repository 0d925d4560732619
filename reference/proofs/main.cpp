// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope_proofs COMMAND [ARGUMENT…]: the proofs of the clippers' rounding bounds.
//
//   constants        prints name = value of every constant, as the code has it
//   write PROOF      prints the script that Gappa reads
//   check PROOF      asks Gappa for the proof
//   slack PROOF      weakens each constant that it proves until Gappa finds no proof; prints the
//                    rows of the table
//   weaken PROOF README
//                    whether there is a proof with the weakest values in the README's table, and
//                    none with those a step weaker
//   certify PROOF    has Gappa's certificate checked by Coq
//   covers PROOF…    whether these are all proofs, and every template belongs to one
//
// Exit codes: 0 all holds; 1 something does not; 2 the command is not one of these; 77 Gappa is not
// installed, unless CLIPSCOPE_REQUIRE_GAPPA is set, which makes that 1.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <set>
#include <span>
#include <stdexcept>
#include <string>

#include "reference/proofs/gappa.hpp"

namespace clipscope::proofs {
namespace {

using Words = std::span<char* const>;

// Those that a proof is about: the code's, and the links that it makes.
std::vector<Constant> proved_by(const Proof& p) {
  std::vector<Constant> r;
  for (const std::string_view name : script_of(p, value_in_code).constants) {
    const bool is_link = std::find(p.links.begin(), p.links.end(), name) != p.links.end();
    if (name.starts_with('k') || is_link) r.push_back(constant(name));
  }
  return r;
}

void check(const Proof& p) {
  if (!is_proved(script_of(p, value_in_code))) {
    throw std::runtime_error(fmt::format("Gappa finds no proof of {}", p.name));
  }
  fmt::print("{}: proved\n", p.name);
}

// The beginning of a constant's row in the table.
std::string row_of(const Proof& p, const Constant& c) {
  return fmt::format("| `{}` | `{}` | {} |", c.name, p.name, text_of(c, c.value));
}

void print_slack(const Proof& p) {
  for (const Constant& c : proved_by(p)) {
    const int steps = steps_to_spare(p, c);
    fmt::print("{} {} |\n", row_of(p, c), text_of(c, c.weakened(steps)));
  }
}

// The weakest value that the table has, as a number of steps.
int steps_in_table(const std::string& readme, const Proof& p, const Constant& c) {
  std::ifstream in(readme);
  if (!in) throw std::runtime_error(readme + ": can't be read");
  const std::string row = row_of(p, c);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(row)) continue;
    for (int steps = 0; steps < c.most_steps(); ++steps) {
      const std::string text = fmt::format("{} {} |", row, text_of(c, c.weakened(steps)));
      if (line.starts_with(text)) return steps;
    }
    throw std::runtime_error(
        fmt::format("{}: the value in this row is not that of a step: {}", readme, line));
  }
  throw std::runtime_error(fmt::format("{}: there is no row that begins with {}", readme, row));
}

void weaken(const Proof& p, const std::string& readme) {
  const std::vector<Constant> weakened = proved_by(p);
  if (weakened.empty()) throw std::runtime_error(fmt::format("{} has no constant", p.name));
  for (const Constant& c : weakened) {
    const int steps = steps_in_table(readme, p, c);
    const std::string good = text_of(c, c.weakened(steps)), bad = text_of(c, c.weakened(steps + 1));
    if (!is_proved_with(p, c, steps)) {
      throw std::runtime_error(fmt::format("{} = {}: no proof is found", c.name, good));
    }
    if (is_proved_with(p, c, steps + 1)) {
      throw std::runtime_error(
          fmt::format("{} = {}: a proof is found; the table says {}", c.name, bad, good));
    }
    fmt::print("{} = {}: proved; {}: no proof\n", c.name, good, bad);
  }
}

// Every proof is asked for, every template belongs to one, and every constant.
void expect_all(Words names) {
  const std::set<std::string_view> given(names.begin(), names.end());
  std::set<std::string_view> known, used;
  std::set<std::string> scripts;
  for (const Proof& p : proofs()) {
    known.insert(p.name);
    scripts.insert(std::string(p.script));
    for (const Constant& c : proved_by(p)) used.insert(c.name);
  }
  if (given != known) throw std::runtime_error("the names are not those of all proofs");
  if (scripts != templates()) throw std::runtime_error("a template belongs to no proof");
  for (const Constant& c : constants()) {
    if (used.count(c.name) == 1) continue;
    throw std::runtime_error(fmt::format("no proof is about {}", c.name));
  }
  fmt::print("{} proofs of {} constants\n", known.size(), used.size());
}

bool needs_gappa(std::string_view command) {
  return command == "check" || command == "slack" || command == "weaken" || command == "certify";
}

int answer(std::string_view command, Words words) {
  if (needs_gappa(command) && !is_gappa_installed()) {
    fmt::print(stderr,
               "clipscope_proofs: Gappa is not installed (on Debian: apt-get install gappa)\n");
    return std::getenv("CLIPSCOPE_REQUIRE_GAPPA") != nullptr ? 1 : 77;
  }
  if (command == "constants" && words.empty()) {
    for (const Constant& c : constants()) fmt::print("{} = {}\n", c.name, text_of(c, c.value));
  } else if (command == "write" && words.size() == 1) {
    fmt::print("{}", script_of(proof(words[0]), value_in_code).text);
  } else if (command == "check" && words.size() == 1) {
    check(proof(words[0]));
  } else if (command == "weaken" && words.size() == 2) {
    weaken(proof(words[0]), words[1]);
  } else if (command == "slack" && words.size() == 1) {
    print_slack(proof(words[0]));
  } else if (command == "certify" && words.size() == 1) {
    certify(script_of(proof(words[0]), value_in_code));
  } else if (command == "covers" && !words.empty()) {
    expect_all(words);
  } else {
    fmt::print(stderr,
               "Usage: clipscope_proofs constants | write PROOF | check PROOF | slack PROOF |\n"
               "                        weaken PROOF README | certify PROOF | covers PROOF…\n");
    return 2;
  }
  return 0;
}

}  // namespace
}  // namespace clipscope::proofs

int main(int argc, char* argv[]) {
  try {
    const std::span<char* const> words(argv, static_cast<std::size_t>(argc));
    if (words.size() < 2) return clipscope::proofs::answer("", {});
    return clipscope::proofs::answer(words[1], words.subspan(2));
  } catch (const std::exception& e) {
    fmt::print(stderr, "clipscope_proofs: {}\n", e.what());
    return 1;
  }
}
