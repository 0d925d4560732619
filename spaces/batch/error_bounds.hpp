// SPDX-License-Identifier: MIT
//
// The constants of the error bounds of batch methods whose floats are certain, each in the lemma of
// the file that uses it; u = 2^-53. Scripts that prove them read them here: reference/proofs/.
#pragma once

#include "spaces/barycentric/exact_lines.hpp"

namespace clipscope::batch {

// One plane (barycentric-inl.hpp): of a mean on an edge, for the largest of its two values.
inline constexpr double kEdgeError = 16 * 0x1p-53;

// Several planes (corners-inl.hpp): of a determinant, a weighted sum and the sum of weights, for
// the product of the norms of the lines.
inline constexpr double kSideError = 12 * 0x1p-53;

// A mean that is the quotient of two such sums: so many times the bound of either, and the
// roundings of the quotient.
inline constexpr double kMeanError = 2 * (1 + 0x1p-17);
inline constexpr double kMeanRoundings = 8 * 0x1p-53;

// The full contract (full_rounded-inl.hpp). A vertex of the triangle, for m / w.
inline constexpr double kOwnVertexError = 16 * 0x1p-53;

// The numerator and the denominator of a point on an edge, and of one on two planes; the sums of
// weights there. For the sums of magnitudes.
inline constexpr double kEdgeNumeratorError = 12 * 0x1p-53;
inline constexpr double kEdgeDenominatorError = 4 * 0x1p-53;
inline constexpr double kMeetingNumeratorError = 16 * 0x1p-53;
inline constexpr double kMeetingDenominatorError = 8 * 0x1p-53;
inline constexpr double kMeetingWeightError = 10 * 0x1p-53;

// Their quotient: so many times the relative error of the denominator, and its roundings.
inline constexpr double kOfDenominator = 2;
inline constexpr double kFullQuotientRoundings = 8 * 0x1p-53;

// A denominator of two planes below this may have lost too much to underflow.
inline constexpr double kSmallestDenominator = 0x1p-700;

}  // namespace clipscope::batch
