// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places for texts beside the points of a plot, such that they cover neither each other nor points.
//
// Greedy, in the order given: each text takes the cheapest of some forty places about its point. Not
// optimal: a text for which every place is covered for more than a quarter by other texts gets none.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace clipscope::experiments {

// All lengths in px, x to the right, y downward.
struct LabelBox {
  double left = 0, top = 0, right = 0, bottom = 0;
};

struct PointLabel {
  double x = 0, y = 0;  // the point
  double width = 0, height = 0;
  bool upward = false;  // above the point only: for bars
};

struct LabelPlace {
  LabelBox box;
  bool distant = false;  // wants a line to its point
};

// One place per label, or none; all within `area`. obstacles: what should not be covered (marks, curves).
std::vector<std::optional<LabelPlace>> place_labels(const std::vector<PointLabel>& labels,
                                                    const std::vector<LabelBox>& obstacles,
                                                    const LabelBox& area);

// About how wide a text is in a sans-serif face [px], size: of the font [px].
double text_width(const std::string& text, double size);

}  // namespace clipscope::experiments
