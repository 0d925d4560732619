// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hunt/prey.hpp"

#include <algorithm>

namespace clipscope::experiments::hunt {
namespace {

HardCase triangle_at(const Setting& setting, const Prey& prey, int attributes,
                     const std::array<std::size_t, 3>& vertices) {
  HardCase c;
  c.space = setting.space;
  c.frustum = frustum_cast<double>(setting.frustum);
  c.volume = setting.volume;
  c.attribute_count = attributes;
  for (const std::size_t i : vertices) {
    reference::InputVertex& v = c.vertices.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) v.position[k] = prey.position[i][k];
    for (std::size_t k = 0; k < static_cast<std::size_t>(attributes); ++k) {
      v.attributes[k] = prey.attributes[i][k];
    }
  }
  return c;
}

}  // namespace

void set_attributes(Prey& prey, int first) {
  for (std::size_t v = 0; v < Prey::kVertices; ++v) {
    for (int k = 0; k < Prey::kAttributes; ++k) {
      const int own = k - first;
      const bool is_one = own < 0 || own == 3 || own == static_cast<int>(v);
      prey.attributes[v][static_cast<std::size_t>(k)] = is_one ? 1.0f : 0.0f;
    }
  }
}

Setting setting_of(const HardCase& c) {
  return {c.space, frustum_cast<float>(c.frustum), c.volume};
}

Prey prey_of(const HardCase& c) {
  Prey prey;
  for (std::size_t i = 0; i < Prey::kVertices; ++i) {
    const reference::InputVertex& v = c.vertices[std::min<std::size_t>(i, 2)];
    for (std::size_t k = 0; k < 4; ++k) prey.position[i][k] = static_cast<float>(v.position[k]);
    for (std::size_t k = 0; k < Prey::kAttributes; ++k) {
      prey.attributes[i][k] = static_cast<float>(v.attributes[k]);
    }
  }
  return prey;
}

HardCase case_of(const Setting& setting, const Prey& prey, int attributes) {
  return triangle_at(setting, prey, attributes, {0, 1, 2});
}

HardCase neighbour_of(const Setting& setting, const Prey& prey, int attributes) {
  Prey turned = prey;
  for (std::size_t k = 0; k < Prey::kAttributes; ++k) {
    std::swap(turned.attributes[0][k], turned.attributes[1][k]);
    turned.attributes[3][k] = prey.attributes[2][k];
  }
  return triangle_at(setting, turned, attributes, {1, 0, 3});
}

}  // namespace clipscope::experiments::hunt
