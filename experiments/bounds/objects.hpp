// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes as many objects: what bounding volumes are put around.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/commands/selection.hpp"
#include "experiments/scenes/scene.hpp"
#include "spaces/bounds/hierarchy.hpp"

namespace clipscope::experiments {

// The mesh's triangles in groups: object i has the triangles order[first], ..., of ranges[i], and the
// ranges follow each other. Of clusters the hierarchy's leaves are the objects; else it has none.
struct Objects {
  std::vector<std::uint32_t> order;
  std::vector<TriangleRange> ranges;
  BoxHierarchy<double> hierarchy;
};

// Clusters of at most `most` triangles each, neighbours in space: the leaves of a hierarchy of boxes.
Objects clusters(const Mesh& mesh, std::uint32_t most);

// Objects of `each` triangles in the order of the mesh. Pre-condition: they come out even.
Objects instances(const Mesh& mesh, std::uint32_t each);

// Positions of an object's triangles, three per triangle.
std::vector<Vec3<double>> positions_of(const Mesh& mesh, const Objects& objects,
                                       const TriangleRange& range);

// A scene with one way of taking it apart.
struct ObjectScene {
  Scene scene;
  std::string object;  // what an object is: "teapot", "cluster of 64"
  std::uint32_t triangles_each = 64;
  bool is_clustered = true;

  Objects objects() const {
    return is_clustered ? clusters(scene.mesh, triangles_each)
                        : instances(scene.mesh, triangles_each);
  }
};

// A square field of teapots, each turned, scaled and moved at random by the seed, and views of a walk
// through it: along a row, across, between pots, along the edge, from above, away from it.
// Objects are the teapots.
ObjectScene teapot_field(std::uint64_t seed, bool quick);

// A scene by its name or file, and how it is taken apart.
struct ObjectSceneName {
  std::string scene;
  std::uint32_t most;  // triangles per cluster; 0: each teapot of the field is an object
};
// The scenes of the selection, else the field and some built-in scenes.
std::vector<ObjectSceneName> object_scenes(const Selection& selection);

// Errors: those of load_selected_scene.
ObjectScene load_object_scene(const Selection& selection, const ObjectSceneName& name);

}  // namespace clipscope::experiments
