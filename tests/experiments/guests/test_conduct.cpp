// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an answer must not depend on is found where it does.
#include <string>
#include <vector>

#include "experiments/guests/conduct.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/guests/marked_batch.hpp"

namespace clipscope::experiments {
namespace {

std::vector<Misconduct> conduct_of(const Contestant& contestant, const Batch& batch) {
  return conduct(contestant, batch, clip(contestant, batch));
}

// What is found of 50 triangles of which the one with number 20 is marked: nothing, or that one.
std::string conduct_of(const char* behaviour) {
  const MarkedBatch triangles(50, 20);
  const std::vector<Misconduct> found = conduct_of(misbehaving_guest(behaviour), triangles.batch());
  if (found.empty()) return "";
  CHECK(found.size() == 1);
  CHECK(found.front().primitive == 20);
  return found.front().reason;
}

}  // namespace

TEST_CASE("conduct: who answers alike always is found innocent") {
  CHECK(conduct_of("none").empty());
  const MarkedBatch triangles(50, 20);
  CHECK(conduct_of(find_contestant("textbook", "float"), triangles.batch()).empty());
}

TEST_CASE("conduct: an answer that depends on earlier calls is found") {
  CHECK(conduct_of("counts") == "answers otherwise when it is asked again");
}

TEST_CASE("conduct: an answer that depends on the primitive before is found") {
  CHECK(conduct_of("remembers") == "answers otherwise in another order");
}

TEST_CASE("conduct: numbers that are not written are found") {
  CHECK(conduct_of("unwritten") == "leaves numbers as they were before, in its output");
}

TEST_CASE("conduct: who crashes each time in the same way is not blamed for that") {
  CHECK(conduct_of("abort").empty());
}

TEST_CASE("conduct: a race between two threads is found") {
  // Marked triangles only, each of another size: what one thread wrote the other one reads.
  std::vector<float> numbers;
  for (int i = 0; i < 200; ++i) {
    const auto y = static_cast<float>(i);
    numbers.insert(numbers.end(), {kMarker, y, 0, 1, 1, 0, 0, 1, 0, 1, 0, 1});
  }
  const Batch batch{.space = Space::clip, .numbers = std::span<const float>(numbers)};
  const auto found = conduct_of(misbehaving_guest("races"), batch);
  REQUIRE(!found.empty());
  CHECK(found.front().reason == "answers otherwise in two threads at once");
}

}  // namespace clipscope::experiments
