// SPDX-License-Identifier: MIT
//
// The batch clippers for Python: arrays are read where they are, results are looked at where the
// library left them.
#include "spaces/batch/batch.hpp"

#include <pybind11/stl.h>

#include "spaces/batch/methods.hpp"
#include "spaces/python/call.hpp"

namespace clipscope::python {
namespace {

// What a call leaves: of one thread the library's own output, of several the parts put together.
struct BatchResult {
  std::vector<batch::Output> parts;
  Buffer<std::uint32_t> inside;
  Buffer<batch::PolygonEnd> polygons;
  Buffer<float> vertices;

  void join(const std::vector<std::size_t>& begins) {
    inside.clear();
    polygons.clear();
    vertices.clear();
    std::uint32_t end = 0;
    for (std::size_t i = 0; i + 1 < begins.size(); ++i) {
      const batch::Output& part = parts[i];
      const auto first = static_cast<std::uint32_t>(begins[i]);
      inside.room(part.inside().size());
      polygons.room(part.polygons().size());
      for (const std::uint32_t t : part.inside()) inside.push_back(first + t);
      for (const batch::PolygonEnd& p : part.polygons()) {
        polygons.push_back({first + p.triangle, end + p.end});
      }
      vertices.append(part.vertices().data(), part.vertices().size());
      end += static_cast<std::uint32_t>(part.vertices().size() / part.stride());
    }
  }
};

using BatchOutput = Pool<BatchResult>;

constexpr std::size_t kLeastOfThread = 4096;  // triangles

// (inside, vertices, ends, source) of one result.
py::tuple arrays_of(std::span<const std::uint32_t> inside,
                    std::span<const batch::PolygonEnd> polygons, std::span<const float> vertices,
                    std::size_t stride, const std::shared_ptr<BatchResult>& result) {
  const auto count = static_cast<py::ssize_t>(polygons.size());
  constexpr py::ssize_t kStep = sizeof(batch::PolygonEnd);
  const std::uint32_t* const triangles = polygons.empty() ? nullptr : &polygons.data()->triangle;
  const std::uint32_t* const ends = polygons.empty() ? nullptr : &polygons.data()->end;
  return py::make_tuple(view_of(inside.data(), inside.size(), result),
                        rows_of_numbers(vertices.data(), vertices.size() / stride, stride, result),
                        view_of(ends, {count}, {kStep}, result),
                        view_of(triangles, {count}, {kStep}, result));
}

// clip(first triangle, last, output) over all triangles, in threads.
template <class F>
py::tuple clip_in_threads(std::size_t count, int threads, BatchOutput& output, const F& clip) {
  const std::shared_ptr<BatchResult> result = output.take();
  const std::vector<std::size_t> begins = parts_of(count, threads, kLeastOfThread);
  const std::size_t parts = begins.size() - 1;
  {
    const py::gil_scoped_release release;
    if (result->parts.size() < parts) result->parts.resize(parts);
    in_threads(parts, [&](std::size_t part) {
      clip(begins[part], begins[part + 1], result->parts[part]);
    });
    if (parts > 1) result->join(begins);
  }
  const batch::Output& only = result->parts[0];
  if (parts == 1) {
    return arrays_of(only.inside(), only.polygons(), only.vertices(), only.stride(), result);
  }
  const BatchResult& all = *result;
  return arrays_of({all.inside.data(), all.inside.size()},
                   {all.polygons.data(), all.polygons.size()},
                   {all.vertices.data(), all.vertices.size()}, only.stride(), result);
}

using Floats = py::array_t<float, py::array::c_style>;

ClipVolume volume_of(int depth, std::array<bool, 2> clamp, int clip_distances,
                     std::array<bool, 4> open) {
  return {static_cast<DepthRange>(depth), DepthClamp(clamp[0], clamp[1]), clip_distances,
          OpenSides(open[0], open[1], open[2], open[3])};
}

struct BatchOptions {
  int method = 0;
  ClipVolume volume;
  int threads = 1;
};

// (triangles, 3, 4 + attributes).
py::tuple stage(const Floats& triangles, const BatchOptions& options, BatchOutput& output) {
  const std::size_t stride = static_cast<std::size_t>(triangles.shape(2));
  const auto attributes = static_cast<int>(stride) - 4;
  const float* const data = triangles.data();
  return clip_in_threads(
      static_cast<std::size_t>(triangles.shape(0)), options.threads, output,
      [&](std::size_t first, std::size_t last, batch::Output& out) {
        const batch::VertexArray part{data + 3 * first * stride, 3 * (last - first), attributes};
        batch::clip(static_cast<batch::Method>(options.method), options.volume, part, out);
      });
}

// Positions (3, 4, triangles), attributes (triangles, 3, k).
py::tuple stage_streams(const Floats& positions, const Floats& attributes,
                        const BatchOptions& options, BatchOutput& output) {
  const auto count = static_cast<std::size_t>(positions.shape(2));
  const auto numbers = static_cast<std::size_t>(attributes.shape(2));
  const float* const data = positions.data();
  const float* const beside = attributes.data();
  return clip_in_threads(
      count, options.threads, output, [&](std::size_t first, std::size_t last, batch::Output& out) {
        batch::TriangleStreams part;
        for (std::size_t i = 0; i < 12; ++i) {
          part.positions[i / 4][i % 4] = data + i * count + first;
        }
        part.count = last - first;
        part.attributes = beside + 3 * first * numbers;
        part.attribute_count = static_cast<int>(numbers);
        batch::clip(static_cast<batch::Method>(options.method), options.volume, part, out);
      });
}

// Vertices (vertices, 4 + attributes), indices of 3 * triangles vertices. None where an index is of
// no vertex.
py::object clip_mesh(const Floats& vertices,
                     const py::array_t<std::uint32_t, py::array::c_style>& indices,
                     const BatchOptions& options, BatchOutput& output) {
  const auto count = static_cast<std::size_t>(vertices.shape(0));
  const batch::VertexArray array{vertices.data(), count, static_cast<int>(vertices.shape(1)) - 4};
  const std::span<const std::uint32_t> all(indices.data(),
                                           static_cast<std::size_t>(indices.size()));
  if (!all.empty() && *std::max_element(all.begin(), all.end()) >= count) return py::none();
  return clip_in_threads(
      all.size() / 3, options.threads, output,
      [&](std::size_t first, std::size_t last, batch::Output& out) {
        const batch::IndexedMesh part{array, all.subspan(3 * first, 3 * (last - first))};
        batch::clip(static_cast<batch::Method>(options.method), options.volume, part, out);
      });
}

py::list methods() {
  py::list list;
  batch::Method method{};
  for_each_type(batch::AllMethods{}, [&]<class M>() {
    method = batch::kMethod<M>;
    if constexpr (batch::HasStage<M>) {
      list.append(py::make_tuple(static_cast<int>(method), std::string(M::name),
                                 std::string(M::summary), std::string(M::source)));
    }
  });
  return list;
}

}  // namespace

void add_batch(py::module_& module) {
  py::class_<BatchOutput>(module, "BatchOutput").def(py::init<>());
  py::class_<BatchOptions>(module, "BatchOptions")
      .def(py::init([](int method, int depth, std::array<bool, 2> clamp, int distances,
                       std::array<bool, 4> open, int threads) {
        return BatchOptions{method, volume_of(depth, clamp, distances, open), threads};
      }));
  module.def("methods", &methods);
  module.def("stage", &stage);
  module.def("stage_streams", &stage_streams);
  module.def("clip_mesh", &clip_mesh);
  module.def("target_name", &batch::target_name);
}

}  // namespace clipscope::python
