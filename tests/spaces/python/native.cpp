// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the Python package is held against: the C++ clippers, called as a C++ program calls them, in
// native_loop.hpp.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>

#include "tests/spaces/python/native_loop.hpp"

namespace py = pybind11;

namespace clipscope::native {
namespace {

// (numbers (v, 8), ends (n,)) of triangles of four attributes: by the clipper so called, in view
// space, or in clip space where the frustum is empty.
template <class T>
py::object clip(const std::string& name, const py::array_t<T>& triangles,
                const std::vector<double>& frustum, int depth, int clip_distances) {
  constexpr int kAttributes = 4;
  const auto count = static_cast<std::size_t>(triangles.shape(0));
  Polygons<T> polygons;
  bool found = false;
  for_each_type(AllClippers{}, [&]<class C>() {
    if (C::name != name) return;
    if constexpr (ClipsViewSpace<C, T, kAttributes>) {
      if (!frustum.empty()) {
        clip_all<C, Space::view, T, kAttributes>(
            triangles.data(), count, projection_of<T>(frustum, depth, clip_distances), polygons);
        found = true;
      }
    }
    if constexpr (ClipsClipSpace<C, T, kAttributes>) {
      if (frustum.empty()) {
        const ClipVolume volume{.depth = static_cast<DepthRange>(depth),
                                .clip_distances = clip_distances};
        clip_all<C, Space::clip, T, kAttributes>(triangles.data(), count, volume, polygons);
        found = true;
      }
    }
  });
  if (!found) return py::none();
  const std::int64_t vertices = count == 0 ? 0 : polygons.ends.back();
  return py::make_tuple(
      py::array_t<T>({static_cast<py::ssize_t>(vertices), static_cast<py::ssize_t>(8)},
                     polygons.numbers.data()),
      py::array_t<std::int64_t>(static_cast<py::ssize_t>(count), polygons.ends.data()));
}

}  // namespace
}  // namespace clipscope::native

PYBIND11_MODULE(native, module) {
  module.def("clip_float", &clipscope::native::clip<float>);
  module.def("clip_double", &clipscope::native::clip<double>);
}
