// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/plot_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace clipscope::experiments {
namespace {

constexpr double kRoom = 0.05;  // of the range, at either end

std::string superscript(int number) {
  static constexpr std::array<const char*, 10> kDigits = {"⁰", "¹", "²", "³", "⁴",
                                                          "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = number < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(number))) {
    text += kDigits[static_cast<std::size_t>(digit - '0')];
  }
  return text;
}

int decade_of(double value) { return static_cast<int>(std::floor(std::log10(value) + 1e-9)); }

// "2×10⁻⁵", or "10⁻⁵" for a whole power.
std::string power_label(double value) {
  const int exponent = decade_of(std::abs(value));
  const double mantissa = std::abs(value) / std::pow(10.0, exponent);
  const std::string power = (value < 0 ? "−" : "") + ("10" + superscript(exponent));
  if (std::abs(mantissa - 1) < 1e-9) return power;
  return fmt::format("{}{:.3g}×10{}", value < 0 ? "−" : "", mantissa, superscript(exponent));
}

// The label of a tic among others `step` apart, on an axis that reaches to `size`.
std::string linear_label(double value, double step, double size) {
  if (value == 0) return "0";
  if (size >= 1e5 || size < 1e-3) return power_label(value);
  const int decimals = std::max(0, -decade_of(step));
  return fmt::format("{}{:.{}f}", value < 0 ? "−" : "", std::abs(value), decimals);
}

// 1, 2 or 5 times a power of ten: the smallest such step that makes at most `most` tics.
double nice_step(double range, std::size_t most) {
  const double rough = range / static_cast<double>(most);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) return factor * power;
  }
  return 10 * power;
}

std::vector<Tic> linear_tics(double low, double high, std::size_t most) {
  const double step = nice_step(high - low, most);
  const double size = std::max(std::abs(low), std::abs(high));
  std::vector<Tic> tics;
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) {
    const double at = std::clamp(k * step, low, high);
    tics.push_back({at, linear_label(k == 0 ? 0.0 : at, step, size)});
  }
  return tics;
}

// Whole powers of ten are labelled, each or every few; those between are minor tics.
std::vector<Tic> decade_tics(double low, double high, std::size_t most) {
  const int first = decade_of(low), last = decade_of(high);
  const int stride = 1 + (last - first) / static_cast<int>(most);
  const bool plain = low >= 1e-3 && high <= 2e4;
  std::vector<Tic> tics;
  for (int k = first; k <= last; ++k) {
    const double power = std::pow(10.0, k);
    const auto add = [&](double at, const std::string& label) {
      if (at >= low * (1 - 1e-12) && at <= high * (1 + 1e-12)) {
        tics.push_back({std::clamp(at, low, high), label});
      }
    };
    const bool labelled = k % stride == 0;
    add(power, !labelled ? "" : (plain ? fmt::format("{:g}", power) : "10" + superscript(k)));
    for (int factor = 2; stride == 1 && factor < 10; ++factor) add(factor * power, "");
  }
  return tics;
}

// 1, 2 and 5 times powers of ten, for two decades or less.
std::vector<Tic> fine_tics(double low, double high) {
  const bool plain = low >= 1e-3 && high <= 2e4;
  std::vector<Tic> tics;
  for (int k = decade_of(low); k <= decade_of(high); ++k) {
    for (int factor = 1; factor < 10; ++factor) {
      const double at = factor * std::pow(10.0, k);
      if (at < low || at > high) continue;
      const bool labelled = factor == 1 || factor == 2 || factor == 5;
      tics.push_back({at, !labelled ? "" : (plain ? fmt::format("{:.6g}", at) : power_label(at))});
    }
  }
  return tics;
}

std::size_t labelled(const std::vector<Tic>& tics) {
  return static_cast<std::size_t>(
      std::count_if(tics.begin(), tics.end(), [](const Tic& t) { return !t.label.empty(); }));
}

std::vector<Tic> logarithmic_tics(double low, double high, std::size_t most) {
  std::vector<Tic> tics = decade_tics(low, high, most);
  if (labelled(tics) > 2) return tics;
  tics = fine_tics(low, high);
  if (labelled(tics) > 2 && labelled(tics) <= most) return tics;
  return high / low < 10 ? linear_tics(low, high, most) : decade_tics(low, high, most);
}

void set_linear_range(double least, double most, bool bars, Scale& scale) {
  const double size = std::max(std::abs(least), std::abs(most));
  // Not so small that neighbouring tics were one number.
  const double range = most > least ? std::max(most - least, 1e-9 * size) : std::max(size, 1.0);
  scale.low = least - kRoom * range;
  scale.high = most + kRoom * range;
  // An axis that all but reaches 0 begins there.
  if (least >= 0 && (bars || least <= 0.3 * most)) scale.low = 0;
  if (most <= 0 && (bars || most >= 0.3 * least)) scale.high = 0;
  if (scale.low == scale.high) scale.high = scale.low + 1;
}

void set_logarithmic_range(double least, double most, bool bars, Scale& scale) {
  const double range = std::log10(most) - std::log10(least);
  const double room = range > 0 ? std::max(kRoom * range, 0.01) : 0.15;
  scale.low = least * std::pow(10.0, -room);
  scale.high = most * std::pow(10.0, room);
  if (bars) scale.low = std::pow(10.0, std::floor(std::log10(least / 1.5)));
  scale.low = std::max(scale.low, 1e-307);
  scale.high = std::min(scale.high, 1e307);
}

}  // namespace

bool Scale::can_show(double value) const {
  return std::isfinite(value) && (!logarithmic || value > 0);
}

double Scale::fraction(double value) const {
  if (!logarithmic) return (value - low) / (high - low);
  return std::log(value / low) / std::log(high / low);
}

Scale make_scale(const Axis& axis, std::span<const double> values, const ScaleOptions& options) {
  Scale scale;
  scale.logarithmic = axis.logarithmic;
  double least = INFINITY, most = -INFINITY;
  for (const double value : values) {
    if (!scale.can_show(value)) continue;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  if (least > most) {
    scale.low = axis.logarithmic ? 1 : 0;
    scale.high = axis.logarithmic ? 10 : 1;
  } else if (axis.logarithmic) {
    set_logarithmic_range(least, most, options.bars, scale);
  } else {
    set_linear_range(least, most, options.bars, scale);
  }
  Scale limited = scale;
  if (axis.from && scale.can_show(*axis.from)) limited.low = *axis.from;
  if (axis.to && scale.can_show(*axis.to)) limited.high = *axis.to;
  if (limited.low < limited.high) scale = limited;
  scale.tics = scale.logarithmic ? logarithmic_tics(scale.low, scale.high, options.most_tics)
                                 : linear_tics(scale.low, scale.high, options.most_tics);
  return scale;
}

}  // namespace clipscope::experiments
