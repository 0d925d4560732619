// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/report/plot_layout.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments {
namespace {

constexpr double kRoom = 0.05;  // of the range, at either end

std::string superscript(int number) {
  static constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = number < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(number))) text += kDigits[digit - '0'];
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

// Calls f(number, k, factor) for 1 to 9 times each power of ten 10^k of the range, in their order.
template <class F>
void for_each_step(double low, double high, F&& f) {
  for (int k = decade_of(low); k <= decade_of(high); ++k) {
    for (int factor = 1; factor < 10; ++factor) f(factor * std::pow(10.0, k), k, factor);
  }
}

bool is_plain(double low, double high) { return low >= 1e-3 && high <= 2e4; }

// Whole powers of ten are labelled, each or every few; those between are minor tics.
std::vector<Tic> decade_tics(double low, double high, std::size_t most) {
  const int stride = 1 + (decade_of(high) - decade_of(low)) / static_cast<int>(most);
  std::vector<Tic> tics;
  for_each_step(low, high, [&](double at, int k, int factor) {
    const bool is_power = factor == 1;
    if ((!is_power && stride > 1) || at < low * (1 - 1e-12) || at > high * (1 + 1e-12)) return;
    std::string label;
    if (is_power && k % stride == 0) {
      label = is_plain(low, high) ? fmt::format("{:g}", at) : "10" + superscript(k);
    }
    tics.push_back({std::clamp(at, low, high), label});
  });
  return tics;
}

// 1, 2 and 5 times powers of ten, for two decades or less.
std::vector<Tic> fine_tics(double low, double high) {
  std::vector<Tic> tics;
  for_each_step(low, high, [&](double at, int, int factor) {
    if (at < low || at > high) return;
    std::string label;
    if (factor == 1 || factor == 2 || factor == 5) {
      label = is_plain(low, high) ? fmt::format("{:.6g}", at) : power_label(at);
    }
    tics.push_back({at, label});
  });
  return tics;
}

std::size_t labelled(const std::vector<Tic>& tics) {
  return tics.size() - static_cast<std::size_t>(std::ranges::count(tics, "", &Tic::label));
}

std::vector<Tic> logarithmic_tics(double low, double high, std::size_t most) {
  std::vector<Tic> decades = decade_tics(low, high, most), fine = fine_tics(low, high);
  if (labelled(decades) > 2) return decades;
  if (labelled(fine) > 2 && labelled(fine) <= most) return fine;
  return high / low < 10 ? linear_tics(low, high, most) : decades;
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

// ---- Labels -------------------------------------------------------------------------------------

// In font sizes: the mean width of DejaVu Sans, which is wider than most.
constexpr double kPerCharacter = 0.58;
constexpr double kNear = 7;        // px between a point and a text beside it
constexpr double kDropped = 0.25;  // a text covered by more than this by others is left out

bool within(const LabelBox& box, const LabelBox& area) {
  return box.left >= area.left && box.right <= area.right && box.top >= area.top &&
         box.bottom <= area.bottom;
}

// The area [px²] of the box that lies in the others, each counted for itself.
double covered(const LabelBox& box, const std::vector<LabelBox>& by) {
  double sum = 0;
  for (const LabelBox& other : by) {
    const double width = std::min(box.right, other.right) - std::max(box.left, other.left);
    const double height = std::min(box.bottom, other.bottom) - std::max(box.top, other.top);
    if (width > 0 && height > 0) sum += width * height;
  }
  return sum;
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
  static constexpr Direction kAround[] = {{1, 0, 0},  {-1, 0, 4}, {0, -1, 6},  {0, 1, 8},
                                          {1, -1, 2}, {1, 1, 3},  {-1, -1, 6}, {-1, 1, 7}};
  std::vector<Candidate> result;
  for (const double extra : {0.0, 8.0, 18.0, 32.0, 50.0, 72.0}) {
    for (const auto& [dx, dy, burden] : kAround) {
      if (label.upward && (dx != 0 || dy != -1)) continue;
      // How far the nearest corner or edge of the box is from the point.
      const double distance = (label.upward ? 3 : kNear) + extra;
      const double reach = dx != 0 && dy != 0 ? distance * 0.7 : distance;
      const double w = label.width / 2, h = label.height / 2;
      const double x = label.x + dx * (reach + w), y = label.y + dy * (reach + h);
      const LabelPlace place{{x - w, y - h, x + w, y + h}, extra > 8 && !label.upward};
      result.push_back({place, burden + 3 * extra});
    }
  }
  return result;
}

}  // namespace

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
  const auto first =
      std::ranges::find_if(scale.tics, [](const Tic& t) { return !t.label.empty(); });
  if (!axis.lowest.empty() && first != scale.tics.end()) first->label = axis.lowest;
  return scale;
}

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
      if (cost >= least || by_texts > kDropped * label.width * label.height) continue;
      least = cost;
      best = candidate.place;
    }
    if (best) taken.push_back(best->box);
    places.push_back(best);
  }
  return places;
}

double text_width(const std::string& text, double size) {
  return kPerCharacter * size * static_cast<double>(character_count(text));
}

}  // namespace clipscope::experiments
