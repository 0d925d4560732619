// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <new>

#include "experiments/commands/commands.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/table/terminal.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments::commands {
namespace {

constexpr const char* kAbout =
    R"(clipscope: where should a triangle be clipped? Clippers in view space, homogeneous clip space and
the canonical view volume, judged by an exact reference.)";
constexpr const char* kProgramFooter = R"(Examples:
  clipscope run                             all default experiments on the built-in scenes
  clipscope run --resume                    what an interrupted run has left undone
  clipscope table accuracy --run results    a table of a run
  clipscope diff results_a results_b        which figures moved
  clipscope compare --scene teapot          every clipper in float and double, one table
  clipscope compare --scene bunny.obj --clipper 'homogeneous/*'
  clipscope verify --clipper cvv/near_first --scalar float
  clipscope verify --plugin ./libmine.so    a clipper of yours; see clipscope_plugin.h
  clipscope render --scene floor --clipper cvv/naive --against exact --out floor.png
  echo '0 0 -2  3 0 -2  0 1 -2' | clipscope clip --space view --perspective 90,1,1,10
  clipscope camera --perspective 60,1.7778,0.1,1000

Exit codes: 0 done; 1 a promise is broken (verify), a figure moved (diff); 2 wrong option or name;
3 bad input file or line; 4 results can't be written; 5 a plug-in or program can't be asked; 6 a
check had nothing to judge.)";

// Help whose descriptions of options are broken into lines.
class Help : public CLI::Formatter {
 public:
  std::string make_option_desc(const CLI::Option* option) const override {
    const auto lines =
        wrapped(CLI::Formatter::make_option_desc(option), kTextWidth - get_column_width());
    return fmt::format("{}", fmt::join(lines, "\n"));
  }
};

int say(const char* kind, const std::exception& error, int code) {
  fmt::print(stderr, "clipscope: {}{}\n", kind, error.what());
  return code;
}

int run_action(const Action& action) {
  try {
    return action();
  } catch (const UsageError& error) {
    return say("", error, kExitUsage);
  } catch (const InputError& error) {
    return say("", error, kExitInput);
  } catch (const OutputError& error) {
    return say("", error, kExitOutput);
  } catch (const GuestError& error) {
    return say("", error, kExitGuest);
  } catch (const std::bad_alloc& error) {
    return say("out of memory: ", error, kExitOutput);
  }
}

}  // namespace

int run_program(int argc, char* argv[], const std::string& version) {
  CLI::App app(kAbout, "clipscope");
  app.set_version_flag("--version", version);
  app.formatter(std::make_shared<Help>());  // of its commands, too
  app.footer(kProgramFooter);
  app.require_subcommand(0, 1);  // `run bounds` asks an experiment, and no second command
  Action action;
  for (const auto add :
       {add_run_command, add_report_command, add_table_command, add_diff_command,
        add_compare_command, add_verify_command, add_clip_command, add_explain_command,
        add_bounds_command, add_camera_command, add_render_command, add_plan_command,
        add_sweep_command, add_hunt_command, add_merge_command, add_promote_command,
        add_audit_command, add_paper_command, add_list_command}) {
    add(app, action);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitOk : kExitUsage;
  }
  if (action) return run_action(action);
  fmt::print(stderr, "{}", app.help());
  return say("", UsageError("a subcommand is missing"), kExitUsage);
}

}  // namespace clipscope::experiments::commands
