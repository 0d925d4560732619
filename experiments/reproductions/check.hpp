// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a reproduction finds wrong: one thing at one pixel.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "experiments/pixels/judgement.hpp"

namespace clipscope::experiments {

struct Check {
  enum class Kind {
    ends,       // that drawing comes to its end
    fragments,  // how many fragments there are
    value,      // what one channel of a quantity is
    depth       // what is in the depth buffer
  };
  Kind kind = Kind::value;
  int x = 0, y = 0;  // pixel
  // What the shader reads: the value, or, of fragments, what it has to read for them to be wrong.
  Quantity quantity = Quantity::covered;
  std::size_t channel = 0;
  int fragments = 0;  // right are so many
  int came = 0;       // and so many came
  // Where they are counted. The rules of lines tell how many there are in all and in a column (or a
  // row), not where.
  enum class Region { pixel, column, row, target } region = Region::pixel;
  float least = 0, greatest = 0;  // right is a value between them; NaN is not

  // Where fragments were none or shall be none, a pixel tells by its colour; else they are counted.
  bool counts() const {
    return kind == Kind::fragments && (region != Region::pixel || (fragments > 0 && came > 0));
  }
  // How the count has to stand to `fragments`: "==", of all of a line ">=", of a column "<=".
  std::string_view comparison() const {
    return region == Region::pixel ? "==" : region == Region::target ? ">=" : "<=";
  }
};
Check check_of(const DrawCall& call, const Violation& violation);

// "2 fragments".
std::string fragments_text(int count);
// "pixel (16, 9), noperspective[0]".
std::string subject_of(const Check& check);
// "between 0.25 and 0.75", "1 fragment": what is right.
std::string demand_of(const Check& check);

// The call with its depths in the other range, -1 to 1 or 0 to 1: the same points of the same
// volume. Nothing where a depth would have to be rounded.
std::optional<DrawCall> in_depth_range(const DrawCall& call, DepthRange range);

// The number as a decimal, exactly, with a point or an exponent: "0.5", "1.0e+20".
std::string decimal_text(float x);

}  // namespace clipscope::experiments
