// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/contestants/scalars.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/fraction.hpp"

namespace clipscope::experiments {

double Format::unit_roundoff() const { return is_exact() ? 0 : std::ldexp(1.0, -precision); }

double Format::ulp_at(double x) const {
  if (is_exact()) return 0;
  const int exponent = x == 0 ? min_exponent : std::max(std::ilogb(x), min_exponent);
  return std::ldexp(1.0, exponent - precision + 1);
}

double Format::largest() const {
  return is_float() ? double{std::numeric_limits<float>::max()}
                    : std::numeric_limits<double>::max();
}

double Format::smallest() const {
  if (is_exact()) return 0;
  return is_float() ? double{std::numeric_limits<float>::denorm_min()}
                    : std::numeric_limits<double>::denorm_min();
}

double nearest_double(const Exact& x) { return reference::round_to<double>(x); }

}  // namespace clipscope::experiments
