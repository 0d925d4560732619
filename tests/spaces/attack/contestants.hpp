// SPDX-License-Identifier: GPL-3.0-or-later
//
// The correctly rounded clipper in all its forms: contracts, layouts, instruction sets.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/spaces/attack/input.hpp"

namespace clipscope::attack {

enum class Contract { ndc, stage };

// Polygons of a batch, 4 + attributes floats for each vertex, by the number of the triangle.
using Polygons = std::vector<std::vector<float>>;

struct Contestant {
  std::string name;
  Contract contract;
  std::function<bool(const Batch&)> takes;
  std::function<Polygons(const Batch&)> clip;
};

// The clipper of one triangle (scalar_contestants.cpp), and the batch clippers in plain C++ and on
// each instruction set that this processor has (batch_contestants.cpp).
std::vector<Contestant> scalar_contestants();
std::vector<Contestant> batch_contestants();

// Those that a program is made for.
std::vector<Contestant> contestants();

// Whether a batch is in view space, or in clip space.
inline bool takes_view(const Batch& batch) { return batch.is_view(); }
inline bool takes_clip(const Batch& batch) { return !batch.is_view(); }

}  // namespace clipscope::attack
