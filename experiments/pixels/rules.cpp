// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pixels/rules.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "reference/exact_clip.hpp"

namespace clipscope::experiments {
namespace {

// The vertices of the clipped polygon: what is linear in clip space, divided by w.
struct PolygonValues {
  bool is_known = false;
  std::vector<double> quotients;
  std::vector<double> sizes;  // the same with all terms positive, and how w multiplies its error
  // How far a cut that is found up to some t (cuts.hpp) may take a quotient along its edge.
  double slide = 0;
};

// Of the exact polygon. Attributes: the clip distances, then n, |n| and |w|.
reference::ExactPolygon clipped(const DrawCall& call, std::span<const std::uint32_t> vertices,
                                const std::array<double, 3>& n) {
  std::vector<reference::InputVertex> input;
  const auto distances = static_cast<std::size_t>(call.volume.clip_distances);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const DrawVertex& v = call.vertices[vertices[i]];
    reference::InputVertex r;
    std::copy(v.position.begin(), v.position.end(), r.position.begin());
    std::copy_n(v.clip_distances.begin(), distances, r.attributes.begin());
    r.attributes[distances] = n[i];
    r.attributes[distances + 1] = std::abs(n[i]);
    r.attributes[distances + 2] = std::abs(v.position[3]);
    input.push_back(r);
  }
  return reference::clip(reference::Truth::of_clip(call.volume), input,
                         static_cast<int>(distances) + 3);
}

// How far the values of vertices are apart.
double spread(std::span<const double> values) {
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  return *greatest - *least;
}

PolygonValues polygon_values(const DrawCall& call, std::span<const std::uint32_t> vertices,
                             const std::array<double, 3>& n) {
  PolygonValues r;
  const reference::ExactPolygon polygon = clipped(call, vertices, n);
  // With depth clamp a vertex may be at infinity, and is left out there.
  r.is_known = polygon.vertices.size() >= 2 && !call.volume.depth_clamp;
  std::array<double, 3> w = {};
  for (std::size_t i = 0; i < vertices.size(); ++i) w[i] = call.vertices[vertices[i]].position[3];
  const double moved_n = kEpsilon * kClip * spread(std::span(n).first(vertices.size()));
  const double moved_w = kEpsilon * kClip * spread(std::span(w).first(vertices.size()));
  const auto first = static_cast<std::size_t>(call.volume.clip_distances);
  for (const auto& vertex : polygon.vertices) {
    const double inv_w = reference::approximate(vertex.inv_w);
    const auto over_w = [&](std::size_t k) {
      return reference::approximate(vertex.attributes[first + k]) * inv_w;
    };
    r.quotients.push_back(over_w(0));
    r.sizes.push_back(over_w(1) * (1 + over_w(2)));
    // |(N + dN) / (w + dw) - N / w| <= (|dN| + |N / w| |dw|) / (w - |dw|).
    const double w_left = 1 / inv_w - moved_w;
    if (w_left <= 0) r.is_known = false;
    r.slide = std::max(r.slide, (moved_n + std::abs(over_w(0)) * moved_w) / w_left);
  }
  return r;
}

double magnitude(double v) { return std::abs(v); }

class RuleMaker {
 public:
  RuleMaker(const DrawCall& call, std::span<const std::uint32_t> vertices)
      : call_(call), vertices_(vertices) {
    is_in_front_ = std::all_of(vertices.begin(), vertices.end(), [&](std::uint32_t number) {
      return call.vertices[number].position[3] > 0;
    });
  }

  std::vector<ValueRule> make() {
    for (std::size_t c = 0; c < 4; ++c) {
      const auto varying = [c](const DrawVertex& v) { return static_cast<double>(v.varying[c]); };
      perspective(Quantity::smooth, c, varying);
      linear(Quantity::noperspective, c, [c](const DrawVertex& v) {
        return static_cast<double>(v.varying[c]) * v.position[3];
      });
    }
    for (std::size_t c = 0; c < static_cast<std::size_t>(call_.volume.clip_distances); ++c) {
      perspective(Quantity::clip_distances, c,
                  [c](const DrawVertex& v) { return static_cast<double>(v.clip_distances[c]); });
    }
    const auto z = [](const DrawVertex& v) { return static_cast<double>(v.position[2]); };
    linear(Quantity::frag_coord, 2, z);
    linear(Quantity::frag_coord, 3, [](const DrawVertex&) { return 1.0; });
    linear(Quantity::depth, 0, z);
    return std::move(rules_);
  }

 private:
  template <class Of>
  std::array<double, 3> numerators(Of&& of) const {
    std::array<double, 3> n = {};
    for (std::size_t i = 0; i < vertices_.size(); ++i) n[i] = of(call_.vertices[vertices_[i]]);
    return n;
  }

  template <class Of>
  void perspective(Quantity quantity, std::size_t channel, Of&& of) {
    if (!call_.quantities[bit(quantity)]) return;
    ValueRule rule{quantity, channel, {numerators(of), true}};
    rule.has_linear_twin = quantity == Quantity::clip_distances;
    const auto& n = rule.interpolant.of_vertices;
    const auto end = n.begin() + static_cast<std::ptrdiff_t>(vertices_.size());
    const auto [least, greatest] = std::minmax_element(n.begin(), end);
    rule.least = *least;
    rule.greatest = *greatest;
    rule.size = std::max(magnitude(*least), magnitude(*greatest));
    rule.slack = kEpsilon * kInterpolation * rule.size;
    rules_.push_back(rule);
  }

  template <class Of>
  void linear(Quantity quantity, std::size_t channel, Of&& of) {
    if (!call_.quantities[bit(quantity)]) return;
    ValueRule rule{quantity, channel, {numerators(of), false}};
    if (quantity == Quantity::noperspective) {
      for (const std::uint32_t number : vertices_) {
        rule.size = std::max(rule.size, magnitude(call_.vertices[number].varying[channel]));
      }
    } else if (quantity == Quantity::depth || channel == 2) {
      set_depth(rule);
    }
    const PolygonValues values =
        is_in_front_ ? vertex_values(rule.interpolant.of_vertices)
                     : polygon_values(call_, vertices_, rule.interpolant.of_vertices);
    set_hull(rule, values);
    if (quantity == Quantity::noperspective && has_end_at_infinity()) leave_open(rule);
    rules_.push_back(rule);
  }

  void set_depth(ValueRule& rule) const {
    if (call_.volume.depth == DepthRange::minus_one_to_one) {
      rule.interpolant.scale = 0.5;
      rule.interpolant.offset = 0.5;
    }
    const bool is_clamped = rule.quantity == Quantity::depth && call_.volume.depth_clamp;
    rule.clamping = is_clamped ? Clamping::must : Clamping::may;
    rule.size = 1;  // of the range
  }

  bool has_end_at_infinity() const {
    return std::any_of(vertices_.begin(), vertices_.end(), [&](std::uint32_t number) {
      return call_.vertices[number].position[3] == 0;
    });
  }

  static void leave_open(ValueRule& rule) {
    rule.least = -std::numeric_limits<double>::infinity();
    rule.greatest = std::numeric_limits<double>::infinity();
  }

  PolygonValues vertex_values(const std::array<double, 3>& n) const {
    PolygonValues r;
    r.is_known = true;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const double quotient = n[i] / static_cast<double>(call_.vertices[vertices_[i]].position[3]);
      r.quotients.push_back(quotient);
      r.sizes.push_back(std::abs(quotient));
    }
    return r;
  }

  static void set_hull(ValueRule& rule, const PolygonValues& values) {
    const Interpolant& of = rule.interpolant;
    double size = std::max(rule.size, std::abs(of.offset)), least = INFINITY, greatest = -INFINITY;
    for (std::size_t i = 0; i < values.quotients.size(); ++i) {
      const double value = of.offset + of.scale * values.quotients[i];
      least = std::min(least, value);
      greatest = std::max(greatest, value);
      size = std::max(size, std::abs(of.offset) + of.scale * values.sizes[i]);
    }
    if (least <= greatest) rule.size = std::max({rule.size, magnitude(least), magnitude(greatest)});
    rule.slack = kEpsilon * (kInterpolation + kTransform + kClip) * size;
    if (!values.is_known) return;
    rule.slack += of.scale * values.slide;
    rule.least = least;
    rule.greatest = greatest;
  }

  const DrawCall& call_;
  std::span<const std::uint32_t> vertices_;
  bool is_in_front_ = false;
  std::vector<ValueRule> rules_;
};

}  // namespace

std::vector<ValueRule> rules_of(const DrawCall& call, std::span<const std::uint32_t> vertices) {
  return RuleMaker(call, vertices).make();
}

}  // namespace clipscope::experiments
