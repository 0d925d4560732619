// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pixels/judgement.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace clipscope::experiments {

std::uint64_t UlpErrors::count() const {
  return std::accumulate(bins.begin(), bins.end(), std::uint64_t{0});
}

double UlpErrors::quantile(double share) const {
  const double wanted = share * static_cast<double>(count());
  std::uint64_t seen = 0;
  for (std::size_t bin = 0; bin + 1 < kBins; ++bin) {
    seen += bins[bin];
    if (static_cast<double>(seen) >= wanted) {
      return std::min(greatest, std::ldexp(1.0, static_cast<int>(bin) - 1));
    }
  }
  return greatest;
}

void UlpErrors::add(double ulps, const WorstPixel& pixel) {
  // 2^(exponent - 1) < 2 ulps <= 2^exponent.
  int exponent = 0;
  if (2 * ulps > 1 && std::frexp(2 * ulps, &exponent) == 0.5) --exponent;
  ++bins[std::min(static_cast<std::size_t>(std::max(exponent, 0)), kBins - 1)];
  if (ulps <= greatest) return;
  greatest = ulps;
  worst = pixel;
}

void UlpErrors::add(const UlpErrors& other) {
  for (std::size_t bin = 0; bin < kBins; ++bin) bins[bin] += other.bins[bin];
  if (other.greatest <= greatest) return;
  greatest = other.greatest;
  worst = other.worst;
}

}  // namespace clipscope::experiments
