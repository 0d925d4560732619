// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope verify: which promises does a clipper keep on every triangle of scenes, of the
// catalogue of hard cases, of random ones or of a file?
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/commands/guest_options.hpp"
#include "experiments/commands/options.hpp"
#include "experiments/commands/verification.hpp"
#include "experiments/commands/verify_sources.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/table/json_text.hpp"

namespace clipscope::experiments::commands {
namespace {

struct VerifyOptions {
  Selection selection;
  GuestOptions guests;
  std::string clipper, scalar;  // empty: not given
  std::vector<std::string> promises;
  VerifySources sources;
  bool shrinks = true;
  std::optional<std::string> junit, corpus_out;
};

// The clipper named, or the first guest; in the scalar named, or the first that it computes in.
const Contestant& chosen_contestant(const VerifyOptions& options) {
  const std::string clipper = given_clipper(options.clipper, load_guests(options.guests));
  if (!options.scalar.empty()) return find_contestant(clipper, options.scalar);
  const bool in_float = find_in_contract(clipper, "float", Contract::full) != nullptr;
  const bool in_double = find_in_contract(clipper, "double", Contract::full) != nullptr;
  return find_contestant(clipper, !in_float && in_double ? "double" : "float");
}

// Those of --promise; nothing if it was not given.
std::optional<Questions> named_questions(const VerifyOptions& options) {
  if (options.promises.empty()) return std::nullopt;
  Questions named;
  for (const std::string& name : options.promises) {
    if (name == "all") return Questions::all();
    const auto names = names_of(Question{});
    named.add(static_cast<Question>(std::ranges::find(names, name) - names.begin()));
  }
  return named;
}

int verify(const VerifyOptions& options) {
  const Contestant& contestant = chosen_contestant(options);
  const std::optional<Questions> named = named_questions(options);
  const Questions asked = named.value_or(usually_asked(contestant));
  const Questions examined = contestant.is_guest && !named ? Questions::all() : asked;
  Verification verification{named.has_value(), {}};
  verification.sources =
      examine_sources(options.sources, options.selection, {contestant, examined, asked});
  if (options.shrinks) verification.smallest = smallest_of(verification);
  if (options.corpus_out && verification.smallest) {
    append_case(*options.corpus_out, verification.smallest->triangle);
  }
  if (options.junit) write_file(*options.junit, junit_of(verification));
  fmt::print("{}", options.selection.json ? json_text(json_of(verification), 2) + "\n"
                                          : text_of(verification));
  return exit_code(verification);
}

void add_promise_option(CLI::App& command, std::vector<std::string>& promises) {
  std::vector<std::string> names = {"all"};
  for (const std::string_view name : names_of(Question{})) names.emplace_back(name);
  add_option(
      command, "--promise", promises, "LIST",
      "What must hold, separated by commas (see below), or all [what the clipper states; of one that is not ours total,contained,covers,winding]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(names).description(""));
}

void add_source_options(CLI::App& command, VerifyOptions& options) {
  VerifySources& sources = options.sources;
  const auto set_space = [&options](const std::string& name) {
    options.sources.space = name == "view" ? Space::view : Space::clip;
    options.guests.space = name;
  };
  command
      .add_option_function<std::string>(
          "--space", set_space,
          "Triangles in view space or in clip space alone; a program takes these alone [both, of a program clip]")
      ->check(CLI::IsMember({"view", "clip"}));
  command.add_flag(
      "--catalogue", sources.catalogue,
      "The hard cases and their families, in view space and clip space, instead of scenes (or besides those named)");
  add_option(command, "--corpus", sources.corpus, "FILE|DIR",
             "The same with hard cases of your own");
  add_option(command, "--case", sources.hard_case, "NAME",
             "Of the hard cases this alone, with its family, or one of a family");
  command.add_option("--triangles", sources.random, "So many random triangles")
      ->check(CLI::PositiveNumber);
  const char* kTextGroup = "Triangles as text";
  add_option(
      command, "--input", sources.input, "FILE",
      "Triangles, one per line, as `clipscope clip` reads them; -: standard input. In view space with --frustum, --ortho or --matrix")
      ->group(kTextGroup);
  add_option(command, "--attributes", sources.attributes, "K", "Attributes per vertex of these [0]")
      ->check(CLI::Range(0, kMaxAttributes))
      ->group(kTextGroup);
  add_boundary_options(command, sources.volume);
  for (const char* name : {"--clip-distances", "--depth-clamp", "--half-open"}) {
    command.get_option(name)->group(kTextGroup);
  }
}

// "Promises: total (...), ...", and the exit codes.
std::string footer() {
  std::string text = "Promises, each judged by the exact reference:\n";
  for (std::size_t i = 0; i < kQuestions; ++i) {
    const auto q = static_cast<Question>(i);
    text += fmt::format("  {:<19}{}\n", name_of(q), question_text(q));
  }
  return text +
         fmt::format(
             R"(The bound is that of the clipper's promise (`clipscope list clippers`); where it states none,
{} u M.
Exit code 0: all that is asked for holds on every triangle that it speaks of; 1: some is broken; 6:
no triangle was judged, or a promise named by --promise on none; 5: a plug-in or program can't be
asked.)",
             kChainUlps);
}

}  // namespace

void add_verify_command(CLI::App& app, Action& action) {
  const auto [command, options] =
      add_command(app, action, verify, "verify",
                  "Which promises does a clipper keep on scenes, hard cases or a file?", footer());
  add_contestant_options(command, options.clipper, options.scalar);
  add_guest_options(command, options.guests);
  add_promise_option(command, options.promises);
  add_source_options(command, options);
  add_scene_options(command, options.selection);
  command.add_flag("!--no-shrink", options.shrinks,
                   "Leave the first counterexample as it is; else it is made as small as it goes");
  add_option(command, "--corpus-out", options.corpus_out, "FILE",
             "Add the smallest to this file of hard cases");
  add_option(command, "--junit", options.junit, "FILE",
             "Also write the promises as test cases, in JUnit's XML, for CI systems");
  add_json_option(command, options.selection);
}

}  // namespace clipscope::experiments::commands
