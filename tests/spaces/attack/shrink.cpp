// SPDX-License-Identifier: GPL-3.0-or-later
//
// A failure made simpler, and in words; see judge.hpp.
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>

#include "tests/spaces/attack/judge.hpp"

namespace clipscope::attack {
namespace {

std::string text(float x) {
  std::array<char, 40> buffer;
  std::snprintf(buffer.data(), buffer.size(), "%a", static_cast<double>(x));
  return buffer.data();
}

// Simpler floats that could take the place of one: small whole numbers, fewer bits.
std::vector<float> simpler(float x) {
  std::vector<float> r;
  for (const float whole : {0.0f, 1.0f, -1.0f, 2.0f, -2.0f}) {
    if (x == whole) return r;
    r.push_back(whole);
  }
  const auto word = std::bit_cast<std::uint32_t>(x);
  for (const int dropped : {20, 12, 6, 3, 1}) {
    const std::uint32_t fewer = word >> dropped << dropped;
    if (fewer != word) r.push_back(std::bit_cast<float>(fewer));
  }
  return r;
}

std::optional<Failure> failure_of(const Batch& batch, const Contestant& contestant) {
  Tally unused;
  return judge(batch, {&contestant, 1}, unused);
}

// Tries all simpler floats in all places once; whether one did.
bool shrink_once(Failure& failure, const Contestant& contestant) {
  bool any = false;
  for (std::size_t i = 0; i < failure.batch.floats.size(); ++i) {
    for (const float x : simpler(failure.batch.floats[i])) {
      Batch batch = failure.batch;
      batch.floats[i] = x;
      if (auto smaller = failure_of(batch, contestant)) {
        failure = *smaller;
        any = true;
        break;
      }
    }
  }
  return any;
}

std::string space_of(const Batch& batch) {
  constexpr std::array<const char*, 3> kDepths = {"gl", "zero_to_one", "reversed"};
  const std::string depth = kDepths[static_cast<std::size_t>(batch.volume.depth)];
  if (!batch.is_view()) return "space clip " + depth;
  const Frustum& f = *batch.frustum;
  std::string r = f.is_perspective ? "space view perspective" : "space view parallel";
  for (const float bound : {f.left, f.right, f.bottom, f.top, f.near}) r += ' ' + text(bound);
  r += f.is_infinite ? " inf" : ' ' + text(f.far);
  if (!f.is_perspective) r += ' ' + text(f.shear_x) + ' ' + text(f.shear_y);
  return r + ' ' + depth;
}

std::string options_of(const Volume& v) {
  std::string r;
  if (v.clamps_near || v.clamps_far) {
    r += "depth_clamp";
    if (!v.clamps_far) r += " near";
    if (!v.clamps_near) r += " far";
    r += '\n';
  }
  if (v.clip_distances != 0) r += "clip_distances " + std::to_string(v.clip_distances) + '\n';
  if (v.is_open == std::array{false, false, false, false}) return r;
  constexpr std::array<const char*, 4> kSides = {" left", " right", " bottom", " top"};
  r += "half_open";
  for (std::size_t i = 0; i < 4; ++i) {
    if (v.is_open[i]) r += kSides[i];
  }
  return r + '\n';
}

std::string rows(const std::vector<float>& floats, std::size_t stride, const std::string& word) {
  std::string r;
  for (std::size_t i = 0; i < floats.size(); ++i) {
    if (i % stride == 0) r += word;
    r += ' ' + text(floats[i]);
    if (i % stride == stride - 1) r += '\n';
  }
  return floats.empty() ? word + " nothing\n" : r;
}

}  // namespace

Failure shrunk(const Failure& failure, std::span<const Contestant> contestants) {
  for (const Contestant& contestant : contestants) {
    if (contestant.name != failure.contestant) continue;
    auto alone = failure_of(failure.batch.only(failure.triangle), contestant);
    if (!alone) return failure;
    while (shrink_once(*alone, contestant)) {
    }
    return *alone;
  }
  return failure;
}

std::string describe(const Failure& failure) {
  const Batch& batch = failure.batch;
  const std::size_t stride = 4 + static_cast<std::size_t>(batch.attributes);
  std::string r = "# " + failure.contestant + ", triangle " + std::to_string(failure.triangle) +
                  " of " + std::to_string(batch.triangles()) +
                  "\ncase misrounded\nprimitive triangle\n" + space_of(batch) + '\n' +
                  options_of(batch.volume);
  for (std::size_t v = 0; v < 3; ++v) {
    const float* p = batch.vertex(failure.triangle, v);
    r += "vertex";
    for (std::size_t i = 0; i < batch.stride(); ++i) {
      if (i == batch.dimension()) r += " |";
      r += ' ' + text(p[i]);
    }
    r += '\n';
  }
  return r + rows(failure.computed, stride, "# computed") +
         rows(failure.exact, stride, "# exact   ");
}

}  // namespace clipscope::attack
