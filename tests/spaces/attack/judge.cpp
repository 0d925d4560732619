// SPDX-License-Identifier: GPL-3.0-or-later
//
// See judge.hpp.
#include "tests/spaces/attack/judge.hpp"

#include <algorithm>
#include <bit>

#include "tests/spaces/attack/integer_clip.hpp"

namespace clipscope::attack {
namespace {

std::vector<std::uint32_t> words_of(std::span<const float> floats) {
  std::vector<std::uint32_t> r;
  for (const float x : floats) r.push_back(std::bit_cast<std::uint32_t>(x));
  return r;
}

const std::vector<float>& of(const Answer& answer, Contract contract) {
  return contract == Contract::ndc ? answer.ndc : answer.stage;
}

}  // namespace

Tally& Tally::operator+=(const Tally& other) {
  facts += other.facts;
  triangles += other.triangles;
  floats += other.floats;
  answers += other.answers;
  return *this;
}

bool is_same_polygon(std::span<const float> a, std::span<const float> b, std::size_t stride) {
  if (a.size() != b.size()) return false;
  const std::vector<std::uint32_t> words = words_of(a);
  std::vector<std::uint32_t> turned = words_of(b);
  for (std::size_t first = 0; first == 0 || first < a.size(); first += stride) {
    if (words == turned) return true;
    const auto next = turned.begin() + static_cast<std::ptrdiff_t>(turned.empty() ? 0 : stride);
    std::rotate(turned.begin(), next, turned.end());
  }
  return false;
}

std::optional<Failure> judge(const Batch& batch, std::span<const Contestant> contestants,
                             Tally& tally) {
  std::vector<Answer> answers;
  for (std::size_t t = 0; t < batch.triangles(); ++t) {
    answers.push_back(exact_answer(batch, t, tally.facts));
  }
  tally.triangles += static_cast<std::int64_t>(batch.triangles());
  const std::size_t stride = 4 + static_cast<std::size_t>(batch.attributes);
  for (const Contestant& contestant : contestants) {
    if (!contestant.takes(batch)) continue;
    const Polygons polygons = contestant.clip(batch);
    for (std::size_t t = 0; t < batch.triangles(); ++t) {
      const std::vector<float>& exact = of(answers[t], contestant.contract);
      if (!is_same_polygon(polygons[t], exact, stride)) {
        return Failure{contestant.name, batch, t, polygons[t], exact};
      }
      tally.floats += static_cast<std::int64_t>(exact.size());
      ++tally.answers;
    }
  }
  return {};
}

}  // namespace clipscope::attack
