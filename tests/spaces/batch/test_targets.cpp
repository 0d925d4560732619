// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which code answers: the tests of SIMD would prove nothing if all targets were one.
#include <set>
#include <string>

#include "tests/catch.hpp"
#include "tests/spaces/batch/inputs.hpp"
#include "tests/spaces/batch/on_every_target.hpp"

namespace clipscope::batch::tests {
namespace {

using Names = std::set<std::string>;

// What this processor must be able to run, by the names that Highway gives.
Names expected_targets() {
#if defined(__x86_64__)
  Names names;
  __builtin_cpu_init();
  const bool sse4 = __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("pclmul");
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                    __builtin_cpu_supports("bmi2");
  const bool avx3 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                    __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  if (sse4) names.insert("SSE4");
  if (avx2) names.insert("AVX2");
  if (avx2 && avx3) names.insert("AVX3");
  return names;
#elif defined(__aarch64__)
  return {"NEON"};
#else
  return {};
#endif
}

Names targets_that_ran() {
  Names names;
  on_every_target([&] { names.insert(target_name()); });
  return names;
}

Output clipped(const Soup& soup, Build build) {
  Output out;
  clip(Method::correctly_rounded, {}, soup.array(), out, build);
  return out;
}

}  // namespace

TEST_CASE("batch: the tests run on every instruction set of this processor") {
  const Names ran = targets_that_ran();
  for (const std::string& name : expected_targets()) {
    INFO(name << " did not run");
    CHECK(ran.count(name) == 1);
  }
#if defined(__x86_64__)
  // What runs on any processor: without vectors, or with those of its baseline.
  CHECK(ran.count("plain") + ran.count("SSE2") == 1);
  CHECK(ran.size() == expected_targets().size() + 1);
#endif
}

TEST_CASE("batch: where a target has no vectors of doubles the plain version answers") {
  Random random(11);
  const Soup soup = make_soup(random, Numbers::near_volume, 4, 500);
  const Tally plain = clipped(soup, Build::plain).tally();
  REQUIRE(plain.plain > 250);
  std::size_t with_vectors = 0;
  on_every_target([&] {
    const Tally tally = clipped(soup, Build::simd).tally();
    const std::uint64_t in_simd = tally.one_plane + tally.planes;
    if (target_name() == "plain") {
      CHECK(tally.plain == plain.plain);
      CHECK(in_simd == 0);
    } else {
      CHECK(tally.plain < 25);
      CHECK(in_simd > 225);
      ++with_vectors;
    }
  });
  CHECK(with_vectors >= expected_targets().size());
}

}  // namespace clipscope::batch::tests
