// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/stage_check.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "experiments/judge/cycle.hpp"
#include "experiments/judge/promise.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kBlock = 4096;  // triangles per call
// One unit of float's roundoff, in units of double's.
constexpr double kFloatInDouble = 536870912;  // 2^(53 - 24)

enum class Way { rejected, inside, cut };

ClipTriangle<float, kRunTime> triangle_of(const StageInput& input, Contract contract,
                                          std::size_t t) {
  ClipTriangle<float, kRunTime> triangle;
  for (std::size_t v = 0; v < 3; ++v) {
    const float* in = input.vertex(contract, t, v);
    triangle[v].position = Vec4<float>(in[0], in[1], in[2], in[3]);
    triangle[v].attributes.resize(input.attributes);
    std::copy_n(in + 4, input.attributes, triangle[v].attributes.values.begin());
  }
  return triangle;
}

Way way_of(const ClipVolume& volume, const ClipTriangle<float, kRunTime>& triangle) {
  const OutcodeSummary code = summarize_outcodes(volume, triangle);
  if (code.all != 0 || !has_finite_positions(triangle)) return Way::rejected;
  if (code.any != 0) return Way::cut;
  const bool drawn = std::all_of(triangle.begin(), triangle.end(),
                                 [](const auto& v) { return 0.0f < v.position[3]; });
  return drawn ? Way::inside : Way::rejected;
}

Answers as_polygon(const ClipTriangle<float, kRunTime>& triangle) {
  Answers answers(kFormat<float>, 4 + static_cast<std::size_t>(triangle[0].attributes.size()));
  add_polygon(triangle, answers);
  return answers;
}

// A triangle that is cut, and what came out: polygon `place` of the answers.
struct CutCase {
  std::size_t number;
  ClipTriangle<float, kRunTime> triangle;
  std::shared_ptr<const Answers> answers;
  std::size_t place;

  PolygonView polygon() const { return (*answers)[place]; }
};

// Checks a block's form and the triangles that are not cut; collects those that are.
std::string check_ways(const Contestant& contestant, const Runner& runner, const StageInput& input,
                       std::size_t first, std::vector<CutCase>& cut) {
  const std::string malformed = runner.malformed();
  if (!malformed.empty()) return malformed;
  const auto answers = std::make_shared<const Answers>(runner.answers());
  const bool copies = contestant.contract == Contract::copy;
  for (std::size_t i = 0; i < answers->size(); ++i) {
    const std::size_t t = first + i;
    const bool listed = answers->is_listed(i);
    const auto triangle = triangle_of(input, contestant.contract, t);
    const auto broken = [&](std::string_view what) {
      return fmt::format("triangle {} {}", t, what);
    };
    switch (way_of(input.volume, triangle)) {
      case Way::cut:
        if (listed) return broken("is listed as inside, but a plane cuts it");
        cut.push_back({t, triangle, answers, i});
        break;
      case Way::rejected:
        if (!(*answers)[i].empty()) return broken("is drawn, but outside");
        break;
      case Way::inside:
        if (listed == copies ||
            !same_cycle((*answers)[i], as_polygon(triangle)[0], Likeness::by_bits)) {
          return broken("is inside and does not come out as it went in");
        }
    }
  }
  return "";
}

// What homogeneous/sutherland_hodgman makes of them before its divide.
std::string check_bits(std::span<const CutCase> cut, const StageInput& input) {
  for (const CutCase& c : cut) {
    Answers wanted(kFormat<float>, input.stride());
    add_polygon(HomogeneousSutherlandHodgman::cut(input.volume, c.triangle), wanted);
    if (!same_cycle(c.polygon(), wanted[0], Likeness::by_bits)) {
      return fmt::format("triangle {} has other bits than the scalar clipper", c.number);
    }
  }
  return "";
}

// The bound, in units of double's roundoff. Rounded once: 4 + K coordinates each move by one unit
// of float at most, so a vertex by sqrt(4 + K) of them; on top of that double's own chain.
Promise bound_of(StagePromise promise, int attributes) {
  const double once = std::sqrt(4.0 + attributes) * kFloatInDouble;
  return {.ulps = promise == StagePromise::rounded_once ? once + kChainUlps
                                                        : kChainUlps * kFloatInDouble};
}

// Whether the polygon is the exact one with every float rounded once. A polygon without area may
// repeat vertices, and is none with fewer than three.
bool is_rounded(const PolygonView& polygon, const FloatPolygon& wanted) {
  FloatPolygon vertices;
  for (const VertexView& v : polygon) vertices.push_back(floats_of(v));
  FloatPolygon found = without_repeats(vertices, Likeness::by_value);
  FloatPolygon expected = without_repeats(wanted, Likeness::by_value);
  if (found.size() < 3) found.clear();
  if (expected.size() < 3) expected.clear();
  return same_cycle(found, expected, Likeness::by_value);
}

std::string check_exactly(const CutCase& c, StagePromise promise, const PromiseChecker& checker,
                          const StageInput& input) {
  const reference::InputTriangle triangle = reference::input_triangle(c.triangle);
  if (reference::classify(checker.truth(), triangle) != reference::Verdict::clipped) {
    return fmt::format("triangle {} is not cut in exact arithmetic", c.number);
  }
  if (promise == StagePromise::correctly_rounded) {
    if (has_no_area(triangle)) return "";
    const FloatPolygon wanted = rounded_clip_polygon(checker.truth(), triangle);
    if (is_rounded(c.polygon(), wanted)) return "";
    return fmt::format("triangle {} is not correctly rounded: {} floats, {} wanted", c.number,
                       c.polygon().size() * input.stride(), wanted.size() * input.stride());
  }
  const Answers ndc = divided(c.polygon());
  const PromiseCheck check = checker.check(bound_of(promise, input.attributes), triangle, ndc[0]);
  if (check.verdict != PromiseVerdict::broken) return "";
  return fmt::format("triangle {}: {}", c.number, check.reason);
}

std::string check_cut(const Contestant& contestant, const StageInput& input,
                      std::span<const CutCase> cut, std::size_t exact) {
  if (contestant.stage_promise == StagePromise::bits_of_scalar) return check_bits(cut, input);
  const PromiseChecker checker(input.volume);
  std::vector<std::string> found(std::min(exact, cut.size()));
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
    found[i] =
        check_exactly(cut[i * cut.size() / found.size()], contestant.stage_promise, checker, input);
  });
  const auto broken =
      std::ranges::find_if(found, [](const std::string& text) { return !text.empty(); });
  return broken == found.end() ? "" : *broken;
}

}  // namespace

Answers divided(const PolygonView& polygon) {
  const std::size_t stride = polygon.empty() ? 4 : polygon[0].size();
  Answers ndc(kFormat<double>, stride);
  for (const VertexView& v : polygon) {
    const Vec4<double> position =
        to_ndc(Vec4<double>(v[0].value, v[1].value, v[2].value, v[3].value));
    for (int i = 0; i < 4; ++i) ndc.add(position[i]);
    for (std::size_t i = 4; i < stride; ++i) ndc.add(v[i].value);
  }
  ndc.end_polygon();
  return ndc;
}

std::array<float, 4> nearest_in_clip(const reference::ExactVertex& v) {
  using reference::Fraction;
  using reference::round_to;
  const Fraction w{v.inv_w.denominator, v.inv_w.numerator};
  const auto times_w = [&](const Fraction& x) {
    return round_to<float>(Fraction{x.numerator * w.numerator, x.denominator * w.denominator});
  };
  return {times_w(v.x), times_w(v.y), times_w(v.z), round_to<float>(w)};
}

FloatPolygon rounded_clip_polygon(const reference::Truth& truth,
                                  const reference::InputTriangle& triangle) {
  const reference::ExactPolygon exact = reference::clip(truth, triangle);
  if (exact.vertices.size() < 3) return {};
  FloatPolygon polygon;
  for (const reference::ExactVertex& v : exact.vertices) {
    const auto position = nearest_in_clip(v);
    auto& floats = polygon.emplace_back(position.begin(), position.end());
    for (const auto& a : v.attributes) floats.push_back(reference::round_to<float>(a));
  }
  return polygon;
}

bool has_no_area(const reference::InputTriangle& triangle) {
  using reference::Rational;
  const auto minor = [&](int a, int b, int c) {
    const auto at = [&](std::size_t v, int i) {
      return Rational(triangle.vertices[v].position[static_cast<std::size_t>(i)]);
    };
    const Rational m0 = at(1, b) * at(2, c) - at(1, c) * at(2, b);
    const Rational m1 = at(1, a) * at(2, c) - at(1, c) * at(2, a);
    const Rational m2 = at(1, a) * at(2, b) - at(1, b) * at(2, a);
    return Rational(at(0, a) * m0 - at(0, b) * m1 + at(0, c) * m2);
  };
  const Rational zero(0);
  return minor(0, 1, 2) == zero && minor(0, 1, 3) == zero && minor(0, 2, 3) == zero &&
         minor(1, 2, 3) == zero;
}

reference::InputTriangle input_triangle(const StageInput& input, Contract contract,
                                        std::size_t triangle) {
  return reference::input_triangle(triangle_of(input, contract, triangle));
}

std::string first_broken_promise(const Contestant& contestant, Runner& runner,
                                 const StageInput& input, const StageCheckOptions& options) {
  const std::size_t size = input.clipped(contestant.contract);
  const std::size_t blocks = (size + kBlock - 1) / kBlock;
  const std::size_t wanted = std::clamp<std::size_t>(options.triangles / kBlock, 1, blocks);
  std::vector<CutCase> cut;
  for (std::size_t i = 0; i < wanted; ++i) {
    const std::size_t first = i * blocks / wanted * kBlock;
    runner.clip(0, first, std::min({kBlock, size - first, options.triangles}));
    const std::string broken = check_ways(contestant, runner, input, first, cut);
    if (!broken.empty()) return broken;
  }
  return check_cut(contestant, input, cut, options.exact);
}

}  // namespace clipscope::experiments
