// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/survey/case_batch.hpp"

#include <map>
#include <utility>

namespace clipscope::experiments {
namespace {

// What must be the same of cases in one batch, as numbers.
std::vector<double> description_of(const HardCase& c) {
  const Frustum<double>& f = c.frustum;
  const ClipVolume& v = c.volume;
  std::vector<double> numbers = {static_cast<double>(c.primitive), static_cast<double>(c.space),
                                 static_cast<double>(c.attribute_count),
                                 static_cast<double>(v.depth),
                                 static_cast<double>(v.clip_distances)};
  for (const bool is_set : {v.depth_clamp.near, v.depth_clamp.far, v.open_sides.left,
                            v.open_sides.right, v.open_sides.bottom, v.open_sides.top}) {
    numbers.push_back(is_set);
  }
  if (has_frustum(c)) {
    numbers.insert(numbers.end(), {static_cast<double>(f.kind), f.left, f.right, f.bottom, f.top,
                                   f.near, f.infinite_far ? 0 : f.far,
                                   static_cast<double>(f.infinite_far), f.shear_x, f.shear_y});
  }
  if (c.matrix) {
    for (const Vec4<double>& row : *c.matrix) {
      numbers.insert(numbers.end(), {row[0], row[1], row[2], row[3]});
    }
  }
  for (const auto& plane : c.planes) numbers.insert(numbers.end(), plane.begin(), plane.end());
  return numbers;
}

}  // namespace

CaseBatch::CaseBatch(const HardCase& hard_case)
    : CaseBatch(std::vector<const HardCase*>{&hard_case}) {}

CaseBatch::CaseBatch(std::span<const HardCase* const> cases)
    : Batch{.space = cases[0]->space,
            .frustum = cases[0]->frustum,
            .matrix = cases[0]->matrix,
            .volume = cases[0]->volume,
            .vertices = static_cast<int>(vertices_of(cases[0]->primitive)),
            .attributes = cases[0]->attribute_count,
            .planes = cases[0]->planes} {
  std::size_t end = 0;
  for (const HardCase* c : cases) {
    for (const auto& [position, values] : c->vertices) {
      own_numbers_.insert(own_numbers_.end(), position.begin(), position.begin() + dimension());
      own_numbers_.insert(own_numbers_.end(), values.begin(), values.begin() + attributes);
    }
    own_ends_.push_back(end += c->vertices.size());
  }
  numbers = std::span<const double>(own_numbers_);
  if (vertices == 0) ends = own_ends_;
}

std::vector<std::vector<const HardCase*>> alike(std::span<const HardCase* const> cases,
                                                std::size_t most) {
  std::vector<std::vector<const HardCase*>> groups;
  std::map<std::vector<double>, std::size_t> open;  // the group that takes a description's next
  for (const HardCase* c : cases) {
    const auto [found, is_new] = open.try_emplace(description_of(*c), groups.size());
    if (is_new || groups[found->second].size() == most) {
      found->second = groups.size();
      groups.emplace_back();
    }
    groups[found->second].push_back(c);
  }
  return groups;
}

HardCase case_of(const Batch& batch, std::size_t primitive, std::string name) {
  constexpr std::array kPrimitives = {Primitive::polygon, Primitive::point, Primitive::segment,
                                      Primitive::triangle};
  HardCase c;
  c.name = std::move(name);
  c.primitive = kPrimitives[static_cast<std::size_t>(batch.vertices)];
  c.space = batch.space;
  c.frustum = batch.frustum;
  c.matrix = batch.matrix;
  c.volume = batch.volume;
  c.planes = batch.planes;
  c.vertices = input_vertices(batch, primitive);
  c.attribute_count = batch.attributes;
  return c;
}

}  // namespace clipscope::experiments
