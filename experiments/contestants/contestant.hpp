// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contestants: every clipper in every scalar, behind batch function pointers.
//
// What runs behind a pointer was compiled for one clipper, one scalar and one attribute count; only
// the call of a batch is indirect, so that timing sees the clipper alone.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "experiments/contestants/scalars.hpp"
#include "experiments/scenes/scene.hpp"
#include "spaces/clipper.hpp"

namespace clipscope::experiments {

// Polygons one after the other. Cleared and filled again, it keeps its memory and, for exact types, that
// of its numbers.
template <Scalar T, int K>
class PolygonStream {
 public:
  void clear() {
    used_ = 0;
    ends_.clear();
  }
  void append(const NdcPolygon<T, K>& polygon) {
    if (vertices_.size() < used_ + kMaxPolygonVertices) {
      vertices_.resize(2 * vertices_.size() + kMaxPolygonVertices);
    }
    std::copy(polygon.begin(), polygon.end(), vertices_.data() + used_);
    used_ += static_cast<std::size_t>(polygon.size());
    ends_.push_back(used_);
  }
  // Many polygons at once, from their vertices one after the other: polygon i, of `polygons`, ends before
  // vertex end_of(i). It is called for each in turn.
  template <class EndOf>
  void append(std::span<const NdcVertex<T, K>> vertices, std::size_t polygons, EndOf&& end_of) {
    if (vertices_.size() < used_ + vertices.size()) {
      vertices_.resize(2 * (used_ + vertices.size()));
    }
    std::copy(vertices.begin(), vertices.end(), vertices_.data() + used_);
    for (std::size_t i = 0; i < polygons; ++i) ends_.push_back(used_ + end_of(i));
    used_ += vertices.size();
  }
  std::size_t size() const { return ends_.size(); }
  std::span<const NdcVertex<T, K>> operator[](std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
    return {vertices_.data() + begin, ends_[i] - begin};
  }

 private:
  std::vector<NdcVertex<T, K>> vertices_;
  std::vector<std::size_t> ends_;  // polygon i has the vertices [ends[i - 1], ends[i])
  std::size_t used_ = 0;
};

// A clipper of points (N = 1), segments (2) or triangles (3) in one scalar.
template <Scalar T, std::size_t N = 3>
struct Contestant {
  static constexpr int K = kSceneAttributes;
  template <Space S>
  using Input = Simplex<S, T, K, N>;
  template <Space S>
  using InputOne = Simplex<S, T, kRunTime, N>;

  std::string_view name, summary, source;
  Promise promise;

  // Clips every primitive and appends one polygon, maybe empty, for each. `clip` is null for a clipper
  // that does not start at clip coordinates.
  void (*view)(const Projection<T>&, std::span<const Input<Space::view>>, PolygonStream<T, K>&);
  void (*clip)(const ClipVolume&, std::span<const Input<Space::clip>>, PolygonStream<T, K>&);

  // The same for one primitive with an attribute count known at run time.
  void (*view_one)(const Projection<T>&, const InputOne<Space::view>&, NdcPolygon<T, kRunTime>&);
  void (*clip_one)(const ClipVolume&, const InputOne<Space::clip>&, NdcPolygon<T, kRunTime>&);
};

// All clippers of primitives with N vertices that there are in one scalar, in the order of
// spaces/clippers.hpp.
template <Scalar T, std::size_t N = 3>
std::span<const Contestant<T, N>> contestants();

// A contestant in any scalar.
template <std::size_t N>
using AnyContestantOf = std::variant<const Contestant<float, N>*, const Contestant<double, N>*,
                                     const Contestant<dd_real, N>*, const Contestant<Exact, N>*,
                                     const Contestant<Counted, N>*>;
using AnyContestant = AnyContestantOf<3>;

template <std::size_t N = 3>
std::string_view clipper_name(const AnyContestantOf<N>& contestant) {
  return std::visit([](const auto* c) { return c->name; }, contestant);
}

template <std::size_t N = 3>
std::string_view scalar_name(const AnyContestantOf<N>& contestant);

// The contestants whose clipper matches the shell pattern (`*`, `?`; a name without them also stands
// for the clippers of which it is the folder or the method) and whose scalar is in the list, by clipper,
// then scalar; a clipper that there is not in a scalar is left out. Throws UsageError naming the
// option, what was given and what there is.
template <std::size_t N = 3>
std::vector<AnyContestantOf<N>> select_contestants(std::string_view clipper_pattern,
                                                   const std::vector<std::string>& scalars);

// The one contestant of that name. Throws UsageError if none or several match.
template <std::size_t N = 3>
AnyContestantOf<N> find_contestant(std::string_view clipper, std::string_view scalar);

}  // namespace clipscope::experiments
