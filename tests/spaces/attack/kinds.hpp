// SPDX-License-Identifier: GPL-3.0-or-later
//
// The kinds of input that a correctly rounded clipper is attacked with.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tests/spaces/attack/dice.hpp"
#include "tests/spaces/attack/facts.hpp"
#include "tests/spaces/attack/input.hpp"

namespace clipscope::attack {

struct Kind {
  std::string_view name, what;
  Batch (*make)(Dice&);
  // What the kind is there for: each has to come about in every run.
  std::vector<Fact> reaches;
};

// Sixteen. Each makes clip space and view space, but for odd_frusta, which is about view space.
std::span<const Kind> all_kinds();

Batch subnormals(Dice& dice);
Batch exact_ties(Dice& dice);
Batch next_to_ties(Dice& dice);
Batch inverse_w_at_overflow(Dice& dice);
Batch underflowing_quotients(Dice& dice);
Batch ulps_from_planes(Dice& dice);
Batch through_the_eye(Dice& dice);
Batch slivers(Dice& dice);
Batch signed_zeros(Dice& dice);
Batch odd_frusta(Dice& dice);
Batch clip_distances(Dice& dice);
Batch depth_clamp(Dice& dice);
Batch extents(Dice& dice);
Batch degenerate_corners(Dice& dice);
Batch cancelling_coordinates(Dice& dice);
Batch extreme_attributes(Dice& dice);

}  // namespace clipscope::attack
