// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangle soups by rejection: propose a triangle of a class, keep it if a double classification
// agrees.
#include "experiments/scenes/builtin.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <numeric>
#include <vector>

#include "experiments/machine/errors.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments {
namespace {

using glm::dvec3;
using Corners = std::array<dvec3, 3>;

constexpr double kMargin = 1e-5;           // see the header
constexpr int kMostProposals = 1'000'000;  // usual are a few
constexpr double kScreenHeight_px = 2160;
constexpr double kInfiniteFarDepth = 1e4;  // in near distances: how deep a soup reaches without far

// Where one vertex lies, or that it is too near to a border to say.
struct Place {
  Outcode outside = 0;
  bool behind_eye = false;
  bool clear = true;
};

Place place_of(const Projection<double>& projection, const std::array<float, 3>& p) {
  const Vec3<double> v(p[0], p[1], p[2]);
  const double margin = kMargin * (std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]));
  Place place;
  for (const Plane plane : kAllPlanes) {
    const Vec4<double>& n = projection.unit_planes[static_cast<std::size_t>(plane)];
    const double d = n[0] * v[0] + n[1] * v[1] + n[2] * v[2] + n[3];
    place.clear = place.clear && std::abs(d) > margin;
    place.outside |= d < 0 ? bit(plane) : 0;
  }
  if (projection.frustum.kind == ProjectionKind::perspective) {
    place.clear = place.clear && std::abs(v[2]) > margin;
    place.behind_eye = v[2] > 0;
  }
  return place;
}

// Proposes triangles of each class.
class Proposer {
 public:
  Proposer(const Frustum<float>& f, std::uint64_t seed)
      : frustum_(frustum_cast<double>(f)), random_(seed) {
    if (f.infinite_far) frustum_.far = frustum_.near * kInfiniteFarDepth;
  }

  Random& random() { return random_; }

  Corners propose(SoupClass wanted) {
    switch (wanted) {
      case SoupClass::inside: return blob(inside_point(), 1, 100);
      case SoupClass::outside: return blob(outside_point(), 1, 100);
      case SoupClass::straddling: return random_.chance(0.85) ? across_side() : across_depth();
      case SoupClass::crossing_w0: return across_eye();
      default: return across_planes();
    }
  }

 private:
  bool is_perspective() const { return frustum_.kind == ProjectionKind::perspective; }

  // The point of the view volume's cone (or prism) at an NDC position and a depth.
  dvec3 at(double x_ndc, double y_ndc, double depth) const {
    const double k = is_perspective() ? depth / frustum_.near : 1;
    const double x = 0.5 * ((1 + x_ndc) * frustum_.right + (1 - x_ndc) * frustum_.left) * k;
    const double y = 0.5 * ((1 + y_ndc) * frustum_.top + (1 - y_ndc) * frustum_.bottom) * k;
    return {x + frustum_.shear_x * depth, y + frustum_.shear_y * depth, -depth};
  }

  double depth() {
    return is_perspective() ? random_.across_magnitudes(frustum_.near, frustum_.far)
                            : random_.uniform(frustum_.near, frustum_.far);
  }

  // The length in view space of one pixel at a depth.
  double pixel(double depth) const {
    const double height = frustum_.top - frustum_.bottom;
    return height / kScreenHeight_px * (is_perspective() ? std::abs(depth) / frustum_.near : 1);
  }

  Corners around(const dvec3& centre, double radius) {
    Corners corners;
    for (dvec3& corner : corners) corner = centre + radius * random_.in_cube();
    return corners;
  }

  // A triangle of lo_px to hi_px around a centre.
  Corners blob(const dvec3& centre, double lo_px, double hi_px) {
    const double size_px = random_.across_magnitudes(lo_px, hi_px);
    return around(centre, 0.5 * size_px * pixel(centre.z));
  }

  double either_sign(double magnitude) { return random_.sign() * magnitude; }

  dvec3 inside_point() {
    const double x = random_.uniform(-1, 1), y = random_.uniform(-1, 1);
    return at(x, y, depth());
  }

  // Beside the volume, sometimes behind the eye or beyond far.
  dvec3 outside_point() {
    const double kind = random_.uniform();
    const double along = random_.uniform(-2, 2), beyond = either_sign(random_.uniform(1, 4));
    const double d = depth();
    if (kind < 0.4) return at(beyond, along, d);
    if (kind < 0.7) return at(along, beyond, d);
    if (kind < 0.9) return at(along, beyond, is_perspective() ? -d : frustum_.near - d);
    const double length = frustum_.far - frustum_.near;
    return at(along, beyond, frustum_.far + length * random_.uniform(0, 1));
  }

  Corners across_side() {
    const double along = random_.uniform(-1, 1), border = either_sign(random_.uniform(0.9, 1.1));
    const double d = depth();
    const bool is_x = random_.chance(0.5);
    return blob(is_x ? at(border, along, d) : at(along, border, d), 16, 400);
  }

  // Across near as large as the near rectangle, across far 16 to 400 px.
  Corners across_depth() {
    const double x = random_.uniform(-1, 1), y = random_.uniform(-1, 1);
    if (random_.chance(0.5)) {
      return around(at(x, y, frustum_.near * random_.uniform(0.9, 1.1)),
                    0.3 * (frustum_.top - frustum_.bottom));
    }
    return blob(at(x, y, frustum_.far * random_.uniform(0.99, 1.01)), 16, 400);
  }

  // From inside the volume to behind the eye.
  Corners across_eye() {
    const double d = depth();
    const double x = random_.uniform(-1, 1), y = random_.uniform(-1, 1);
    const dvec3 inside = at(x, y, d);
    const double reach = d * random_.across_magnitudes(0.0625, 4);
    const dvec3 behind = reach * random_.in_cube() + dvec3(0, 0, reach);
    const dvec3 third = random_.chance(0.5) ? inside + 0.25 * reach * random_.in_cube()
                                            : behind + 0.5 * reach * random_.in_cube();
    Corners corners = {inside, behind, third};
    random_.shuffle(std::span<dvec3>(corners));
    return corners;
  }

  // Around a point inside, as large as what is seen there.
  Corners across_planes() {
    const dvec3 centre = inside_point();
    const double reach =
        is_perspective() ? std::abs(centre.z) : 0.5 * (frustum_.top - frustum_.bottom);
    return around(centre, reach * random_.across_magnitudes(0.5, 4));
  }

  Frustum<double> frustum_;
  Random random_;
};

constexpr std::size_t kClasses = 6;
using ByClass = std::array<double, kClasses>;  // in the order of SoupClass

ByClass by_class(const SoupShares& shares, ProjectionKind kind) {
  const double behind = kind == ProjectionKind::perspective ? 0.5 * shares.several_planes : 0;
  return {shares.inside,
          shares.outside,
          shares.straddling,
          shares.crossing_w0,
          shares.several_planes - behind,
          behind};
}

// Whole numbers in the proportion of the shares, by the largest remainder, that sum to `total`.
std::array<std::size_t, kClasses> apportion(const ByClass& shares, std::size_t total) {
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  std::array<std::size_t, kClasses> counts;
  std::array<double, kClasses> remainders;
  for (std::size_t i = 0; i < kClasses; ++i) {
    const double exact = shares[i] / sum * static_cast<double>(total);
    counts[i] = static_cast<std::size_t>(exact);
    remainders[i] = exact - static_cast<double>(counts[i]);
  }
  while (std::accumulate(counts.begin(), counts.end(), std::size_t{0}) < total) {
    const auto largest = std::ranges::max_element(remainders) - remainders.begin();
    ++counts[largest];
    remainders[largest] = -1;
  }
  return counts;
}

void check(const SoupShares& shares, const Frustum<float>& frustum) {
  const std::array all = {shares.inside, shares.outside, shares.straddling, shares.crossing_w0,
                          shares.several_planes};
  for (const double share : all) {
    if (!(share >= 0 && std::isfinite(share))) {
      throw UsageError(fmt::format("soup: a share of {} given; shares are numbers >= 0", share));
    }
  }
  if (std::ranges::count(all, 0) == std::ssize(all)) {
    throw UsageError("soup: all shares are 0; at least one must be positive");
  }
  if (shares.crossing_w0 > 0 && frustum.kind == ProjectionKind::parallel) {
    throw UsageError("soup: in a parallel projection w is 1 everywhere, nothing can cross w = 0");
  }
}

std::vector<SoupClass> shuffled_classes(const ByClass& shares, std::size_t triangles,
                                        Random& random) {
  std::vector<SoupClass> classes;
  for (int kind = 0; const std::size_t count : apportion(shares, triangles)) {
    classes.insert(classes.end(), count, static_cast<SoupClass>(kind++));
  }
  random.shuffle(std::span(classes));
  return classes;
}

Corners find_triangle(SoupClass wanted, Proposer& proposer, const Frustum<float>& frustum) {
  for (int i = 0; i < kMostProposals; ++i) {
    const Corners corners = proposer.propose(wanted);
    const auto& [a, b, c] = corners;
    if (is_of_class(wanted, frustum, {rounded(a), rounded(b), rounded(c)})) return corners;
  }
  throw UsageError(fmt::format(
      "soup: the volume from near {} to far {} is too thin for triangles of a pixel and more; move near and far apart",
      frustum.near, frustum.far));
}

}  // namespace

bool is_of_class(SoupClass kind, const Frustum<float>& frustum,
                 const std::array<std::array<float, 3>, 3>& triangle) {
  const Projection<double> projection(frustum_cast<double>(frustum));
  Outcode all = ~Outcode{0}, any = 0;
  int inside = 0, behind = 0;
  for (const auto& corner : triangle) {
    const Place place = place_of(projection, corner);
    if (!place.clear) return false;
    all &= place.outside;
    any |= place.outside;
    inside += place.outside == 0;
    behind += place.behind_eye;
  }
  if (all != 0) return kind == SoupClass::outside;
  const bool straddles = inside == 1 || inside == 2, several = std::popcount(any) > 1;
  switch (kind) {
    case SoupClass::inside: return inside == 3;
    case SoupClass::outside: return false;
    case SoupClass::straddling: return straddles && behind == 0;
    case SoupClass::crossing_w0: return straddles && behind > 0;
    case SoupClass::several_planes: return several && behind == 0;
    default: return several && behind > 0;
  }
}

Mesh make_soup(const SoupShares& shares, std::size_t triangles, std::uint64_t seed,
               const Frustum<float>& frustum) {
  assert(is_valid(frustum));
  check(shares, frustum);
  Proposer proposer(frustum, seed);
  Mesh mesh;
  const ByClass weights = by_class(shares, frustum.kind);
  for (const SoupClass wanted : shuffled_classes(weights, triangles, proposer.random())) {
    add_random_triangle(mesh, find_triangle(wanted, proposer, frustum), proposer.random());
  }
  return mesh;
}

}  // namespace clipscope::experiments
