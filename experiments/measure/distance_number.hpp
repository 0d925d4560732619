// SPDX-License-Identifier: GPL-3.0-or-later
//
// The number type that distances between an answer and the truth are computed in: double-double where that
// is much finer than the answer's scalar, exact rationals for wider scalars.
#pragma once

#include <concepts>
#include <type_traits>

#include "experiments/contestants/scalars.hpp"

namespace clipscope::experiments {

template <class T>
using DistanceNumber =
    std::conditional_t<(ScalarTraits<T>::precision > 0 && ScalarTraits<T>::precision <= 53),
                       dd_real, Exact>;

// The value in N: exactly, or with an error of some 2^-104.
template <class N>
N distance_number(const Exact& x) {
  if constexpr (std::same_as<N, Exact>) {
    return x;
  } else {
    const double high = CGAL::to_double(x);
    const Exact rest = x - Exact(high);
    return dd_real(high) + dd_real(CGAL::to_double(rest));
  }
}

}  // namespace clipscope::experiments
