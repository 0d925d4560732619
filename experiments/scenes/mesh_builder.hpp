// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes a Mesh of what the reader of a file finds: vertices, polygons, and the attributes of some.
//
// Readers are strict in what is used: a value that is not finite is an error once a polygon refers
// to its vertex, and no sooner.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "experiments/scenes/scene.hpp"

namespace clipscope::experiments {

// The values of a vertex that must be finite; of the normal it is the length.
enum class VertexValue { x, y, z, u, v, normal };
// "x", "texture coordinate u", "the normal's length".
const char* to_string(VertexValue value);

// Calls add(a, b, c) with the triangles of a strip, every second one turned round, so that all run
// the same way. Those that have a corner twice are left out: they only join strips.
template <class Add>
void add_strip(std::span<const std::uint32_t> corners, const Add& add) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const std::uint32_t a = corners[i - 2], b = corners[i - 1], c = corners[i];
    if (a == b || b == c || c == a) continue;
    if (i % 2 == 0) {
      add(a, b, c);
    } else {
      add(b, a, c);
    }
  }
}

class MeshBuilder {
 public:
  // The place of a value in the file, for messages: "a.ply: vertex 2: x".
  using Place = std::function<std::string(std::size_t vertex, VertexValue value)>;

  // `file` names the file in messages and must outlive the builder. `numbered_by` says what the
  // numbers of polygons count.
  explicit MeshBuilder(const std::string& file, const char* numbered_by = "line")
      : file_(file), numbered_by_(numbered_by) {}

  std::size_t vertices() const { return mesh_.positions.size(); }

  // Adds a vertex; each coordinate is rounded to float once.
  void add_vertex(const std::array<double, 3>& position);
  // The same of one whose nearest floats are known, since its text is more than its doubles.
  void add_vertex(const std::array<double, 3>& position, const std::array<float, 3>& rounded);
  // What the file says of a vertex beside its position. A normal is scaled to length 1; one of
  // length 0 stays.
  void set_texture(std::size_t vertex, double u, double v);
  void set_normal(std::size_t vertex, const std::array<double, 3>& normal);

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.triangles.push_back({a, b, c});
  }
  // Three corners or more, concave or convex; `number` tells it from others in messages.
  // finish() takes it apart.
  void add_polygon(std::span<const std::uint32_t> corners, std::size_t number);
  // Replaces the vertices by others that are copies of them, without attributes: vertex i becomes a
  // copy of vertex sources[i]. Corners of polygons count the new ones.
  void copy_vertices(std::span<const std::uint32_t> sources);

  // The mesh, as load_mesh describes it. Polygons that cross or touch themselves or have no area
  // become a fan around their first corner, and a remark counts them.
  // Errors: InputError if there is no triangle, if there are 2^32 vertices or more, and for a value
  // of a used vertex that is not finite or that no float can hold.
  // Pre-condition: all corners are vertices.
  Mesh finish(const Place& place);

 private:
  // A value that is not finite, and was not stored.
  struct Defect {
    std::size_t vertex;
    VertexValue what;
    double value;
  };
  // A polygon of more than three corners, which is stored as a fan around its first corner.
  struct Fan {
    std::size_t first, triangles;
    std::size_t number;
  };

  std::array<float, kSceneAttributes>& attributes_of(std::size_t vertex);
  void require_finite_values(const std::vector<bool>& is_used, const Place& place) const;
  bool split(const Fan& fan);
  void split_polygons();
  void merge_equal_vertices(const std::vector<bool>& is_used);
  void fill_attributes();

  const std::string& file_;
  const char* numbered_by_;
  Mesh mesh_;
  std::vector<Defect> defects_;
  std::vector<Fan> fans_;
};

}  // namespace clipscope::experiments
