// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clippers against the exact answer: the textbook chain in float keeps its promise, and the
// correctly rounded clipper has every bit right. The batch clippers in SIMD give the bits of their
// plain twins.
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "experiments/judge/promise.hpp"
#include "spaces/barycentric/correctly_rounded.hpp"
#include "spaces/batch/methods.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"
#include "tests/experiments/contestants/handmade.hpp"
#include "tests/fuzz/harness.hpp"
#include "tests/spaces/batch/inputs.hpp"

namespace clipscope::fuzz {
namespace {

using namespace experiments;

constexpr int kAttributes = kSceneAttributes;

// Bytes make all floats alike; those that clippers decide by are rare among them. So a byte says
// how the next number is made: as four bytes, as a small fraction, or from one that came before, up
// to some ulps and its sign.
class NumberReader {
 public:
  explicit NumberReader(ByteReader& in) : in_(in) {}

  float take() {
    const int kind = in_.below(8);
    float number = 0;
    if (kind == 0) {
      number = in_.take<float>();
    } else if (kind <= 2 || numbers_.empty()) {
      number = static_cast<float>(in_.take<std::int8_t>()) / 8;
    } else if (kind == 3) {
      number = std::ldexp(static_cast<float>(in_.take<std::int8_t>()), in_.take<std::int8_t>());
    } else {
      number = neighbour(numbers_[static_cast<std::size_t>(
          in_.below(static_cast<int>(std::min<std::size_t>(numbers_.size(), 200))))]);
    }
    numbers_.push_back(number);
    return number;
  }

 private:
  float neighbour(float number) {
    const int byte = in_.take<std::uint8_t>();
    const auto ulps = static_cast<std::uint32_t>(byte % 16) - 8u;
    if (byte >= 64) return byte % 2 == 0 ? number : -number;
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(number) + ulps);
  }

  ByteReader& in_;
  std::vector<float> numbers_;
};

ClipVolume volume_from(ByteReader& in) {
  ClipVolume volume{.depth = static_cast<DepthRange>(in.below(3))};
  const int options = in.take<std::uint8_t>();
  if (options < 128) return volume;  // half of them plain
  volume.depth_clamp = {(options & 1) != 0, (options & 2) != 0};
  volume.clip_distances = options >> 2 & 3;
  volume.open_sides = {(options & 16) != 0, (options & 32) != 0, (options & 64) != 0,
                       in.below(2) != 0};
  return volume;
}

template <Space S>
Triangle<S, float, kAttributes> triangle_from(ByteReader& in) {
  NumberReader numbers(in);
  Triangle<S, float, kAttributes> triangle;
  for (auto& vertex : triangle) {
    for (int i = 0; i < vertex.kDimension; ++i) vertex.position[i] = numbers.take();
    for (float& a : vertex.attributes.values) a = numbers.take();
  }
  return triangle;
}

template <Space S>
bool has_finite_attributes(const Triangle<S, float, kAttributes>& triangle) {
  for (const auto& vertex : triangle) {
    for (const float a : vertex.attributes.values) {
      if (!std::isfinite(a)) return false;
    }
  }
  return true;
}

// Where: the projection, or the volume, that the batch describes.
template <class Clipper, Space S, class Where>
NdcPolygon<float, kAttributes> answer_to(const Where& where,
                                         const Triangle<S, float, kAttributes>& triangle) {
  NdcPolygon<float, kAttributes> out;
  Clipper{}(where, triangle, out);
  require(out.empty() || has_finite_positions(triangle), "{} answers a triangle that is not finite",
          Clipper::name);
  for (const auto& vertex : out) {
    for (int i = 0; i < 3; ++i) {
      require(std::isfinite(vertex.position[i]), "{} is not total: a coordinate is {}",
              Clipper::name, vertex.position[i]);
    }
  }
  return out;
}

void check(const PromiseChecker& checker, const Batch& batch, const Promise& promise,
           std::string_view clipper, const Answers& answers) {
  const auto vertices = input_vertices(batch, 0);
  const PromiseCheck check = checker.check(promise, vertices, kAttributes, answers[0]);
  require(check.verdict != PromiseVerdict::broken, "{} breaks its promise: {}", clipper,
          check.reason);
  if (!promise.correctly_rounded) return;
  const std::string wrong = misrounded(checker.truth(), vertices, kAttributes, answers[0]);
  require(wrong.empty(), "{}: {}", clipper, wrong);
}

template <Space S, class Where>
void check_both(const Where& where, const Batch& batch,
                const Triangle<S, float, kAttributes>& triangle) {
  using SutherlandHodgman = HomogeneousSutherlandHodgman;
  const auto chain = answer_to<SutherlandHodgman>(where, triangle);
  const auto rounded = answer_to<CorrectlyRounded>(where, triangle);
  if (!has_finite_positions(triangle) || !has_finite_attributes(triangle)) return;
  const PromiseChecker checker(batch);
  check(checker, batch, SutherlandHodgman::promise, SutherlandHodgman::name, answer_of(chain));
  check(checker, batch, CorrectlyRounded::promise, CorrectlyRounded::name, answer_of(rounded));
}

Frustum<float> frustum_from(ByteReader& in, DepthRange depth) {
  NumberReader numbers(in);
  Frustum<float> f;
  f.kind = in.below(2) == 0 ? ProjectionKind::perspective : ProjectionKind::parallel;
  for (float* bound : {&f.left, &f.right, &f.bottom, &f.top, &f.near, &f.far}) {
    *bound = numbers.take();
  }
  f.infinite_far = f.kind == ProjectionKind::perspective && in.below(4) == 0;
  if (f.infinite_far) f.far = 0;
  if (f.kind == ProjectionKind::parallel) f.shear_x = numbers.take();
  f.depth = depth;
  return f;
}

bool is_finite(const Frustum<float>& f) {
  return std::isfinite(f.left) && std::isfinite(f.right) && std::isfinite(f.bottom) &&
         std::isfinite(f.top) && std::isfinite(f.near) && std::isfinite(f.far) &&
         std::isfinite(f.shear_x);
}

}  // namespace

void clip_space(Bytes bytes) {
  ByteReader in(bytes);
  const ClipVolume volume = volume_from(in);
  const auto triangle = triangle_from<Space::clip>(in);
  check_both(volume, batch_of(volume, std::span(&triangle, 1)), triangle);
}

void view_space(Bytes bytes) {
  ByteReader in(bytes);
  const ClipVolume volume = volume_from(in);
  const Frustum<float> frustum = frustum_from(in, volume.depth);
  if (!is_finite(frustum) || !is_valid(frustum)) return;
  Projection<float> projection(frustum);
  projection.volume = volume;
  const auto triangle = triangle_from<Space::view>(in);
  Batch batch = batch_of(frustum, std::span(&triangle, 1));
  batch.volume = volume;
  check_both(projection, batch, triangle);
}

void batches(Bytes bytes) {
  using batch::Build, batch::Output;
  ByteReader in(bytes);
  const batch::Method method = batch::kStageMethods[static_cast<std::size_t>(
      in.below(static_cast<int>(std::size(batch::kStageMethods))))];
  const ClipVolume volume = volume_from(in);
  const int attributes = std::max(in.below(9), volume.clip_distances);
  // Few triangles, again and again, so that every lane meets each.
  const auto given = static_cast<std::size_t>(1 + in.below(6));
  const std::size_t count = given * static_cast<std::size_t>(1 + in.below(8));
  NumberReader numbers(in);
  batch::tests::Soup soup{attributes, {}, std::vector<std::vector<float>>(12), {}, {}};
  const std::size_t stride = soup.array().stride();
  for (std::size_t i = 0; i < 3 * given * stride; ++i) soup.vertices.push_back(numbers.take());
  for (std::size_t i = 3 * given * stride; i < 3 * count * stride; ++i) {
    soup.vertices.push_back(soup.vertices[i - 3 * given * stride]);
  }
  for (std::size_t v = 0; v < 3 * count; ++v) {
    const auto vertex = soup.vertices.begin() + static_cast<std::ptrdiff_t>(v * stride);
    for (std::size_t c = 0; c < 4; ++c) soup.coordinates[4 * (v % 3) + c].push_back(vertex[c]);
    soup.attribute_values.insert(soup.attribute_values.end(), vertex + 4, vertex + stride);
    soup.indices.push_back(static_cast<std::uint32_t>(in.take<std::uint8_t>() % (3 * count)));
  }
  const auto check_twins = [&](const auto& input, std::string_view layout) {
    Output plain, simd;
    clip(method, volume, input, plain, Build::plain);
    clip(method, volume, input, simd);
    const auto at = batch::tests::first_difference(plain, simd);
    require(!at, "{}, {}: SIMD differs from the plain version in triangle {}", batch::name(method),
            layout, at.value_or(0));
  };
  check_twins(soup.array(), "array");
  check_twins(soup.streams(), "streams");
  check_twins(soup.mesh(), "mesh");
}

}  // namespace clipscope::fuzz
