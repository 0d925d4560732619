// SPDX-License-Identifier: GPL-3.0-or-later
//
// An attribute that has one value at all vertices of a primitive is an identity: of an object, of a
// material. No clipper may change it, whatever it does to others.
#include <cfloat>
#include <cmath>
#include <random>
#include <span>

#include "experiments/contestants/contestant.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

// Floats; for scalars that are wider, too.
const std::vector<double> kValues = {double{0.1f},         16777215, double{3e38f}, double{FLT_MAX},
                                     double{FLT_TRUE_MIN}, -0.0};

// Random primitives, of which many cross several planes; the attributes of all vertices are those
// given. A polygon is a parallelogram.
struct Primitives {
  std::vector<double> numbers;
  std::vector<std::size_t> ends;
  Batch batch;

  Primitives(Space space, int vertices, std::vector<double> attributes) {
    batch = {
        .space = space, .vertices = vertices, .attributes = static_cast<int>(attributes.size())};
    const std::size_t corners = vertices == 0 ? 4 : static_cast<std::size_t>(vertices);
    std::mt19937 random(5);
    for (int n = 0; n < 60; ++n) {
      std::vector<std::vector<double>> p;
      for (std::size_t i = 0; i < corners; ++i) p.push_back(position(space, random));
      for (std::size_t c = 0; vertices == 0 && c < p[3].size(); ++c) {
        p[3][c] = p[0][c] + p[2][c] - p[1][c];
      }
      for (const auto& v : p) {
        numbers.insert(numbers.end(), v.begin(), v.end());
        numbers.insert(numbers.end(), attributes.begin(), attributes.end());
      }
      ends.push_back(corners * static_cast<std::size_t>(n + 1));
    }
    batch.numbers = std::span<const double>(numbers);
    if (vertices == 0) batch.ends = ends;
  }
  Primitives(const Primitives&) = delete;

 private:
  // Multiples of 2^-6: differences are exact.
  static std::vector<double> position(Space space, std::mt19937& random) {
    const auto any = [&](double low, double high) {
      const int steps = static_cast<int>((high - low) * 64);
      return low + static_cast<double>(random() % static_cast<unsigned>(steps)) / 64;
    };
    if (space == Space::view) return {any(-4, 4), any(-4, 4), any(-12, 1)};
    return {any(-3, 3), any(-3, 3), any(-3, 3), any(-1, 4)};
  }
};

// Vertices of the answers, all of which must have the attributes.
std::size_t check_constants(const Contestant& contestant, const Batch& batch,
                            const std::vector<double>& attributes) {
  const Answers answers = clip(contestant, batch);
  std::size_t vertices = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    for (const VertexView& v : answers[i]) {
      ++vertices;
      for (std::size_t k = 0; k < attributes.size(); ++k) {
        const Number found = v.attribute(static_cast<int>(k));
        INFO("primitive " << i << ", attribute " << k << " is " << found.value);
        REQUIRE(is_finite(found));
        REQUIRE(to_exact(found) == Exact(attributes[k]));
      }
    }
  }
  return vertices;
}

}  // namespace

TEST_CASE("constants: every clipper in every scalar keeps an attribute that is constant") {
  const auto space = GENERATE(Space::view, Space::clip);
  const auto attributes =
      GENERATE(kValues, std::vector<double>(kValues.begin(), kValues.begin() + 4));
  int judged = 0;
  for (const Contestant& c : all_contestants()) {
    if (!c.prepare) continue;
    const Primitives primitives(space, c.vertices, attributes);
    if (!c.takes(primitives.batch)) continue;
    INFO(name_of(c));
    REQUIRE(c.promise.constants);
    REQUIRE(check_constants(c, primitives.batch, attributes) > 0);
    ++judged;
  }
  CHECK(judged > 50);
}

TEST_CASE("constants: doubles of 53 bits and the largest one are kept in wider scalars") {
  const std::vector<double> attributes = {0.1, DBL_MAX, 9007199254740991.0, DBL_TRUE_MIN};
  for (const Contestant& c : all_contestants()) {
    if (!c.prepare || c.format->is_float()) continue;
    const Primitives primitives(Space::view, c.vertices, attributes);
    if (!c.takes(primitives.batch)) continue;
    INFO(name_of(c));
    check_constants(c, primitives.batch, attributes);
  }
}
