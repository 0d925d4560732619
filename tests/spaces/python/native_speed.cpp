// SPDX-License-Identifier: GPL-3.0-or-later
//
// A C++ call to be timed beside the Python package's (measure_speed.py).
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "tests/spaces/python/native_loop.hpp"

namespace py = pybind11;

namespace clipscope::native {
namespace {

template <int K>
void clip_view(const float* from, std::size_t count, const Projection<float>& projection,
               Polygons<float>& to) {
  clip_all<HomogeneousSutherlandHodgman, Space::view, float, K>(from, count, projection, to);
}

// A C++ call with a reused output: homogeneous/sutherland_hodgman in float, view space,
// with 0, 2, 3, 4 or 8 attributes. Returns the number of vertices.
std::int64_t clip_reused(const py::array_t<float>& triangles, const std::vector<double>& frustum) {
  static Polygons<float> reused;
  const Projection<float> projection = projection_of<float>(frustum, 0, 0);
  const auto count = static_cast<std::size_t>(triangles.shape(0));
  const float* const data = triangles.data();
  switch (triangles.shape(2) - 3) {
    case 0: clip_view<0>(data, count, projection, reused); break;
    case 2: clip_view<2>(data, count, projection, reused); break;
    case 3: clip_view<3>(data, count, projection, reused); break;
    case 4: clip_view<4>(data, count, projection, reused); break;
    case 8: clip_view<8>(data, count, projection, reused); break;
    default: throw py::value_error("0, 2, 3, 4 or 8 attributes");
  }
  return reused.ends.back();
}

}  // namespace
}  // namespace clipscope::native

PYBIND11_MODULE(native_speed, module) {
  module.def("clip_reused", &clipscope::native::clip_reused);
}
