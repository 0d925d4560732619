// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/process.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>

#include "experiments/guests/child.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

using End = ProcessResult::End;

ProcessResult run(const std::string& command, const std::string& input = "",
                  const ProcessLimits& limits = {},
                  const std::vector<std::string>& variables = {}) {
  return run_process(command, input, variables, "CLIPSCOPE_", limits);
}

TEST_CASE("process: a megabyte goes through while standard error is flooded") {
  const std::string input(1 << 20, 'x');
  const ProcessResult r =
      run("tee /dev/stderr", input, {.seconds = 20, .most_output = std::size_t{2} << 20});
  CHECK(r.succeeded());
  CHECK(r.output == input);
  CHECK(r.errors.size() == 4096);
}

TEST_CASE("process: who reads nothing of its input does no harm") {
  const ProcessResult r = run("echo done", std::string(1 << 20, 'x'));
  CHECK(r.succeeded());
  CHECK(r.output == "done\n");
}

TEST_CASE("process: exit codes and signals are told apart, those of a shell's commands, too") {
  CHECK(run("exit 3").code == 3);
  CHECK(run("exit 3").end == End::exited);
  for (const char* command : {"kill -SEGV $$", "sh -c 'kill -SEGV $$'; exit $?"}) {
    const ProcessResult r = run(command);
    CHECK(r.end == End::killed);
    CHECK(r.code == SIGSEGV);
  }
}

TEST_CASE("process: what does not end is ended in time, with all that it started") {
  const auto start = std::chrono::steady_clock::now();
  for (const char* command :
       {"sleep 100", "sleep 100 & sleep 100; exit 0", "exec >&- 2>&-; sleep 100"}) {
    CHECK(run(command, "", {.seconds = 0.1}).end == End::timed_out);
  }
  const auto passed = std::chrono::steady_clock::now() - start;
  CHECK(passed < std::chrono::seconds(20));
}

TEST_CASE("process: endless output is cut off") {
  CHECK(run("yes", "", {.most_output = 100000}).end == End::too_much_output);
}

TEST_CASE("process: it gets the variables given, and none of ours that are hidden") {
  setenv("CLIPSCOPE_OLD", "old", 1);
  const ProcessResult r =
      run("echo \"$CLIPSCOPE_NEW:$CLIPSCOPE_OLD:${HOME:+home}\"", "", {}, {"CLIPSCOPE_NEW=new"});
  unsetenv("CLIPSCOPE_OLD");
  CHECK(r.output == "new::home\n");
}

TEST_CASE("process: last words are the last lines, whatever their bytes") {
  CHECK(last_words(run("true").errors).empty());
  CHECK(last_words(run("printf 'a\\n\\n b \\nc\\n ~~^~~\\nd\\n' >&2").errors) == "b | c | d");
  CHECK_THAT(last_words(run("printf 'bad \\377 byte' >&2").errors),
             Catch::Contains("bad <0xFF> byte"));
}

}  // namespace
}  // namespace clipscope::experiments
