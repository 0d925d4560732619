// SPDX-License-Identifier: GPL-3.0-or-later
//
// Answers and contestants made by hand.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "experiments/contestants/contestant.hpp"

namespace clipscope::experiments {

// One polygon of typed vertices.
template <class Vertices>
Answers answer_of(const Vertices& vertices) {
  using T = std::remove_cvref_t<decltype(vertices.begin()->position[0])>;
  const int attributes = vertices.empty() ? kSceneAttributes : vertices.begin()->attributes.size();
  Answers answers(kFormat<T>, 4 + static_cast<std::size_t>(attributes));
  add_polygon(vertices, answers);
  return answers;
}

// The numbers of a polygon, vertex by vertex.
using Numbers = std::vector<std::vector<double>>;

inline Numbers numbers_of(const PolygonView& polygon) {
  Numbers numbers;
  for (const VertexView& v : polygon) {
    auto& vertex = numbers.emplace_back();
    for (std::size_t k = 0; k < v.size(); ++k) vertex.push_back(v[k].value);
  }
  return numbers;
}

inline void add_polygon(const Numbers& polygon, Answers& answers) {
  for (const auto& vertex : polygon) {
    for (const double x : vertex) answers.add(x);
  }
  answers.end_polygon();
}

class AlteredRunner final : public Runner {
 public:
  AlteredRunner(std::unique_ptr<Runner> honest, std::function<void(Numbers&)> change)
      : honest_(std::move(honest)), change_(std::move(change)) {}

  void clip(std::size_t batch, std::size_t first, std::size_t count) override {
    honest_->clip(batch, first, count);
  }
  Answers answers() const override {
    const Answers honest = honest_->answers();
    Answers answers(honest.format(), honest.stride());
    for (std::size_t i = 0; i < honest.size(); ++i) {
      Numbers polygon = numbers_of(honest[i]);
      change_(polygon);
      add_polygon(polygon, answers);
    }
    return answers;
  }

 private:
  std::unique_ptr<Runner> honest_;
  std::function<void(Numbers&)> change_;
};

// The contestant with each polygon of its answers changed. In float or double.
inline Contestant altered(const Contestant& honest, std::function<void(Numbers&)> change) {
  Contestant liar = honest;
  liar.prepare = [&honest, change](std::span<const Batch> batches) -> std::unique_ptr<Runner> {
    return std::make_unique<AlteredRunner>(honest.prepare(batches), change);
  };
  return liar;
}

}  // namespace clipscope::experiments
