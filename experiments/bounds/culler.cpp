// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/bounds/culler.hpp"

#include <array>

namespace clipscope::experiments {
namespace {

using Points = std::span<const Vec3<double>>;

// A volume around each object.
template <class Volume>
class VolumePerObject final : public Culler {
 public:
  VolumePerObject(const Mesh& mesh, const Objects& objects, Volume (*around)(Points)) {
    for (const TriangleRange& range : objects.ranges) {
      volumes_.push_back(around(positions_of(mesh, objects, range)));
    }
  }

  void query(const CullingPlanes<double>& planes, std::span<Visibility> answers) const override {
    for (std::size_t i = 0; i < volumes_.size(); ++i) answers[i] = visibility(planes, volumes_[i]);
  }

 private:
  std::vector<Volume> volumes_;
};

class Hierarchy final : public Culler {
 public:
  explicit Hierarchy(const Objects& objects) : objects_(objects) {}

  // Ranges are reported in order, and so lie the objects.
  void query(const CullingPlanes<double>& planes, std::span<Visibility> answers) const override {
    std::size_t object = 0;
    objects_.hierarchy.query(planes, [&](TriangleRange range, Visibility answer) {
      const std::uint32_t end = range.first + range.count;
      while (object < answers.size() && objects_.ranges[object].first < end) {
        answers[object++] = answer;
      }
    });
  }

 private:
  const Objects& objects_;
};

template <class Volume, Volume (*kAround)(Points)>
std::unique_ptr<Culler> make_volumes(const Mesh& mesh, const Objects& objects) {
  return std::make_unique<VolumePerObject<Volume>>(mesh, objects, kAround);
}

AxisBox<double> axis_box(Points points) { return clipscope::bounding_box(points); }
Sphere<double> sphere(Points points) { return bounding_sphere(points); }
OrientedBox<double> oriented_box(Points points) { return bounding_oriented_box(points); }

std::unique_ptr<Culler> make_hierarchy(const Mesh&, const Objects& objects) {
  if (objects.hierarchy.nodes().empty()) return nullptr;
  return std::make_unique<Hierarchy>(objects);
}

}  // namespace

std::span<const BoundKind> bound_kinds() {
  static constexpr std::array<BoundKind, 4> kKinds = {{
      {"axis box", make_volumes<AxisBox<double>, axis_box>},
      {"sphere", make_volumes<Sphere<double>, sphere>},
      {"oriented box", make_volumes<OrientedBox<double>, oriented_box>},
      {"box hierarchy", make_hierarchy},
  }};
  return kKinds;
}

}  // namespace clipscope::experiments
