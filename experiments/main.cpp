// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope: where should a triangle be clipped?
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "experiments/commands/commands.hpp"
#include "experiments/errors.hpp"
#include "experiments/measure/build_info.hpp"

namespace {

using namespace clipscope::experiments;

constexpr const char* kFooter = R"(Examples:
  clipscope run                             all default experiments on the built-in scenes
  clipscope run --resume                    what an interrupted run has left undone
  clipscope table accuracy --run results    a table of a run
  clipscope diff results_a results_b        which figures moved
  clipscope compare --scene teapot          every clipper in float and double, one table
  clipscope compare --scene bunny.obj --clipper 'homogeneous/*'
  clipscope verify --clipper cvv/near_first --scalar float
  clipscope render --scene floor --clipper cvv/naive --against exact --out floor.png
  echo '0 0 -2  3 0 -2  0 1 -2' | clipscope clip --space view --perspective 90,1,1,10

Exit codes: 0 done; 1 a promise is broken (verify), a figure moved (diff); 2 wrong option or name;
3 bad input file or line; 4 results can't be written.)";

int report(const char* kind, const std::exception& error, int code) {
  fmt::print(stderr, "clipscope: {}{}\n", kind, error.what());
  return code;
}

int run_action(const Action& action) {
  try {
    return action();
  } catch (const UsageError& error) {
    return report("", error, kExitUsage);
  } catch (const InputError& error) {
    return report("", error, kExitInput);
  } catch (const OutputError& error) {
    return report("", error, kExitOutput);
  } catch (const std::bad_alloc& error) {
    return report("out of memory: ", error, kExitOutput);
  }
}

}  // namespace

int main(int argc, char* argv[]) {
  CLI::App app(
      "clipscope: where should a triangle be clipped? Clippers in view space, homogeneous "
      "clip space and the canonical view volume, judged by an exact reference.",
      "clipscope");
  app.set_version_flag("--version", fmt::format("clipscope {} ({})", kVersion, kCommit));
  app.footer(kFooter);
  Action action;
  add_run_command(app, action);
  add_report_command(app, action);
  add_table_command(app, action);
  add_diff_command(app, action);
  add_compare_command(app, action);
  add_verify_command(app, action);
  add_clip_command(app, action);
  add_explain_command(app, action);
  add_render_command(app, action);
  add_plan_command(app, action);
  add_sweep_command(app, action);
  add_paper_command(app, action);
  add_list_command(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitOk : kExitUsage;
  }
  if (!action) {
    fmt::print(stderr, "{}", app.help());
    return report("", UsageError("a subcommand is missing"), kExitUsage);
  }
  return run_action(action);
}
