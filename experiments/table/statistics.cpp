// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/table/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace clipscope::experiments {
namespace {

constexpr double kBinsPerOctave = 64.0;
constexpr int kInfinityBin = 1 << 20;

int bin_of(double value) {
  if (std::isinf(value)) return kInfinityBin;
  return static_cast<int>(std::floor(std::log2(value) * kBinsPerOctave));
}

}  // namespace

MedianInterval median_interval(std::vector<double> samples) {
  std::sort(samples.begin(), samples.end());
  const std::size_t count = samples.size();
  const double n = static_cast<double>(count);
  const double median = (samples[(count - 1) / 2] + samples[count / 2]) / 2;
  const double spread = 1.96 * std::sqrt(n);
  const double low_rank = std::floor((n - spread) / 2);
  const double high_rank = n - 1 - low_rank;
  const auto at = [&](double rank) {
    return samples[static_cast<std::size_t>(std::clamp(rank, 0.0, n - 1))];
  };
  return {median, at(low_rank), at(high_rank)};
}

void LogHistogram::add(double value) {
  ++count_;
  max_ = std::max(max_, value);
  if (value == 0.0) {
    ++zeros_;
  } else {
    ++bins_[bin_of(value)];
  }
}

double LogHistogram::quantile(double q) const {
  if (count_ == 0) return 0.0;
  const auto rank = static_cast<std::uint64_t>(q * static_cast<double>(count_ - 1));
  std::uint64_t below = zeros_;
  if (rank < below) return 0.0;
  for (const auto& [bin, count] : bins_) {
    below += count;
    if (rank < below) {
      if (bin == kInfinityBin) return max_;
      return std::min(max_, std::exp2((bin + 0.5) / kBinsPerOctave));
    }
  }
  return max_;
}

std::optional<Spread> spread_of(const LogHistogram& errors) {
  if (errors.count() == 0) return std::nullopt;
  return Spread{errors.quantile(0.5), errors.max()};
}

}  // namespace clipscope::experiments
