// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/proofs/proofs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "spaces/batch/error_bounds.hpp"
#include "spaces/bounds/enclose.hpp"
#include "spaces/effects/plan.hpp"

namespace clipscope::proofs {

namespace {

constexpr double kU = 0x1p-53;

constexpr Constant in_u(std::string_view name, double value) {
  return {name, value, Weakening::subtract, kU};
}
constexpr Constant counted(std::string_view name, double value) {
  return {name, value, Weakening::subtract, 1};
}
constexpr Constant by_halves(std::string_view name, double value) {
  return {name, value, Weakening::halve, 0};
}

constexpr std::array kConstants = {
    // spaces/barycentric/exact_lines.hpp
    in_u("kFilterError", barycentric::kFilterError),
    in_u("kLeadingQuotientError", barycentric::kLeadingQuotientError),
    by_halves("kDivisorCertainty", barycentric::kDivisorCertainty),
    in_u("kQuotientRoundings", barycentric::kQuotientRoundings),
    by_halves("kQuotientSlack", barycentric::kQuotientSlack),
    by_halves("kSmallestFiltered", barycentric::kSmallestFiltered),
    Constant{"kDotLowest", barycentric::kDotLowest, Weakening::add, 1},
    counted("kDotHighest", barycentric::kDotHighest),
    // spaces/batch/error_bounds.hpp
    in_u("kEdgeError", batch::kEdgeError),
    in_u("kSideError", batch::kSideError),
    Constant{"kMeanError", batch::kMeanError, Weakening::subtract, 0x1p-7},
    in_u("kMeanRoundings", batch::kMeanRoundings),
    in_u("kOwnVertexError", batch::kOwnVertexError),
    in_u("kEdgeNumeratorError", batch::kEdgeNumeratorError),
    in_u("kEdgeDenominatorError", batch::kEdgeDenominatorError),
    in_u("kMeetingNumeratorError", batch::kMeetingNumeratorError),
    in_u("kMeetingDenominatorError", batch::kMeetingDenominatorError),
    in_u("kMeetingWeightError", batch::kMeetingWeightError),
    Constant{"kOfDenominator", batch::kOfDenominator, Weakening::subtract, 0x1p-7},
    in_u("kFullQuotientRoundings", batch::kFullQuotientRoundings),
    by_halves("kSmallestDenominator", batch::kSmallestDenominator),
    // spaces/bounds/
    counted("kDistanceRoundings", kDistanceRoundings),
    counted("kLengthRoundings", kLengthRoundings),
    counted("kNormalRoundings", kNormalRoundings),
    Constant{"kMostSkew", bounds::kMostSkew, Weakening::twice, 0},
    counted("kHalfSizeRoundings", bounds::kHalfSizeRoundings),
    by_halves("kSafe_float", bounds::kSafe<float>),
    by_halves("kSafe_double", bounds::kSafe<double>),
    // spaces/effects/plan.hpp
    counted("kCutRoundings", kCutRoundings),
    counted("kAffineRoundings", kAffineRoundings),
    // Links: a count of roundings with room for what is of higher order.
    in_u("sheared_entry", 2 * (1 + 0x1p-42) * kU),
    in_u("numerator", 3 * (1 + 0x1p-40) * kU),
    in_u("clip_minor", 4 * (1 + 0x1p-40) * kU),
    in_u("view_minor", 6 * (1 + 0x1p-38) * kU),
    in_u("matrix_entry", 3 * (1 + 0x1p-40) * kU),
    in_u("clip_coordinate", 6 * (1 + 0x1p-38) * kU),
    by_halves("numerator_slack", 0x1p-18),
    counted("entry_exponent", 257),
    counted("lambda_exponent", 515),
    Constant{"midpoint_bits", 25, Weakening::add, 1},
};

const std::vector<Parameter> kFloat = {
    {"EPS", "1b-23"},     {"EPS/2", "1b-24"},         {"FORMAT", "ieee_32"},         {"BITS", "24"},
    {"SMALLEST", "-149"}, {"kSafe", "@kSafe_float@"}, {"kSafe/2", "@kSafe_float/2@"}};
const std::vector<Parameter> kDouble = {{"EPS", "1b-52"},
                                        {"EPS/2", "1b-53"},
                                        {"FORMAT", "ieee_64"},
                                        {"BITS", "53"},
                                        {"SMALLEST", "-1074"},
                                        {"kSafe", "@kSafe_double@"},
                                        {"kSafe/2", "@kSafe_double/2@"}};

const std::array kProofs = {
    Proof{"range", "range", {}, {"entry_exponent", "lambda_exponent"}},
    Proof{"line_entry", "line_entry", {}, {"sheared_entry"}},
    Proof{"minor_clip", "minor", {{"ENTRY", "1b-53"}, {"MINOR", "@clip_minor@"}}, {"clip_minor"}},
    Proof{"minor_view",
          "minor",
          {{"ENTRY", "@sheared_entry@"}, {"MINOR", "@view_minor@"}},
          {"view_minor"}},
    Proof{"numerator", "numerator", {}, {"numerator"}},
    Proof{"filter", "filter", {}, {}},
    Proof{"certificate", "certificate", {}, {}},
    Proof{"leading_quotient", "leading_quotient", {}, {}},
    Proof{"midpoint", "midpoint", {}, {"midpoint_bits"}},
    Proof{"edge_mean", "edge_mean", {}, {}},
    Proof{"corner_sums", "corner_sums", {}, {}},
    Proof{"mean_quotient", "mean_quotient", {}, {}},
    Proof{"clip_coordinate", "clip_coordinate", {}, {"matrix_entry", "clip_coordinate"}},
    Proof{"own_vertex", "own_vertex", {}, {}},
    Proof{"edge_sums", "edge_sums", {}, {}},
    Proof{"meeting_sums", "meeting_sums", {}, {}},
    Proof{"meeting_weights", "meeting_weights", {}, {}},
    Proof{"full_quotient", "full_quotient", {}, {"numerator_slack"}},
    Proof{"small_denominator", "small_denominator", {}, {}},
    Proof{"culling_distance_float", "culling_distance", kFloat, {}},
    Proof{"culling_distance_double", "culling_distance", kDouble, {}},
    Proof{"length_float", "length", kFloat, {}},
    Proof{"length_double", "length", kDouble, {}},
    Proof{"normal_length_float", "normal_length", kFloat, {}},
    Proof{"normal_length_double", "normal_length", kDouble, {}},
    Proof{"oriented_box_float", "oriented_box", kFloat, {}},
    Proof{"oriented_box_double", "oriented_box", kDouble, {}},
    Proof{"safe_product_float", "safe_product", kFloat, {}},
    Proof{"safe_product_double", "safe_product", kDouble, {}},
    Proof{"affine_float", "affine", kFloat, {}},
    Proof{"affine_double", "affine", kDouble, {}},
};

template <class Range>
const auto& named(const Range& range, std::string_view name, std::string_view kind) {
  const auto found = std::find_if(std::begin(range), std::end(range),
                                  [&](const auto& x) { return x.name == name; });
  if (found == std::end(range)) {
    throw std::runtime_error(fmt::format("there is no {} named {}", kind, name));
  }
  return *found;
}

}  // namespace

double Constant::weakened(int steps) const {
  switch (weakening) {
    case Weakening::subtract: return value - steps * step;
    case Weakening::add: return value + steps * step;
    case Weakening::halve: return std::ldexp(value, -steps);
    case Weakening::twice: return std::ldexp(value, steps);
  }
  return value;
}

int Constant::most_steps() const {
  if (weakening == Weakening::subtract) return static_cast<int>(std::ceil(value / step));
  // A double that is halved may become 0, which is no constant any more.
  if (weakening == Weakening::halve) return std::ilogb(value) + 1074;
  return 64;
}

std::span<const Constant> constants() { return kConstants; }
const Constant& constant(std::string_view name) { return named(kConstants, name, "constant"); }
std::span<const Proof> proofs() { return kProofs; }
const Proof& proof(std::string_view name) { return named(kProofs, name, "proof"); }

std::string text_of(const Constant& c, double value) {
  const bool is_in_u = c.weakening == Weakening::subtract && c.step == kU;
  if (is_in_u) return fmt::format("{:.6g} u", value / kU);
  int exponent;
  const bool is_power = std::abs(std::frexp(value, &exponent)) == 0.5;
  const bool is_scale = c.weakening == Weakening::halve || c.weakening == Weakening::twice;
  return is_power && is_scale ? fmt::format("2^{}", exponent - 1) : fmt::format("{:.6g}", value);
}

}  // namespace clipscope::proofs
