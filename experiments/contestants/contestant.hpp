// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contestants: every clipper in every scalar, behind batch function pointers.
//
// What runs behind a pointer was compiled for one clipper, one scalar and one attribute count; only
// the call of a batch is indirect, so that timing sees the clipper alone.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "experiments/contestants/scalars.hpp"
#include "experiments/scenes/scene.hpp"
#include "spaces/clipper.hpp"

namespace clipscope::experiments {

// Polygons one after the other: polygon i has the vertices [ends[i - 1], ends[i]). Cleared and filled
// again, it keeps its memory.
template <Scalar T, int K>
struct PolygonStream {
  std::vector<NdcVertex<T, K>> vertices;
  std::vector<std::uint32_t> ends;
  bool overflowed = false;  // some polygon lost vertices to the fixed capacity

  void clear() {
    vertices.clear();
    ends.clear();
    overflowed = false;
  }
  void append(const NdcPolygon<T, K>& polygon) {
    vertices.insert(vertices.end(), polygon.begin(), polygon.end());
    ends.push_back(static_cast<std::uint32_t>(vertices.size()));
    overflowed |= polygon.overflowed();
  }
  std::size_t size() const { return ends.size(); }
  std::span<const NdcVertex<T, K>> operator[](std::size_t i) const {
    const std::uint32_t begin = i == 0 ? 0 : ends[i - 1];
    return {vertices.data() + begin, ends[i] - begin};
  }
};

template <Scalar T>
struct Contestant {
  static constexpr int K = kSceneAttributes;

  std::string_view name, summary, source;
  Promise promise;

  // Clips every triangle and appends one polygon, maybe empty, for each. `clip` is null for a clipper
  // that does not start at clip coordinates.
  void (*view)(const Projection<T>&, std::span<const ViewTriangle<T, K>>, PolygonStream<T, K>&);
  void (*clip)(DepthRange, std::span<const ClipTriangle<T, K>>, PolygonStream<T, K>&);

  // The same for one triangle with an attribute count known at run time.
  void (*view_one)(const Projection<T>&, const ViewTriangle<T, kRunTime>&,
                   NdcPolygon<T, kRunTime>&);
  void (*clip_one)(DepthRange, const ClipTriangle<T, kRunTime>&, NdcPolygon<T, kRunTime>&);
};

// All clippers in one scalar, in the order of spaces/clippers.hpp.
template <Scalar T>
std::span<const Contestant<T>> contestants();

// A contestant in any scalar.
using AnyContestant =
    std::variant<const Contestant<float>*, const Contestant<double>*, const Contestant<dd_real>*,
                 const Contestant<Exact>*, const Contestant<Counted>*>;

std::string_view clipper_name(const AnyContestant& contestant);
std::string_view scalar_name(const AnyContestant& contestant);

// The contestants whose clipper matches the shell pattern (`*`, `?`; a name without them also stands
// for the clippers of which it is the folder or the method) and whose scalar is in the list, by clipper,
// then scalar. Throws UsageError naming the option, what was given and what there is.
std::vector<AnyContestant> select_contestants(std::string_view clipper_pattern,
                                              const std::vector<std::string>& scalars);

// The one contestant of that name. Throws UsageError if none or several match.
AnyContestant find_contestant(std::string_view clipper, std::string_view scalar);

}  // namespace clipscope::experiments
