// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scene: a mesh and the views it is looked at from.
//
// Only floats enter an experiment: `view_triangles` moves world-space vertices into view space in
// double precision and rounds each coordinate to float once. These float bits are the input of
// every clipper and of the exact reference alike.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spaces/projection.hpp"
#include "spaces/vertex.hpp"

namespace clipscope::experiments {

// The attributes of every vertex: texture coordinates u and v and two more values in [-1, 1].
inline constexpr int kSceneAttributes = 4;

using SceneTriangle = ViewTriangle<float, kSceneAttributes>;
using DoubleSceneTriangle = ViewTriangle<double, kSceneAttributes>;

struct Mesh {
  std::vector<std::array<float, 3>> positions;  // world space
  // The same in double, where a file has one that no float holds; else empty.
  std::vector<std::array<double, 3>> double_positions = {};
  std::vector<std::array<float, kSceneAttributes>> attributes;  // one per position
  std::vector<std::array<std::uint32_t, 3>> triangles;          // indices into positions
  std::vector<std::string> remarks = {};  // what people should know of the file it was read from
};

inline glm::dvec3 point_of(const Mesh& mesh, std::size_t vertex) {
  const auto& [x, y, z] = mesh.positions[vertex];
  return {x, y, z};
}

// The position as the file has it, before it was rounded to float.
inline glm::dvec3 point_in_double(const Mesh& mesh, std::size_t vertex) {
  if (mesh.double_positions.empty()) return point_of(mesh, vertex);
  const auto& [x, y, z] = mesh.double_positions[vertex];
  return {x, y, z};
}

// A camera position: world to view, and the frustum, whose numbers are floats; or instead of the
// frustum a matrix from view space to clip space, as given (view space is then what the matrix
// takes, the world itself where it holds the camera, too). With a matrix only the depth range of
// the frustum counts.
struct View {
  std::string label;
  glm::dmat4 view_from_world = glm::dmat4(1.0);
  Frustum<float> frustum = {};
  std::optional<MatrixRows<float>> matrix = {};
};

struct Scene {
  std::string name;
  std::string description;
  Mesh mesh;
  std::vector<View> views;  // at least one
};

// The view-space triangles [first, first + out.size()) of the mesh as seen from the view. An
// identity view keeps the bits of the mesh's floats, signs of zeros included.
// Pre-condition: first + out.size() <= scene.mesh.triangles.size().
void view_triangles(const Scene& scene, const View& view, std::size_t first,
                    std::span<SceneTriangle> out);
// The same without the roundings to float, from positions as the file has them.
void view_triangles(const Scene& scene, const View& view, std::size_t first,
                    std::span<DoubleSceneTriangle> out);

// An axis-aligned box, lo <= hi in each coordinate.
struct Box {
  glm::dvec3 lo, hi;

  glm::dvec3 centre() const { return (lo + hi) * 0.5; }
  glm::dvec3 size() const { return hi - lo; }
};

// The smallest box around all positions of the mesh, in double where there are doubles.
// Pre-condition: the mesh has a position.
Box bounding_box(const Mesh& mesh);

struct SceneOptions;   // experiments/scenes/builtin.hpp
struct CameraOptions;  // experiments/scenes/camera.hpp

// A built-in scene by its name, or a mesh file (a name that holds a '.' or a '/', or exists) seen
// from `make_views`. Options of the camera replace the views of a built-in scene as soon as one
// other than `depth` differs from its default; `depth` holds for every view.
// Errors: UsageError for a name that is neither, and for a camera on a scene given in view space;
// those of load_mesh and make_views.
Scene load_scene(std::string_view name_or_file, const SceneOptions& options,
                 const CameraOptions& camera);

// At most `limit` of the values, evenly spaced from the first on. Pre-condition: limit > 0.
template <class T>
std::vector<T> evenly_spaced(const std::vector<T>& values, std::size_t limit) {
  const std::size_t stride = (values.size() + limit - 1) / limit;
  std::vector<T> spaced;
  for (std::size_t i = 0; i < values.size(); i += stride) spaced.push_back(values[i]);
  return spaced;
}

// Which triangles of a mesh are sampled: `count`, evenly spaced, number i being triangle i *
// stride.
struct Spacing {
  std::size_t count = 0;
  std::size_t stride = 1;
};

// At most `limit` triangles of the scene; 0: all.
Spacing spacing_of(const Scene& scene, std::size_t limit);

// The sampled triangles [first, first + count) of a view.
template <class Triangle = SceneTriangle>
std::vector<Triangle> sampled_view_triangles(const Scene& scene, const View& view,
                                             const Spacing& spacing, std::size_t first,
                                             std::size_t count) {
  std::vector<Triangle> triangles(count);
  for (std::size_t i = 0; i < count; ++i) {
    view_triangles(scene, view, (first + i) * spacing.stride, std::span(&triangles[i], 1));
  }
  return triangles;
}

// Calls f(triangles, first) with all sampled triangles of a view, some thousand at once, so that
// memory does not grow with the mesh. first: the number of the first of them in the sample.
template <class Triangle = SceneTriangle, class F>
void for_each_chunk(const Scene& scene, const View& view, const Spacing& spacing, const F& f) {
  constexpr std::size_t kChunk = 4096;
  for (std::size_t first = 0; first < spacing.count; first += kChunk) {
    const std::size_t count = std::min(kChunk, spacing.count - first);
    f(sampled_view_triangles<Triangle>(scene, view, spacing, first, count), first);
  }
}

// Triangles of one view.
struct SampledView {
  View view;
  std::vector<SceneTriangle> triangles;
  std::vector<std::size_t> numbers = {};  // in the mesh, one per triangle; empty if there is none
};

// At most `limit` triangles over all views of the scene, evenly spaced and shuffled with a fixed
// seed, so that a leading share of a view is like the whole.
std::vector<SampledView> sampled_views(const Scene& scene, std::size_t limit);

}  // namespace clipscope::experiments
