// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/contestants/answers.hpp"

namespace clipscope::experiments {
namespace {

// op(a, b) in the scalar of the format.
template <class Op>
Number computed(const Format& format, const Number& a, const Number& b, Op&& op) {
  if (format.is_exact()) {
    const auto r = std::make_shared<const Exact>(op(*a.exact, *b.exact));
    return {nearest_double(*r), 0, r};
  }
  if (format.is_float()) return {op(static_cast<float>(a.value), static_cast<float>(b.value))};
  if (format.precision == kFormat<double>.precision) return {op(a.value, b.value)};
  const dd_real r = op(dd_real(a.value, a.rest), dd_real(b.value, b.rest));
  return {r.x[0], r.x[1]};
}

}  // namespace

Exact to_exact(const Number& x) {
  if (x.exact) return *x.exact;
  return Exact(Exact(x.value) + Exact(x.rest));
}

Number difference(const Format& format, const Number& a, const Number& b) {
  return computed(format, a, b, []<class T>(const T& x, const T& y) { return T(x - y); });
}

Number product(const Format& format, const Number& a, const Number& b) {
  return computed(format, a, b, []<class T>(const T& x, const T& y) { return T(x * y); });
}

Number times_power_of_two(const Number& x, int exponent) {
  Number r{std::ldexp(x.value, exponent), std::ldexp(x.rest, exponent)};
  if (x.exact) r.exact = std::make_shared<const Exact>(*x.exact * Exact(std::ldexp(1.0, exponent)));
  return r;
}

std::size_t VertexView::size() const { return answers_->stride(); }

Number VertexView::operator[](std::size_t i) const {
  const std::size_t at = vertex_ * answers_->stride_ + i;
  Number x{answers_->values_[at]};
  if (!answers_->rests_.empty()) x.rest = answers_->rests_[at];
  // Not owned: it lives as long as the answers do.
  if (!answers_->exact_.empty()) x.exact = {std::shared_ptr<void>(), &answers_->exact_[at]};
  return x;
}

const Format& PolygonView::format() const { return answers_->format(); }

const Failure* PolygonView::failure() const {
  const auto found = answers_->failures_.find(primitive_);
  return found == answers_->failures_.end() ? nullptr : &found->second;
}

// The parts need not be those of QD's normal form, in which the first is the nearest double.
void Answers::add(const dd_real& x) {
  double rest = 0;
  const double value = qd::two_sum(x.x[0], x.x[1], rest);
  values_.push_back(value);
  rests_.push_back(std::isfinite(value) ? rest : 0);
}

void Answers::add(const Exact& x) {
  values_.push_back(nearest_double(x));
  exact_.push_back(x);
}

}  // namespace clipscope::experiments
