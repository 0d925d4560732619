// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/stage_check.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "experiments/measure/promise.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kBlock = 4096;  // triangles per call
// One unit of float's roundoff, in units of double's.
constexpr double kFloatInDouble = 536870912;  // 2^(53 - 24)

enum class Way { rejected, inside, cut };

ClipTriangle<float, kRunTime> triangle_of(const StageInput& input, StageContract contract,
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
  const OutcodeSummary code = summarize_outcodes(volume, triangle, [&](std::size_t i) {
    return clip_outcode(volume.depth, triangle[i].position);
  });
  if (code.all != 0 || !has_finite_positions(triangle)) return Way::rejected;
  if (code.any != 0) return Way::cut;
  const bool drawn = std::all_of(triangle.begin(), triangle.end(),
                                 [](const auto& v) { return 0.0f < v.position[3]; });
  return drawn ? Way::inside : Way::rejected;
}

std::vector<float> flattened(const ClipTriangle<float, kRunTime>& triangle) {
  std::vector<float> flat;
  for (const auto& v : triangle) {
    for (int c = 0; c < 4; ++c) flat.push_back(v.position[c]);
    for (int k = 0; k < v.attributes.size(); ++k) flat.push_back(v.attributes[k]);
  }
  return flat;
}

bool same_bits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}
bool same_value(float a, float b) { return a == b; }

// Whether two polygons have the same vertices in the same order, whichever is first.
template <class Same>
bool same_cycle(std::span<const float> a, std::span<const float> b, std::size_t stride,
                const Same& same) {
  if (a.size() != b.size()) return false;
  for (std::size_t shift = 0; shift < a.size(); shift += stride) {
    const auto middle = b.begin() + static_cast<std::ptrdiff_t>(shift);
    const auto split = a.end() - static_cast<std::ptrdiff_t>(shift);
    if (std::equal(middle, b.end(), a.begin(), same) &&
        std::equal(b.begin(), middle, split, same)) {
      return true;
    }
  }
  return a.empty();
}

// The polygon without vertices that equal the one before them; nothing if that leaves fewer than three. A
// polygon without area may repeat vertices.
std::vector<float> without_repeated(std::span<const float> polygon, std::size_t stride) {
  std::vector<float> distinct;
  const auto equals_last = [&](const float* v) {
    return distinct.size() >= stride &&
           std::equal(v, v + stride, distinct.end() - static_cast<std::ptrdiff_t>(stride));
  };
  for (std::size_t i = 0; i < polygon.size(); i += stride) {
    const float* v = polygon.data() + i;
    if (!equals_last(v)) distinct.insert(distinct.end(), v, v + stride);
  }
  while (distinct.size() > stride && equals_last(distinct.data())) {
    distinct.resize(distinct.size() - stride);
  }
  return distinct.size() < 3 * stride ? std::vector<float>() : distinct;
}

// A triangle that is cut, and what came out.
struct CutCase {
  std::size_t number;
  ClipTriangle<float, kRunTime> triangle;
  std::vector<float> polygon;
};

// Checks a block's order and the triangles that are not cut; collects those that are.
std::string check_ways(const StageContestant& contestant, const StageInput& input,
                       std::size_t first, std::size_t count, std::vector<CutCase>& cut) {
  const StageAnswer answer = contestant.answer();
  if (answer.stride != input.stride()) {
    return fmt::format("{} floats per vertex instead of {}", answer.stride, input.stride());
  }
  const bool copies = contestant.contract() == StageContract::copy;
  std::size_t inside = 0, polygons = 0;
  for (std::size_t t = 0; t < count; ++t) {
    const bool listed = inside < answer.inside.size() && answer.inside[inside] == t;
    const bool drawn = polygons < answer.polygons.size() && answer.polygons[polygons].triangle == t;
    const std::span<const float> polygon =
        drawn ? answer.polygon(polygons) : std::span<const float>();
    inside += listed ? 1 : 0;
    polygons += drawn ? 1 : 0;
    const auto triangle = triangle_of(input, contestant.contract(), first + t);
    const Way way = way_of(input.volume, triangle);
    const auto broken = [&](std::string_view what) {
      return fmt::format("triangle {} {}", first + t, what);
    };
    if (way == Way::cut) {
      if (listed) return broken("is listed as inside, but a plane cuts it");
      cut.push_back({first + t, triangle, {polygon.begin(), polygon.end()}});
    } else if (way == Way::rejected) {
      if (listed || drawn) return broken("is drawn, but outside");
    } else if (copies ? !same_cycle(polygon, flattened(triangle), answer.stride, same_bits)
                      : !listed || drawn) {
      return broken("is inside and does not come out as it went in");
    }
  }
  if (inside == answer.inside.size() && polygons == answer.polygons.size()) return "";
  return "the numbers of triangles do not ascend, or are not of the input";
}

// What homogeneous/sutherland_hodgman makes of them before its divide.
std::string check_bits(std::span<const CutCase> cut, const StageInput& input) {
  std::vector<float> vertices;
  for (const CutCase& c : cut) {
    const std::vector<float> flat = flattened(c.triangle);
    vertices.insert(vertices.end(), flat.begin(), flat.end());
  }
  const StageInput soup =
      soup_input(input.name, input.volume, input.attributes, std::move(vertices));
  const auto scalar = stage_sutherland_hodgman("float");
  scalar->clip(soup, 0, cut.size());
  const StageAnswer wanted = scalar->answer();
  std::size_t p = 0;
  for (std::size_t i = 0; i < cut.size(); ++i) {
    std::span<const float> polygon;
    if (p < wanted.polygons.size() && wanted.polygons[p].triangle == i) {
      polygon = wanted.polygon(p++);
    }
    if (!same_cycle(cut[i].polygon, polygon, input.stride(), same_bits)) {
      return fmt::format("triangle {} has other bits than the scalar clipper", cut[i].number);
    }
  }
  return "";
}

std::vector<NdcVertex<double, kRunTime>> divided(std::span<const float> polygon,
                                                 std::size_t stride) {
  std::vector<NdcVertex<double, kRunTime>> ndc;
  for (std::size_t i = 0; i < polygon.size(); i += stride) {
    const float* v = polygon.data() + i;
    auto& vertex = ndc.emplace_back();
    vertex.position = to_ndc(Vec4<double>(v[0], v[1], v[2], v[3]));
    vertex.attributes.resize(static_cast<int>(stride) - 4);
    std::copy(v + 4, v + stride, vertex.attributes.values.begin());
  }
  return ndc;
}

// The bound, in units of double's roundoff. Rounded once: 4 + K coordinates each move by one unit of float at
// most, so a vertex by sqrt(4 + K) of them; on top of that double's own chain.
Promise bound_of(StagePromise promise, int attributes) {
  const double once = std::sqrt(4.0 + attributes) * kFloatInDouble;
  return {.ulps = promise == StagePromise::rounded_once ? once + kChainUlps
                                                        : kChainUlps * kFloatInDouble};
}

std::string check_exactly(const CutCase& c, StagePromise promise, const PromiseChecker& checker,
                          const StageInput& input) {
  const reference::InputTriangle triangle = reference::input_triangle(c.triangle);
  if (reference::classify(checker.truth(), triangle) != reference::Verdict::clipped) {
    return fmt::format("triangle {} is not cut in exact arithmetic", c.number);
  }
  if (promise == StagePromise::correctly_rounded) {
    if (has_no_area(triangle)) return "";
    const std::vector<float> wanted = rounded_clip_polygon(checker.truth(), triangle);
    const std::size_t stride = input.stride();
    if (same_cycle(without_repeated(c.polygon, stride), without_repeated(wanted, stride), stride,
                   same_value)) {
      return "";
    }
    return fmt::format("triangle {} is not correctly rounded: {} floats, {} wanted", c.number,
                       c.polygon.size(), wanted.size());
  }
  const auto polygon = divided(c.polygon, input.stride());
  const PromiseCheck check = checker.check<double, kRunTime>(bound_of(promise, input.attributes),
                                                             triangle, std::span(polygon));
  if (check.verdict != PromiseVerdict::broken) return "";
  return fmt::format("triangle {}: {}", c.number, check.reason);
}

std::string check_cut(const StageContestant& contestant, const StageInput& input,
                      std::span<const CutCase> cut, std::size_t exact) {
  if (contestant.promise() == StagePromise::bits_of_scalar) return check_bits(cut, input);
  const PromiseChecker checker(input.volume);
  std::vector<std::string> found(std::min(exact, cut.size()));
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
    found[i] =
        check_exactly(cut[i * cut.size() / found.size()], contestant.promise(), checker, input);
  });
  const auto broken = std::find_if(found.begin(), found.end(),
                                   [](const std::string& text) { return !text.empty(); });
  return broken == found.end() ? "" : *broken;
}

}  // namespace

std::array<float, 4> nearest_in_clip(const reference::ExactVertex& v) {
  using reference::Fraction;
  using reference::round_to;
  const Fraction w{v.inv_w.denominator, v.inv_w.numerator};
  const auto times_w = [&](const Fraction& x) {
    return round_to<float>(Fraction{x.numerator * w.numerator, x.denominator * w.denominator});
  };
  return {times_w(v.x), times_w(v.y), times_w(v.z), round_to<float>(w)};
}

std::vector<float> rounded_clip_polygon(const reference::Truth& truth,
                                        const reference::InputTriangle& triangle) {
  const reference::ExactPolygon exact = reference::clip(truth, triangle);
  if (exact.vertices.size() < 3) return {};
  std::vector<float> polygon;
  for (const reference::ExactVertex& v : exact.vertices) {
    for (const float coordinate : nearest_in_clip(v)) polygon.push_back(coordinate);
    for (const reference::Fraction& a : v.attributes) {
      polygon.push_back(reference::round_to<float>(a));
    }
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
    const Rational determinant = at(0, a) * m0 - at(0, b) * m1 + at(0, c) * m2;
    return determinant;
  };
  const Rational zero(0);
  return minor(0, 1, 2) == zero && minor(0, 1, 3) == zero && minor(0, 2, 3) == zero &&
         minor(1, 2, 3) == zero;
}

reference::InputTriangle input_triangle(const StageInput& input, StageContract contract,
                                        std::size_t triangle) {
  return reference::input_triangle(triangle_of(input, contract, triangle));
}

std::string first_broken_promise(StageContestant& contestant, const StageInput& input,
                                 const StageCheckOptions& options) {
  const std::size_t size = contestant.contract() == StageContract::copy
                               ? input.array_size()
                               : input.size(contestant.contract());
  const std::size_t blocks = (size + kBlock - 1) / kBlock;
  const std::size_t wanted = std::clamp<std::size_t>(options.triangles / kBlock, 1, blocks);
  std::vector<CutCase> cut;
  for (std::size_t i = 0; i < wanted; ++i) {
    const std::size_t first = i * blocks / wanted * kBlock;
    const std::size_t count = std::min({kBlock, size - first, options.triangles});
    contestant.clip(input, first, count);
    const std::string broken = check_ways(contestant, input, first, count, cut);
    if (!broken.empty()) return broken;
  }
  return check_cut(contestant, input, cut, options.exact);
}

}  // namespace clipscope::experiments
