// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hunt/sketch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/judge/outcome.hpp"

namespace clipscope::experiments::hunt {
namespace {

constexpr std::size_t kPlace = 3;

double squared_px(const double* a, const double* b) {
  const double x = (a[0] - b[0]) * (kScreenWidth / 2), y = (a[1] - b[1]) * (kScreenHeight / 2);
  return x * x + y * y;
}

// The shift of the answer that brings the vertices closest together. Pre-condition: as many.
std::size_t best_shift(const Sketch& wide, const Sketch& answer) {
  constexpr double kTogether = 1e-4;  // px^2
  const std::size_t n = wide.size();
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t shift = 0; shift < n && least > kTogether; ++shift) {
    double largest = 0;
    for (std::size_t i = 0; i < n && largest < least; ++i) {
      largest = std::max(largest, squared_px(wide[i], answer[(i + shift) % n]));
    }
    if (largest >= least) continue;
    least = largest;
    best = shift;
  }
  return best;
}

double error_in_ulp(const Format& format, double value, double wide) {
  const double error = std::abs(value - wide);
  return error == 0 ? 0 : error / format.ulp_at(wide);
}

Outcome seeming_outcome(const PolygonView& polygon, const Sketch& answer, const Sketch& wide) {
  if (polygon.failure() != nullptr) {
    switch (polygon.failure()->kind) {
      case Failure::Kind::crashed: return Outcome::crashed;
      case Failure::Kind::timed_out: return Outcome::timed_out;
      case Failure::Kind::malformed: return Outcome::malformed;
    }
  }
  if (!answer.is_finite()) return Outcome::not_finite;
  const bool is_seen = wide.size() >= 3, is_drawn = answer.size() >= 3;
  if (!is_seen && !is_drawn) return Outcome::exact;
  if (!is_drawn) return Outcome::missing;
  if (!is_seen) return Outcome::extra;
  return answer.size() == wide.size() ? Outcome::exact : Outcome::vertex_count;
}

}  // namespace

Sketch::Sketch(const PolygonView& polygon) {
  for (const VertexView& v : polygon) {
    stride_ = v.size();
    for (std::size_t i = 0; i < stride_; ++i) {
      const double x = v[i].value;
      if (i != kPlace) is_finite_ = is_finite_ && std::isfinite(x);
      numbers_.push_back(x);
    }
  }
  drop_repeats();
}

Sketch::Sketch(const TruthPolygon& truth) {
  for (const std::vector<double>& v : truth.approximation) {
    stride_ = v.size();
    numbers_.insert(numbers_.end(), v.begin(), v.end());
  }
}

void Sketch::drop_repeats() {
  const auto same_place = [&](std::size_t a, std::size_t b) {
    return std::equal((*this)[a], (*this)[a] + kPlace, (*this)[b]);
  };
  std::size_t kept = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    if (kept > 0 && same_place(i, kept - 1)) continue;
    if (kept != i) std::copy_n((*this)[i], stride_, numbers_.data() + kept * stride_);
    ++kept;
  }
  while (kept > 1 && same_place(0, kept - 1)) --kept;
  numbers_.resize(kept * stride_);
}

Errors sketched_errors(const PolygonView& polygon, const Sketch& answer, const Sketch& wide) {
  Errors errors;
  Comparison& r = errors.comparison;
  r.outcome = seeming_outcome(polygon, answer, wide);
  r.visible = wide.size() >= 3 || answer.size() >= 3 || polygon.failure() != nullptr;
  if (r.outcome != Outcome::exact || wide.size() < 3) return errors;
  const Format& format = polygon.format();
  const std::size_t n = wide.size(), shift = best_shift(wide, answer);
  double px = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double *a = answer[(i + shift) % n], *b = wide[i];
    px = std::max(px, squared_px(a, b));
    for (std::size_t c = 0; c < 4; ++c) {
      r.position_ulp = std::max(r.position_ulp, error_in_ulp(format, a[c], b[c]));
    }
    errors.depth_ulp = std::max(errors.depth_ulp, std::abs(a[2] - b[2]) / format.ulp_at(1));
    for (std::size_t k = 4; k < std::min(answer.stride(), wide.stride()); ++k) {
      r.attribute = std::max(r.attribute, std::abs(a[k] - b[k]));
    }
  }
  r.position_px = std::sqrt(px);
  return errors;
}

double crack_between(const Side& triangle, const Side& neighbour, std::size_t third) {
  constexpr double kOnEdge = 1e-12;
  const auto fits = [](const Side& side) {
    return side.answer.is_finite() && side.wide.size() >= 3 &&
           side.answer.size() == side.wide.size();
  };
  if (!fits(triangle) || !fits(neighbour)) return 0;
  const std::size_t a_shift = best_shift(triangle.wide, triangle.answer),
                    b_shift = best_shift(neighbour.wide, neighbour.answer);
  double widest = 0;
  for (std::size_t i = 0; i < triangle.wide.size(); ++i) {
    if (std::abs(triangle.wide[i][4 + third]) > kOnEdge) continue;
    // The vertex of the neighbour for the same point.
    double least = std::numeric_limits<double>::infinity(), distance = 0;
    for (std::size_t j = 0; j < neighbour.wide.size(); ++j) {
      if (std::abs(neighbour.wide[j][4 + third]) > kOnEdge) continue;
      const double apart = squared_px(triangle.wide[i], neighbour.wide[j]);
      if (apart >= least) continue;
      least = apart;
      distance = squared_px(triangle.answer[(i + a_shift) % triangle.answer.size()],
                            neighbour.answer[(j + b_shift) % neighbour.answer.size()]);
    }
    constexpr double kSamePoint = 1e-12;  // px^2
    if (least < kSamePoint) widest = std::max(widest, distance);
  }
  return std::sqrt(widest);
}

}  // namespace clipscope::experiments::hunt
