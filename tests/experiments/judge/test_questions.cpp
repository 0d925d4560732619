// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each question must have a guest that breaks it and is found out, and one that keeps it.
#include <cmath>
#include <limits>
#include <random>

#include "experiments/judge/questions.hpp"
#include "experiments/scenes/scene.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/judge/guest.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

using Triangles = std::vector<ClipTriangle<float, 2>>;

// Triangles of all sizes about the volume, w > 0.
Triangles random_triangles(std::size_t count) {
  std::mt19937_64 random(7);
  const auto number = [&] {
    return static_cast<float>(static_cast<int>(random() % 4001) - 2000) / 700.0f;
  };
  Triangles triangles(count);
  for (auto& triangle : triangles) {
    for (auto& v : triangle) {
      for (int i = 0; i < 4; ++i) v.position[i] = number();
      v.position[3] = std::abs(v.position[3]) + 0.125f;
      v.attributes[0] = number();
      v.attributes[1] = number();
    }
  }
  return triangles;
}

std::vector<Examined> examined(const Contestant& contestant, const Triangles& triangles,
                               const Questions& asked) {
  return examine(contestant, batch_of(ClipVolume{}, std::span(triangles)), asked);
}

struct Count {
  std::size_t judged = 0, broken = 0;
  std::string reason;
  double excess = 0;
};

// What came of one question on 400 triangles, asked with all others.
Count count(const Contestant& contestant, Question question, const Questions& asked) {
  Count count;
  for (const Examined& e : examined(contestant, random_triangles(400), asked)) {
    count.judged += e.judged.contains(question);
    const BrokenPromise* violation = e.violation(question);
    if (violation == nullptr) continue;
    if (count.broken++ == 0) count.reason = violation->reason;
    count.excess = std::max(count.excess, violation->excess);
  }
  return count;
}

const Spoil kHonest = [](const GuestCall&, Numbers&) {};
const char* const kChain = "homogeneous/sutherland_hodgman";

// The question breaks for the guest and holds for the honest one.
Count broken(const Contestant& guest, Question question, const char* honest = kChain) {
  const Count kept = count(guest_like(honest, kHonest), question, Questions::all());
  CHECK(kept.judged > 50);
  CHECK(kept.broken == 0);
  const Count alone = count(guest, question, {question});
  const Count all = count(guest, question, Questions::all());
  CHECK(alone.broken == all.broken);
  CHECK(all.broken > 0);
  CHECK(all.excess > 1);
  return all;
}

}  // namespace

TEST_CASE("questions: a NaN is not total, and nothing else hides it") {
  const Contestant guest = guest_like(kChain, [](const GuestCall& call, Numbers& polygon) {
    if (call.primitive % 7 == 0 && !polygon.empty()) polygon[0][0] = std::nan("");
  });
  CHECK(broken(guest, Question::total).reason == "not total: a coordinate is not finite");
}

TEST_CASE("questions: a crash is not total, and is blamed for nothing else") {
  const Triangles triangles = random_triangles(20);
  const auto is_bad = [&](const Batch& batch, std::size_t t) {
    return batch.number(3 * t * batch.stride()) == double{triangles[5][0].position[0]};
  };
  // Beside the bad one, all others get something else when they are asked again.
  const Spoil spoil = [&](const GuestCall& call, Numbers& polygon) {
    for (std::size_t t = 0; call.call > 0 && t < call.batch.size(); ++t) {
      if (is_bad(call.batch, t)) polygon.clear();
    }
  };
  const Contestant guest = guest_like(
      kChain, spoil, [&](const GuestCall& call) { return is_bad(call.batch, call.primitive); });
  const auto found = examined(guest, triangles, Questions::all());
  REQUIRE(found[5].violations.size() == 1);
  CHECK(found[5].violations[0].question == Question::total);
  CHECK(found[5].violations[0].reason == "the process ended by signal 11");
  CHECK(found[5].judged == Questions{Question::total});
  for (const std::size_t other : {std::size_t{4}, std::size_t{6}}) {
    CHECK(found[other].judged.contains(Question::covers));
    CHECK(found[other].violation(Question::steady) == nullptr);
    CHECK(found[other].violation(Question::total) == nullptr);
  }
}

TEST_CASE("questions: a crash on a triangle that is rotated alone says so") {
  const Contestant guest = guest_like(kChain, kHonest, [](const GuestCall& call) {
    return call.call > 0 && call.batch.size() > 20 && call.primitive == 3;
  });
  const auto found = examined(guest, random_triangles(20), {Question::rotation});
  REQUIRE(found[3].violation(Question::total) != nullptr);
  CHECK(found[3].violation(Question::total)->reason ==
        "asked with its second vertex first: the process ended by signal 11");
}

TEST_CASE("questions: an ulp beyond 1 is not confined") {
  const Contestant guest = guest_like("correctly_rounded", [](const GuestCall&, Numbers& polygon) {
    for (auto& v : polygon) {
      if (v[0] == 1) v[0] = 1 + 0x1p-23;
    }
  });
  CHECK(broken(guest, Question::confined, "correctly_rounded").reason ==
        "not confined: a coordinate is 1.19e-07 beyond its bound in NDC");
}

TEST_CASE("questions: what is drawn outside the volume is not contained") {
  const Contestant guest = guest_like(kChain, [](const GuestCall&, Numbers& polygon) {
    for (auto& v : polygon) v[0] *= 1.01;
  });
  const Count found = broken(guest, Question::contained);
  CHECK(std::isfinite(found.excess));
}

TEST_CASE("questions: a vertex that is left out is not covered") {
  const Contestant guest = guest_like(kChain, [](const GuestCall&, Numbers& polygon) {
    if (polygon.size() > 3) polygon.pop_back();
  });
  CHECK(broken(guest, Question::covers).reason.starts_with("a visible point was not drawn"));
  CHECK(count(guest, Question::contained, Questions::all()).broken == 0);
}

TEST_CASE("questions: a guest may leave out what has no area on screen, and nothing else") {
  const Contestant guest = guest_like(kChain, [](const GuestCall&, Numbers& p) { p.clear(); });
  const auto is_broken = [&](float y) {
    ClipTriangle<float, 1> triangle;
    const float positions[3][4] = {{0, 0, 0, 1}, {0.5f, 0, 0, 1}, {0.25f, y, 0.5f, 1}};
    for (std::size_t i = 0; i < 3; ++i) {
      for (int c = 0; c < 4; ++c) triangle[i].position[c] = positions[i][c];
      triangle[i].attributes[0] = 0;
    }
    const std::span<const ClipTriangle<float, 1>> triangles(&triangle, 1);
    const Batch batch = batch_of(ClipVolume{}, triangles);
    return examine(guest, batch, {Question::covers})[0].violation(Question::covers) != nullptr;
  };
  CHECK_FALSE(is_broken(0));
  CHECK(is_broken(0.25f));
}

TEST_CASE("questions: a polygon that is turned over has the wrong winding, and covers all") {
  const Contestant guest =
      guest_like(kChain, [](const GuestCall&, Numbers& polygon) { std::ranges::reverse(polygon); });
  CHECK(broken(guest, Question::winding).reason == "the winding is reversed");
  CHECK(count(guest, Question::covers, Questions::all()).broken == 0);
}

TEST_CASE("questions: a cut that depends on the edge's direction cracks") {
  CHECK(broken(guest_like("textbook", kHonest), Question::watertight)
            .reason.starts_with("not watertight: a neighbour has other"));
}

TEST_CASE("questions: a guest without attributes is judged on its edges, too") {
  std::vector<double> numbers;
  for (const auto& triangle : random_triangles(100)) {
    for (const auto& v : triangle) {
      for (int i = 0; i < 4; ++i) numbers.push_back(v.position[i]);
    }
  }
  const Batch batch{.space = Space::clip, .numbers = std::span<const double>(numbers)};
  std::size_t cracks = 0, judged = 0;
  for (const char* clipper : {"textbook", kChain}) {
    for (const Examined& e : examine(guest_like(clipper, kHonest), batch, {Question::watertight})) {
      judged += e.judged.contains(Question::watertight);
      cracks += !e.violations.empty() && clipper != kChain;
      if (clipper == kChain) CHECK(e.violations.empty());
    }
  }
  CHECK(judged > 40);
  CHECK(cracks > 0);
}

TEST_CASE("questions: who starts with the third vertex answers other bits when rotated") {
  const Contestant guest = guest_like(kChain, [](const GuestCall& call, Numbers& polygon) {
    const double x = call.batch.number(call.primitive * 3 * call.batch.stride());
    if (x > 0 && !polygon.empty()) polygon[0][2] = std::nextafter(float(polygon[0][2]), 2.0f);
  });
  CHECK(broken(guest, Question::rotation).reason == "another vertex first gives other bits");
}

TEST_CASE("questions: a w-plane at a fixed epsilon depends on scale") {
  const Contestant guest = guest_like(kChain, [](const GuestCall& call, Numbers& polygon) {
    if (std::abs(call.batch.number(call.primitive * 3 * call.batch.stride() + 3)) > 100) {
      polygon.clear();
    }
  });
  CHECK(broken(guest, Question::scale).reason == "scaled by 2^8 it gives other bits");
}

TEST_CASE("questions: a mean that changes a constant is found") {
  const Contestant guest = guest_like(kChain, [](const GuestCall&, Numbers& polygon) {
    for (auto& v : polygon) v[5] = std::nextafter(float(v[5]), 0.0f);
  });
  CHECK(
      broken(guest, Question::constants).reason.starts_with("not constant: an attribute that is"));
}

TEST_CASE("questions: two ulps off is not faithful, one ulp off is, and not correctly rounded") {
  const auto off_by = [](int ulps) {
    return guest_like("correctly_rounded", [ulps](const GuestCall&, Numbers& polygon) {
      for (auto& v : polygon) {
        for (int i = 0; i < ulps; ++i) v[3] = std::nextafter(float(v[3]), 1e9f);
      }
    });
  };
  CHECK(broken(off_by(2), Question::faithful, "correctly_rounded").excess > 1);
  CHECK(broken(off_by(1), Question::correctly_rounded, "correctly_rounded")
            .reason.starts_with("not correctly rounded"));
  // One ulp up is faithful where the exact value is above the float next to it.
  const Count up = count(off_by(1), Question::faithful, {Question::faithful});
  CHECK(up.broken < up.judged);
}

TEST_CASE("questions: any vertex may be the first of a correctly rounded polygon") {
  const Contestant guest = guest_like("correctly_rounded", [](const GuestCall&, Numbers& polygon) {
    if (!polygon.empty()) std::ranges::rotate(polygon, polygon.begin() + 1);
  });
  CHECK(count(guest, Question::correctly_rounded, Questions::all()).broken == 0);
  CHECK(count(guest, Question::faithful, Questions::all()).broken == 0);
}

TEST_CASE("questions: an attribute that is off is not faithful") {
  const Contestant guest = guest_like("correctly_rounded", [](const GuestCall&, Numbers& polygon) {
    for (auto& v : polygon) v[4] *= 1 + 0x1p-20;
  });
  CHECK(broken(guest, Question::faithful, "correctly_rounded").reason ==
        "not faithful: a coordinate or attribute is not next to the exact value");
}

TEST_CASE("questions: who remembers earlier calls, or earlier triangles, is not steady") {
  const Contestant by_call = guest_like(kChain, [](const GuestCall& call, Numbers& polygon) {
    if (call.call % 2 == 1 && !polygon.empty()) polygon[0][3] *= 1 + 0x1p-20;
  });
  CHECK(broken(by_call, Question::steady).reason ==
        "not steady: it answers otherwise when it is asked again");
  const Contestant by_place = guest_like(kChain, [](const GuestCall& call, Numbers& polygon) {
    if (call.primitive == 0 && !polygon.empty()) polygon[0][3] *= 1 + 0x1p-20;
  });
  CHECK(count(by_place, Question::steady, {Question::steady}).broken > 0);
}

TEST_CASE("questions: what a guest answers of fewer attributes is judged by these") {
  Contestant guest = guest_like(kChain, kHonest);
  const Contestant inner = guest;
  guest.most_attributes = 1;
  guest.prepare = [inner](std::span<const Batch> batches) -> std::unique_ptr<Runner> {
    REQUIRE(batches[0].attributes == 1);
    return inner.prepare(batches);
  };
  const Triangles triangles = random_triangles(30);
  std::vector<float> numbers;
  for (const auto& triangle : triangles) {
    for (const auto& v : triangle) {
      for (int i = 0; i < 4; ++i) numbers.push_back(v.position[i]);
      numbers.push_back(v.attributes[0]);
    }
  }
  Batch fewer{.space = Space::clip, .attributes = 1, .numbers = std::span<const float>(numbers)};
  const Batch batch = batch_of(ClipVolume{}, std::span(triangles));
  const Answers given = clip(guest, fewer);
  for (const Examined& e : examine(guest, batch, Questions::all(), given)) {
    CHECK_FALSE(e.violation(Question::covers));
    CHECK_FALSE(e.violation(Question::constants));
  }
}

TEST_CASE("questions: what our clippers state is what their promise says") {
  const Questions stated = stated_by(find_contestant("correctly_rounded", "float"));
  CHECK(stated.contains(Question::correctly_rounded));
  CHECK(stated.contains(Question::confined));
  CHECK_FALSE(stated_by(find_contestant("textbook", "float")).contains(Question::watertight));
  CHECK(stated_by(guest_like(kChain, kHonest)) == Questions{});
  CHECK(usually_asked(guest_like(kChain, kHonest)).list() ==
        std::vector{Question::total, Question::contained, Question::covers, Question::winding});
}

TEST_CASE("questions: a program is started a few times for a batch, however large it is") {
  std::size_t calls = 0;
  const Contestant guest = guest_like(
      kChain, [&](const GuestCall& call, Numbers&) { calls = std::max(calls, call.call + 1); });
  examined(guest, random_triangles(300), Questions::all());
  CHECK(calls == 5);  // the batch, its variants, one alone, all again, all in reversed order
}

TEST_CASE("questions: a program is not started for the same triangle alone, reversed and again") {
  std::size_t calls = 0;
  const Contestant guest = guest_like(
      kChain, [&](const GuestCall& call, Numbers&) { calls = std::max(calls, call.call + 1); });
  examined(guest, random_triangles(1), Questions::all());
  CHECK(calls == 3);  // the triangle, its variants, the triangle again
}

TEST_CASE("questions: scale is not asked about where the frustum's numbers have no room") {
  SceneTriangle triangle{};
  triangle[0].position = {0, 0, -2};
  triangle[1].position = {3, 0, -2};
  triangle[2].position = {0, 1, -2};
  const auto judged_in = [&](const Frustum<float>& frustum) {
    View view;
    view.frustum = frustum;
    const Batch batch = batch_of(view, {&triangle, 1});
    return examine(find_contestant("textbook", "float"), batch, {Question::scale}).front().judged;
  };
  CHECK(judged_in({.far = 1000}).contains(Question::scale));
  CHECK_FALSE(judged_in({.far = 0x1.fffffep+127f}).contains(Question::scale));
}
