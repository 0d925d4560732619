// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/budget/stages.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "experiments/judge/match.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/selection/select.hpp"
#include "spaces/barycentric/distance_matrix.hpp"

namespace clipscope::experiments::budget {
namespace {

using reference::Dyadic;
using reference::Fraction;
using reference::InputVertex;
using reference::Truth;

// The distance matrix's polygons before its divide: x y z w and the weight.
template <class T>
Answers cut_weighted(const ClipVolume& volume, const std::vector<ClipTriangle<double, 0>>& in) {
  Answers answers(kFormat<T>, 5);
  for (const auto& triangle : in) {
    ClipTriangle<T, 0> rounded;
    for (std::size_t v = 0; v < 3; ++v) rounded[v].position = Vec4<T>(triangle[v].position);
    for (const auto& v : DistanceMatrix::cut_weighted(volume, rounded)) {
      for (int c = 0; c < 4; ++c) answers.add(v.position[c]);
      answers.add(v.weight);
    }
    answers.end_polygon();
  }
  return answers;
}

Vec4<double> position_of(const VertexView& v) {
  return {v[0].value, v[1].value, v[2].value, v[3].value};
}

InputVertex input_vertex(const Vec4<double>& p) { return {{p[0], p[1], p[2], p[3]}, {}}; }

// w > 0 times (x, y, z, 1/w), divided exactly by w.
std::array<Fraction, 4> divided(const Vec4<double>& clip, double weight = 1) {
  const Dyadic w(clip[3]);
  return {Fraction{Dyadic(clip[0]), w}, {Dyadic(clip[1]), w}, {Dyadic(clip[2]), w}, {weight, w}};
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

StagePolygon stage_of(const reference::ExactPolygon& polygon) {
  StagePolygon r;
  for (const reference::ExactVertex& v : polygon.vertices) r.push_back({v.x, v.y, v.z, v.inv_w});
  return r;
}

StagePolygon stage_of(const PolygonView& answer) {
  StagePolygon r;
  for (const VertexView v : answer) {
    auto& position = r.emplace_back();
    for (std::size_t c = 0; c < 4; ++c) position[c] = {Dyadic(v[c].value), 1};
  }
  return r;
}

StagePolygon rotated(StagePolygon polygon, std::size_t first) {
  std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(first), polygon.end());
  return polygon;
}

// Begun at the vertex that belongs to the first one of the answer.
StagePolygon matched(StagePolygon polygon, std::span<const ScreenPoint> answer) {
  if (polygon.size() != answer.size()) return {};
  std::vector<ScreenPoint> points;
  for (const auto& v : polygon) {
    points.push_back(screen_point(reference::approximate(v[0]), reference::approximate(v[1])));
  }
  return rotated(std::move(polygon), best_rotation(answer, points));
}

double rounded(const Fraction& value, const Format& format) {
  if (format.is_float()) return reference::round_to<float>(value);
  return reference::round_to<double>(value);
}

bool is_usable(const PolygonView& answer) {
  for (const VertexView v : answer) {
    for (std::size_t i = 0; i < v.size(); ++i) {
      if (!is_finite(v[i])) return false;
    }
  }
  return answer.size() >= 3;
}

// a - b, right to 2^-50 of itself.
double difference(const Fraction& a, const Fraction& b) {
  return reference::approximate(
      {a.numerator * b.denominator - b.numerator * a.denominator, a.denominator * b.denominator});
}

PartError part_error(const StagePolygon& from, const StagePolygon& to, const StagePolygon& exact,
                     const Format& format) {
  PartError error;
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::array<double, 4> d;
    for (std::size_t c = 0; c < 4; ++c) {
      d[c] = difference(to[i][c], from[i][c]);
      if (d[c] == 0) continue;
      const double ulp = format.ulp_at(reference::approximate(exact[i][c]));
      error.ulp = std::max(error.ulp, std::abs(d[c]) / ulp);
    }
    error.px = std::max(error.px, std::hypot(d[0] * kScreenWidth / 2, d[1] * kScreenHeight / 2));
  }
  return error;
}

void add_contestant(const Contestant& contestant, const StagedView& staged, std::size_t view,
                    std::size_t stride, Tally& tally) {
  const Answers answers = staged.answers(contestant), cuts = staged.cuts(contestant);
  std::vector<std::optional<PartErrors>> errors(answers.size());
  tbb::parallel_for(std::size_t{0}, errors.size(), [&](std::size_t i) {
    if (!staged.is_visible(i)) return;
    const auto stages = staged.stages(contestant, i, answers[i], cuts[i]);
    if (stages) errors[i] = errors_of(*stages, *contestant.format);
  });
  for (std::size_t i = 0; i < errors.size(); ++i) {
    tally.left_out += staged.is_visible(i) && !errors[i];
    if (!errors[i]) continue;
    const PartError& total = errors[i]->back();
    if (tally.triangles == 0 || total.px > tally.part(Part::total).px.max()) {
      tally.worst_view = view;
      tally.worst_triangle = i * stride;
    }
    ++tally.triangles;
    for (std::size_t p = 0; p < kParts.size(); ++p) {
      tally.parts[p].px.add((*errors[i])[p].px);
      tally.parts[p].ulp.add((*errors[i])[p].ulp);
    }
  }
}

}  // namespace

PartErrors errors_of(const Stages& stages, const Format& format) {
  const std::vector<StagePolygon>& polygons = stages.polygons;
  PartErrors errors;
  for (std::size_t i = 0; i < stages.parts.size(); ++i) {
    errors[static_cast<std::size_t>(stages.parts[i])] =
        part_error(polygons[i], polygons[i + 1], polygons.front(), format);
  }
  errors.back() = part_error(polygons.front(), polygons.back(), polygons.front(), format);
  return errors;
}

StagedView::StagedView(const Format& format, const View& view, std::vector<SceneTriangle> triangles)
    : format_(format),
      view_(view),
      triangles_(std::move(triangles)),
      frustum_truth_(Truth::of_frustum(frustum_cast<double>(view.frustum))),
      transformed_(triangles_.size()),
      truths_(triangles_.size()) {
  const auto use = [&]<class T>(const Projection<T>& projection) {
    to_clip_ = [=](const Vec4<double>& p) { return Vec4<double>(to_clip(projection, Vec3<T>(p))); };
    matrix_truth_ = Truth::of_matrix(projection);
  };
  if (format.is_float()) {
    use(Projection<float>(view.frustum));
  } else {
    use(Projection<double>(frustum_cast<double>(view.frustum)));
  }
  const Truth clip_truth = Truth::of_clip(frustum_truth_.volume());
  tbb::parallel_for(std::size_t{0}, truths_.size(), [&](std::size_t i) {
    const reference::InputTriangle input = reference::input_triangle(triangles_[i]);
    std::array<InputVertex, 3> clip;
    for (std::size_t v = 0; v < 3; ++v) {
      transformed_[i][v].position = to_clip_(Vec4<double>(triangles_[i][v].position, 1));
      clip[v] = input_vertex(transformed_[i][v].position);
    }
    truths_[i] = {stage_of(reference::clip(frustum_truth_, input.vertices, 0)),
                  stage_of(reference::clip(matrix_truth_, input.vertices, 0)),
                  stage_of(reference::clip(clip_truth, clip, 0))};
  });
}

Answers StagedView::answers(const Contestant& contestant) const {
  return clip(contestant, batch_of(view_, triangles_));
}

Answers StagedView::cuts(const Contestant& contestant) const {
  if (contestant.clipper == DistanceMatrix::name) {
    const ClipVolume& volume = frustum_truth_.volume();
    return format_.is_float() ? cut_weighted<float>(volume, transformed_)
                              : cut_weighted<double>(volume, transformed_);
  }
  // The batch method in view space computes what the scalar one does.
  const std::string_view method =
      contestant.clipper == "view/batch" ? "view/sutherland_hodgman" : contestant.clipper;
  const Contestant* cut = find_in_contract(method, contestant.scalar(), Contract::cut);
  if (cut != nullptr) return answers(*cut);
  Answers none(*contestant.format, 4);
  for (std::size_t i = 0; i < triangles_.size(); ++i) none.end_polygon();
  return none;
}

// x, y and z / w are linear over the divided triangle with w = 1, and so is 1/w as an attribute.
StagePolygon StagedView::cut_after_divide(std::size_t triangle) const {
  const ClipVolume& volume = frustum_truth_.volume();
  std::array<InputVertex, 3> vertices;
  for (std::size_t v = 0; v < 3; ++v) {
    const Vec4<double>& clip = transformed_[triangle][v].position;
    if (!(0 < clip[3] && 0 <= clip_distance(volume.depth, Plane::near, clip))) return {};
    std::array<double, 4> ndc;
    for (std::size_t c = 0; c < 4; ++c) ndc[c] = rounded(divided(clip)[c], format_);
    vertices[v] = {{ndc[0], ndc[1], ndc[2], 1}, {ndc[3]}};
  }
  StagePolygon r;
  for (const auto& v : reference::clip(Truth::of_clip(volume), vertices, 1).vertices) {
    r.push_back({v.x, v.y, v.z, v.attributes[0]});
  }
  return r;
}

std::array<StagePolygon, 3> StagedView::projected(const PolygonView& polygon) const {
  std::array<StagePolygon, 3> r;
  for (const VertexView v : polygon) {
    const InputVertex input = input_vertex(position_of(v));
    const Vec4<double> clip = to_clip_(position_of(v));
    if (!(0 < clip[3])) return {};
    r[0].push_back(project(frustum_truth_, input));
    r[1].push_back(project(matrix_truth_, input));
    r[2].push_back(divided(clip));
  }
  return r;
}

std::optional<Stages> StagedView::stages(const Contestant& contestant, std::size_t triangle,
                                         const PolygonView& answer,
                                         const PolygonView& after_cut) const {
  const StageOrder order = stage_order(contestant.clipper, contestant.promise);
  if (order == StageOrder::none || !is_usable(answer)) return std::nullopt;
  std::vector<ScreenPoint> screen;
  for (const VertexView v : answer) screen.push_back(screen_point(v));
  const auto truth = [&](std::size_t which) { return matched(truths_[triangle][which], screen); };

  using enum Part;
  Stages r{{truth(0)}, {matrix, transform, cut, divide}};
  if (order == StageOrder::view_space) {
    r.parts = {cut, matrix, transform, divide};
    for (StagePolygon& polygon : projected(after_cut)) r.polygons.push_back(std::move(polygon));
  } else if (order == StageOrder::cvv) {
    r.parts = {matrix, transform, divide, cut};
    r.polygons = {truth(0), truth(1), truth(2), matched(cut_after_divide(triangle), screen)};
  } else {
    const bool weighted = contestant.clipper == DistanceMatrix::name;
    StagePolygon quotients;
    for (const VertexView v : after_cut) {
      quotients.push_back(divided(position_of(v), weighted ? v[4].value : 1));
    }
    r.polygons = {truth(0), truth(1), truth(2), std::move(quotients)};
  }
  for (const StagePolygon& polygon : r.polygons) {
    if (polygon.size() != answer.size()) return std::nullopt;
  }
  if (r.parts.back() == divide) {
    const auto rounds_to = [&](const VertexView& v, const auto& quotients) {
      for (std::size_t i = 0; i < 4; ++i) {
        if (v[i].value != rounded(quotients[i], format_)) return false;
      }
      return true;
    };
    const auto shift = find_shift(answer, r.polygons.back(), rounds_to);
    if (!shift) return std::nullopt;
    for (std::size_t i = order == StageOrder::view_space ? 1 : 3; i < r.polygons.size(); ++i) {
      r.polygons[i] = rotated(std::move(r.polygons[i]), *shift);
    }
  }
  r.polygons.push_back(stage_of(answer));
  return r;
}

Contestants budget_contestants(std::string_view clipper_pattern,
                               const std::vector<std::string>& scalars) {
  std::vector<std::string> rounding;
  for (const char* scalar : {"float", "double"}) {
    if (std::ranges::count(scalars, scalar) > 0) rounding.emplace_back(scalar);
  }
  if (rounding.empty()) return {};
  Contestants contestants = select_contestants(clipper_pattern, rounding);
  std::erase_if(contestants, [](const Contestant* c) {
    return stage_order(c->clipper, c->promise) == StageOrder::none;
  });
  return contestants;
}

std::vector<Tally> measure(const Scene& scene, const Contestants& contestants,
                           std::size_t triangles_per_view, Progress& progress) {
  std::vector<Tally> tallies(contestants.size());
  const Spacing spacing = spacing_of(scene, triangles_per_view);
  for (std::size_t view = 0; view < scene.views.size(); ++view) {
    const auto triangles =
        sampled_view_triangles(scene, scene.views[view], spacing, 0, spacing.count);
    std::map<const Format*, StagedView> staged;
    for (std::size_t c = 0; c < contestants.size(); ++c) {
      const Format* format = contestants[c]->format;
      const auto found = staged.try_emplace(format, *format, scene.views[view], triangles).first;
      add_contestant(*contestants[c], found->second, view, spacing.stride, tallies[c]);
      progress.advance(spacing.count);
    }
  }
  return tallies;
}

}  // namespace clipscope::experiments::budget
