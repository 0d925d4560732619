// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/bit_promise.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <utility>

#include "experiments/guests/conduct.hpp"
#include "experiments/judge/compare.hpp"
#include "experiments/judge/containment.hpp"
#include "experiments/judge/cycle.hpp"
#include "experiments/judge/match.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments {
namespace {

// Attributes that are no clip distance.
std::size_t free_attributes(const Batch& batch) {
  return static_cast<std::size_t>(batch.attributes - batch.volume.clip_distances);
}

// The distance of a vertex from a plane, as a clipper in that scalar has it.
template <class T>
T distance_of(const Batch& batch, Plane plane, std::size_t vertex) {
  const auto at = [&](std::size_t i) {
    return scalar_from<T>(batch.number(vertex * batch.stride() + i));
  };
  if (batch.space == Space::clip) {
    return signed_distance(batch.volume.depth, plane,
                           ClipVertex<T, 0>{{at(0), at(1), at(2), at(3)}, {}});
  }
  const ViewVertex<T, 0> v{{at(0), at(1), at(2)}, {}};
  if (batch.matrix) {
    return signed_distance(batch.volume.depth, plane, to_clip(matrix_from<T>(*batch.matrix), v));
  }
  return signed_distance(projection_from<T>(batch.frustum).frustum, plane, v);
}

bool is_total(const PolygonView& polygon) {
  return std::ranges::all_of(polygon, [](const VertexView& v) {
    return is_finite(v[0]) && is_finite(v[1]) && is_finite(v[2]) && !is_nan(v[3]);
  });
}

// How much 1/w shrinks when all is scaled: by as much as w grows, which is 1 for a parallel
// projection.
int inv_w_exponent(const Batch& batch) {
  const bool is_parallel = batch.space == Space::view && !batch.matrix &&
                           batch.frustum.kind != ProjectionKind::perspective;
  return is_parallel ? 0 : kScaleExponent;
}

// Whether b is a with 1/w divided by 2^exponent.
bool same_scaled(const PolygonView& a, const PolygonView& b, int exponent) {
  if (a.size() != b.size()) return false;
  for (std::size_t v = 0; v < a.size(); ++v) {
    for (std::size_t i = 0; i < a[v].size(); ++i) {
      const Number back = i == 3 ? times_power_of_two(b[v][i], exponent) : b[v][i];
      if (!same_number(a[v][i], back, Likeness::by_value)) return false;
    }
  }
  return true;
}

bool same_bits(const PolygonView& a, const PolygonView& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t v = 0; v < a.size(); ++v) {
    if (!same_vertex(a[v], b[v], Likeness::by_bits)) return false;
  }
  return true;
}

// The first `count` numbers of vertices: the same set.
bool same_set(const std::vector<VertexView>& a, const std::vector<VertexView>& b,
              std::size_t count) {
  const auto covers = [count](const auto& x, const auto& y) {
    return std::ranges::all_of(x, [&](const VertexView& v) {
      return std::ranges::any_of(
          y, [&](const VertexView& u) { return same_vertex(u, v, count, Likeness::by_value); });
    });
  };
  return covers(a, b) && covers(b, a);
}

// Floats that a mean or a sum of products is apt to change or to lose: many bits, the largest, the
// smallest, a signed zero.
constexpr std::array<double, 6> kConstants = {
    double{0.1f}, 16777215, double{3e38f}, double{FLT_MAX}, double{FLT_TRUE_MIN}, -0.0};

bool is_value(const Number& x, double value) { return is_finite(x) && to_exact(x) == Exact(value); }

// What becomes of the last attributes, whose values are the same at all vertices; empty if they
// keep them.
std::string changed_constant(const PolygonView& polygon, const std::vector<double>& values) {
  for (const VertexView& v : polygon) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      const Number found = v[v.size() - values.size() + k];
      if (is_value(found, values[k])) continue;
      return fmt::format("not constant: an attribute that is {} at all vertices becomes {}",
                         values[k], found.value);
    }
  }
  return {};
}

}  // namespace

BitQuestions::BitQuestions(const Contestant& contestant, const Batch& batch, const Questions& asked,
                           const Answers& given)
    : contestant_(contestant), batch_(batch), given_(given), has_room_(room_of(batch)) {
  add_variants(asked);
  ask();
}

void BitQuestions::add_variants(const Questions& asked) {
  if (asked.contains(Question::rotation)) {
    asked_.push_back({Question::rotation, "with its second vertex first", rotated(batch_, 1)});
    asked_.push_back({Question::rotation, "with its third vertex first", rotated(batch_, 2)});
  }
  if (asked.contains(Question::scale)) {
    asked_.push_back({Question::scale, "scaled by 2^8", scaled(batch_, has_room_)});
  }
  if (asked.contains(Question::constants)) add_constants();
  if (asked.contains(Question::watertight)) add_watertight();
  if (asked.contains(Question::steady)) add_steady();
}

void BitQuestions::add_constants() {
  const std::size_t free = free_attributes(batch_);
  for (std::size_t used = 0; free > 0 && used < kConstants.size(); used += free) {
    std::vector<double> values;
    for (std::size_t k = 0; k < free; ++k) {
      values.push_back(kConstants[(used + k) % kConstants.size()]);
    }
    asked_.push_back({Question::constants, "with attributes that are constant",
                      with_constants(batch_, values), Order::same, values});
  }
}

// A NaN marks all that it touches. A barycentric clipper multiplies it by 0 everywhere; its weight
// of vertex 2 is exactly 0 on the edge, and 1 marks what has any. A guest is not asked for marks.
void BitQuestions::add_watertight() {
  const bool as_floats = contestant_.format->is_float();
  if (contestant_.format->is_exact()) return;
  if (contestant_.is_guest) {
    truth_ = reference::truth_of(batch_);
    asked_.push_back({Question::watertight, "beside its neighbour across the first edge",
                      neighbours(batch_, has_room_, as_floats)});
    return;
  }
  if (free_attributes(batch_) == 0) return;
  const bool is_barycentric = contestant_.clipper.starts_with("barycentric/");
  Variant left =
      marked(batch_, has_room_, is_barycentric ? 1 : std::numeric_limits<double>::quiet_NaN());
  Variant right = neighbours(left.batch(), has_room_, as_floats);
  asked_.push_back({Question::watertight, "with a mark", std::move(left)});
  asked_.push_back({Question::watertight, "with a mark, its neighbour", std::move(right)});
}

void BitQuestions::add_steady() {
  for (std::size_t t = 0; t < given_.size(); ++t) {
    if (given_[t].empty()) continue;
    lone_ = t;
    break;
  }
  const bool has_others = batch_.size() > 1;  // else it was asked alone already
  if (has_others) asked_.push_back({Question::steady, "alone", alone(batch_, lone_), Order::alone});
  if (contestant_.is_guest) {
    for (const Misconduct& m : conduct(contestant_, batch_, given_)) {
      misconduct_[m.primitive] = m.reason;
    }
    return;
  }
  asked_.push_back({Question::steady, "again", Variant(batch_)});
  asked_.push_back({Question::steady, "in another order", reversed(batch_), Order::reversed});
}

// Whether a guest is asked about it in one batch with others. What shall show whether its answers
// depend on others is asked apart.
bool BitQuestions::joins(const Asked& asked) const {
  if (!contestant_.is_guest || asked.question == Question::steady) return false;
  const bool same_volume = batch_.space == Space::clip && !batch_.matrix;
  return asked.question != Question::scale || same_volume;
}

// A guest is asked about one batch after the other: it may have but one process.
void BitQuestions::ask() {
  std::vector<double> joined;
  std::size_t rounds = 0;
  for (Asked& asked : asked_) {
    if (!joins(asked)) {
      asked.round = ++rounds;
      continue;
    }
    asked.first = joined.size() / (3 * batch_.stride());
    const std::span<const double> numbers = asked.variant.numbers();
    joined.insert(joined.end(), numbers.begin(), numbers.end());
  }
  rounds_.resize(rounds + 1);
  if (!joined.empty()) rounds_[0] = clip(contestant_, Variant(batch_, std::move(joined)).batch());
  const auto ask_one = [&](std::size_t i) {
    std::optional<Answers>& answers = rounds_[asked_[i].round];
    if (!joins(asked_[i])) answers = clip(contestant_, asked_[i].variant.batch());
  };
  if (contestant_.is_guest || batch_.size() == 1) {
    for (std::size_t i = 0; i < asked_.size(); ++i) ask_one(i);
  } else {
    tbb::parallel_for(std::size_t{0}, asked_.size(), ask_one);
  }
}

std::optional<PolygonView> BitQuestions::answer(const Asked& asked, std::size_t triangle) const {
  const Answers& answers = *rounds_[asked.round];
  switch (asked.order) {
    case Order::same: return answers[asked.first + triangle];
    case Order::reversed: return answers[asked.first + batch_.size() - 1 - triangle];
    case Order::alone: break;
  }
  if (triangle != lone_) return std::nullopt;
  return answers[asked.first];
}

std::string BitQuestions::failure(std::size_t triangle) const {
  for (const Asked& asked : asked_) {
    const std::optional<PolygonView> polygon = answer(asked, triangle);
    if (!polygon || !polygon->failure()) continue;
    return fmt::format("asked {}: {}", asked.how, polygon->failure()->reason);
  }
  return {};
}

// Of all variants of that question; judge(asked, polygon): what is wrong, or empty.
template <class Judge>
Found BitQuestions::judge_variants(Question question, std::size_t triangle,
                                   const Judge& judge) const {
  Found found;
  for (const Asked& asked : asked_) {
    if (asked.question != question) continue;
    const std::optional<PolygonView> polygon = answer(asked, triangle);
    if (!polygon || polygon->failure()) continue;
    found.judged = true;
    found.reason = judge(asked, *polygon);
    if (!found.reason.empty()) return found;
  }
  return found;
}

Found BitQuestions::judge(Question question, std::size_t triangle) const {
  const PolygonView given = given_[triangle];
  const auto reason_if = [](bool is_broken, std::string reason) {
    return is_broken ? std::move(reason) : std::string();
  };
  switch (question) {
    case Question::total: return judge_total(triangle);
    case Question::confined: return judge_confined(triangle);
    case Question::rotation:
      return judge_variants(question, triangle, [&](const Asked&, const PolygonView& polygon) {
        return reason_if(!same_cycle(given, polygon, Likeness::by_value),
                         "another vertex first gives other bits");
      });
    case Question::scale:
      if (!has_room_[triangle]) return {};
      return judge_variants(question, triangle, [&](const Asked&, const PolygonView& polygon) {
        return reason_if(!same_scaled(given, polygon, inv_w_exponent(batch_)),
                         "scaled by 2^8 it gives other bits");
      });
    case Question::constants:
      return judge_variants(question, triangle,
                            [&](const Asked& asked, const PolygonView& polygon) {
                              return changed_constant(polygon, asked.constants);
                            });
    case Question::steady: return judge_steady(triangle);
    case Question::watertight: return judge_watertight(triangle);
    default: return {};
  }
}

Found BitQuestions::judge_steady(std::size_t triangle) const {
  const auto misconduct = misconduct_.find(triangle);
  if (misconduct != misconduct_.end()) return Found::broken("not steady: it " + misconduct->second);
  const PolygonView given = given_[triangle];
  Found found = judge_variants(
      Question::steady, triangle, [&](const Asked& asked, const PolygonView& polygon) {
        if (same_bits(given, polygon)) return std::string();
        return fmt::format("not steady: asked {} it gives other bits", asked.how);
      });
  found.judged = true;
  return found;
}

Found BitQuestions::judge_total(std::size_t triangle) const {
  if (!is_total(given_[triangle])) return Found::broken("not total: a coordinate is not finite");
  // What overflowed is known of the whole batch alone.
  if (given_.overflowed && clip(contestant_, alone(batch_, triangle).batch()).overflowed) {
    return Found::broken("not total: more vertices than there is room for");
  }
  return Found::kept();
}

// The quotient of two double-doubles is not rounded correctly and may exceed a bound.
Found BitQuestions::judge_confined(std::size_t triangle) const {
  if (contestant_.format->precision == kFormat<dd_real>.precision) return {};
  const double beyond = overshoot(batch_.volume, given_[triangle]);
  if (beyond == 0) return Found::kept();
  return Found::broken(
      fmt::format("not confined: a coordinate is {:.3g} beyond its bound in NDC", beyond));
}

// Whether the first two vertices have the distance 0 from some plane, in the contestant's scalar.
bool BitQuestions::first_edge_lies_in_a_plane(std::size_t triangle) const {
  return with_scalar(*contestant_.format, [&]<class T>() {
    return std::ranges::any_of(kAllPlanes, [&](Plane plane) {
      return distance_of<T>(batch_, plane, 3 * triangle) == T(0) &&
             distance_of<T>(batch_, plane, 3 * triangle + 1) == T(0);
    });
  });
}

// The vertices on the edge from vertex 0 to vertex 1: those that the mark in the last attribute of
// vertex 2 did not reach; of a guest those that stand for vertices of the exact polygon that have
// no part of vertex 2. Nothing where it has not as many as that.
std::optional<std::vector<VertexView>> BitQuestions::on_first_edge(
    const Batch& batch, std::size_t triangle, const PolygonView& polygon) const {
  std::vector<VertexView> edge;
  if (!truth_) {
    std::ranges::copy_if(polygon, std::back_inserter(edge),
                         [](const VertexView& v) { return v[v.size() - 1].value == 0; });
    return edge;
  }
  std::vector<reference::InputVertex> vertices = input_vertices(batch, triangle);
  const auto mark = static_cast<std::size_t>(batch.volume.clip_distances);
  for (std::size_t v = 0; v < 3; ++v) vertices[v].attributes[mark] = v == 2;
  const TruthPolygon exact = truth_polygon(*truth_, vertices, static_cast<int>(mark) + 1);
  const std::vector<VertexView> found = distinct_vertices(polygon);
  if (!exact.is_visible() || found.size() != exact.exact.vertices.size()) return std::nullopt;
  const std::size_t shift = best_rotation(screen_points(exact.approximation), screen_points(found));
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (exact.exact.vertices[i].attributes[mark].sign() != 0) continue;
    edge.push_back(found[(i + shift) % found.size()]);
  }
  return edge;
}

Found BitQuestions::judge_watertight(std::size_t triangle) const {
  struct Side {
    const Batch* batch;
    PolygonView polygon;
  };
  std::vector<Side> sides;
  if (contestant_.is_guest) sides.push_back({&batch_, given_[triangle]});
  for (const Asked& asked : asked_) {
    if (asked.question != Question::watertight) continue;
    sides.push_back({&asked.variant.batch(), *answer(asked, triangle)});
  }
  if (sides.size() != 2 || !has_room_[triangle] || first_edge_lies_in_a_plane(triangle)) return {};
  if (std::ranges::any_of(sides, [](const Side& s) { return s.polygon.empty(); })) return {};
  const auto left = on_first_edge(*sides[0].batch, triangle, sides[0].polygon);
  const auto right = on_first_edge(*sides[1].batch, triangle, sides[1].polygon);
  if (!left || !right) return {};
  constexpr std::size_t kPlace = 3;
  const std::size_t numbers = given_.stride();
  if (same_set(*left, *right, numbers)) return Found::kept();
  return Found::broken(
      fmt::format("not watertight: a neighbour has other {} on the shared edge",
                  same_set(*left, *right, kPlace) ? "1/w or attributes" : "vertices"));
}

}  // namespace clipscope::experiments
