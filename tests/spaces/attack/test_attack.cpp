// SPDX-License-Identifier: GPL-3.0-or-later
//
// The attack in its quick form: every kind of input, every form of the correctly rounded clipper,
// every bit.
#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include "tests/catch.hpp"
#include "tests/sampled.hpp"
#include "tests/spaces/attack/attack.hpp"
#include "tests/spaces/attack/integer_clip.hpp"

namespace clipscope::attack {
namespace {

constexpr std::uint64_t kSeed = 1;

void check(std::string_view name) {
  const auto kinds = all_kinds();
  const auto kind = std::ranges::find(kinds, name, &Kind::name);
  REQUIRE(kind != kinds.end());
  const std::vector<Contestant> all = contestants();
  const int batches = tests::sampled(80);
  const Attacked r = attack(*kind, kSeed, all, [=](int done) { return done < batches; });
  if (r.failure) FAIL(describe(shrunk(*r.failure, all)));
  CHECK(missing_facts(*kind, r.tally.facts) == "");
  CHECK(r.tally.floats > 10000);
}

}  // namespace

TEST_CASE("attack: subnormals: every bit is that of exact integers") { check("subnormals"); }
TEST_CASE("attack: exact ties: every bit is that of exact integers") { check("exact_ties"); }
TEST_CASE("attack: next to ties: every bit is that of exact integers") { check("next_to_ties"); }
TEST_CASE("attack: 1/w at overflow: every bit is that of exact integers") {
  check("inverse_w_at_overflow");
}
TEST_CASE("attack: underflowing quotients: every bit is that of exact integers") {
  check("underflowing_quotients");
}
TEST_CASE("attack: ulps from planes: every bit is that of exact integers") {
  check("ulps_from_planes");
}
TEST_CASE("attack: through the eye: every bit is that of exact integers") {
  check("through_the_eye");
}
TEST_CASE("attack: slivers: every bit is that of exact integers") { check("slivers"); }
TEST_CASE("attack: signed zeros: every bit is that of exact integers") { check("signed_zeros"); }
TEST_CASE("attack: odd frusta: every bit is that of exact integers") { check("odd_frusta"); }
TEST_CASE("attack: clip distances: every bit is that of exact integers") {
  check("clip_distances");
}
TEST_CASE("attack: depth clamp: every bit is that of exact integers") { check("depth_clamp"); }
TEST_CASE("attack: extents to 1e38: every bit is that of exact integers") { check("extents"); }
TEST_CASE("attack: degenerate corners: every bit is that of exact integers") {
  check("degenerate_corners");
}
TEST_CASE("attack: cancelling coordinates: every bit is that of exact integers") {
  check("cancelling_coordinates");
}
TEST_CASE("attack: attributes at both extremes: every bit is that of exact integers") {
  check("extreme_attributes");
}

TEST_CASE("attack: every contract, layout and build takes part") {
  std::set<std::string> names;
  for (const Contestant& contestant : contestants()) names.insert(contestant.name);
  CHECK(names.size() == contestants().size());
  for (const char* name :
       {"clip space to NDC", "view space to NDC", "stage", "batch, copied, plain",
        "batch, by number, plain", "batch, indexed, plain", "batch, full, plain"}) {
    CHECK(names.count(name) == 1);
  }
}

TEST_CASE("attack: a wrong bit is found, a wrong zero and a vertex too many as well") {
  const Kind& kind = all_kinds()[0];
  Dice dice(kSeed);
  const Batch batch = kind.make(dice);
  const std::vector<Contestant> right = contestants();
  const auto honest = std::ranges::find_if(
      right, [&](const Contestant& c) { return c.contract == Contract::ndc && c.takes(batch); });
  REQUIRE(honest != right.end());
  const auto is_found = [&](auto&& spoil) {
    Contestant wrong = *honest;
    wrong.clip = [&](const Batch& b) {
      Polygons r = honest->clip(b);
      for (std::vector<float>& polygon : r) {
        if (!polygon.empty()) spoil(polygon);
      }
      return r;
    };
    Tally tally;
    return judge(batch, {&wrong, 1}, tally).has_value();
  };
  CHECK(!is_found([](std::vector<float>&) {}));
  CHECK(is_found([](std::vector<float>& p) { p[1] = std::nextafter(p[1], 2.0f); }));
  CHECK(is_found([](std::vector<float>& p) { std::ranges::replace(p, 0.0f, -0.0f); }));
  CHECK(is_found([&](std::vector<float>& p) {
    p.insert(p.end(), p.begin(), p.begin() + 4 + batch.attributes);
  }));
  CHECK(is_found([](std::vector<float>& p) { p.clear(); }));
}

TEST_CASE("attack: the input is the same for a seed, whatever the compiler") {
  std::uint64_t sum = 0xcbf29ce484222325;
  for (const Kind& kind : all_kinds()) {
    Dice dice(kSeed);
    for (int i = 0; i < 20; ++i) {
      for (const float x : kind.make(dice).floats) {
        sum = (sum ^ std::bit_cast<std::uint32_t>(x)) * 0x100000001b3;
      }
    }
  }
  CHECK(sum == 0xe48ae54d5d983f13);
}

TEST_CASE("attack: a failure is shrunk to a triangle of small numbers that fails as well") {
  // A clipper that loses what lies on the right plane.
  Contestant wrong{"wrong", Contract::ndc, takes_clip, [](const Batch& b) {
                     Polygons r;
                     Facts unused;
                     for (std::size_t t = 0; t < b.triangles(); ++t) {
                       r.push_back(exact_answer(b, t, unused).ndc);
                       const auto on_plane = [&](std::size_t i) { return r[t][i] == 1; };
                       for (std::size_t i = 0; i < r[t].size(); i += 4) {
                         if (on_plane(i)) r[t].clear();
                       }
                     }
                     return r;
                   }};
  const Batch batch = {
      {}, {}, 0, {0.3f, 0.1f, 0.7f, 1.1f, 2.3f, 0.4f, 0.1f, 0.9f, 0.1f, 0.6f, 0, 1}};
  Tally tally;
  const auto failure = judge(batch, {&wrong, 1}, tally);
  REQUIRE(failure.has_value());
  const Failure small = shrunk(*failure, {&wrong, 1});
  CHECK(judge(small.batch, {&wrong, 1}, tally).has_value());
  const auto whole =
      std::ranges::count_if(small.batch.floats, [](float x) { return x == std::round(x); });
  CHECK(whole >= 10);
  CHECK(describe(small).find("vertex 0x0p+0") != std::string::npos);
}

}  // namespace clipscope::attack
