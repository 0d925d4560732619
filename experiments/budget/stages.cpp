// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/budget/stages.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments/budget/traced.hpp"
#include "experiments/measure/batches.hpp"
#include "experiments/measure/match.hpp"
#include "spaces/clippers.hpp"

namespace clipscope::experiments {
namespace {

using reference::Dyadic;
using reference::Fraction;
using reference::InputVertex;
using reference::Truth;

constexpr int kCoordinates = 4;

Fraction whole(double value) { return {Dyadic(value), 1}; }

StagePolygon stage_of(const reference::ExactPolygon& polygon) {
  StagePolygon r;
  for (const reference::ExactVertex& v : polygon.vertices) r.push_back({v.x, v.y, v.z, v.inv_w});
  return r;
}

template <class T>
StagePolygon stage_of(std::span<const NdcVertex<T, kSceneAttributes>> answer) {
  StagePolygon r;
  for (const auto& v : answer) {
    r.push_back(
        {whole(v.position[0]), whole(v.position[1]), whole(v.position[2]), whole(v.position[3])});
  }
  return r;
}

template <class T>
InputVertex clip_vertex(const Vec4<T>& position) {
  return {{position[0], position[1], position[2], position[3]}, {}};
}

// A view-space vertex through an exact projection and divide.
std::array<Fraction, 4> project(const Truth& truth, const InputVertex& vertex) {
  const Dyadic w = reference::value(truth.w(), vertex);
  std::array<Fraction, 4> r;
  for (std::size_t i = 0; i < 3; ++i) {
    const reference::ProjectionForm& row = truth.projection()[i];
    r[i] = {row.value(vertex), row.scale * w};
  }
  r[3] = {1, w};
  return r;
}

// A clip-space position divided exactly.
template <class T>
std::array<Fraction, 4> divided(const Vec4<T>& clip) {
  const Dyadic w(clip[3]);
  return {Fraction{Dyadic(clip[0]), w}, {Dyadic(clip[1]), w}, {Dyadic(clip[2]), w}, {1, w}};
}

// a - b, right to 2^-50 of itself.
double difference(const Fraction& a, const Fraction& b) {
  return reference::approximate(
      {a.numerator * b.denominator - b.numerator * a.denominator, a.denominator * b.denominator});
}

std::vector<ScreenPoint> screen_points(const StagePolygon& polygon) {
  std::vector<ScreenPoint> points;
  for (const auto& v : polygon) {
    points.push_back(screen_point(reference::approximate(v[0]), reference::approximate(v[1])));
  }
  return points;
}

// Begun at the vertex that belongs to the first one of the answer.
StagePolygon matched(StagePolygon polygon, std::span<const ScreenPoint> answer) {
  if (polygon.size() != answer.size()) return {};
  const std::size_t rotation = best_rotation(answer, screen_points(polygon));
  std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(rotation),
              polygon.end());
  return polygon;
}

template <class T>
PartError part_error(const StagePolygon& from, const StagePolygon& to, const StagePolygon& exact) {
  PartError error;
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::array<double, kCoordinates> d;
    for (std::size_t c = 0; c < kCoordinates; ++c) {
      d[c] = difference(to[i][c], from[i][c]);
      if (d[c] == 0) continue;
      const double ulp = ulp_at<T>(reference::approximate(exact[i][c]));
      error.ulp = std::max(error.ulp, std::abs(d[c]) / ulp);
    }
    error.px = std::max(error.px, std::hypot(d[0] * kScreenWidth / 2, d[1] * kScreenHeight / 2));
  }
  return error;
}

// The clipper's polygon before its divide, divided exactly; empty unless dividing it in T gives the
// answer's bits.
template <class C, class T>
StagePolygon traced_polygon(const Projection<Traced<T>>& projection,
                            const ViewTriangle<Traced<T>, kSceneAttributes>& triangle,
                            std::span<const NdcVertex<T, kSceneAttributes>> answer) {
  NdcPolygon<Traced<T>, kSceneAttributes> polygon;
  C{}(projection, triangle, polygon);
  if (static_cast<std::size_t>(polygon.size()) != answer.size()) return {};
  StagePolygon r;
  for (std::size_t i = 0; i < answer.size(); ++i) {
    std::array<Fraction, kCoordinates>& position = r.emplace_back();
    for (int c = 0; c < kCoordinates; ++c) {
      const Traced<T>& x = polygon[static_cast<int>(i)].position[c];
      if (x.value() != answer[i].position[c]) return {};
      position[static_cast<std::size_t>(c)] = {Dyadic(x.numerator()), Dyadic(x.denominator())};
    }
  }
  return r;
}

}  // namespace

std::string_view budget_part_name(BudgetPart part) {
  switch (part) {
    case BudgetPart::matrix: return "matrix";
    case BudgetPart::transform: return "transform";
    case BudgetPart::cut: return "cut";
    case BudgetPart::divide: return "divide";
    default: return "total";
  }
}

template <class T>
StagedView<T>::StagedView(const View& view, std::vector<SceneTriangle> triangles)
    : projection_(projection_of<T>(view)),
      traced_projection_(projection_of<Traced<T>>(view)),
      frustum_truth_(Truth::of_frustum(frustum_cast<double>(view.frustum))),
      matrix_truth_(Truth::of_matrix(projection_)),
      source_(std::move(triangles)),
      triangles_(simplices_cast<T>(source_)),
      truths_(triangles_.size()) {
  const Truth clip_truth = Truth::of_clip(projection_.volume);
  tbb::parallel_for(std::size_t{0}, truths_.size(), [&](std::size_t i) {
    const reference::InputTriangle input = reference::input_triangle(source_[i]);
    std::array<InputVertex, 3> transformed;
    for (std::size_t v = 0; v < 3; ++v) {
      transformed[v] = clip_vertex(to_clip(projection_, triangles_[i][v].position));
    }
    truths_[i] = {stage_of(reference::clip(frustum_truth_, input.vertices, 0)),
                  stage_of(reference::clip(matrix_truth_, input.vertices, 0)),
                  stage_of(reference::clip(clip_truth, transformed, 0))};
  });
}

template <class T>
StagePolygon StagedView<T>::before_divide(std::string_view clipper, std::size_t triangle,
                                          Answer answer) const {
  StagePolygon r;
  for_each_type(AllClippers{}, [&]<class C>() {
    if constexpr (stage_order(C::name, C::promise) == StageOrder::clip_space) {
      if (C::name != clipper) return;
      r = traced_polygon<C, T>(traced_projection_, simplex_cast<Traced<T>>(source_[triangle]),
                               answer);
    }
  });
  return r;
}

// x, y and z of view space come out of a clipper whose matrix hands them through with w = 1.
template <class T>
std::vector<Vec3<T>> StagedView<T>::view_polygon(const Contestant<T>& contestant,
                                                 std::size_t triangle) const {
  Projection<T> through = projection_;
  through.x = through.y = {T(1), T(0), T(0)};
  through.z = {T(0), T(1), T(0)};
  through.w = {T(0), T(0), T(1)};
  PolygonStream<T, kSceneAttributes> out;
  contestant.view(through, std::span(triangles_).subspan(triangle, 1), out);
  std::vector<Vec3<T>> r;
  for (const auto& v : out[0]) r.emplace_back(v.position[0], v.position[1], v.position[2]);
  return r;
}

// x, y and z / w are linear over the divided triangle with w = 1, and so is 1/w as an attribute.
template <class T>
StagePolygon StagedView<T>::cut_after_divide(std::size_t triangle) const {
  std::array<InputVertex, 3> vertices;
  for (std::size_t v = 0; v < 3; ++v) {
    const Vec4<T> clip = to_clip(projection_, triangles_[triangle][v].position);
    const bool in_front =
        T(0) < clip[3] && T(0) <= clip_distance(projection_.volume.depth, Plane::near, clip);
    if (!in_front) return {};
    const Vec4<T> ndc = to_ndc(clip);
    vertices[v] = {{ndc[0], ndc[1], ndc[2], 1}, {ndc[3]}};
  }
  const Truth truth = Truth::of_clip(projection_.volume);
  StagePolygon r;
  for (const reference::ExactVertex& v : reference::clip(truth, vertices, 1).vertices) {
    r.push_back({v.x, v.y, v.z, v.attributes[0]});
  }
  return r;
}

template <class T>
std::optional<typename StagedView<T>::Stages> StagedView<T>::stages(const Contestant<T>& contestant,
                                                                    std::size_t triangle,
                                                                    Answer answer) const {
  const bool usable =
      std::all_of(answer.begin(), answer.end(), [](const auto& v) { return is_finite(v); });
  if (!usable || answer.size() < 3) return std::nullopt;
  const std::vector<ScreenPoint> screen = screen_points(stage_of<T>(answer));
  const auto truth = [&](std::size_t which) { return matched(truths_[triangle][which], screen); };

  using enum BudgetPart;
  Stages r;
  r.polygons.push_back(truth(0));
  switch (stage_order(contestant.name, contestant.promise)) {
    case StageOrder::none: return std::nullopt;
    case StageOrder::clip_space:
      r.parts = {matrix, transform, cut, divide};
      r.polygons.insert(r.polygons.end(),
                        {truth(1), truth(2), before_divide(contestant.name, triangle, answer)});
      break;
    case StageOrder::cvv:
      r.parts = {matrix, transform, divide, cut};
      r.polygons.insert(r.polygons.end(),
                        {truth(1), truth(2), matched(cut_after_divide(triangle), screen)});
      break;
    case StageOrder::view_space: {
      r.parts = {cut, matrix, transform, divide};
      StagePolygon by_frustum, by_matrix, by_floats;
      for (const Vec3<T>& v : view_polygon(contestant, triangle)) {
        const InputVertex input{{v[0], v[1], v[2], 1}, {}};
        const Vec4<T> clip = to_clip(projection_, v);
        if (!(T(0) < clip[3])) return std::nullopt;
        by_frustum.push_back(project(frustum_truth_, input));
        by_matrix.push_back(project(matrix_truth_, input));
        by_floats.push_back(divided(clip));
      }
      r.polygons.insert(r.polygons.end(), {by_frustum, by_matrix, by_floats});
      break;
    }
  }
  r.polygons.push_back(stage_of<T>(answer));
  const bool same_vertices =
      std::all_of(r.polygons.begin(), r.polygons.end(),
                  [&](const StagePolygon& p) { return p.size() == answer.size(); });
  if (!same_vertices) return std::nullopt;
  return r;
}

template <class T>
std::optional<PartErrors> StagedView<T>::errors(const Contestant<T>& contestant,
                                                std::size_t triangle, Answer answer) const {
  const std::optional<Stages> way = stages(contestant, triangle, answer);
  if (!way) return std::nullopt;
  const StagePolygon& exact = way->polygons.front();
  PartErrors errors;
  for (std::size_t i = 0; i < way->parts.size(); ++i) {
    errors[static_cast<std::size_t>(way->parts[i])] =
        part_error<T>(way->polygons[i], way->polygons[i + 1], exact);
  }
  errors[static_cast<std::size_t>(BudgetPart::total)] =
      part_error<T>(exact, way->polygons.back(), exact);
  return errors;
}

template class StagedView<float>;
template class StagedView<double>;

}  // namespace clipscope::experiments
