// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/plot_labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace clipscope::experiments {
namespace {

constexpr double kPerCharacter =
    0.58;                          // of the font size: the mean of DejaVu Sans, wider than most
constexpr double kNear = 7;        // px between a point and a text beside it
constexpr double kDropped = 0.25;  // a text covered by more than this by others is left out

double area_of(const LabelBox& box) { return (box.right - box.left) * (box.bottom - box.top); }

double overlap(const LabelBox& a, const LabelBox& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  return width > 0 && height > 0 ? width * height : 0;
}

bool within(const LabelBox& box, const LabelBox& area) {
  return box.left >= area.left && box.right <= area.right && box.top >= area.top &&
         box.bottom <= area.bottom;
}

double covered(const LabelBox& box, const std::vector<LabelBox>& by) {
  double sum = 0;
  for (const LabelBox& other : by) sum += overlap(box, other);
  return sum;
}

// The box whose nearest corner or edge is `distance` from the point in a direction (dx, dy of -1, 0, 1).
LabelBox box_towards(const PointLabel& label, int dx, int dy, double distance) {
  const double reach = dx != 0 && dy != 0 ? distance * 0.7 : distance;
  const double x = label.x + dx * (reach + label.width / 2);
  const double y = label.y + dy * (reach + label.height / 2);
  return {x - label.width / 2, y - label.height / 2, x + label.width / 2, y + label.height / 2};
}

struct Candidate {
  LabelPlace place;
  double burden = 0;  // px², to compare with covered area
};

// Cheapest first among equals: right, left, above, below, the corners; near before far.
std::vector<Candidate> candidates(const PointLabel& label) {
  struct Direction {
    int dx, dy;
    double burden;
  };
  static constexpr std::array<Direction, 8> kAround = {{{1, 0, 0},
                                                        {-1, 0, 4},
                                                        {0, -1, 6},
                                                        {0, 1, 8},
                                                        {1, -1, 2},
                                                        {1, 1, 3},
                                                        {-1, -1, 6},
                                                        {-1, 1, 7}}};
  std::vector<Candidate> result;
  for (const double extra : {0.0, 8.0, 18.0, 32.0, 50.0, 72.0}) {
    for (const Direction& d : kAround) {
      if (label.upward && (d.dx != 0 || d.dy != -1)) continue;
      const double near = label.upward ? 3 : kNear;
      const LabelPlace place = {box_towards(label, d.dx, d.dy, near + extra),
                                extra > 8 && !label.upward};
      result.push_back({place, d.burden + 3 * extra});
    }
  }
  return result;
}

}  // namespace

std::vector<std::optional<LabelPlace>> place_labels(const std::vector<PointLabel>& labels,
                                                    const std::vector<LabelBox>& obstacles,
                                                    const LabelBox& area) {
  std::vector<std::optional<LabelPlace>> places;
  std::vector<LabelBox> taken;
  for (const PointLabel& label : labels) {
    std::optional<LabelPlace> best;
    double least = INFINITY;
    for (const Candidate& candidate : candidates(label)) {
      const LabelBox& box = candidate.place.box;
      if (!within(box, area)) continue;
      const double by_texts = covered(box, taken);
      const double cost = candidate.burden + 6 * by_texts + covered(box, obstacles);
      if (cost >= least || by_texts > kDropped * area_of(box)) continue;
      least = cost;
      best = candidate.place;
    }
    if (best) taken.push_back(best->box);
    places.push_back(best);
  }
  return places;
}

double text_width(const std::string& text, double size) {
  const auto characters = std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  });
  return kPerCharacter * size * static_cast<double>(characters);
}

}  // namespace clipscope::experiments
