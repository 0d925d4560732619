// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hunt/rows.hpp"

#include <utility>

#include "experiments/judge/outcome.hpp"

namespace clipscope::experiments::hunt {
namespace {

// Whether a list as "missing, extra" has the name.
bool lists(const std::string& list, std::string_view name) {
  const std::string padded = ", " + list + ", ";
  return padded.find(", " + std::string(name) + ", ") != std::string::npos;
}

std::string in_either(const std::string& a, const std::string& b) {
  std::string both;
  for (const std::string_view name : kOutcomeNames) {
    if (!lists(a, name) && !lists(b, name)) continue;
    if (!both.empty()) both += ", ";
    both += name;
  }
  return both;
}

}  // namespace

HuntRow& HuntRow::operator+=(const HuntRow& other) {
  if (other.hunts == 0) return *this;
  HuntRow sum = *this;
  const bool is_worse = other.worst > worst || (other.worst == worst && other.seed < seed);
  if (hunts == 0 || is_worse) sum = other;
  sum.evaluations = evaluations + other.evaluations;
  sum.failing = in_either(failing, other.failing);
  sum.hunts = hunts + other.hunts;
  return *this = std::move(sum);
}

bool same_subject(const HuntRow& a, const HuntRow& b) {
  return a.clipper == b.clipper && a.scalar == b.scalar && a.measure == b.measure;
}

}  // namespace clipscope::experiments::hunt
