// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include "experiments/table/statistics.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;

TEST_CASE("statistics: the median of an even number is the middle of the two inner samples") {
  CHECK(median_interval({4, 1, 3, 2}).median == 2.5);
  CHECK(median_interval({7}).median == 7);
  CHECK(median_interval({7}).low == 7);
}

TEST_CASE("statistics: the interval of 25 samples runs from the 8th to the 18th") {
  std::vector<double> samples;
  for (int i = 25; i >= 1; --i) samples.push_back(i);
  const MedianInterval m = median_interval(samples);
  CHECK(m.median == 13);
  CHECK(m.low == 8);
  CHECK(m.high == 18);
}

TEST_CASE("statistics: a histogram's quantile is right to 1.1 percent over all magnitudes") {
  LogHistogram histogram;
  for (int i = -300; i <= 300; ++i) histogram.add(std::pow(10.0, i));
  CHECK(histogram.quantile(0.5) == Approx(1.0).epsilon(0.011));
  CHECK(histogram.quantile(1.0) == 1e300);
  CHECK(histogram.max() == 1e300);
}

TEST_CASE("statistics: zeros and infinities have bins of their own") {
  LogHistogram histogram;
  CHECK(histogram.quantile(0.5) == 0);
  histogram.add(0);
  histogram.add(0);
  histogram.add(std::numeric_limits<double>::infinity());
  CHECK(histogram.quantile(0.5) == 0);
  CHECK(std::isinf(histogram.quantile(1.0)));
}
