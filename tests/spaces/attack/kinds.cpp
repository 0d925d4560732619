// SPDX-License-Identifier: GPL-3.0-or-later
//
// See kinds.hpp.
#include "tests/spaces/attack/kinds.hpp"

namespace clipscope::attack {

std::span<const Kind> all_kinds() {
  using enum Fact;
  static const std::vector<Kind> kinds = {
      {"subnormals",
       "coordinates and attributes of a few units of the smallest float",
       subnormals,
       {cut, subnormal, two_planes, tie_to_low}},
      {"exact_ties",
       "new vertices half way between two floats in all that the cut leaves free",
       exact_ties,
       {tie_to_low, tie_to_high}},
      {"next_to_ties",
       "the same, off by 2^-24 to 2^-140, and as near as random weights allow",
       next_to_ties,
       {next_to_tie, two_planes}},
      {"inverse_w_at_overflow",
       "1/w on both sides of where it rounds to infinity",
       inverse_w_at_overflow,
       {largest_inverse, infinite_inverse, cut}},
      {"underflowing_quotients",
       "quotients around half of the smallest float, of both signs",
       underflowing_quotients,
       {rounded_to_zero, rounded_to_minus_zero, subnormal, tie_to_low}},
      {"ulps_from_planes",
       "vertices and corners on planes, and as little beside them as floats can",
       ulps_from_planes,
       {vertex_on_plane, beside_plane, next_to_corner, cut}},
      {"through_the_eye",
       "edges, vertices and triangles through (0, 0, 0, 0), w of all signs",
       through_the_eye,
       {behind, without_w, flat, cut}},
      {"slivers", "three vertices in a line but for their last bits", slivers, {sliver, cut}},
      {"signed_zeros",
       "coordinates and attributes that are 0 and -0",
       signed_zeros,
       {kept_minus_zero, lost_minus_zero, cancelled_to_zero, cut}},
      {"odd_frusta",
       "bounds one float apart, of other sizes, off-centre, sheared, infinite",
       odd_frusta,
       {cut, two_planes, next_to_tie}},
      {"clip_distances",
       "up to eight clip distances, of all sizes and on a lattice",
       clip_distances,
       {by_clip_distance, two_planes, through_corner}},
      {"depth_clamp",
       "near or far do not cut, and depths reach infinity",
       depth_clamp,
       {overflowed_z, outside_depth, next_to_tie, cut}},
      {"extents", "coordinates and attributes up to the largest float", extents, {huge, cut}},
      {"degenerate_corners",
       "vertices that coincide, lie in a line, in a plane, in its corners",
       degenerate_corners,
       {flat, vertex_on_plane, through_corner, in_open_side, cut}},
      {"cancelling_coordinates",
       "coordinates and attributes whose terms cancel",
       cancelling_coordinates,
       {cancelled, cancelled_to_zero, cut}},
      {"extreme_attributes",
       "attributes at both ends of the range at once",
       extreme_attributes,
       {huge, subnormal, cut}}};
  return kinds;
}

}  // namespace clipscope::attack
