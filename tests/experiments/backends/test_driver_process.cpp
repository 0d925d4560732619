// SPDX-License-Identifier: GPL-3.0-or-later
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "experiments/backends/driver_process.hpp"
#include "experiments/guests/child.hpp"
#include "experiments/machine/errors.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

using Kind = DrawFailure::Kind;

KnownDriver misbehaving(const std::string& greeting = "") {
  return {.name = "mine",
          .host = "clipscope_misbehaving_host",
          .arguments = {greeting},
          .renderer = "misbehaving",
          .package = "mine-dri"};
}

DrawCall call_named(const std::string& name) {
  DrawCall call;
  call.name = name;
  return call;
}

DrawFailure failure_of(DriverProcess& driver, const std::string& name) {
  const Drawn drawn = driver.draw(call_named(name));
  const auto* failure = std::get_if<DrawFailure>(&drawn);
  if (!failure) FAIL(name << " has drawn");
  return *failure;
}

bool draws(DriverProcess& driver, const std::string& name = "") {
  const Drawn drawn = driver.draw(call_named(name));
  const auto* pixels = std::get_if<Pixels>(&drawn);
  return pixels && pixels->of(Quantity::covered) == std::vector<float>(32 * 32, 1.0f);
}

std::string error_of(const KnownDriver& driver) {
  try {
    DriverProcess(driver, 1);
  } catch (const GuestError& error) {
    return error.what();
  }
  return {};
}

TEST_CASE("driver process: however a draw call ends, it is told, and the next one is served") {
  struct {
    const char* name;
    DrawFailure failure;
  } const kEnds[] = {
      {"crash",
       {Kind::crashed, "was ended by SIGABRT (standard error: mine: an invariant is broken)"}},
      {"end", {Kind::crashed, "ended with exit code 3"}},
      {"hang", {Kind::timed_out, "does not answer within 0.5 s"}},
      {"nonsense", {Kind::crashed, "answered with bytes that are no answer"}},
      {"too_long", {Kind::crashed, "answered with bytes that are no answer"}},
      {"small", {Kind::crashed, "answered with bytes that are no answer"}},
      {"half", {Kind::crashed, "answered with bytes that are no answer"}},
      {"refuse", {Kind::refused, "GL_OUT_OF_MEMORY"}}};
  DriverProcess driver(misbehaving(), 0.5);
  for (const auto& end : kEnds) {
    CAPTURE(end.name);
    const DrawFailure failure = failure_of(driver, end.name);
    CHECK(failure.kind == end.failure.kind);
    CHECK(failure.reason == end.failure.reason);
    CHECK(draws(driver));
  }
}

TEST_CASE("driver process: a driver that floods what it prints is still heard") {
  DriverProcess driver(misbehaving(), 20);
  CHECK(draws(driver, "print"));
}

TEST_CASE("driver process: what the driver says that it can't, it is not asked") {
  DriverProcess driver(misbehaving(), 20);
  DrawCall call;
  call.volume.depth_clamp = true;
  CHECK(driver.draw(call) == Drawn(DrawFailure{Kind::unable, "has no depth clamp"}));
}

TEST_CASE("driver process: a large draw call reaches a host that is slow to read") {
  DriverProcess driver(misbehaving(), 20);
  DrawCall call;
  call.vertices.resize(100'000);
  CHECK(std::holds_alternative<Pixels>(driver.draw(call)));
}

TEST_CASE("driver process: who is not there is refused with the reason and the package") {
  CHECK(error_of(misbehaving("none")) ==
        "mine: no display can be opened (Debian package: mine-dri)");
  CHECK(error_of(misbehaving("end")) ==
        "mine: clipscope_misbehaving_host ended with exit code 4 (Debian package: mine-dri)");
  CHECK_THAT(error_of(misbehaving("nonsense")), Catch::Contains("bytes that are no answer"));
  KnownDriver other = misbehaving();
  other.renderer = "softpipe";
  CHECK_THAT(error_of(other),
             Catch::Contains("another driver answers in its place: \"misbehaving\""));
  KnownDriver unbuilt = misbehaving();
  unbuilt.host = "clipscope_draw_nothing";
  unbuilt.built_with = "libnothing-dev";
  CHECK_THAT(error_of(unbuilt), Catch::StartsWith("mine: clipscope_draw_nothing is missing") &&
                                    Catch::Contains("libnothing-dev"));
  KnownDriver missing = misbehaving();
  missing.missing = "there is no manifest";
  CHECK(error_of(missing) == "mine: there is no manifest");
}

// The number of the process that the driver's host has.
pid_t host_of(const DriverProcess& driver) { return std::stoi(driver.info().version); }

TEST_CASE("driver process: the host ends with its owner") {
  pid_t host = 0;
  {
    const DriverProcess driver(misbehaving(), 20);
    host = host_of(driver);
    CHECK(kill(host, 0) == 0);
  }
  CHECK(kill(host, 0) == -1);
}

TEST_CASE("driver process: a host that hangs ends with a program that is killed") {
  prctl(PR_SET_CHILD_SUBREAPER, 1);  // so that the orphan can be waited for
  Pipe pipe = open_pipe();
  const pid_t program = fork();
  if (program == 0) {
    DriverProcess driver(misbehaving(), 1000);
    const pid_t host = host_of(driver);
    if (write(pipe.write_end.number(), &host, sizeof host) != sizeof host) _exit(1);
    driver.draw(call_named("hang"));
    _exit(0);
  }
  pid_t host = 0;
  REQUIRE(read(pipe.read_end.number(), &host, sizeof host) == sizeof host);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // it hangs most likely
  kill(program, SIGKILL);
  CHECK(waitpid(program, nullptr, 0) == program);
  CHECK(ends_before(host, std::chrono::steady_clock::now() + std::chrono::seconds(20)));
  CHECK(waitpid(host, nullptr, 0) == host);
  prctl(PR_SET_CHILD_SUBREAPER, 0);
}

}  // namespace
}  // namespace clipscope::experiments
