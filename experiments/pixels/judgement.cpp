// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/pixels/judgement.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace clipscope::experiments {
namespace {

// The least k >= 0 with 2 ulps <= 2^k: from the exponent's bits, one more unless the others are 0.
std::size_t bin_of(double ulps) {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(std::clamp(2 * ulps, 1.0, 0x1p60));
  const std::uint64_t above_power = bits + (std::uint64_t{1} << 52) - 1;
  return std::min(static_cast<std::size_t>((above_power >> 52) - 1023), UlpErrors::kBins - 1);
}

}  // namespace

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
  ++bins[bin_of(ulps)];
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
