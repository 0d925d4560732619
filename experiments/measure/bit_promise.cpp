// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/bit_promise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "spaces/planes.hpp"

namespace clipscope::experiments {
namespace {

constexpr int kScaleExponent = 8;
constexpr int kRoom = 40;  // |x| in [2^-kRoom, 2^kRoom] or 0: products neither over- nor underflow

template <class T>
using Answer = NdcPolygon<T, kRunTime>;

// Clips triangles of one space, in a volume scaled by 2^exponent with them.
template <class T>
struct ViewSetting {
  static constexpr Space kSpace = Space::view;
  const Contestant<T>& contestant;
  const Frustum<double>& frustum;
  const ClipVolume& volume;

  Answer<T> clip(const Triangle<kSpace, T, kRunTime>& triangle, int exponent = 0) const {
    Frustum<double> f = frustum;
    for (double* length : {&f.near, &f.far}) *length = std::ldexp(*length, exponent);
    for (double* side : {&f.left, &f.right, &f.bottom, &f.top}) {
      *side = std::ldexp(*side, exponent);
    }
    auto projection = projection_from<T>(f);
    projection.volume = volume;
    Answer<T> out;
    contestant.view_one(projection, triangle, out);
    return out;
  }
  // How much 1/w shrinks: by as much as w grows, which is 1 for a parallel projection.
  int inv_w_exponent() const {
    return frustum.kind == ProjectionKind::perspective ? kScaleExponent : 0;
  }
  T distance(Plane plane, const ViewVertex<T, kRunTime>& v) const {
    return signed_distance(projection_from<T>(frustum).frustum, plane, v);
  }
};

template <class T>
struct ClipSetting {
  static constexpr Space kSpace = Space::clip;
  const Contestant<T>& contestant;
  const ClipVolume& volume;

  Answer<T> clip(const Triangle<kSpace, T, kRunTime>& triangle, int = 0) const {
    Answer<T> out;
    contestant.clip_one(volume, triangle, out);
    return out;
  }
  int inv_w_exponent() const { return kScaleExponent; }
  T distance(Plane plane, const ClipVertex<T, kRunTime>& v) const {
    return signed_distance(volume.depth, plane, v);
  }
};

template <class T>
bool same(const T& a, const T& b) {
  return a == b || (is_nan(a) && is_nan(b));
}

template <class T>
bool same(const NdcVertex<T, kRunTime>& a, const NdcVertex<T, kRunTime>& b) {
  for (int i = 0; i < 4; ++i) {
    if (!same(a.position[i], b.position[i])) return false;
  }
  for (int k = 0; k < a.attributes.size(); ++k) {
    if (!same(a.attributes[k], b.attributes[k])) return false;
  }
  return true;
}

template <class T>
bool is_total(const Answer<T>& polygon) {
  return !polygon.overflowed() &&
         std::all_of(polygon.begin(), polygon.end(), [](const NdcVertex<T, kRunTime>& v) {
           const auto& p = v.position;
           return is_finite(p[0]) && is_finite(p[1]) && is_finite(p[2]) && !is_nan(p[3]);
         });
}

template <class T>
bool same_up_to_rotation(const Answer<T>& a, const Answer<T>& b) {
  const int n = a.size();
  if (n != b.size()) return false;
  for (int shift = 0; shift < std::max(n, 1); ++shift) {
    int equal = 0;
    while (equal < n && same(a[equal], b[(equal + shift) % n])) ++equal;
    if (equal == n) return true;
  }
  return false;
}

template <class T>
double exponent_bound(const T& x) {
  const double value = std::abs(nearest_double(x));
  return value == 0 ? 0 : std::abs(std::ilogb(value));
}

template <Space S, class T>
bool has_room(const Triangle<S, T, kRunTime>& triangle) {
  return std::all_of(triangle.begin(), triangle.end(), [](const auto& v) {
    for (int i = 0; i < std::remove_cvref_t<decltype(v)>::kDimension; ++i) {
      if (exponent_bound(v.position[i]) > kRoom) return false;
    }
    for (int k = 0; k < v.attributes.size(); ++k) {
      if (exponent_bound(v.attributes[k]) > kRoom) return false;
    }
    return true;
  });
}

template <Space S, class T>
Triangle<S, T, kRunTime> scaled(Triangle<S, T, kRunTime> triangle) {
  const T factor(std::ldexp(1.0f, kScaleExponent));
  for (auto& v : triangle) {
    for (int i = 0; i < std::remove_cvref_t<decltype(v)>::kDimension; ++i) {
      v.position[i] = v.position[i] * factor;
    }
  }
  return triangle;
}

// Whether b is a with 1/w divided by 2^exponent.
template <class T>
bool same_scaled(const Answer<T>& a, const Answer<T>& b, int exponent) {
  if (a.size() != b.size()) return false;
  const T factor(std::ldexp(1.0f, exponent));
  for (int v = 0; v < a.size(); ++v) {
    NdcVertex<T, kRunTime> back = b[v];
    back.position[3] = back.position[3] * factor;
    if (!same(a[v], back)) return false;
  }
  return true;
}

// The vertices on the edge from vertex 0 to vertex 1: those that the mark in the last attribute of
// vertex 2 did not reach (see mark).
template <class T>
std::vector<NdcVertex<T, kRunTime>> on_first_edge(const Answer<T>& polygon, int last) {
  std::vector<NdcVertex<T, kRunTime>> edge;
  for (const auto& v : polygon) {
    if (v.attributes[last] == T(0)) edge.push_back(v);
  }
  return edge;
}

template <class T>
bool same_set(const std::vector<NdcVertex<T, kRunTime>>& a,
              const std::vector<NdcVertex<T, kRunTime>>& b) {
  const auto covers = [](const auto& x, const auto& y) {
    return std::all_of(x.begin(), x.end(), [&](const auto& v) {
      return std::any_of(y.begin(), y.end(), [&](const auto& u) { return same(u, v); });
    });
  };
  return covers(a, b) && covers(b, a);
}

// A NaN marks all that it touches. A barycentric clipper multiplies it by 0 everywhere; its weight of
// vertex 2 is exactly 0 on the edge, and 1 marks what has any.
template <class T>
T mark(std::string_view clipper) {
  return clipper.starts_with("barycentric/") ? T(1) : T(std::numeric_limits<float>::quiet_NaN());
}

// The triangle on the other side of the edge from vertex 0 to vertex 1, its third vertex across.
template <Space S, class T>
Triangle<S, T, kRunTime> neighbour(const Triangle<S, T, kRunTime>& triangle) {
  Triangle<S, T, kRunTime> r = {triangle[1], triangle[0], triangle[2]};
  for (int i = 0; i < Vertex<S, T, kRunTime>::kDimension; ++i) {
    const T sum = triangle[0].position[i] + triangle[1].position[i];
    r[2].position[i] = sum - triangle[2].position[i];
  }
  return r;
}

template <class Setting, class T>
bool edge_lies_in_a_plane(const Setting& setting,
                          const Triangle<Setting::kSpace, T, kRunTime>& triangle) {
  return std::any_of(kAllPlanes.begin(), kAllPlanes.end(), [&](Plane plane) {
    return setting.distance(plane, triangle[0]) == T(0) &&
           setting.distance(plane, triangle[1]) == T(0);
  });
}

// Pre-condition: no attribute is a clip distance but those before the last.
template <class Setting, class T>
bool is_watertight(const Setting& setting, Triangle<Setting::kSpace, T, kRunTime> triangle) {
  const int last = triangle[0].attributes.size() - 1;
  for (auto& v : triangle) v.attributes[last] = T(0);
  triangle[2].attributes[last] = mark<T>(setting.contestant.name);
  const Answer<T> left = setting.clip(triangle);
  const Answer<T> right = setting.clip(neighbour<Setting::kSpace, T>(triangle));
  return left.empty() || right.empty() ||
         same_set(on_first_edge(left, last), on_first_edge(right, last));
}

template <class Setting, class T>
std::string broken(const Setting& setting, const Promise& promise,
                   const Triangle<Setting::kSpace, T, kRunTime>& triangle) {
  const Answer<T> polygon = setting.clip(triangle);
  if (promise.total && !is_total(polygon)) return "not total: a coordinate is not finite";
  if (promise.rotation_invariant &&
      !same_up_to_rotation(polygon, setting.clip({triangle[1], triangle[2], triangle[0]}))) {
    return "another vertex first gives other bits";
  }
  const bool room = has_room<Setting::kSpace, T>(triangle);
  if (promise.scale_invariant && room &&
      !same_scaled(polygon, setting.clip(scaled<Setting::kSpace, T>(triangle), kScaleExponent),
                   setting.inv_w_exponent())) {
    return "scaled by 2^8 it gives other bits";
  }
  if constexpr (kHasInfinity<T>) {
    const bool has_free_attribute = triangle[0].attributes.size() > setting.volume.clip_distances;
    if (promise.watertight && room && has_free_attribute &&
        !edge_lies_in_a_plane<Setting, T>(setting, triangle) &&
        !is_watertight<Setting, T>(setting, triangle)) {
      return "not watertight: a neighbour has other vertices on the shared edge";
    }
  }
  return {};
}

}  // namespace

template <class T>
std::string broken_bits(const Contestant<T>& contestant, const Frustum<double>& frustum,
                        const ClipVolume& volume, const ViewTriangle<T, kRunTime>& triangle) {
  return broken<ViewSetting<T>, T>({contestant, frustum, volume}, contestant.promise, triangle);
}

template <class T>
std::string broken_bits(const Contestant<T>& contestant, const ClipVolume& volume,
                        const ClipTriangle<T, kRunTime>& triangle) {
  return broken<ClipSetting<T>, T>({contestant, volume}, contestant.promise, triangle);
}

void break_by_bits(PromiseCheck& check, const std::string& reason) {
  if (reason.empty()) return;
  check.verdict = PromiseVerdict::broken;
  check.reason = reason;
}

template std::string broken_bits(const Contestant<float>&, const Frustum<double>&,
                                 const ClipVolume&, const ViewTriangle<float, kRunTime>&);
template std::string broken_bits(const Contestant<float>&, const ClipVolume&,
                                 const ClipTriangle<float, kRunTime>&);
template std::string broken_bits(const Contestant<double>&, const Frustum<double>&,
                                 const ClipVolume&, const ViewTriangle<double, kRunTime>&);
template std::string broken_bits(const Contestant<double>&, const ClipVolume&,
                                 const ClipTriangle<double, kRunTime>&);
template std::string broken_bits(const Contestant<dd_real>&, const Frustum<double>&,
                                 const ClipVolume&, const ViewTriangle<dd_real, kRunTime>&);
template std::string broken_bits(const Contestant<dd_real>&, const ClipVolume&,
                                 const ClipTriangle<dd_real, kRunTime>&);
template std::string broken_bits(const Contestant<Exact>&, const Frustum<double>&,
                                 const ClipVolume&, const ViewTriangle<Exact, kRunTime>&);
template std::string broken_bits(const Contestant<Exact>&, const ClipVolume&,
                                 const ClipTriangle<Exact, kRunTime>&);
template std::string broken_bits(const Contestant<Counted>&, const Frustum<double>&,
                                 const ClipVolume&, const ViewTriangle<Counted, kRunTime>&);
template std::string broken_bits(const Contestant<Counted>&, const ClipVolume&,
                                 const ClipTriangle<Counted, kRunTime>&);

}  // namespace clipscope::experiments
