// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contestants have the bits that the same clippers have when compiled with other flags.
#include <bit>
#include <cmath>
#include <cstdint>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/contestants/contestant.hpp"
#include "experiments/scenes/builtin.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/contestants/other_build.hpp"

namespace clipscope::experiments {
namespace {

// NaNs are equal: which one comes out is the processor's choice.
bool has_same_bits(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool has_same_bits(const PolygonView& polygon, const std::vector<double>& numbers) {
  std::size_t next = 0;
  for (const VertexView& v : polygon) {
    for (std::size_t i = 0; i < v.size(); ++i, ++next) {
      if (next == numbers.size() || !has_same_bits(v[i].value, numbers[next])) return false;
    }
  }
  return next == numbers.size();
}

bool is_same_clipper(const Contestant& c, const other_build::Clipper& other) {
  return c.contract == Contract::full && c.clipper == other.clipper && c.scalar() == other.scalar &&
         c.vertices == other.vertices;
}

const Contestant& contestant_of(const other_build::Clipper& other) {
  const auto all = all_contestants();
  const auto found =
      std::ranges::find_if(all, [&](const Contestant& c) { return is_same_clipper(c, other); });
  REQUIRE(found != all.end());
  return *found;
}

// Primitives of the batch that the two builds answer alike.
std::size_t count_alike(const Contestant& contestant, const other_build::Clipper& other,
                        const Batch& batch) {
  const Answers answers = clip(contestant, batch);
  const auto run = batch.space == Space::view ? other.from_view : other.from_clip;
  const std::size_t size = batch.stride() * static_cast<std::size_t>(batch.vertices);
  std::size_t alike = 0;
  std::vector<double> numbers, found;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    numbers.clear();
    found.clear();
    for (std::size_t k = 0; k < size; ++k) numbers.push_back(batch.number(i * size + k));
    other_build::Input input{.frustum = {}, .volume = {}, .numbers = numbers};
    input.frustum = std::bit_cast<decltype(input.frustum)>(batch.frustum);
    input.volume = std::bit_cast<decltype(input.volume)>(batch.volume);
    run(input, found);
    alike += has_same_bits(answers[i], found);
  }
  return alike;
}

// Checks every clipper that takes the batch; how many did.
std::size_t check_bits(const Batch& batch) {
  REQUIRE(batch.attributes == other_build::kAttributes);
  std::size_t clippers = 0;
  for (const other_build::Clipper& other : other_build::clippers()) {
    const Contestant& contestant = contestant_of(other);
    if (!contestant.takes(batch)) continue;
    INFO(name_of(contestant));
    CHECK(count_alike(contestant, other, batch) == batch.size());
    ++clippers;
  }
  return clippers;
}

std::vector<double> numbers_of(const HardCase& c) {
  const std::size_t dimension = c.space == Space::view ? 3 : 4;
  std::vector<double> numbers;
  for (const auto& [position, attributes] : c.vertices) {
    for (std::size_t i = 0; i < dimension; ++i) numbers.push_back(position[i]);
    for (int k = 0; k < c.attribute_count; ++k) {
      numbers.push_back(attributes[static_cast<std::size_t>(k)]);
    }
  }
  return numbers;
}

}  // namespace

TEST_CASE("compiled: every clipper in float and double is compared with another build") {
  const auto& others = other_build::clippers();
  const auto is_compared = [&](const Contestant& c) {
    return std::ranges::any_of(
        others, [&](const other_build::Clipper& other) { return is_same_clipper(c, other); });
  };
  for (const Contestant& c : all_contestants()) {
    if (c.contract != Contract::full || c.build != "scalar" || c.vertices < 2) continue;
    if (c.scalar() != "float" && c.scalar() != "double") continue;
    INFO(name_of(c));
    CHECK(is_compared(c));
  }
}

TEST_CASE("compiled: on random triangles contestants have the bits of another build") {
  for (const char* name : {"soup", "soup_straddling", "soup_behind"}) {
    const Scene scene = make_builtin_scene(name, {.seed = 3, .quick = true});
    for (const SampledView& v : sampled_views(scene, 2000)) {
      INFO(name);
      CHECK(check_bits(batch_of(v.view, v.triangles)) > 40);
    }
  }
}

TEST_CASE("compiled: on the catalogue contestants have the bits of another build") {
  std::size_t compared = 0;
  for (const HardCase& c : builtin_catalogue()) {
    const bool is_simplex = c.primitive == Primitive::triangle || c.primitive == Primitive::segment;
    if (!is_simplex || c.attribute_count != other_build::kAttributes) continue;
    INFO(c.name);
    const std::vector<double> numbers = numbers_of(c);
    compared += check_bits({.space = c.space,
                            .frustum = c.frustum,
                            .volume = c.volume,
                            .vertices = static_cast<int>(c.vertices.size()),
                            .attributes = c.attribute_count,
                            .numbers = std::span<const double>(numbers)});
  }
  CHECK(compared > 3000);
}

}  // namespace clipscope::experiments
