// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/lens.hpp"

#include <fmt/core.h>

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>

#include "experiments/machine/errors.hpp"

namespace clipscope::experiments {
namespace {

void require_positive(const char* option, double v) {
  if (v > 0 && std::isfinite(v)) return;
  throw UsageError(fmt::format("{}: {} given; it takes a finite number > 0", option, v));
}

void require_depths(double near, double far) {
  require_positive("--near", near);
  if (!(far > 0)) {
    throw UsageError(fmt::format("--far: {} given; it takes a number > 0, or inf", far));
  }
  if (near < far) return;
  throw UsageError(
      fmt::format("--near: {} given; it must be less than far, which is {}", near, far));
}

bool encloses_a_volume(const Frustum<float>& f) {
  return is_valid(f) &&
         std::isfinite(f.left + f.right + f.bottom + f.top + f.near + (f.infinite_far ? 0 : f.far));
}

Frustum<double> sides(double left, double right, double bottom, double top, double near,
                      double far) {
  Frustum<double> f{ProjectionKind::perspective, left, right, bottom, top, near, far};
  f.infinite_far = std::isinf(far);
  if (f.infinite_far) f.far = 0;
  return f;
}

}  // namespace

Frustum<double> intrinsics_frustum(const Intrinsics& i, double near, double far) {
  for (const auto& [name, v] :
       {std::pair{"FX", i.fx}, {"FY", i.fy}, {"WIDTH", i.width}, {"HEIGHT", i.height}}) {
    if (v > 0 && std::isfinite(v)) continue;
    throw UsageError(fmt::format("--intrinsics: {} is {}; a finite number > 0 expected", name, v));
  }
  if (!std::isfinite(i.cx + i.cy)) {
    throw UsageError(
        fmt::format("--intrinsics: CX,CY is {},{}; finite numbers expected", i.cx, i.cy));
  }
  require_depths(near, far);
  const auto x_at = [&](double px) { return near * (px - i.cx) / i.fx; };
  const auto y_at = [&](double py) { return near * (i.cy - py) / i.fy; };
  return sides(x_at(-0.5), x_at(i.width - 0.5), y_at(i.height - 0.5), y_at(-0.5), near, far);
}

Frustum<float> perspective_frustum(double fovy_degrees, double aspect, double near, double far) {
  if (!(fovy_degrees > 0 && fovy_degrees < 180)) {
    throw UsageError(fmt::format(
        "--fovy: {} given; it takes degrees between 0 and 180, both excluded", fovy_degrees));
  }
  require_positive("--aspect", aspect);
  require_depths(near, far);
  const double top = near * std::tan(fovy_degrees * std::numbers::pi / 360);
  const Frustum<float> f =
      frustum_cast<float>(sides(-top * aspect, top * aspect, -top, top, near, far));
  if (encloses_a_volume(f)) return f;
  throw UsageError(fmt::format(
      "--near: {} and far {} with --fovy {} and --aspect {} enclose no volume once rounded to float; move near and far apart",
      near, far, fovy_degrees, aspect));
}

Frustum<float> rounded_frustum(const Frustum<double>& f, const char* option) {
  const Frustum<float> rounded = frustum_cast<float>(f);
  if (encloses_a_volume(rounded)) return rounded;
  throw UsageError(fmt::format(
      "{}: left={} right={} bottom={} top={} near={} far={} enclose no volume once rounded to float; expected left < right, bottom < top, near < far, and 0 < near for perspective",
      option, f.left, f.right, f.bottom, f.top, f.near, f.infinite_far ? HUGE_VAL : f.far));
}

}  // namespace clipscope::experiments
