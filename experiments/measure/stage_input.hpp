// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clip-space triangles as a renderer holds them, for clippers that are a stage of it: the input of the three
// output contracts of spaces/batch/batch.hpp.
//
//   copy       an array of vertices, three per triangle
//   reference  twelve streams of coordinates, and the attributes
//   indexed    an indexed mesh
//
// Positions go to clip space in float, vertex by vertex, so that a vertex that triangles share has the same
// bits in all of them and in every layout.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/scenes/scene.hpp"
#include "experiments/scenes/soup.hpp"
#include "spaces/batch/batch.hpp"

namespace clipscope::experiments {

enum class StageContract : std::uint8_t { copy, reference, indexed };
inline constexpr std::array kStageContracts = {StageContract::copy, StageContract::reference,
                                               StageContract::indexed};
std::string_view contract_name(StageContract contract);  // "copy" and so on

struct StageInput {
  std::string name;
  ClipVolume volume;
  int attributes = kSceneAttributes;
  // Of a soup all triangles; of a mesh an evenly spaced sample, for clippers that take no mesh.
  std::vector<float> vertices;
  std::array<std::array<std::vector<float>, 4>, 3> positions;  // of a soup: [vertex][coordinate]
  std::vector<float> stream_attributes;                        // of a soup
  std::vector<float> mesh_vertices;
  std::vector<std::uint32_t> indices;

  std::size_t stride() const { return 4 + static_cast<std::size_t>(attributes); }
  std::size_t array_size() const { return vertices.size() / (3 * stride()); }  // triangles
  // Triangles in that layout; 0 where the input does not have it.
  std::size_t size(StageContract contract) const;

  // Triangles [first, first + count) of a layout that the input has.
  batch::VertexArray array(std::size_t first, std::size_t count) const;
  batch::TriangleStreams streams(std::size_t first, std::size_t count) const;
  batch::IndexedMesh mesh(std::size_t first, std::size_t count) const;
  // Vertex v of triangle t in that layout: x y z w and the attributes.
  const float* vertex(StageContract contract, std::size_t triangle, std::size_t v) const;
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

// Shares of the triangles, in percent, by outcodes.
struct StageShares {
  double inside = 0, outside = 0, straddling = 0;
};
StageShares shares_of(const StageInput& input, StageContract contract);

}  // namespace clipscope::experiments
