// SPDX-License-Identifier: MIT
//
// clipscope._clipscope: the clippers for Python. The package around it checks what users give, so
// that what arrives here has the right shape and type.
#include <pybind11/stl.h>

#include <array>
#include <string>

#include "spaces/python/call.hpp"
#include "spaces/python/instances.hpp"

namespace clipscope::python {
namespace {

// What is clipped against, as the package passes it on.
struct Against {
  int depth = 0;  // a DepthRange
  std::array<bool, 2> depth_clamp = {};
  int clip_distances = 0;
  std::array<bool, 4> open_sides = {};
  bool is_parallel = false;
  std::vector<double> frustum;  // left right bottom top near far shear_x shear_y, or nothing
  std::vector<double> matrix;   // 16 numbers by rows, or nothing
  std::array<double, 2> point_half_size = {};
};

ClipVolume volume_of(const Against& a) {
  return {static_cast<DepthRange>(a.depth), DepthClamp(a.depth_clamp[0], a.depth_clamp[1]),
          a.clip_distances,
          OpenSides(a.open_sides[0], a.open_sides[1], a.open_sides[2], a.open_sides[3])};
}

template <class T>
Projection<T> projection_of(const Against& a) {
  const std::vector<double>& n = a.frustum;
  Frustum<double> frustum{a.is_parallel ? ProjectionKind::parallel : ProjectionKind::perspective,
                          n[0],
                          n[1],
                          n[2],
                          n[3],
                          n[4],
                          n[5]};
  frustum.infinite_far = std::isinf(frustum.far);
  if (frustum.infinite_far) frustum.far = 0;
  frustum.shear_x = n[6];
  frustum.shear_y = n[7];
  frustum.depth = static_cast<DepthRange>(a.depth);
  Projection<T> projection(frustum_cast<T>(frustum));
  projection.volume = volume_of(a);
  return projection;
}

template <class T>
Task<T> task_of(const py::array& positions, const py::array& attributes, const Against& against) {
  Task<T> task;
  task.count = static_cast<std::size_t>(positions.shape(0));
  task.positions = layout_of(positions);
  task.attributes = layout_of(attributes);
  task.attribute_count = static_cast<int>(attributes.shape(2));
  task.volume = volume_of(against);
  if (!against.frustum.empty()) task.projection = projection_of<T>(against);
  if (!against.matrix.empty()) {
    task.matrix.emplace();
    for (std::size_t i = 0; i < 16; ++i) {
      (*task.matrix)[i / 4][static_cast<int>(i % 4)] = static_cast<T>(against.matrix[i]);
    }
  }
  task.point_size = {static_cast<T>(against.point_half_size[0]),
                     static_cast<T>(against.point_half_size[1])};
  return task;
}

// The instance with the least room for the task's numbers; null where the clipper does not take it.
template <class T>
ClipRange<T> find_range(const std::string& clipper, int vertices, const Task<T>& task) {
  const Instance<T>* best = nullptr;
  for (const Instance<T>& i : all_instances<T>()) {
    if (i.name != clipper || i.vertices != vertices) continue;
    const bool fits = i.attributes == kRunTime || i.attributes >= task.numbers();
    const bool is_better = best == nullptr || best->attributes == kRunTime ||
                           (i.attributes != kRunTime && i.attributes < best->attributes);
    if (fits && is_better) best = &i;
  }
  if (best == nullptr) return nullptr;
  return task.projection ? best->in_view_space : best->in_clip_space;
}

// Memory for results in each scalar.
struct Output {
  Pool<Rows<float>> floats;
  Pool<Rows<double>> doubles;

  Pool<Rows<float>>& pool(float) { return floats; }
  Pool<Rows<double>>& pool(double) { return doubles; }
};

// A thread is worth its start from so many primitives on.
constexpr std::size_t kLeastOfThread = 1024;

// clip(first, last, rows) over all primitives, in threads.
template <class T, class F>
std::shared_ptr<Rows<T>> clip_in_threads(std::size_t count, std::size_t stride, int threads,
                                         Output& output, const F& clip) {
  const std::shared_ptr<Rows<T>> rows = output.pool(T()).take();
  const py::gil_scoped_release release;
  const std::vector<std::size_t> begins = parts_of(count, threads, kLeastOfThread);
  std::vector<Rows<T>> others(begins.size() - 2);
  in_threads(begins.size() - 1, [&](std::size_t part) {
    Rows<T>& to = part == 0 ? *rows : others[part - 1];
    to.begin(stride, begins[part + 1] - begins[part]);
    clip(begins[part], begins[part + 1], to);
  });
  for (const Rows<T>& other : others) rows->append(other);
  return rows;
}

// (rows, offsets, source).
template <class T>
py::tuple arrays_of(const std::shared_ptr<Rows<T>>& rows) {
  return py::make_tuple(rows_of_numbers(rows->numbers.data(), rows->vertices, rows->stride, rows),
                        view_of(rows->offsets.data(), rows->offsets.size(), rows),
                        view_of(rows->source.data(), rows->source.size(), rows));
}

struct Options {
  std::string clipper;
  bool weights = true;
  int threads = 1;
};

template <class T>
py::object clip_in(const py::array& positions, const py::array& attributes, const Against& against,
                   const Options& options, Output& output) {
  Task<T> task = task_of<T>(positions, attributes, against);
  const auto vertices = static_cast<int>(positions.shape(1));
  task.weights = options.weights ? vertices : 0;
  const ClipRange<T> range = find_range(options.clipper, vertices, task);
  if (range == nullptr) return py::none();
  return arrays_of(clip_in_threads<T>(
      task.count, static_cast<std::size_t>(4 + task.numbers()), options.threads, output,
      [&](std::size_t first, std::size_t last, Rows<T>& to) { range(task, first, last, to); }));
}

// Positions: (primitives, vertices of each, 3 or 4), attributes: (primitives, vertices, k), both
// float or both double. None where the clipper does not take that.
py::object clip(const py::array& positions, const py::array& attributes, const Against& against,
                const Options& options, Output& output) {
  if (positions.itemsize() == sizeof(float)) {
    return clip_in<float>(positions, attributes, against, options, output);
  }
  return clip_in<double>(positions, attributes, against, options, output);
}

template <class T>
py::tuple clip_polygons_in(const py::array& positions, const py::array& attributes,
                           const py::array_t<std::int64_t>& ends, const Against& against,
                           int threads, Output& output) {
  const Task<T> task = task_of<T>(positions, attributes, against);
  return arrays_of(clip_in_threads<T>(
      static_cast<std::size_t>(ends.size()), static_cast<std::size_t>(4 + task.numbers()), threads,
      output, [&, from = ends.data()](std::size_t first, std::size_t last, Rows<T>& to) {
        clip_polygons(task, from, first, last, to);
      }));
}

// Positions: (vertices, 1, 3 or 4) and so on; polygon i ends before vertex ends[i].
py::tuple clip_polygons_of(const py::array& positions, const py::array& attributes,
                           const py::array_t<std::int64_t>& ends, const Against& against,
                           int threads, Output& output) {
  if (positions.itemsize() == sizeof(float)) {
    return clip_polygons_in<float>(positions, attributes, ends, against, threads, output);
  }
  return clip_polygons_in<double>(positions, attributes, ends, against, threads, output);
}

void add_structs(py::module_& module) {
  py::class_<Against>(module, "Against")
      .def(py::init<>())
      .def_readwrite("depth", &Against::depth)
      .def_readwrite("depth_clamp", &Against::depth_clamp)
      .def_readwrite("clip_distances", &Against::clip_distances)
      .def_readwrite("open_sides", &Against::open_sides)
      .def_readwrite("is_parallel", &Against::is_parallel)
      .def_readwrite("frustum", &Against::frustum)
      .def_readwrite("matrix", &Against::matrix)
      .def_readwrite("point_half_size", &Against::point_half_size);
  py::class_<Options>(module, "Options")
      .def(py::init([](std::string clipper, bool weights, int threads) {
        return Options{std::move(clipper), weights, threads};
      }));
  py::class_<Output>(module, "Output").def(py::init<>());
  py::class_<Description>(module, "Description")
      .def_readonly("name", &Description::name)
      .def_readonly("summary", &Description::summary)
      .def_readonly("source", &Description::source)
      .def_readonly("vertices", &Description::vertices)
      .def_readonly("clip_space", &Description::clip_space)
      .def_readonly("in_double", &Description::in_double)
      .def_property_readonly("depth_clamp",
                             [](const Description& d) { return d.promise.depth_clamp; })
      .def_property_readonly("clip_distances",
                             [](const Description& d) { return d.promise.clip_distances; })
      .def_property_readonly("open_sides",
                             [](const Description& d) { return d.promise.open_sides; });
}

}  // namespace
}  // namespace clipscope::python

PYBIND11_MODULE(_clipscope, module) {
  using namespace clipscope::python;
  module.doc() = "The clippers of clipscope, compiled; see the package clipscope.";
  add_structs(module);
  module.attr("MOST_ATTRIBUTES") = clipscope::kMaxAttributes;
  module.attr("MOST_CLIP_DISTANCES") = clipscope::kMaxClipDistances;
  module.def("descriptions", &all_descriptions);
  module.def("clip", &clip);
  module.def("clip_polygons", &clip_polygons_of);
  add_batch(module);
}
