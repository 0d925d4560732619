// SPDX-License-Identifier: GPL-3.0-or-later
//
// Order statistics: medians with their intervals, and histograms of errors over many magnitudes.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace clipscope::experiments {

// The median of some samples and an interval that covers the population's median with a probability
// of about 95 %, whatever the distribution: the order statistics floor((n - 1.96 sqrt(n)) / 2)
// places from either end (Hollander and Wolfe, "Nonparametric Statistical Methods", 1999, section
// 3.6).
struct MedianInterval {
  double median = 0, low = 0, high = 0;
};

// Whether all of a lies below all of b: then a is less, not only by chance.
constexpr bool is_below(const MedianInterval& a, const MedianInterval& b) { return a.high < b.low; }

// Pre-condition: at least one sample.
MedianInterval median_interval(std::vector<double> samples);

// Counts non-negative values in bins of 1/64 of an octave, so that a quantile is right to 1.1 % in
// memory that does not grow with the number of values. Zero has a bin of its own.
class LogHistogram {
 public:
  void add(double value);
  std::uint64_t count() const { return count_; }
  double max() const { return max_; }
  // The q-quantile, 0 <= q <= 1; 0 for an empty histogram.
  double quantile(double q) const;

 private:
  std::map<int, std::uint64_t> bins_;
  std::uint64_t zeros_ = 0, count_ = 0;
  double max_ = 0;
};

// The median of many errors, and the largest.
struct Spread {
  double median = 0, max = 0;
};

// Nothing where nothing was counted.
std::optional<Spread> spread_of(const LogHistogram& errors);

}  // namespace clipscope::experiments
