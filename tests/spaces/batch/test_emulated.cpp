// SPDX-License-Identifier: GPL-3.0-or-later
//
// The batch clippers compiled for no instruction set, as for a processor that Highway has none for.
#include <optional>

#include "tests/catch.hpp"
#include "tests/spaces/batch/inputs.hpp"

namespace clipscope::batch::tests {

TEST_CASE("batch: compiled for Highway's emulated target the plain version answers") {
  CHECK(target_name() == "plain");
  Random random(12);
  for (const Numbers numbers : kNumbers) {
    const Soup soup = make_soup(random, numbers, 4, 500);
    for (const Method method : kStageMethods) {
      INFO(name(method) << ", numbers " << static_cast<int>(numbers));
      Output plain, emulated;
      clip(method, {}, soup.mesh(), plain, Build::plain);
      clip(method, {}, soup.mesh(), emulated);
      CHECK(first_difference(plain, emulated) == std::nullopt);
      CHECK(emulated.tally().plain == plain.tally().plain);
    }
  }
}

}  // namespace clipscope::batch::tests
