// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/variants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "experiments/guests/conduct.hpp"

namespace clipscope::experiments {
namespace {

constexpr int kRoom = 40;

bool leaves_room(double x) { return x == 0 || std::abs(std::ilogb(x)) <= kRoom; }

bool has_room(const Vec4<double>& row) {
  return leaves_room(row[0]) && leaves_room(row[1]) && leaves_room(row[2]) && leaves_room(row[3]);
}

bool has_room(const Frustum<double>& f) {
  return std::ranges::all_of(std::array{f.left, f.right, f.bottom, f.top, f.near,
                                        f.infinite_far ? 0 : f.far, f.shear_x, f.shear_y},
                             leaves_room);
}

// What the triangles are clipped against, as far as it has numbers.
bool surroundings_have_room(const Batch& batch) {
  if (!batch.matrix) return batch.space == Space::clip || has_room(batch.frustum);
  const auto row_has_room = [](const Vec4<double>& row) { return has_room(row); };
  return std::ranges::all_of(*batch.matrix, row_has_room);
}

}  // namespace

Variant::Variant(const Batch& original) : batch_(original) {
  numbers_.resize(original.size() * 3 * original.stride());
  for (std::size_t i = 0; i < numbers_.size(); ++i) numbers_[i] = original.number(i);
  batch_.numbers = std::span<const double>(numbers_);
}

Variant::Variant(const Batch& description, std::vector<double> numbers)
    : numbers_(std::move(numbers)), batch_(description) {
  batch_.numbers = std::span<const double>(numbers_);
}

std::vector<char> room_of(const Batch& batch) {
  std::vector<char> room(batch.size(), surroundings_have_room(batch));
  const std::size_t numbers = 3 * batch.stride();
  for (std::size_t i = 0; i < room.size() * numbers; ++i) {
    if (!leaves_room(batch.number(i))) room[i / numbers] = false;
  }
  return room;
}

Variant rotated(const Batch& batch, std::size_t by) {
  Variant variant(batch);
  const std::size_t stride = batch.stride();
  for (std::size_t t = 0; t < batch.size(); ++t) {
    for (std::size_t i = 0; i < 3 * stride; ++i) {
      variant.number(t, 0, i) = batch.number(3 * t * stride + (i + by * stride) % (3 * stride));
    }
  }
  return variant;
}

Variant scaled(const Batch& batch, const std::vector<char>& has_room) {
  Variant variant(batch);
  Batch& larger = variant.batch();
  Frustum<double>& f = larger.frustum;
  for (double* length : {&f.near, &f.far, &f.left, &f.right, &f.bottom, &f.top}) {
    *length = std::ldexp(*length, kScaleExponent);
  }
  if (larger.matrix) {
    for (Vec4<double>& row : *larger.matrix) row[3] = std::ldexp(row[3], kScaleExponent);
  }
  if (larger.space == Space::view) {
    for (auto& plane : larger.planes) plane[3] = std::ldexp(plane[3], kScaleExponent);
  }
  for (std::size_t t = 0; t < batch.size(); ++t) {
    for (std::size_t i = 0; has_room[t] && i < 3 * static_cast<std::size_t>(batch.dimension());
         ++i) {
      double& x = variant.number(t, i % 3, i / 3);
      x = std::ldexp(x, kScaleExponent);
    }
  }
  return variant;
}

Variant with_constants(const Batch& batch, const std::vector<double>& values) {
  Variant variant(batch);
  const std::size_t first = batch.stride() - values.size();
  for (std::size_t v = 0; v < 3 * batch.size(); ++v) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      variant.number(v / 3, v % 3, first + i) = values[i];
    }
  }
  return variant;
}

Variant marked(const Batch& batch, const std::vector<char>& has_room, double mark) {
  Variant variant(batch);
  for (std::size_t t = 0; t < batch.size(); ++t) {
    for (std::size_t v = 0; has_room[t] && v < 3; ++v) {
      variant.number(t, v, batch.stride() - 1) = v == 2 ? mark : 0;
    }
  }
  return variant;
}

Variant neighbours(const Batch& batch, const std::vector<char>& has_room, bool as_floats) {
  Variant variant(batch);
  for (std::size_t t = 0; t < batch.size(); ++t) {
    if (!has_room[t]) continue;
    for (std::size_t i = 0; i < batch.stride(); ++i) {
      std::swap(variant.number(t, 0, i), variant.number(t, 1, i));
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(batch.dimension()); ++i) {
      double& x = variant.number(t, 2, i);
      x = variant.number(t, 1, i) + variant.number(t, 0, i) - x;
      if (as_floats) x = static_cast<float>(x);
    }
  }
  return variant;
}

Variant reversed(const Batch& batch) { return {batch, reversed_numbers(batch)}; }

Variant alone(const Batch& batch, std::size_t triangle) {
  Batch one = batch;
  const std::size_t numbers = 3 * batch.stride();
  std::visit([&](const auto& all) { one.numbers = all.subspan(triangle * numbers, numbers); },
             batch.numbers);
  return Variant(one);
}

}  // namespace clipscope::experiments
