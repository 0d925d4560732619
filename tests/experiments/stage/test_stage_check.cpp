// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stage's check: honest contestants pass, wrong ones are found out, each in its own way.
#include <functional>

#include "experiments/measure/stage_check.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/stage/inputs.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

const StageCheckOptions kFew{.triangles = 4096, .exact = 40};

// The answer of an honest contestant, copied, so that it can be spoilt.
struct Spoilt {
  std::vector<std::uint32_t> inside;
  std::vector<batch::PolygonEnd> polygons;
  std::vector<float> vertices;
  std::size_t stride = 4;
};

class Spoiler final : public StageContestant {
 public:
  Spoiler(std::unique_ptr<StageContestant> honest, StagePromise promise,
          std::function<void(Spoilt&)> spoil)
      : StageContestant("spoilt", "float", "plain", honest->contract(), promise),
        honest_(std::move(honest)),
        spoil_(std::move(spoil)) {}

  void clip(const StageInput& input, std::size_t first, std::size_t count) override {
    honest_->clip(input, first, count);
    const StageAnswer a = honest_->answer();
    answer_ = {{a.inside.begin(), a.inside.end()},
               {a.polygons.begin(), a.polygons.end()},
               {a.vertices.begin(), a.vertices.end()},
               a.stride};
    spoil_(answer_);
  }
  StageAnswer answer() const override {
    return {answer_.inside, answer_.polygons, answer_.vertices, answer_.stride};
  }

 private:
  std::unique_ptr<StageContestant> honest_;
  std::function<void(Spoilt&)> spoil_;
  Spoilt answer_;
};

std::unique_ptr<StageContestant> plain_batch(StageContract contract) {
  return stage_batch(batch::Method::homogeneous, contract, batch::Build::plain);
}

std::string broken(StageContract contract, StagePromise promise,
                   std::function<void(Spoilt&)> spoil) {
  Spoiler contestant(plain_batch(contract), promise, std::move(spoil));
  return first_broken_promise(contestant, small_soup(), kFew);
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

TEST_CASE("stage check: scalar clippers keep what they promise") {
  const StageInput input = small_soup();
  CHECK(first_broken_promise(*stage_textbook(), input, kFew) == "");
  CHECK(first_broken_promise(*stage_sutherland_hodgman("float"), input, kFew) == "");
  CHECK(first_broken_promise(*stage_sutherland_hodgman("double"), input, kFew) == "");
}

TEST_CASE("stage check: batch clippers keep what they promise in every contract and build") {
  const StageInput input = small_soup();
  for (const auto& contestant : stage_contestants(input)) {
    INFO(contestant->name());
    CHECK(first_broken_promise(*contestant, input, kFew) == "");
  }
}

TEST_CASE("stage check: nothing is spoilt and nothing is found") {
  CHECK(broken(StageContract::copy, StagePromise::bits_of_scalar, leave) == "");
  CHECK(broken(StageContract::reference, StagePromise::bits_of_scalar, leave) == "");
}

TEST_CASE("stage check: a moved vertex breaks the bits, the bound and the rounding") {
  const auto by_an_ulp = [](Spoilt& a) { move_cut_vertex(a, 1e-7f); };
  const auto far = [](Spoilt& a) { move_cut_vertex(a, 0.01f); };
  const auto contract = StageContract::reference;
  CHECK(broken(contract, StagePromise::bits_of_scalar, by_an_ulp) != "");
  CHECK(broken(contract, StagePromise::correctly_rounded, by_an_ulp) != "");
  CHECK(broken(contract, StagePromise::float_chain, by_an_ulp) == "");
  CHECK(broken(contract, StagePromise::float_chain, far) != "");
  CHECK(broken(contract, StagePromise::rounded_once, far) != "");
}

TEST_CASE("stage check: float chains are not correctly rounded") {
  CHECK(broken(StageContract::reference, StagePromise::correctly_rounded, leave) != "");
}

TEST_CASE("stage check: numbers must be those of the exact classification, in order") {
  const auto contract = StageContract::reference;
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
  CHECK(broken(StageContract::copy, StagePromise::float_chain, [](Spoilt& a) {
          for (float& x : a.vertices) x = -x;
        }) != "");
  CHECK(broken(StageContract::copy, StagePromise::float_chain, [](Spoilt& a) { a.stride = 9; }) !=
        "");
}

TEST_CASE("stage check: the exact polygon of a triangle that one plane halves") {
  // x from -2 to 0 at w = 1: half of each edge to the left vertex remains.
  const StageInput input = soup_input("one", {}, 1,
                                      {-2, 0, 0, 1, 8,   //
                                       0, -1, 0, 1, 16,  //
                                       0, 1, 0, 1, 32});
  const auto truth = reference::Truth::of_clip(input.volume);
  const auto triangle = input_triangle(input, StageContract::copy, 0);
  const std::vector<float> polygon = rounded_clip_polygon(truth, triangle);
  REQUIRE(polygon.size() == 4 * 5);
  double x = 0, attribute = 0;
  for (std::size_t i = 0; i < polygon.size(); i += 5) {
    x += polygon[i];
    attribute += polygon[i + 4];
    CHECK(polygon[i + 3] == 1);
  }
  CHECK(x == -2);
  CHECK(attribute == 12 + 16 + 32 + 20);
}
