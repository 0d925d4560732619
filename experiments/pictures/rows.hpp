// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the pictures' table, whose title names their size.
#pragma once

#include <cstdint>

#include "experiments/table/row.hpp"

namespace clipscope::experiments::pictures {

struct Row {
  std::string scene, clipper;
  std::uint64_t holes_px = 0, extra_px = 0, flipped_px = 0;
  double max_error_texel = 0, above_one_texel_percent = 0;

  // Pixels that show nothing, something or a side that they should not.
  std::uint64_t wrong_px() const { return holes_px + extra_px + flipped_px; }

  static constexpr std::string_view kName = "pictures";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Error: of the texture coordinates, in texels of a 1024-texel texture, where both pictures show the same side of something. Pictures: <scene>-<clipper>.png and .exr."};
  static constexpr auto columns() {
    using R = Row;
    return std::tuple(
        column("scene", &R::scene), column("clipper", &R::clipper),
        column("holes_px", "holes [px]", &R::holes_px),
        column("extra_px", "extra [px]", &R::extra_px),
        column("flipped_px", "flipped [px]", &R::flipped_px),
        column("max_error_texel", "max error [texel]", &R::max_error_texel),
        column("above_one_texel_percent", "above 1 texel [%]", &R::above_one_texel_percent));
  }
};

// How many pictures are right in every pixel, and what the worst shows. pixels: of one picture.
std::string finding(const std::vector<Row>& rows, std::uint64_t pixels);

}  // namespace clipscope::experiments::pictures
