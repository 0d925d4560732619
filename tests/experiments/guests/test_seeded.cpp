// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/seeded.hpp"

#include <algorithm>

#include "experiments/judge/compare.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

const Contestant* find(std::string_view clipper, const Format& format) {
  const auto found = std::ranges::find_if(all_contestants(), [&](const Contestant& c) {
    return c.clipper == clipper && c.format == &format;
  });
  return found == all_contestants().end() ? nullptr : &*found;
}

// Reaches beyond left, the second triangle beyond right.
const std::vector<double> kBeyondLeftAndRight = {-3, 0, 0, 2, .5, 0, 0, 1, 0, .5, 0, 1,
                                                 3,  0, 0, 2, .5, 0, 0, 1, 0, .5, 0, 1};

Batch seeded_batch(const std::vector<double>& numbers, int attributes = 0) {
  return {.space = Space::clip, .attributes = attributes, .numbers = std::span(numbers)};
}

std::vector<Outcome> outcomes(const Contestant& contestant, const Batch& batch) {
  std::vector<Outcome> all;
  for (const Comparison& c :
       compare(clip(contestant, batch), truth_polygons(reference::truth_of(batch), batch))) {
    all.push_back(c.outcome);
  }
  return all;
}

}  // namespace

TEST_CASE("seeded: a bug is a guest once it was asked for by name, once in each scalar") {
  CHECK(find("seeded/skips_left", kFormat<float>) == nullptr);
  add_if_seeded("seeded/skips_left", "float");
  add_if_seeded("seeded/skips_left", "float");
  add_if_seeded("seeded/skips_left", "exact");
  const Contestant* const guest = find("seeded/skips_left", kFormat<float>);
  REQUIRE(guest != nullptr);
  CHECK(guest->is_guest);
  CHECK(options_of(*guest) == "--clipper seeded/skips_left --scalar float");
  CHECK(find("seeded/skips_left", kFormat<Exact>) != nullptr);
  CHECK(find("seeded/skips_left", kFormat<double>) == nullptr);
}

TEST_CASE("seeded: no guest comes of another name, or of a scalar without one") {
  const std::size_t before = all_contestants().size();
  add_if_seeded("seeded/none", "float");
  add_if_seeded("seeded/*", "float");
  add_if_seeded("skips_left", "float");
  add_if_seeded("seeded/skips_top", "double_double");
  CHECK(all_contestants().size() == before);
}

TEST_CASE("seeded: a bug shows where it is, and elsewhere each number is the nearest") {
  for (const char* scalar : {"float", "double", "exact"}) {
    add_if_seeded("seeded/skips_right", scalar);
  }
  const Batch batch = seeded_batch(kBeyondLeftAndRight);
  for (const Format* format : {&kFormat<float>, &kFormat<double>, &kFormat<Exact>}) {
    const Contestant* const guest = find("seeded/skips_right", *format);
    REQUIRE(guest != nullptr);
    const std::vector<Outcome> found = outcomes(*guest, batch);
    CHECK(found[0] == Outcome::exact);
    CHECK(found[1] == Outcome::vertex_count);
  }
}

TEST_CASE("seeded: planes of the user clip") {
  add_if_seeded("seeded/skips_left", "exact");
  Batch batch = seeded_batch(kBeyondLeftAndRight);
  batch.planes = {{0, 1, 0, -0.25}};  // y >= w / 4
  const Answers answers = clip(*find("seeded/skips_left", kFormat<Exact>), batch);
  REQUIRE(answers[1].size() >= 3);
  for (const VertexView& v : answers[1]) CHECK(v.position(1).value >= 0.25);
}

TEST_CASE("seeded: every bug has its name, and no other") {
  const std::vector<std::string_view> names = seeded_names();
  CHECK(names.size() == 26);
  CHECK(names.front() == "seeded/epsilon_in_denominator");
  CHECK(names.back() == "seeded/skips_far");
}
