// SPDX-License-Identifier: GPL-3.0-or-later
//
// Coverage of triangles and points: which pixels were hit too seldom or too often.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "experiments/pixels/exact_pixel.hpp"
#include "experiments/pixels/judgement.hpp"
#include "experiments/pixels/region.hpp"

namespace clipscope::experiments {

// A triangle, a line or a point of a draw call.
struct JudgedPrimitive {
  std::vector<std::uint32_t> vertices = {};
  std::optional<ExactPrimitive> exact = {};  // not of a point
  Region region = {};

  bool is_triangle() const { return vertices.size() == 3; }
  bool has_values() const { return exact && exact->orientation() != 0; }
};

// Gathers the pixels of each primitive, quantity and kind into one violation, with the worst of
// them.
class Accusations {
 public:
  // size: how far beyond what is allowed, in multiples of that.
  void add(std::size_t primitive, Quantity quantity, ViolationKind kind, const WorstPixel& pixel,
           double size);
  std::vector<Violation> violations() const;

 private:
  struct Found {
    Violation violation;
    int x = -1, y = -1;  // counted last: a pixel with several channels is one
  };
  std::map<std::tuple<std::size_t, Quantity, ViolationKind>, Found> found_;
};

// What all primitives together ask of one pixel.
struct PixelClaim {
  std::uint16_t covered = 0;  // by so many for certain
  std::uint16_t open = 0;     // and perhaps by so many more
  std::int32_t last = -1;     // the last primitive of both
  // Of the only open one.
  Coverage of_open = Coverage::outside;
};

struct CoverageMap {
  int width = 0;
  std::vector<PixelClaim> claims;  // row by row
  // By primitive: whether a pixel is covered for certain, so that its orientation is certain, too.
  std::vector<bool> is_certain;

  const PixelClaim& at(int x, int y) const {
    return claims[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

CoverageMap coverage_map(const DrawCall& call, const std::vector<JudgedPrimitive>& primitives);

// missing, extra, zero_area and primitive_lost; counts pixels, undecided and inexact.
void judge_coverage(const std::vector<JudgedPrimitive>& primitives, const CoverageMap& map,
                    const Pixels& pixels, Accusations& accusations, Judgement& judgement);

// shared_edge: two triangles on either side of an edge whose ends are in the clip volume. Of an
// edge that is cut both polygons have vertices of their own, which no specification wants to be
// equal to the bit. Centres near the ends of the edge, or claimed by a third primitive, are left
// out.
void judge_shared_edges(const DrawCall& call, const std::vector<JudgedPrimitive>& primitives,
                        const CoverageMap& map, const Pixels& pixels, Accusations& accusations);

}  // namespace clipscope::experiments
