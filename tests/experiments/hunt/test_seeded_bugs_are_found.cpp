// SPDX-License-Identifier: GPL-3.0-or-later
//
// A hunt finds each seeded bug (reference/mutants.hpp) without the catalogue. The guests round each
// number once: what is farther off than that, or fails, is the bug.
#include <algorithm>

#include "experiments/guests/seeded.hpp"
#include "experiments/hunt/hunt.hpp"
#include "experiments/selection/select.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::hunt;

namespace {

// Whether there is a failure, or a value beyond what one rounding can do.
bool is_found(const Hunted& hunted, double largest_without_bug) {
  const bool fails =
      std::ranges::any_of(hunted.failing, [](const auto& c) { return c.has_value(); });
  return fails || (hunted.worst && hunted.worst->value > largest_without_bug);
}

bool is_found_by(const Contestant& contestant, std::uint64_t evaluations) {
  const auto found_by = [&](Measure measure, double largest_without_bug) {
    const HuntOptions options{.measure = measure, .evaluations = evaluations, .catalogue = false};
    return is_found(hunt::hunt(contestant, options), largest_without_bug);
  };
  return found_by(Measure::attribute, 0x1p-20) || found_by(Measure::ulp, 0.5);
}

}  // namespace

constexpr std::uint64_t kEvaluations = 2048;  // some hundredths of a second

TEST_CASE("hunt: each seeded bug is found without the catalogue") {
  for (const std::string_view name : seeded_names()) {
    CAPTURE(name);
    CHECK(is_found_by(find_contestant(name, "float"), kEvaluations));
  }
}

TEST_CASE("hunt: no bug is found in who rounds each number of the exact polygon once") {
  CHECK_FALSE(is_found_by(find_contestant("barycentric/correctly_rounded", "float"), kEvaluations));
}
