// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes as many objects, bounding volumes around these, and what the volumes say of a view: one
// kind of volume per culler.
//
// Volumes never move while the camera does, so the planes of a view are brought to world space:
// once per view, and an object costs its test and nothing else.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "experiments/scenes/scene.hpp"
#include "experiments/selection/select.hpp"
#include "spaces/bounds/hierarchy.hpp"
#include "spaces/bounds/separating_axes.hpp"

namespace clipscope::experiments::bounds {

// The mesh's triangles in groups: object i has the triangles order[first], ..., of ranges[i], and
// the ranges follow each other. Of clusters the leaves of each hierarchy are the objects; else they
// are empty.
struct Objects {
  std::vector<std::uint32_t> order;
  std::vector<TriangleRange> ranges;
  BoxHierarchy<double> boxes;
  SphereHierarchy<double> spheres;
  OrientedBoxHierarchy<double> oriented_boxes;
};

// Clusters of at most `most` triangles each, neighbours in space: the leaves of
// hierarchies.
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
  Objects objects;
};

// A square field of teapots, each turned, scaled and moved at random by the seed, and views of a
// walk through it: along a row, across, between pots, along the edge, from above, away from it.
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

// The planes of a view in world space.
//
// Rounding. What is clipped are view-space vertices v = R p + t, computed in double and rounded to
// float, then transformed by the projection's float matrix. Let W be a plane's sum of magnitudes at
// v (spaces/bounds/culling_planes.hpp) and u = 2^-23. Then, from the exact frustum to what a float
// clipper sees, each plane's signed distance is off by at most
//   W u / 2   rounding v to float (what double adds is 2^-29 of that),
//   6 W u     the matrix's entries, a few roundings off the frustum's each, both rows of a plane,
//   W u       the plane itself, a rounded sum of two rows,
//   12 W u    the clipper's transform in float, in any order of summation,
// 20 W u in all. In world space W is taken as |n| |R| |p| + |n| |t| + |offset|, which is never
// less. The planes are given in double with weights 2^30 times as large, so that the error that
// visibility() allows for is 16 * 2^-52 * 2^30 W = 32 u W.
//
// Guarantees, for boxes and spheres that contain the world-space positions of an object: rejected
// means that no triangle of it is visible in exact arithmetic (reference::Truth::of_frustum), and
// that each has all its outcodes in common in float clip space; accepted means that all of it is
// inside in both senses: projecting it is all that is left to do.
// Does not guarantee: anything for a view whose matrix is not a rotation and a shift.
CullingPlanes<double> world_planes(const View& view);

// The corners of the exact frustum in world space, with what planes allow for. Let M be the sum of
// magnitudes of a corner's coordinate in world space, (|R| (|position| + weight |t|)); inverse view
// and product are rounded in double. As with the planes, the magnitudes are 2^30 times as large:
// 32 u M is allowed for, which is more than the matrix's entries are off the frustum's.
//
// Guarantees, where planes and hull are used together: rejected means that no triangle of the
// object is visible in exact arithmetic. Its vertices need have no outcode in common, and of a
// sliver beside an edge of the frustum a float clipper may leave what is not there: polygons then
// differ from those without bounds.
CullingHull<double> world_hull(const View& view);

// One answer per object. Pre-condition: as many answers as objects.
using Culler = std::function<void(const View& view, std::span<Visibility> answers)>;

struct BoundKind {
  std::string_view name;
  // The volumes around the world-space positions of the objects, in double: no position is lost by
  // rounding. None where the objects do not allow this kind. The objects outlive it.
  Culler (*make)(const Mesh& mesh, const Objects& objects);
};

// Axis-aligned box, sphere and oriented box by the planes, the boxes by all separating axes, too;
// for clusters hierarchies of each, of the same tree, whose leaves are the objects: an inner node
// settles all below it at once.
std::span<const BoundKind> bound_kinds();

}  // namespace clipscope::experiments::bounds
