// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any scalar's value as the nearest float: what a renderer keeps of an answer computed in that scalar.
//
// Rounding by way of a double would round twice: a value just beside the middle between two floats
// could become that middle first. So the double picks the candidates, and the middle next to it is
// compared with the value itself, exactly.
#pragma once

#include <cmath>
#include <limits>

#include "experiments/contestants/scalars.hpp"

namespace clipscope::experiments {

// The float nearest to x, ties to even. NaN stays NaN; what overflows becomes infinite.
template <class T>
float nearest_float(const T& x) {
  const double approximation = nearest_double(x);
  const float f = static_cast<float>(approximation);
  if constexpr (ScalarTraits<T>::precision == 24 || ScalarTraits<T>::precision == 53) {
    return f;  // one rounding
  } else {
    if (!is_finite(x) || !std::isfinite(f)) return f;
    for (const float limit :
         {std::numeric_limits<float>::lowest(), std::numeric_limits<float>::max()}) {
      const float neighbour = std::nextafter(f, limit);
      const double middle = (double{f} + double{neighbour}) / 2;  // exact: 25 bits
      // The double is at most one of its units off; away from the middle the side is settled.
      if (std::abs(approximation - middle) > std::abs(middle) * 0x1p-50) continue;
      const Exact value = to_exact(x);
      const Exact exact_middle(middle);
      if (value == exact_middle) return static_cast<float>(middle);
      const bool beyond = limit < 0 ? value < exact_middle : exact_middle < value;
      if (beyond) return neighbour;
    }
    return f;
  }
}

}  // namespace clipscope::experiments
