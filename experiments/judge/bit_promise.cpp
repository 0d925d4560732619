// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/judge/promise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <limits>
#include <vector>

#include "experiments/judge/containment.hpp"
#include "experiments/judge/cycle.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments {
namespace {

constexpr int kScaleExponent = 8;
constexpr int kRoom = 40;  // |x| in [2^-kRoom, 2^kRoom] or 0: products neither over- nor underflow

using Numbers = std::vector<double>;  // of a vertex: position, attributes
using Triangle = std::array<Numbers, 3>;

bool has_room(const Numbers& numbers) {
  return std::ranges::all_of(numbers,
                             [](double x) { return x == 0 || std::abs(std::ilogb(x)) <= kRoom; });
}

// Asks a contestant about triangles like the one of a batch.
class Asked {
 public:
  Asked(const Contestant& contestant, const Batch& batch)
      : contestant_(contestant), batch_(batch) {}

  Triangle triangle() const {
    Triangle t;
    for (std::size_t i = 0; i < 3 * batch_.stride(); ++i) {
      t[i / batch_.stride()].push_back(batch_.number(i));
    }
    return t;
  }
  // In a volume that is scaled by 2^exponent with the triangle.
  Answers clip(const Triangle& triangle, int exponent = 0) const {
    Numbers flat;
    for (const Numbers& v : triangle) flat.insert(flat.end(), v.begin(), v.end());
    Batch batch = batch_;
    batch.numbers = std::span<const double>(flat);
    Frustum<double>& f = batch.frustum;
    for (double* length : {&f.near, &f.far, &f.left, &f.right, &f.bottom, &f.top}) {
      *length = std::ldexp(*length, exponent);
    }
    if (batch.matrix) {
      for (Vec4<double>& row : *batch.matrix) row[3] = std::ldexp(row[3], exponent);
    }
    return experiments::clip(contestant_, batch);
  }
  // How much 1/w shrinks when all is scaled: by as much as w grows, which is 1 for a parallel
  // projection.
  int inv_w_exponent() const {
    const bool is_parallel = batch_.space == Space::view && !batch_.matrix &&
                             batch_.frustum.kind != ProjectionKind::perspective;
    return is_parallel ? 0 : kScaleExponent;
  }
  // Whether the first two vertices have the distance 0 from some plane, in the contestant's scalar.
  bool first_edge_lies_in_a_plane() const {
    return with_scalar(*contestant_.format, [&]<class T>() {
      return std::ranges::any_of(kAllPlanes, [&](Plane plane) {
        return distance<T>(plane, 0) == T(0) && distance<T>(plane, 1) == T(0);
      });
    });
  }
  // Whether neither the triangle nor a matrix has numbers whose products over- or underflow.
  bool has_room() const {
    const auto row_has_room = [](const Vec4<double>& row) {
      return experiments::has_room(Numbers{row[0], row[1], row[2], row[3]});
    };
    const auto vertex_has_room = [](const Numbers& v) { return experiments::has_room(v); };
    return std::ranges::all_of(triangle(), vertex_has_room) &&
           (!batch_.matrix || std::ranges::all_of(*batch_.matrix, row_has_room));
  }
  std::size_t dimension() const { return static_cast<std::size_t>(batch_.dimension()); }
  int attributes() const { return batch_.attributes; }
  const ClipVolume& volume() const { return batch_.volume; }
  int clip_distances() const { return volume().clip_distances; }
  const Contestant& contestant() const { return contestant_; }

 private:
  template <class T>
  T distance(Plane plane, std::size_t vertex) const {
    const auto at = [&](std::size_t i) {
      return scalar_from<T>(batch_.number(vertex * batch_.stride() + i));
    };
    if (batch_.space == Space::view) {
      const ViewVertex<T, 0> v{{at(0), at(1), at(2)}, {}};
      if (batch_.matrix) {
        return signed_distance(batch_.volume.depth, plane,
                               to_clip(matrix_from<T>(*batch_.matrix), v));
      }
      return signed_distance(projection_from<T>(batch_.frustum).frustum, plane, v);
    }
    return signed_distance(batch_.volume.depth, plane,
                           ClipVertex<T, 0>{{at(0), at(1), at(2), at(3)}, {}});
  }

  const Contestant& contestant_;
  const Batch& batch_;
};

bool is_total(const Answers& answers) {
  return !answers.overflowed && answers[0].failure() == nullptr &&
         std::ranges::all_of(answers[0], [](const VertexView& v) {
           return is_finite(v[0]) && is_finite(v[1]) && is_finite(v[2]) && !is_nan(v[3]);
         });
}

Triangle scaled(Triangle triangle, std::size_t dimension) {
  for (Numbers& v : triangle) {
    for (std::size_t i = 0; i < dimension; ++i) v[i] = std::ldexp(v[i], kScaleExponent);
  }
  return triangle;
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

// The vertices on the edge from vertex 0 to vertex 1: those that the mark in the last attribute of
// vertex 2 did not reach (see is_watertight).
std::vector<VertexView> on_first_edge(const PolygonView& polygon) {
  std::vector<VertexView> edge;
  for (const VertexView& v : polygon) {
    if (v[v.size() - 1].value == 0) edge.push_back(v);
  }
  return edge;
}

bool same_set(const std::vector<VertexView>& a, const std::vector<VertexView>& b) {
  const auto covers = [](const auto& x, const auto& y) {
    return std::ranges::all_of(x, [&](const VertexView& v) {
      return std::ranges::any_of(
          y, [&](const VertexView& u) { return same_vertex(u, v, Likeness::by_value); });
    });
  };
  return covers(a, b) && covers(b, a);
}

// The triangle on the other side of the edge from vertex 0 to vertex 1, its third vertex across.
Triangle neighbour(const Triangle& t, std::size_t dimension) {
  Triangle r = {t[1], t[0], t[2]};
  for (std::size_t i = 0; i < dimension; ++i) r[2][i] = t[0][i] + t[1][i] - t[2][i];
  return r;
}

// A NaN marks all that it touches. A barycentric clipper multiplies it by 0 everywhere; its weight
// of vertex 2 is exactly 0 on the edge, and 1 marks what has any.
// Pre-condition: no attribute is a clip distance but those before the last.
bool is_watertight(const Asked& asked, Triangle triangle) {
  const bool is_barycentric = asked.contestant().clipper.starts_with("barycentric/");
  for (Numbers& v : triangle) v.back() = 0;
  triangle[2].back() = is_barycentric ? 1 : std::numeric_limits<double>::quiet_NaN();
  const Answers left = asked.clip(triangle);
  const Answers right = asked.clip(neighbour(triangle, asked.dimension()));
  return left[0].empty() || right[0].empty() ||
         same_set(on_first_edge(left[0]), on_first_edge(right[0]));
}

// Floats that a mean or a sum of products is apt to change or to lose: many bits, the largest, the
// smallest, a signed zero.
constexpr std::array<double, 6> kConstants = {
    double{0.1f}, 16777215, double{3e38f}, double{FLT_MAX}, double{FLT_TRUE_MIN}, -0.0};

bool is_value(const Number& x, double value) { return is_finite(x) && to_exact(x) == Exact(value); }

// What becomes of attributes that have one value at all vertices; empty if they keep it. Clip
// distances stay as they are.
std::string changed_constant(const Asked& asked, Triangle triangle) {
  const auto first = asked.dimension() + static_cast<std::size_t>(asked.clip_distances());
  const std::size_t end = triangle[0].size();
  for (std::size_t used = 0; used < kConstants.size(); used += end - first) {
    const auto value_at = [&](std::size_t i) {
      return kConstants[(used + i - first) % kConstants.size()];
    };
    for (Numbers& v : triangle) {
      for (std::size_t i = first; i < end; ++i) v[i] = value_at(i);
    }
    const Answers answers = asked.clip(triangle);
    for (const VertexView& v : answers[0]) {
      for (std::size_t i = first; i < end; ++i) {
        const Number found = v[4 + i - asked.dimension()];
        if (is_value(found, value_at(i))) continue;
        return fmt::format("not constant: an attribute that is {} at all vertices becomes {}",
                           value_at(i), found.value);
      }
    }
  }
  return {};
}

// What is wrong with the numbers of an answer, whatever else the clipper answers. The quotient of
// two double-doubles is not rounded correctly and may exceed a bound.
std::string broken_values(const Asked& asked, const Triangle& triangle,
                          const PolygonView& polygon) {
  const Promise& promise = asked.contestant().promise;
  const bool is_double_double = polygon.format().precision == kFormat<dd_real>.precision;
  if (promise.confined && !is_double_double) {
    const double beyond = overshoot(asked.volume(), polygon);
    if (beyond > 0) {
      return fmt::format("not confined: a coordinate is {:.3g} beyond its bound in NDC", beyond);
    }
  }
  const bool has_free_attribute = asked.attributes() > asked.clip_distances();
  return promise.constants && has_free_attribute ? changed_constant(asked, triangle) : "";
}

}  // namespace

std::string broken_bits(const Contestant& contestant, const Batch& batch) {
  const Promise& promise = contestant.promise;
  const Asked asked(contestant, batch);
  const Triangle triangle = asked.triangle();
  const Answers answers = asked.clip(triangle);
  if (promise.total && !is_total(answers)) return "not total: a coordinate is not finite";
  if (const std::string reason = broken_values(asked, triangle, answers[0]); !reason.empty()) {
    return reason;
  }
  if (promise.rotation_invariant) {
    const Answers rotated = asked.clip({triangle[1], triangle[2], triangle[0]});
    if (!same_cycle(answers[0], rotated[0], Likeness::by_value)) {
      return "another vertex first gives other bits";
    }
  }
  if (!asked.has_room()) return {};
  if (promise.scale_invariant) {
    const Answers larger = asked.clip(scaled(triangle, asked.dimension()), kScaleExponent);
    if (!same_scaled(answers[0], larger[0], asked.inv_w_exponent())) {
      return "scaled by 2^8 it gives other bits";
    }
  }
  const bool has_free_attribute = asked.attributes() > asked.clip_distances();
  if (promise.watertight && !contestant.format->is_exact() && has_free_attribute &&
      !asked.first_edge_lies_in_a_plane() && !is_watertight(asked, triangle)) {
    return "not watertight: a neighbour has other vertices on the shared edge";
  }
  return {};
}

void break_by_bits(PromiseCheck& check, const std::string& reason) {
  if (reason.empty()) return;
  check.verdict = PromiseVerdict::broken;
  check.reason = reason;
}

}  // namespace clipscope::experiments
