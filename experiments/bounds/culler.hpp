// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounding volumes of a scene's objects, held against a view: one kind of volume per culler.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "experiments/bounds/objects.hpp"
#include "spaces/bounds/visibility.hpp"

namespace clipscope::experiments {

class Culler {
 public:
  virtual ~Culler() = default;
  // One answer per object. Pre-condition: as many answers as objects.
  virtual void query(const CullingPlanes<double>& planes, std::span<Visibility> answers) const = 0;
};

struct BoundKind {
  std::string_view name;
  // The volumes around the world-space positions of the objects, in double: no position is lost by
  // rounding. None where the objects do not allow this kind.
  std::unique_ptr<Culler> (*make)(const Mesh& mesh, const Objects& objects);
};

// Axis-aligned box, sphere, oriented box, and for clusters a hierarchy of boxes whose leaves are the
// objects: an inner node settles all below it at once.
std::span<const BoundKind> bound_kinds();

}  // namespace clipscope::experiments
