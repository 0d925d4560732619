// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/workloads/forms.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "experiments/catalogue/projected.hpp"
#include "experiments/workloads/plain_call.hpp"

namespace clipscope::experiments {
namespace {

using Positions = std::vector<std::array<float, 4>>;

Positions positions_of(const HardCase& c) {
  Positions positions;
  for (const reference::InputVertex& v : projected(c).vertices) {
    std::array<float, 4>& position = positions.emplace_back();
    std::ranges::transform(v.position, position.begin(),
                           [](double x) { return static_cast<float>(x); });
  }
  return positions;
}

Topology plain_topology(Primitive primitive) {
  if (primitive == Primitive::point) return Topology::points;
  return primitive == Primitive::segment ? Topology::lines : Topology::triangles;
}

// Triangles of a polygon around its first vertex.
std::vector<std::uint32_t> fan_indices(std::size_t vertices) {
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 1; i + 1 < vertices; ++i) indices.insert(indices.end(), {0, i, i + 1});
  return indices;
}

void set_case_distances(DrawCall& call, const HardCase& c) {
  const int count = c.volume.clip_distances;
  if (count == 0) return;
  set_clip_distances(call, count);
  for (std::size_t v = 0; v < call.vertices.size(); ++v) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
      call.vertices[v].clip_distances[k] = static_cast<float>(c.vertices[v].attributes[k]);
    }
  }
}

DrawCall plain_form(const HardCase& c, const DriverInfo& info) {
  DrawCall call = plain_call(c.name, plain_topology(c.primitive), positions_of(c), info);
  if (c.primitive == Primitive::polygon) call.indices = fan_indices(call.vertices.size());
  const DepthRange possible = call.volume.depth;
  const bool is_gl = c.volume.depth == DepthRange::minus_one_to_one;
  // Reversed depth is the range 0 to 1 with near and far exchanged, which is the shader's affair.
  call.volume.depth = is_gl ? DepthRange::minus_one_to_one : DepthRange::zero_to_one;
  if (is_gl ? !info.minus_one_to_one : !info.zero_to_one) set_depth_range(call, possible);
  call.volume.depth_clamp = static_cast<bool>(c.volume.depth_clamp);
  set_case_distances(call, c);
  return call;
}

class Forms {
 public:
  Forms(DrawCall plain, const DriverInfo& info) : plain_(std::move(plain)), info_(info) {
    add(plain_);
  }

  std::vector<DrawCall> all() {
    switch (plain_.topology) {
      case Topology::points: add_points(); break;
      case Topology::lines: add_lines(); break;
      default: add_triangles();
    }
    add_volumes();
    add_windows();
    add_quantities();
    return std::move(forms_);
  }

 private:
  void add(DrawCall call) {
    if (is_finite(call)) forms_.push_back(std::move(call));
  }

  template <class Change>
  void add(std::string_view label, const Change& change) {
    DrawCall call = labelled(plain_, label);
    change(call);
    add(std::move(call));
  }

  static DrawVertex parallelogram(const DrawVertex& a, const DrawVertex& b, const DrawVertex& c) {
    DrawVertex d{.varying = varying_of(3), .clip_distances = clip_distances_of(3)};
    for (std::size_t i = 0; i < 4; ++i) {
      d.position[i] = static_cast<float>(double{b.position[i]} + c.position[i] - a.position[i]);
    }
    return d;
  }

  static void rotate(DrawCall& call, std::ptrdiff_t places) {
    std::vector<DrawVertex>& v = call.vertices;
    std::rotate(v.begin(), v.begin() + places, v.end());
  }

  void add_points() {
    for (const float size : {2.0f, 5.0f, 16.0f}) {
      add(std::to_string(static_cast<int>(size)) + " px",
          [size](DrawCall& call) { call.point_size = size; });
    }
    add("indexed", [](DrawCall& call) { call.indices = {0, 0}; });
  }

  void add_lines() {
    add("reversed", [](DrawCall& call) { std::ranges::reverse(call.vertices); });
    add("indexed", [](DrawCall& call) { call.indices = {1, 0, 0, 1}; });
    add("strip", [](DrawCall& call) {
      call.topology = Topology::line_strip;
      DrawVertex turned = call.vertices[0];
      std::swap(turned.position[0], turned.position[1]);
      turned.varying = varying_of(2);
      call.vertices.push_back(turned);
    });
    add_other_provoking();
  }

  void add_triangles() {
    add("rotated", [](DrawCall& call) { rotate(call, 1); });
    add("reversed", [](DrawCall& call) { std::ranges::reverse(call.vertices); });
    if (plain_.vertices.size() == 3) add_twice_rotated_and_strips();
    add("fan", [](DrawCall& call) {
      call.topology = Topology::triangle_fan;
      call.indices.clear();
      const std::vector<DrawVertex>& v = call.vertices;
      if (v.size() == 3) call.vertices.push_back(parallelogram(v[1], v[0], v[2]));
    });
    add_other_provoking();
  }

  void add_twice_rotated_and_strips() {
    add("rotated twice", [](DrawCall& call) { rotate(call, 2); });
    const auto add_fourth = [](DrawCall& call) {
      const std::vector<DrawVertex>& v = call.vertices;
      call.vertices.push_back(parallelogram(v[0], v[1], v[2]));
    };
    add("strip", [&](DrawCall& call) {
      call.topology = Topology::triangle_strip;
      add_fourth(call);
    });
    add("indexed", [&](DrawCall& call) {
      add_fourth(call);
      call.indices = {2, 0, 1, 3, 2, 1};
    });
    add("indexed strip", [&](DrawCall& call) {
      call.topology = Topology::triangle_strip;
      add_fourth(call);
      call.indices = {3, 2, 1, 0};
    });
  }

  void add_other_provoking() {
    const bool is_last = plain_.provoking == ProvokingVertex::last;
    add(is_last ? "provoking first" : "provoking last", [&](DrawCall& call) {
      call.provoking = is_last ? ProvokingVertex::first : ProvokingVertex::last;
    });
  }

  void add_volumes() {
    const bool is_gl = plain_.volume.depth == DepthRange::minus_one_to_one;
    add(is_gl ? "depth 0 to 1" : "depth -1 to 1", [&](DrawCall& call) {
      set_depth_range(call, is_gl ? DepthRange::zero_to_one : DepthRange::minus_one_to_one);
    });
    if (!plain_.volume.depth_clamp) {
      add("depth clamp", [](DrawCall& call) { call.volume.depth_clamp = true; });
    }
    if (plain_.volume.clip_distances > 0) return;
    add("1 clip distance", [](DrawCall& call) { set_clip_distances(call, 1); });
    const int most = std::min(kMaxClipDistances, info_.max_clip_distances);
    if (most < 2) return;
    add(std::to_string(most) + " clip distances",
        [most](DrawCall& call) { set_clip_distances(call, most); });
  }

  void add_windows() {
    add("256 px", [](DrawCall& call) { set_size(call, kLargeTarget, kLargeTarget); });
    add("viewport beside the target", [](DrawCall& call) { call.viewport = {-5, 3, 41, 26}; });
    const int large = std::min(kLargeViewport, info_.max_size);
    const int middle = kSmallTarget / 2 - large / 2, end = kSmallTarget - large;
    add("middle of a large viewport", [&](DrawCall& call) {
      call.viewport = {middle, middle, large, large};
    });
    add("first corner of a large viewport", [&](DrawCall& call) {
      call.viewport = {0, 0, large, large};
    });
    add("last corner of a large viewport", [&](DrawCall& call) {
      call.viewport = {end, end, large, large};
    });
  }

  // Those of the plain call and gl_PrimitiveID.
  void add_quantities() {
    Quantities alone = plain_.quantities;
    alone.set(bit(Quantity::primitive_id));
    for (std::size_t q = bit(Quantity::smooth); q < kQuantities; ++q) {
      if (!alone[q]) continue;
      add(std::string(names_of(Quantity{})[q]) + " alone",
          [q](DrawCall& call) { call.quantities = Quantities().set(q); });
    }
  }

  DrawCall plain_;
  const DriverInfo& info_;
  std::vector<DrawCall> forms_;
};

}  // namespace

std::vector<DrawCall> forms_of(const HardCase& hard_case, const DriverInfo& info) {
  const DrawCall plain = plain_form(hard_case, info);
  return is_finite(plain) ? Forms(plain, info).all() : std::vector<DrawCall>();
}

}  // namespace clipscope::experiments
