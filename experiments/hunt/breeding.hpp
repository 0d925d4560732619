// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where prey comes from: chance, the neighbourhood of planes and vertices, what was worst so far.
//
// All numbers are finite floats, coordinates of both signs and of all exponents.
#pragma once

#include <optional>

#include "experiments/contestants/contestant.hpp"
#include "experiments/hunt/prey.hpp"
#include "experiments/scenes/random.hpp"

namespace clipscope::experiments::hunt {

// What is left out.
struct SettingLimits {
  std::optional<Space> space = {};  // nothing but this
  bool is_plain = false;            // the closed volume of six planes alone
  bool has_distances = true;        // clip distances may be among the options

  bool allow(const Setting& setting) const {
    return (!space || setting.space == *space) &&
           (!is_plain || clipscope::is_plain(setting.volume)) &&
           (has_distances || setting.volume.clip_distances == 0);
  }
};

// What the contestant takes: either space, any of some frusta, depth range and options.
Setting random_setting(const Contestant& contestant, int attributes, const SettingLimits& limits,
                       Random& random);

// Whether the contestant takes triangles with so many attributes there.
bool takes(const Contestant& contestant, const Setting& setting, int attributes);

// Anywhere: around the volume, far outside, over all exponents, beside planes, in a side, across
// all planes, slivers, small whole numbers.
Prey random_prey(const Setting& setting, Random& random);

// One to some changes: ulps of a coordinate, bits of its mantissa, its exponent, its sign; a
// coordinate that becomes another one or goes to a plane; a vertex that is scaled or moves towards
// another. `attributes`: so many of them change, too.
Prey mutated(const Setting& setting, Prey prey, int attributes, Random& random);

// Each vertex of one of both.
Prey crossed(const Prey& a, const Prey& b, Random& random);

}  // namespace clipscope::experiments::hunt
