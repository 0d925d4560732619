// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/bounds/solid.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/machine/errors.hpp"

namespace clipscope::experiments::bounds {
namespace {

using reference::Dyadic;
using reference::ExactPoint;
using reference::InputVertex;
using reference::Overlap;

struct KindForm {
  std::string_view name;
  std::size_t numbers;  // 0: three per point
  std::string_view form;
};

constexpr std::array<KindForm, 5> kKinds = {{
    {"box", 6, "box X0 Y0 Z0 X1 Y1 Z1"},
    {"sphere", 4, "sphere X Y Z R"},
    {"obb", 12, "obb CX CY CZ  UX UY UZ  VX VY VZ  WX WY WZ (half axes)"},
    {"points", 0, "points X Y Z ..."},
    {"polygon", 0, "polygon X Y Z ..."},
}};

Vec3<float> vector_at(const Solid& solid, std::size_t first) {
  return Vec3<float>(solid.numbers[first], solid.numbers[first + 1], solid.numbers[first + 2]);
}

bool is_point_set(const Solid& solid) {
  return solid.kind == SolidKind::points || solid.kind == SolidKind::polygon;
}

ExactPoint exact(const Vec3<float>& p) { return reference::exact_point(p[0], p[1], p[2]); }

std::vector<ExactPoint> exact_points(std::span<const Vec3<float>> points) {
  std::vector<ExactPoint> r;
  std::ranges::transform(points, std::back_inserter(r), exact);
  return r;
}

// centre + sum of +-half_k axis_k.
std::vector<ExactPoint> exact_corners(const OrientedBox<float>& box) {
  std::vector<ExactPoint> r;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    ExactPoint& p = r.emplace_back(exact(box.centre));
    for (std::size_t k = 0; k < 3; ++k) {
      const float half = box.half[static_cast<int>(k)];
      const Dyadic t(double{(corner >> k & 1) != 0 ? half : -half});
      for (std::size_t c = 0; c < 3; ++c) {
        p[c] += t * Dyadic(double{box.axes[k][static_cast<int>(c)]});
      }
    }
  }
  return r;
}

std::vector<ExactPoint> exact_corners(const AxisBox<float>& box) {
  std::vector<ExactPoint> r;
  for (const float x : {box.lower[0], box.upper[0]}) {
    for (const float y : {box.lower[1], box.upper[1]}) {
      for (const float z : {box.lower[2], box.upper[2]}) {
        r.push_back(reference::exact_point(x, y, z));
      }
    }
  }
  return r;
}

Visibility answer_of(Overlap overlap) {
  if (overlap == Overlap::outside) return Visibility::rejected;
  return overlap == Overlap::inside ? Visibility::accepted : Visibility::look_closer;
}

std::string text_of(Visibility answer) {
  if (answer == Visibility::rejected) return "rejected";
  return answer == Visibility::accepted ? "accepted" : "look closer";
}

// By the signs of doubles, wherever they are settled, and a program for what is left.
Visibility triangle_answer(const Region& region, std::span<const Vec3<float>> corners) {
  bool inside = true;
  for (const reference::LinearForm& form : region.half_spaces) {
    int outside = 0;
    for (const Vec3<float>& p : corners) {
      InputVertex vertex;
      vertex.position = {p[0], p[1], p[2], 1};
      outside += reference::sign(form, vertex) < 0 ? 1 : 0;
    }
    if (outside == 3) return Visibility::rejected;
    inside = inside && outside == 0;
  }
  if (inside) return Visibility::accepted;
  return answer_of(reference::overlap(region.half_spaces, exact_points(corners)));
}

}  // namespace

Region region_of(const Frustum<float>& frustum) {
  return {frustum.depth, rows_of(Projection<float>(frustum)), culling_planes(frustum),
          culling_hull(frustum),
          reference::half_spaces_of(reference::Truth::of_frustum(frustum_cast<double>(frustum)))};
}

Region region_of(DepthRange depth, const MatrixRows<float>& rows) {
  const CullingHull<float> hull = culling_hull(depth, rows);
  const auto truth = reference::Truth::of_matrix(matrix_cast<double>(rows), {.depth = depth});
  return {depth, rows, with_reach(culling_planes(depth, rows), hull), hull,
          reference::half_spaces_of(truth)};
}

std::string_view kind_names() { return "box, sphere, obb, points or polygon"; }

Solid solid_of(const std::string& place, std::string_view kind, std::vector<float> numbers) {
  const auto found = std::ranges::find(kKinds, kind, &KindForm::name);
  if (found == kKinds.end()) {
    throw InputError(
        fmt::format("{}: '{}' given; {} expected, and its numbers", place, kind, kind_names()));
  }
  const std::size_t n = numbers.size();
  const bool fits = found->numbers != 0 ? n == found->numbers : n >= 3 && n % 3 == 0;
  if (!fits) {
    throw InputError(fmt::format("{}: {} numbers given; expected {}", place, n, found->form));
  }
  const auto index = static_cast<std::size_t>(found - kKinds.begin());
  Solid solid{fmt::format("{}", place), static_cast<SolidKind>(index), std::move(numbers)};
  const auto& v = solid.numbers;
  if (solid.kind == SolidKind::box && (v[0] > v[3] || v[1] > v[4] || v[2] > v[5])) {
    throw InputError(fmt::format(
        "{}: the box ends before it begins; expected X0 <= X1, Y0 <= Y1, Z0 <= Z1", place));
  }
  if (solid.kind == SolidKind::sphere && v[3] < 0) {
    throw InputError(fmt::format("{}: the radius is {}; 0 or more expected", place, v[3]));
  }
  return solid;
}

std::vector<Vec3<float>> points_of(const Solid& solid) {
  std::vector<Vec3<float>> points;
  for (std::size_t i = 0; i < solid.numbers.size(); i += 3) points.push_back(vector_at(solid, i));
  return points;
}

std::vector<ExactPoint> exact_hull(const Solid& solid) {
  if (is_point_set(solid)) return exact_points(points_of(solid));
  return std::visit(
      [](const auto& volume) {
        if constexpr (requires { volume.radius; }) {
          return std::vector<ExactPoint>{};
        } else {
          return exact_corners(volume);
        }
      },
      bounds_of(solid).front().volume);
}

std::vector<Bound> bounds_around(std::span<const Vec3<float>> points) {
  return {{"axis box", clipscope::bounding_box(points)},
          {"sphere", bounding_sphere(points)},
          {"oriented box", bounding_oriented_box(points)}};
}

std::vector<Bound> bounds_of(const Solid& solid) {
  const auto& v = solid.numbers;
  switch (solid.kind) {
    case SolidKind::box:
      return {{"axis box", AxisBox<float>{vector_at(solid, 0), vector_at(solid, 3)}}};
    case SolidKind::sphere: return {{"sphere", Sphere<float>{vector_at(solid, 0), v[3]}}};
    case SolidKind::obb: {
      // The half axes as given, so that nothing is rounded.
      const OrientedBox<float> box{vector_at(solid, 0),
                                   {vector_at(solid, 3), vector_at(solid, 6), vector_at(solid, 9)},
                                   Vec3<float>(1)};
      return {{"oriented box", box}};
    }
    default: return bounds_around(points_of(solid));
  }
}

Visibility exact_answer(const Region& region, const Volume& volume) {
  const auto overlap = [&](const auto& v) {
    if constexpr (requires { v.radius; }) {
      return reference::overlap(region.half_spaces, exact(v.centre), Dyadic(double{v.radius}));
    } else {
      return reference::overlap(region.half_spaces, exact_corners(v));
    }
  };
  return answer_of(std::visit(overlap, volume));
}

Visibility exact_answer(const Region& region, const Solid& solid) {
  if (is_point_set(solid)) {
    return answer_of(reference::overlap(region.half_spaces, exact_hull(solid)));
  }
  return exact_answer(region, bounds_of(solid).front().volume);
}

Visibility exact_answer(const Region& region, std::span<const Vec3<float>> corners) {
  Visibility all = Visibility::look_closer;
  for (std::size_t i = 0; i + 3 <= corners.size(); i += 3) {
    const Visibility one = triangle_answer(region, corners.subspan(i, 3));
    if (i > 0 && one != all) return Visibility::look_closer;
    all = one;
    if (all == Visibility::look_closer) return all;
  }
  return all;
}

AnswerRow answer_row(const Region& region, const std::string& solid, const Bound& bound,
                     Visibility content) {
  const auto [planes, axes] = std::visit(
      [&](const auto& volume) {
        return std::pair(visibility(region.planes, volume),
                         visibility(region.planes, region.hull, volume));
      },
      bound.volume);
  const Visibility exact = exact_answer(region, bound.volume);
  std::string needless;
  if (exact != Visibility::look_closer) {
    if (planes == Visibility::look_closer) needless = "planes";
    if (axes == Visibility::look_closer) needless = "planes, axes";
  }
  return {solid,          bound.name,       text_of(planes), text_of(axes),
          text_of(exact), text_of(content), needless};
}

}  // namespace clipscope::experiments::bounds
