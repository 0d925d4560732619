// SPDX-License-Identifier: GPL-3.0-or-later
//
// The batch clippers in a renderer: an indexed mesh in, what is to be drawn out.
//
//   clipscope_example [SCENE or MESH FILE]
//
// Each view is clipped twice, in float and correctly rounded. A renderer would then draw
//
//   inside triangles   from the mesh's own vertex buffer, by an index buffer made of their numbers
//   polygons           from the vertices of the output, as fans: (0, 1, 2), (0, 2, 3), ...
//
// after the divide and the viewport, which are not the clipper's.
#include <fmt/core.h>

#include <exception>
#include <string>
#include <vector>

#include "experiments/scenes/builtin.hpp"
#include "experiments/scenes/camera.hpp"
#include "experiments/scenes/scene.hpp"
#include "spaces/batch/batch.hpp"

using namespace clipscope;
using experiments::kSceneAttributes;

namespace {

// What a vertex shader does: every vertex to clip space, once, and its attributes beside it.
std::vector<float> shade_vertices(const experiments::Mesh& mesh, const experiments::View& view) {
  const Projection<float> projection(view.frustum);
  std::vector<float> vertices;
  vertices.reserve(mesh.positions.size() * (4 + kSceneAttributes));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const auto& p = mesh.positions[i];
    const glm::dvec4 v = view.view_from_world * glm::dvec4(p[0], p[1], p[2], 1);
    const Vec4<float> clip = to_clip(
        projection,
        Vec3<float>(static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])));
    for (int c = 0; c < 4; ++c) vertices.push_back(clip[c]);
    vertices.insert(vertices.end(), mesh.attributes[i].begin(), mesh.attributes[i].end());
  }
  return vertices;
}

struct IndexBuffers {
  std::vector<std::uint32_t> inside;  // into the mesh's vertices
  std::vector<std::uint32_t> fans;    // into the output's vertices
};

IndexBuffers buffers_to_draw(const batch::IndexedMesh& mesh, const batch::Output& out) {
  IndexBuffers buffers;
  for (const std::uint32_t triangle : out.inside()) {
    const auto corners = mesh.indices.subspan(std::size_t{3} * triangle, 3);
    buffers.inside.insert(buffers.inside.end(), corners.begin(), corners.end());
  }
  std::uint32_t begin = 0;
  for (const batch::PolygonEnd& polygon : out.polygons()) {
    for (std::uint32_t v = begin + 2; v < polygon.end; ++v) {
      buffers.fans.insert(buffers.fans.end(), {begin, v - 1, v});
    }
    begin = polygon.end;
  }
  return buffers;
}

void clip_scene(const experiments::Scene& scene) {
  std::vector<std::uint32_t> indices;
  for (const auto& t : scene.mesh.triangles) indices.insert(indices.end(), t.begin(), t.end());
  batch::Output out;  // reused from view to view: after the first it allocates no more
  for (const experiments::View& view : scene.views) {
    const std::vector<float> vertices = shade_vertices(scene.mesh, view);
    const batch::IndexedMesh mesh{{vertices.data(), scene.mesh.positions.size(), kSceneAttributes},
                                  indices};
    for (const auto method : {batch::Method::homogeneous, batch::Method::correctly_rounded}) {
      batch::clip(method, ClipVolume{.depth = view.frustum.depth}, mesh, out);
      const IndexBuffers buffers = buffers_to_draw(mesh, out);
      fmt::print("{}, {}: of {} triangles {} inside, {} cut; drawn {} by index, {} as fans\n",
                 view.label, batch::name(method), indices.size() / 3, out.inside().size(),
                 out.polygons().size(), buffers.inside.size() / 3, buffers.fans.size() / 3);
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const std::string name = count > 1 ? arguments[1] : "terrain";
    clip_scene(experiments::load_scene(name, {}, {}));
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "clipscope_example: {}\n", error.what());
    return 1;
  }
}
