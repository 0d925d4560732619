// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scissor rectangle as planes: what OpenGL's glScissor does to pixels, done to primitives.
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "experiments/commands/options.hpp"
#include "reference/truth.hpp"

namespace clipscope::experiments::commands {
namespace {

// of_axis * x + of_w * w >= 0 in clip space; y for axis 1. Whole numbers of pixels are exact.
struct Side {
  int axis;
  double of_axis, of_w;
};

// low <= pixel: low <= (x / w + 1) size / 2, times 2 w.
Side at_least(int axis, double low, double size) { return {axis, size, size - 2 * low}; }
Side at_most(int axis, double high, double size) { return {axis, -size, 2 * high - size}; }

// The side as a form of view space: that of clip space with each coordinate's own form put in.
std::array<double, 4> in_view_space(const reference::Truth& truth, const Side& side) {
  using reference::Dyadic;
  const auto& row = truth.projection()[static_cast<std::size_t>(side.axis)];
  std::array<Dyadic, 5> form;
  std::ranges::transform(row.coefficients, form.begin(), [&](const Dyadic& x) {
    const Dyadic r = Dyadic(side.of_axis) * x;
    return r;
  });
  for (const reference::Term& term : truth.w()) {
    form[static_cast<std::size_t>(term.coordinate)] +=
        Dyadic(side.of_w) * row.scale * Dyadic(term.coefficient);
  }
  const Dyadic constant = form[3] + form[reference::kOne];  // the fourth coordinate is 1
  const auto rounded = [](const Dyadic& x) { return reference::round_to<double>({x, 1}); };
  return {rounded(form[0]), rounded(form[1]), rounded(form[2]), rounded(constant)};
}

}  // namespace

std::vector<std::array<double, 4>> scissor_planes(const Scissor& s, const Batch& batch) {
  std::vector<std::array<double, 4>> planes;
  for (const Side& side :
       {at_least(0, s.x, s.viewport[0]), at_most(0, s.x + s.width, s.viewport[0]),
        at_least(1, s.y, s.viewport[1]), at_most(1, s.y + s.height, s.viewport[1])}) {
    if (batch.space == Space::view) {
      const reference::Truth truth = reference::truth_of(batch);
      planes.push_back(in_view_space(truth, side));
    } else {
      std::array<double, 4>& plane = planes.emplace_back(std::array<double, 4>{0, 0, 0, side.of_w});
      plane[static_cast<std::size_t>(side.axis)] = side.of_axis;
    }
  }
  return planes;
}

Scissor parse_scissor(const std::vector<double>& numbers) {
  const bool is_finite = std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); });
  if (is_finite && numbers[2] > 0 && numbers[3] > 0) {
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
  }
  throw CLI::ValidationError(
      "--scissor", fmt::format("{} given, finite numbers with a positive width and height expected",
                               fmt::join(numbers, ",")));
}

}  // namespace clipscope::experiments::commands
