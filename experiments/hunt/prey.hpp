// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a hunt breeds: primitives that are clipped against one setting.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/contestants/batch.hpp"
#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments::hunt {

// What a triangle is clipped against.
struct Setting {
  Space space = Space::clip;
  Frustum<float> frustum = {};  // of view space
  ClipVolume volume = {};

  friend bool operator==(const Setting& a, const Setting& b) {
    return a.space == b.space && a.volume == b.volume &&
           (a.space == Space::clip || a.frustum == b.frustum);
  }
  int dimension() const { return space == Space::view ? 3 : 4; }
};

// A triangle; for `crack` its neighbour, too: the triangles 0 1 2 and 1 0 3.
struct Prey {
  static constexpr std::size_t kVertices = 4;
  static constexpr int kAttributes = kSceneAttributes;

  std::array<std::array<float, 4>, kVertices> position{};
  std::array<std::array<float, kAttributes>, kVertices> attributes{};
  double value = 0;  // of the measure
};

// The attributes of every prey that nobody changed: those that a hard case is given where it has
// none (hard_case.hpp), behind `first` that are 1: clip distances, which cut nothing then.
void set_attributes(Prey& prey, int first);

// What a case of a triangle is clipped against, and it as prey, whose neighbour's third vertex is
// its own. Pre-condition: floats in front of a frustum or in clip space.
Setting setting_of(const HardCase& hard_case);
Prey prey_of(const HardCase& hard_case);

// The triangle of a prey as a case, with `attributes` of its attributes, those first.
HardCase case_of(const Setting& setting, const Prey& prey, int attributes);

// Its neighbour, whose vertices have the attributes of those of the triangle, one after the other.
HardCase neighbour_of(const Setting& setting, const Prey& prey, int attributes);

}  // namespace clipscope::experiments::hunt
