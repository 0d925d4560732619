// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/mutants.hpp"

#include <algorithm>
#include <cassert>

namespace clipscope::reference {
namespace {

constexpr BugInfo kBugs[] = {
    {Bug::epsilon_in_denominator, "epsilon_in_denominator", "t = d_a / (d_a - d_b + 1e-10)"},
    {Bug::absolute_w, "absolute_w", "|w| instead of w"},
    {Bug::w_sign_ignored, "w_sign_ignored", "|x / w| <= 1 without w > 0"},
    {Bug::w_plane_left_out, "w_plane_left_out",
     "divides, then cuts, without a cut at w > 0 before"},
    {Bug::w_plane_epsilon, "w_plane_epsilon", "cuts at w = 1e-5 first"},
    {Bug::plane_epsilon, "plane_epsilon", "d >= -1e-6 is inside"},
    {Bug::open_volume, "open_volume", "d > 0 is inside, 0 is not"},
    {Bug::far_end_weighted, "far_end_weighted", "t from the wrong end of the edge"},
    {Bug::nearer_end_swapped, "nearer_end_swapped",
     "t from the end nearer to the plane, the ends swapped"},
    {Bug::near_side_flipped, "near_side_flipped", "keeps what is before the near plane"},
    {Bug::attributes_in_ndc, "attributes_in_ndc", "attributes interpolated after the divide"},
    {Bug::attribute_axis_of_clip_space, "attribute_axis_of_clip_space",
     "t of attributes along the longest axis of clip space, measured in NDC"},
    {Bug::inv_w_linear, "inv_w_linear", "1/w interpolated with the t of clip space"},
    {Bug::depth_from_zero, "depth_from_zero", "near at z = 0 whatever the depth range"},
    {Bug::rejects_without_common_plane, "rejects_without_common_plane",
     "rejects if every vertex is outside of some plane"},
    {Bug::drops_whole, "drops_whole", "drops what has a vertex outside"},
    {Bug::last_edge_left_out, "last_edge_left_out", "the edge from the last vertex is not cut"},
    {Bug::eight_vertices, "eight_vertices", "room for eight vertices"},
    {Bug::closed_sides, "closed_sides", "open sides own their points"},
    {Bug::opposite_sides_open, "opposite_sides_open",
     "the sides opposite to the open ones are open"},
    {Bug::skips_left, "skips_left", "the left plane left out"},
    {Bug::skips_right, "skips_right", "the right plane left out"},
    {Bug::skips_bottom, "skips_bottom", "the bottom plane left out"},
    {Bug::skips_top, "skips_top", "the top plane left out"},
    {Bug::skips_near, "skips_near", "the near plane left out"},
    {Bug::skips_far, "skips_far", "the far plane left out"},
};

constexpr int kNear = 4, kSixPlanes = 6;

// x, y, z, w; the sum of the weights, 1 but for vertices divided by w; 1/w as interpolated;
// attributes times the sum.
using Vertex = std::vector<Rational>;
enum Component { kX, kY, kZ, kW, kSum, kInvW, kAttributes };

class Textbook {
 public:
  Textbook(Bug bug, const Truth& truth) : bug_(bug), volume_(truth.volume()) {}

  std::vector<Vertex> clip(std::vector<Vertex> polygon) const {
    const bool is_segment = polygon.size() < 3;
    if (is_given_up(polygon)) return {};
    if (bug_ == Bug::w_plane_epsilon) {
      const Rational epsilon = to_rational(1e-5);
      polygon =
          cut(polygon, is_segment, [&](const Vertex& v) { return Rational(v[kW] - epsilon); });
    }
    for (int plane = 0; plane < kSixPlanes + volume_.clip_distances; ++plane) {
      if (!is_skipped(plane)) {
        polygon = cut(polygon, is_segment, [&](const Vertex& v) { return distance(v, plane); });
      }
      if (bug_ == Bug::eight_vertices && polygon.size() > 8) polygon.resize(8);
    }
    if (!is_owned(polygon)) return {};
    return polygon;
  }

  bool is_visible(const Vertex& v) const {
    return v[kW] > 0 || (bug_ == Bug::w_sign_ignored && v[kW] < 0);
  }

 private:
  bool is_skipped(int plane) const {
    const bool clamped = (volume_.depth_clamp.near && plane == kNear) ||
                         (volume_.depth_clamp.far && plane == kNear + 1);
    return clamped || plane == static_cast<int>(bug_) - static_cast<int>(Bug::skips_left);
  }

  // Left, right, bottom, top, near, far, clip distances.
  Rational distance(const Vertex& v, int plane) const {
    if (plane >= kSixPlanes) return v[kAttributes + static_cast<std::size_t>(plane - kSixPlanes)];
    Rational d;
    if (plane < kNear) {
      const Rational c = v[static_cast<std::size_t>(plane / 2)];
      d = plane % 2 == 0 ? Rational(v[kW] + c) : Rational(v[kW] - c);
    } else {
      d = depth_distance(v, plane == kNear);
    }
    const bool negated = (bug_ == Bug::w_sign_ignored && v[kW] < 0) ||
                         (bug_ == Bug::near_side_flipped && plane == kNear);
    return negated ? Rational(-d) : d;
  }

  Rational depth_distance(const Vertex& v, bool near) const {
    const bool at_low_end = near != (volume_.depth == DepthRange::reversed);
    if (!at_low_end) return Rational(v[kW] - v[kZ]);
    const bool from_minus_w =
        volume_.depth == DepthRange::minus_one_to_one && bug_ != Bug::depth_from_zero;
    return from_minus_w ? Rational(v[kW] + v[kZ]) : v[kZ];
  }

  // Whether some vertex of the closed part is strictly inside, for each open side.
  bool is_owned(const std::vector<Vertex>& part) const {
    if (bug_ == Bug::closed_sides) return true;
    const OpenSides& open = volume_.open_sides;
    const bool is_open[] = {open.left, open.right, open.bottom, open.top};
    for (int side = 0; side < kNear; ++side) {
      const bool opposite = bug_ == Bug::opposite_sides_open;
      if (!is_open[opposite ? side ^ 1 : side]) continue;
      const auto is_inside = [&](const Vertex& v) { return distance(v, side) > 0; };
      if (std::ranges::none_of(part, is_inside)) return false;
    }
    return true;
  }

  bool is_given_up(const std::vector<Vertex>& polygon) const {
    const auto is_outside = [&](const Vertex& v) {
      for (int plane = 0; plane < kSixPlanes + volume_.clip_distances; ++plane) {
        if (!is_skipped(plane) && distance(v, plane) < 0) return true;
      }
      return false;
    };
    return (bug_ == Bug::rejects_without_common_plane &&
            std::ranges::all_of(polygon, is_outside)) ||
           (bug_ == Bug::drops_whole && std::ranges::any_of(polygon, is_outside));
  }

  // 1 is inside, 0 on the plane and inside too.
  int side(const Rational& d) const {
    if (bug_ == Bug::plane_epsilon) return d >= to_rational(-1e-6) ? 1 : -1;
    if (bug_ == Bug::open_volume) return d > 0 ? 1 : -1;
    return d > 0 ? 1 : (d < 0 ? -1 : 0);
  }

  template <class Distance>
  std::vector<Vertex> cut(const std::vector<Vertex>& polygon, bool is_segment,
                          const Distance& distance) const {
    std::vector<Vertex> r;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vertex& a = polygon[i];
      const Rational d_a = distance(a);
      if (side(d_a) >= 0) r.push_back(a);
      const bool last = i + 1 == polygon.size();
      if (last && (is_segment || bug_ == Bug::last_edge_left_out)) break;
      const Vertex& b = polygon[(i + 1) % polygon.size()];
      const Rational d_b = distance(b);
      if (side(d_a) * side(d_b) < 0) r.push_back(meet(a, d_a, b, d_b));
    }
    return r;
  }

  Vertex meet(const Vertex& a, const Rational& d_a, const Vertex& b, const Rational& d_b) const {
    const Rational epsilon = bug_ == Bug::epsilon_in_denominator ? to_rational(1e-10) : Rational(0);
    const Rational denominator = d_a - d_b + epsilon;
    Rational t = denominator == 0 ? Rational(0) : Rational(d_a / denominator);
    if (bug_ == Bug::far_end_weighted || (bug_ == Bug::nearer_end_swapped && abs(d_a) < abs(d_b))) {
      t = 1 - t;
    }
    const auto mix = [&](std::size_t i, const Rational& s) {
      return Rational((1 - s) * a[i] + s * b[i]);
    };
    Vertex r;
    for (std::size_t i = 0; i < kAttributes; ++i) r.push_back(mix(i, t));
    const Rational s = attribute_weight(a, b, r, t);
    for (std::size_t i = kAttributes; i < a.size(); ++i) r.push_back(mix(i, s));
    return r;
  }

  // The weight of b for attributes at the point p, which has the weight t in clip space.
  Rational attribute_weight(const Vertex& a, const Vertex& b, const Vertex& p,
                            const Rational& t) const {
    if (a[kW] == 0 || b[kW] == 0 || p[kW] == 0) return t;
    if (bug_ == Bug::attributes_in_ndc) return Rational(t * b[kW] / p[kW]);
    if (bug_ == Bug::attribute_axis_of_clip_space) {
      const auto length = [&](std::size_t i) { return Rational(abs(b[i] - a[i])); };
      std::size_t axis = kX;
      if (length(kY) > length(axis)) axis = kY;
      if (length(kZ) > length(axis)) axis = kZ;
      const auto ndc = [&](const Vertex& v) { return Rational(v[axis] / v[kW]); };
      const Rational whole = ndc(b) - ndc(a);
      return whole == 0 ? Rational(0) : Rational((ndc(p) - ndc(a)) / whole);
    }
    return t;
  }

  const Bug bug_;
  const ClipVolume volume_;
};

Vertex input(Bug bug, const Truth& truth, const InputVertex& vertex, int attribute_count) {
  Vertex r;
  for (const Rational& c : truth.clip_position(vertex)) r.push_back(c);
  if (bug == Bug::absolute_w) r[kW] = abs(r[kW]);
  r.push_back(1);
  r.push_back(r[kW] == 0 ? Rational(0) : Rational(1 / r[kW]));
  for (int k = 0; k < attribute_count; ++k) {
    r.push_back(to_rational(vertex.attributes[static_cast<std::size_t>(k)]));
  }
  if (bug == Bug::w_plane_left_out && r[kW] != 0) {
    const Rational w = r[kW];
    for (Rational& component : r) component /= w;
  }
  return r;
}

// Pre-conditions: w and the sum are not 0.
RationalVertex output(Bug bug, const Vertex& v) {
  RationalVertex r = {Rational(v[kX] / v[kW]),
                      Rational(v[kY] / v[kW]),
                      Rational(v[kZ] / v[kW]),
                      Rational(v[kSum] / v[kW]),
                      {}};
  if (bug == Bug::inv_w_linear) r.inv_w = v[kInvW];
  for (std::size_t i = kAttributes; i < v.size(); ++i) {
    r.attributes.push_back(Rational(v[i] / v[kSum]));
  }
  return r;
}

}  // namespace

std::span<const BugInfo> all_bugs() { return kBugs; }

std::vector<RationalVertex> textbook_polygon(Bug bug, const Truth& truth,
                                             std::span<const InputVertex> vertices,
                                             int attribute_count) {
  assert(is_finite(vertices, attribute_count));
  std::vector<Vertex> polygon;
  for (const InputVertex& vertex : vertices) {
    polygon.push_back(input(bug, truth, vertex, attribute_count));
  }
  const Textbook clipper(bug, truth);
  std::vector<RationalVertex> r;
  for (const Vertex& v : clipper.clip(polygon)) {
    if (!clipper.is_visible(v) || v[kSum] == 0) continue;
    RationalVertex vertex = output(bug, v);
    const bool seen = std::ranges::any_of(r, [&](const RationalVertex& other) {
      return other.x == vertex.x && other.y == vertex.y && other.z == vertex.z;
    });
    if (!seen) r.push_back(std::move(vertex));
  }
  return r;
}

std::vector<RationalVertex> textbook(Bug bug, const Truth& truth,
                                     std::span<const InputVertex> vertices, int attribute_count) {
  std::vector<RationalVertex> r = textbook_polygon(bug, truth, vertices, attribute_count);
  std::sort(r.begin(), r.end());
  return r;
}

std::vector<RationalVertex> textbook(Bug bug, const Truth& truth, const InputTriangle& triangle) {
  return textbook(bug, truth, triangle.vertices, triangle.attribute_count);
}

bool catches(Bug bug, const Truth& truth, std::span<const InputVertex> vertices,
             int attribute_count) {
  return textbook(bug, truth, vertices, attribute_count) !=
         vertex_set(clip(truth, vertices, attribute_count));
}

}  // namespace clipscope::reference
