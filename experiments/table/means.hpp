// SPDX-License-Identifier: GPL-3.0-or-later
//
// Means of figures that are ratios or times of different things.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

namespace clipscope::experiments {

// exp of the mean of logarithms: of ratios it does not matter which way round they are.
class GeometricMean {
 public:
  // Pre-condition: figure > 0.
  void add(double figure) {
    logarithms_ += std::log(figure);
    ++count_;
  }
  // None of nothing.
  std::optional<double> mean() const {
    if (count_ == 0) return std::nullopt;
    return std::exp(logarithms_ / static_cast<double>(count_));
  }

 private:
  double logarithms_ = 0;
  std::size_t count_ = 0;
};

}  // namespace clipscope::experiments
