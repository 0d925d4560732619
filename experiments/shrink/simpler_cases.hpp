// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is simpler than a case, and by how much.
#pragma once

#include <cstddef>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"

namespace clipscope::experiments {

// The bits from the first to the last that is set: 1 for powers of two, at most 24 for a float; 0
// for 0.
int significant_bits(double x);

// The largest number of significant bits of a coordinate.
int significant_bits(const HardCase& hard_case);

// How much there is to a case: what the header of shrink.hpp calls smaller costs less. A
// significant bit costs more than any exponent.
double cost_of(const HardCase& hard_case);

// A change of one coordinate of one vertex.
struct CoordinateChange {
  std::size_t vertex = 0, coordinate = 0;
  double value = 0;

  HardCase of(HardCase hard_case) const {
    hard_case.vertices[vertex].position[coordinate] = value;
    return hard_case;
  }
};

// Values simpler than a coordinate, for each coordinate: 0, 1, powers of two, fewer bits, whole
// numbers, those of its vertex and of its neighbours.
std::vector<CoordinateChange> simpler_coordinates(const HardCase& hard_case);

// The case as a whole simpler: without an option, attributes or a matrix, in the standard frustum,
// scaled by a power of two, all coordinates with fewer bits, exactly rounded and, since rounding
// errors come and go, a few units beside that.
std::vector<HardCase> simpler_wholes(const HardCase& hard_case);

}  // namespace clipscope::experiments
