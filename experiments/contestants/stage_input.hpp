// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clip-space triangles as a renderer holds them, for clippers that are a stage of it
// (contract.hpp): an array of vertices, three per triangle; twelve streams of coordinates, and the
// attributes; an indexed mesh.
//
// Positions go to clip space in float, vertex by vertex, so that a vertex that triangles share has
// the same bits in all of them and in every layout.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "experiments/contestants/contract.hpp"
#include "experiments/scenes/builtin.hpp"
#include "experiments/scenes/scene.hpp"
#include "spaces/batch/batch.hpp"

namespace clipscope::experiments {

struct StageInput {
  std::string name;
  ClipVolume volume;
  int attributes = kSceneAttributes;
  // All triangles of a soup, an evenly spaced sample of a mesh: for clippers that take no mesh.
  std::vector<float> vertices = {};
  std::array<std::array<std::vector<float>, 4>, 3> positions =
      {};                                     // of a soup: [vertex][coordinate]
  std::vector<float> stream_attributes = {};  // of a soup
  std::vector<float> mesh_vertices = {};
  std::vector<std::uint32_t> indices = {};
  // Of a mesh in draws (in_draws): triangles of each but the last, 0 where the mesh is one draw;
  // and the vertex that each begins with, from which its indices count.
  std::size_t draw_triangles = 0;
  std::vector<std::size_t> draw_begins = {};

  std::size_t stride() const { return 4 + static_cast<std::size_t>(attributes); }
  std::size_t array_size() const { return vertices.size() / (3 * stride()); }  // triangles
  // Triangles in the contract's layout; 0 where the input does not have it.
  std::size_t size(Contract contract) const;
  // Triangles that a contestant of the contract clips: of a mesh by copy those of the sample.
  std::size_t clipped(Contract contract) const {
    return contract == Contract::copy ? array_size() : size(contract);
  }

  // The vertices that the indices of a mesh's triangle count in.
  std::span<const float> draw_vertices(std::size_t triangle) const;
  // Triangles [first, first + count) of a layout that the input has. Those of a mesh are of one
  // draw.
  batch::VertexArray array(std::size_t first, std::size_t count) const;
  batch::TriangleStreams streams(std::size_t first, std::size_t count) const;
  batch::IndexedMesh mesh(std::size_t first, std::size_t count) const;
  // Vertex v of triangle t in that layout: x y z w and the attributes.
  const float* vertex(Contract contract, std::size_t triangle, std::size_t v) const;
};

// Both layouts of a soup, from clip-space vertices, three per triangle.
StageInput soup_input(std::string name, const ClipVolume& volume, int attributes,
                      std::vector<float> vertices);

// A soup of random triangles in the given shares. Attributes beyond the scene's four repeat them.
StageInput random_input(const std::string& name, const SoupShares& shares, std::size_t triangles,
                        int attributes, std::uint64_t seed);

// At most `limit` triangles over all views of the scene, evenly spaced, in random order, as a soup.
// Pre-condition: the views have the same depth range.
StageInput scene_input(const Scene& scene, std::size_t limit);

// The mesh of a scene as seen from one of its views. Pre-condition: a triangle.
StageInput mesh_input(const Scene& scene, const View& view);

// The mesh in draws of so many triangles: a vertex comes once in each draw that has it, in the
// order in which triangles ask for it. Pre-condition: a mesh in one draw.
StageInput in_draws(const StageInput& mesh, std::size_t triangles);

// The triangles of a soup again and again, at least `triangles`, each time in another random order:
// more than a cache holds, and nothing that a branch predictor could learn by heart.
// Pre-condition: a soup with a triangle.
StageInput shuffled_copies(const StageInput& soup, std::size_t triangles, std::uint64_t seed);

// Shares of the triangles, in percent, by outcodes.
struct StageShares {
  double inside = 0, outside = 0, straddling = 0;
  // Of the straddling ones: by the number of planes that a vertex is outside of, and those with a
  // vertex behind the eye, w < 0.
  double one_plane = 0, two_planes = 0, more_planes = 0, behind_eye = 0;
};
StageShares shares_of(const StageInput& input, Contract contract);

}  // namespace clipscope::experiments
