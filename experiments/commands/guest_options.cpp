// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/commands/guest_options.hpp"

#include <fmt/ranges.h>

#include "experiments/commands/options.hpp"
#include "experiments/guests/program.hpp"
#include "experiments/machine/shell_word.hpp"
#include "experiments/selection/replay_text.hpp"

namespace clipscope::experiments::commands {
namespace {

void add_program_options(CLI::App& command, GuestOptions& options) {
  add_option(
      command, "--program", options.programs, "COMMAND",
      "A clipper of yours: a command line that reads primitives as `clipscope clip` does, until its input ends, and writes its CSV; judged, not timed; may be given several times")
      ->allow_extra_args(false);
  add_option(
      command, "--takes", options.takes, "LIST",
      fmt::format("What the program can be asked: some of {} [clip,gl,triangles]", takes_words()))
      ->delimiter(',')
      ->allow_extra_args(false);
  add_option(command, "--name", options.name, "NAME", "Name of the program [that of its file]");
}

ProgramOptions program_of(const std::string& command, const GuestOptions& options) {
  ProgramOptions program{.command = command, .name = options.name};
  program.seconds = options.seconds.value_or(program.seconds);
  set_takes(options.takes, program);
  if (!options.space.empty()) set_takes({options.space}, program);
  return program;
}

}  // namespace

void add_guest_options(CLI::App& command, GuestOptions& options) {
  add_option(
      command, "--plugin", options.plugins, "LIB",
      "A clipper of yours: a shared library with the interface of clipscope_plugin.h; may be given several times")
      ->allow_extra_args(false);
  add_option(command, "--time-limit", options.seconds, "SECONDS",
             fmt::format("What a plug-in or program may take for a batch [{:g}, {:g}]",
                         kPluginSeconds, ProgramOptions{}.seconds))
      ->check(CLI::Range(0.01, 86400.0));
  add_program_options(command, options);
}

void add_guest_space_option(CLI::App& command, GuestOptions& options) {
  command
      .add_option("--space", options.space,
                  "Space that the program starts in: view (x y z) or clip (x y z w) [clip]")
      ->check(CLI::IsMember({"view", "clip"}));
}

std::string command_options(const GuestOptions& options) {
  std::string text;
  for (const std::string& library : options.plugins) text += " --plugin " + shell_word(library);
  for (const std::string& program : options.programs) text += " --program " + shell_word(program);
  return text;
}

std::vector<std::string_view> load_guests(const GuestOptions& options) {
  std::vector<std::string_view> names;
  for (const std::string& library : options.plugins) {
    names.push_back(add_plugin(library, options.seconds.value_or(kPluginSeconds)));
  }
  if (!options.name.empty() && options.programs.size() != 1) {
    usage_error("--name: '{}' given for {} programs; expected one --program", options.name,
                options.programs.size());
  }
  for (const std::string& command : options.programs) {
    names.push_back(add_program(program_of(command, options)));
  }
  return names;
}

void load_guests(const GuestOptions& options, Selection& selection) {
  selection.guests = load_guests(options);
  selection.guest_files = options.plugins;
  for (const std::string& command : options.programs) {
    const std::string file = program_file(command);
    if (!file.empty()) selection.guest_files.push_back(file);
  }
  check_scalars_of_guests(selection);
}

void check_takes_scenes(const Selection& selection) {
  const DepthRange depth = selection.camera.depth;
  const Batch batch{.space = Space::view, .frustum = {.depth = depth}, .volume = {.depth = depth}};
  for (const std::string_view guest : selection.guests) {
    for (const Contestant& c : all_contestants()) {
      if (c.clipper != guest || c.vertices != 3 || c.takes(batch)) continue;
      usage_error(
          "{}: {} does not take what scenes are made of: triangles in view space or clip space, with --depth {}",
          c.brought_by, guest, depth_option(depth));
    }
  }
}

std::string given_clipper(const std::string& clipper, const std::vector<std::string_view>& guests,
                          std::string_view usual) {
  if (!clipper.empty()) return clipper;
  if (guests.size() > 1) {
    usage_error("--clipper: {} were brought, and this command takes one; expected the name of one",
                fmt::join(guests, ", "));
  }
  if (guests.empty() && usual.empty()) {
    usage_error("--clipper: a name is missing, or --plugin or --program");
  }
  return std::string(guests.empty() ? usual : guests.front());
}

}  // namespace clipscope::experiments::commands
