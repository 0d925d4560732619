// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stage's check: honest contestants pass, wrong ones are found out, each in its own way.
#include <functional>

#include "experiments/contestants/stage_runner.hpp"
#include "experiments/judge/stage_check.hpp"
#include "experiments/selection/select.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/contestants/stage_inputs.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

const StageCheckOptions kFew{.triangles = 4096, .exact = 40};

// An honest answer, copied, so that it can be spoilt.
struct Spoilt {
  std::vector<std::uint32_t> inside;
  std::vector<batch::PolygonEnd> polygons;
  std::vector<float> vertices;
  std::size_t stride = 4;
};

// homogeneous/batch, plain, with its answer spoilt.
class Spoiler final : public StageRunner {
 public:
  Spoiler(Contract contract, const StageInput& input, std::function<void(Spoilt&)> spoil)
      : StageRunner(contract, input), spoil_(std::move(spoil)) {}

 private:
  void clip_stage(std::size_t first, std::size_t count) override {
    const auto method = batch::Method::homogeneous;
    batch::Output out;
    if (contract() == Contract::copy) {
      batch::clip(method, input().volume, input().array(first, count), out, batch::Build::plain);
    } else {
      batch::clip(method, input().volume, input().streams(first, count), out, batch::Build::plain);
    }
    answer_ = {{out.inside().begin(), out.inside().end()},
               {out.polygons().begin(), out.polygons().end()},
               {out.vertices().begin(), out.vertices().end()},
               out.stride()};
    spoil_(answer_);
  }
  StageAnswer answer() const override {
    return {answer_.inside, answer_.polygons, answer_.vertices};
  }

  std::function<void(Spoilt&)> spoil_;
  Spoilt answer_;
};

std::string broken(Contract contract, StagePromise promise, std::function<void(Spoilt&)> spoil) {
  const StageInput input = small_soup();
  Contestant contestant{.clipper = "spoilt", .contract = contract, .stage_promise = promise};
  Spoiler runner(contract, input, std::move(spoil));
  return first_broken_promise(contestant, runner, input, kFew);
}

std::string broken(const Contestant& contestant, const StageInput& input) {
  return first_broken_promise(contestant, *contestant.prepare_stage(input), input, kFew);
}

void leave(Spoilt&) {}

// The first vertex of a triangle that is cut, moved by a part of its w.
void move_cut_vertex(Spoilt& answer, float part) {
  std::size_t begin = 0;
  for (const batch::PolygonEnd& polygon : answer.polygons) {
    float* v = answer.vertices.data() + begin * answer.stride;
    v[0] += part * v[3];
    begin = polygon.end;
  }
}

}  // namespace

TEST_CASE("stage check: every clipper keeps what it promises in every contract and build") {
  const StageInput input = small_soup();
  const Contestants contestants = stage_contestants(input);
  CHECK(has_clipper(contestants, "textbook"));
  CHECK(has_clipper(contestants, "homogeneous/sutherland_hodgman"));
  CHECK(contestants.size() == 3 + 2 * 5 * 2);
  for (const Contestant* contestant : contestants) {
    INFO(name_of(*contestant));
    CHECK(broken(*contestant, input) == "");
  }
}

TEST_CASE("stage check: nothing is spoilt and nothing is found") {
  CHECK(broken(Contract::copy, StagePromise::bits_of_scalar, leave) == "");
  CHECK(broken(Contract::number, StagePromise::bits_of_scalar, leave) == "");
}

TEST_CASE("stage check: a moved vertex breaks the bits, the bound and the rounding") {
  const auto by_an_ulp = [](Spoilt& a) { move_cut_vertex(a, 1e-7f); };
  const auto far = [](Spoilt& a) { move_cut_vertex(a, 0.01f); };
  const auto contract = Contract::number;
  CHECK(broken(contract, StagePromise::bits_of_scalar, by_an_ulp) != "");
  CHECK(broken(contract, StagePromise::correctly_rounded, by_an_ulp) != "");
  CHECK(broken(contract, StagePromise::float_chain, by_an_ulp) == "");
  CHECK(broken(contract, StagePromise::float_chain, far) != "");
  CHECK(broken(contract, StagePromise::rounded_once, far) != "");
}

TEST_CASE("stage check: float chains are not correctly rounded") {
  CHECK(broken(Contract::number, StagePromise::correctly_rounded, leave) != "");
}

TEST_CASE("stage check: numbers must be those of the exact classification, in order") {
  const auto contract = Contract::number;
  const auto promise = StagePromise::bits_of_scalar;
  CHECK(broken(contract, promise, [](Spoilt& a) { a.inside.pop_back(); }) != "");
  CHECK(broken(contract, promise, [](Spoilt& a) { std::swap(a.inside[0], a.inside[1]); }) != "");
  CHECK(broken(contract, promise, [](Spoilt& a) { a.inside.push_back(1 << 20); }) != "");
  CHECK(broken(contract, promise, [](Spoilt& a) { ++a.polygons[0].triangle; }) != "");
  CHECK(broken(contract, promise, [](Spoilt& a) {
          a.vertices.resize(a.polygons[a.polygons.size() - 2].end * a.stride);
          a.polygons.pop_back();
        }) != "");
}

TEST_CASE("stage check: a triangle that is inside comes out as it went in") {
  CHECK(broken(Contract::copy, StagePromise::float_chain, [](Spoilt& a) {
          for (float& x : a.vertices) x = -x;
        }) != "");
  CHECK(broken(Contract::copy, StagePromise::float_chain,
               [](Spoilt& a) { a.vertices.pop_back(); }) != "");
}

TEST_CASE("stage check: the exact polygon of a triangle that one plane halves") {
  // x from -2 to 0 at w = 1: half of each edge to the left vertex remains.
  const StageInput input = soup_input("one", {}, 1,
                                      {-2, 0, 0, 1, 8,   //
                                       0, -1, 0, 1, 16,  //
                                       0, 1, 0, 1, 32});
  const auto truth = reference::Truth::of_clip(input.volume);
  const auto triangle = input_triangle(input, Contract::copy, 0);
  const FloatPolygon polygon = rounded_clip_polygon(truth, triangle);
  REQUIRE(polygon.size() == 4);
  double x = 0, attribute = 0;
  for (const std::vector<float>& v : polygon) {
    REQUIRE(v.size() == 5);
    x += v[0];
    attribute += v[4];
    CHECK(v[3] == 1);
  }
  CHECK(x == -2);
  CHECK(attribute == 12 + 16 + 32 + 20);
}
