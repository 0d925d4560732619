// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whatever a plug-in does wrong is an outcome of the primitive that it does it to, and the others
// are answered.
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "experiments/guests/plugin.hpp"
#include "experiments/machine/errors.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/guests/marked_batch.hpp"

namespace clipscope::experiments {
namespace {

// Of a batch of 100 triangles the one whose number is given is marked, and no other fails.
Failure only_failure(const char* behaviour, std::size_t marked = 37) {
  const Contestant& guest = misbehaving_guest(behaviour);
  const MarkedBatch triangles(100, marked);
  const Answers answers = clip(guest, triangles.batch());
  REQUIRE(answers.size() == 100);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    CAPTURE(behaviour, i);
    if (i == marked) {
      REQUIRE(answers[i].failure() != nullptr);
      continue;
    }
    REQUIRE(answers[i].failure() == nullptr);
    REQUIRE(answers[i].size() == 3);
    REQUIRE(answers[i][0][0].value == static_cast<double>(i) / 128);
  }
  return *answers[marked].failure();
}

std::string why_not(const std::string& library, const char* behaviour = "none") {
  setenv("CLIPSCOPE_MISBEHAVIOUR", behaviour, 1);
  try {
    add_plugin(library);
  } catch (const GuestError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("plug-in: one that ends its process is found with its primitive") {
  using Kind = Failure::Kind;
  const auto [behaviour, reason] = GENERATE(table<const char*, const char*>(
      {{"crash", "was ended by SIGSEGV"},
       {"abort", "was ended by SIGABRT"},
       {"last_words", "was ended by SIGABRT, printing: mine: an invariant is broken"},
       {"last_bytes", "was ended by SIGABRT, printing: bad <0xFF> byte"},
       {"exit", "ended its process with exit code 3"},
       {"stack", "was ended by SIGSEGV"},
       {"write_beyond", "wrote beyond the end of its output"},
       {"write_beyond_ends", "wrote beyond the end of the ends of its output"},
       {"write_input", "wrote into its input"}}));
  const Failure failure = only_failure(behaviour);
  CHECK(failure.kind == Kind::crashed);
  CHECK(failure.reason == reason);
}

TEST_CASE("plug-in: one that reads beyond its input is found where the input ends") {
  const Failure failure = only_failure("read_beyond", 99);
  CHECK(failure.kind == Failure::Kind::crashed);
  CHECK(failure.reason == "read beyond the end of its input");
}

TEST_CASE("plug-in: one that leaves no answer is found with its primitive") {
  const auto [behaviour, reason] =
      GENERATE(table<const char*, const char*>({{"error", "returns error 7"},
                                                {"write_before", "wrote in front of its output"},
                                                {"too_many", "leaves a polygon of 30 vertices"}}));
  const Failure failure = only_failure(behaviour);
  CHECK(failure.kind == Failure::Kind::malformed);
  CHECK(failure.reason == reason);
}

TEST_CASE("plug-in: ends that descend are malformed") {
  const Failure failure = only_failure("descend", 1);
  CHECK(failure.kind == Failure::Kind::malformed);
  CHECK(contains(failure.reason, "leaves ends that descend at primitive 1"));
}

TEST_CASE("plug-in: one that loops for ever is found with its primitive, after the time it has") {
  const Failure failure = only_failure("loop");
  CHECK(failure.kind == Failure::Kind::timed_out);
  CHECK(failure.reason == "does not end within 0.5 s");
}

TEST_CASE(
    "plug-in: a crash that takes another primitive before is blamed on the one that ends it") {
  const Failure failure = only_failure("crash_after_another");
  CHECK(failure.kind == Failure::Kind::crashed);
  CHECK(contains(failure.reason, "before it, not alone"));
}

TEST_CASE("plug-in: NaN stays in the answer, to be judged") {
  const MarkedBatch triangles(5, 2);
  const Answers answers = clip(misbehaving_guest("nan"), triangles.batch());
  REQUIRE(answers[2].failure() == nullptr);
  CHECK(std::isnan(answers[2][0][0].value));
}

TEST_CASE(
    "plug-in: one that writes to its output after it has returned is found, and harms nobody") {
  const MarkedBatch triangles(5, 0);
  const Batch batch = triangles.batch();
  const auto runner = misbehaving_guest("writes_later").prepare(std::span(&batch, 1));
  runner->clip(0, 0, 5);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  const Answers answers = runner->answers();
  REQUIRE(answers.size() == 5);
  REQUIRE(answers[0].failure() != nullptr);
  CHECK(answers[0].failure()->reason == "changes its answer after it was given");
}

TEST_CASE("plug-in: many failures are found each, and the answers between them") {
  const Contestant& guest = misbehaving_guest("abort");
  MarkedBatch triangles(300, 0);
  for (std::size_t i = 0; i < 300; i += 7) triangles.mark(i);
  const Answers answers = clip(guest, triangles.batch());
  for (std::size_t i = 0; i < 300; ++i) {
    CAPTURE(i);
    CHECK((answers[i].failure() != nullptr) == (i % 7 == 0));
  }
}

TEST_CASE("plug-in: batches larger than a block are answered, wherever they fail") {
  const MarkedBatch triangles(10000, 8191);
  const Answers answers = clip(misbehaving_guest("abort"), triangles.batch());
  REQUIRE(answers.size() == 10000);
  CHECK(answers[8191].failure() != nullptr);
  CHECK(answers[8190].size() == 3);
  CHECK(answers[9999][0][0].value == 9999.0 / 128);
}

TEST_CASE("plug-in: one that can't be asked says why") {
  CHECK(contains(why_not("no/such/library.so"), "there is no such file"));
  CHECK(contains(why_not(CLIPSCOPE_NO_PLUGIN), "exports no clipscope_plugin_entry"));
  CHECK(contains(why_not(__FILE__), "invalid ELF header"));
  const auto [behaviour, reason] = GENERATE(table<const char*, const char*>(
      {{"crash_at_once", "while it is loaded, it was ended by SIGABRT"},
       {"other_version", "speaks version 99 of the interface; expected version 1"},
       {"no_version", "does not speak version 1 of the interface"},
       {"too_small", "its struct_size is 8; expected"},
       {"bad_name", "its name is 'Not A Name'; expected"},
       {"many_attributes", "its most_attributes are 33; expected 32 at most"},
       {"no_primitive", "name no primitive"},
       {"unknown_bits", "have bits that version 1 of the interface lacks"}}));
  const std::string error = why_not(CLIPSCOPE_MISBEHAVING, behaviour);
  CAPTURE(behaviour, error);
  CHECK(contains(error, reason));
  CHECK(contains(error, CLIPSCOPE_MISBEHAVING));
}

TEST_CASE("plug-in: the same name twice is refused") {
  misbehaving_guest("twice");
  CHECK(contains(why_not(CLIPSCOPE_MISBEHAVING, "twice"), "there is a clipper called test/twice"));
}

}  // namespace clipscope::experiments
