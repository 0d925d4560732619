// SPDX-License-Identifier: GPL-3.0-or-later
//
// A hard case as the input of a clipper in scalar T: each number is rounded to T once, and none is where
// T holds floats.
#pragma once

#include <algorithm>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/contestants/scalars.hpp"
#include "spaces/projection.hpp"
#include "spaces/vertex.hpp"

namespace clipscope::experiments {

// Pre-condition: S is the case's space.
template <class T, Space S>
std::vector<Vertex<S, T, kRunTime>> case_vertices(const HardCase& hard_case) {
  std::vector<Vertex<S, T, kRunTime>> vertices;
  for (const reference::InputVertex& source : hard_case.vertices) {
    Vertex<S, T, kRunTime>& v = vertices.emplace_back();
    for (int i = 0; i < Vertex<S, T, kRunTime>::kDimension; ++i) {
      v.position[i] = scalar_from<T>(source.position[static_cast<std::size_t>(i)]);
    }
    v.attributes.resize(hard_case.attribute_count);
    for (int k = 0; k < hard_case.attribute_count; ++k) {
      v.attributes[k] = scalar_from<T>(source.attributes[static_cast<std::size_t>(k)]);
    }
  }
  return vertices;
}

// Pre-conditions: S is the case's space, and it has N vertices.
template <class T, Space S, std::size_t N>
Simplex<S, T, kRunTime, N> case_simplex(const HardCase& hard_case) {
  Simplex<S, T, kRunTime, N> simplex;
  std::ranges::copy(case_vertices<T, S>(hard_case), simplex.begin());
  return simplex;
}

// The projection with the case's volume; of use in view space.
template <class T>
Projection<T> case_projection(const HardCase& hard_case) {
  auto projection = projection_from<T>(hard_case.frustum);
  projection.volume = hard_case.volume;
  return projection;
}

}  // namespace clipscope::experiments
