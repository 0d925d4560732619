// SPDX-License-Identifier: GPL-3.0-or-later
//
// An audit: what a driver makes of many draw calls, each pixel against the exact one.
//
// Violations of one kind in one quantity and in the same circumstances are one finding, however
// many cases show it; those with clip distances or depth clamp count to the finding without them,
// if there is one. It is kept by its first case, its worst, and the smallest found that still
// violates in the same way at least twice as much as is allowed.
// Deterministic as far as the driver is, whatever the number of threads, but for a shrinking that
// runs out of time.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/audit/outcome.hpp"

namespace clipscope::experiments {

// A draw call and how it was violated.
struct DrawExample {
  DrawCall call;
  Violation violation;
  std::string reason = {};  // of a crash or time-out: the driver's last words
};

struct DriverFinding {
  FindingKey key = {};
  Clause clause = {};
  std::size_t cases = 0;               // draw calls with such a violation
  std::uint64_t pixels = 0;            // of all of them
  DrawExample first = {}, worst = {};  // the first of the worst
  std::optional<DrawExample> smallest = {};

  // The one to show.
  const DrawExample& example() const { return smallest ? *smallest : worst; }
};

struct QuantityErrors {
  std::size_t cases = 0;        // in which it was judged
  UlpErrors errors = {};        // of legal values
  std::string worst_case = {};  // the name of the one with the greatest error
};

using Counts = std::map<std::string, std::size_t>;  // of draw calls, by reason

struct Audit {
  std::string driver = {};  // its name
  DriverInfo info = {};
  std::size_t cases = 0;      // draw calls drawn and judged
  std::size_t violating = 0;  // of these
  Counts apart = {};          // of these, by why they accuse nobody
  Counts refused = {};        // by the error of the API
  Counts unable = {};         // by what the driver lacks
  // Judged; of these within the margin of an edge; covered otherwise than the sub-pixel bits say,
  // but legally.
  std::uint64_t pixels = 0, undecided = 0, inexact = 0;
  std::vector<DriverFinding> findings = {};             // in the order in which they were met
  std::array<QuantityErrors, kQuantities> errors = {};  // by Quantity; without the cases apart
};

struct AuditLimits {
  bool shrinks = true;
  double seconds_each = 10;  // for shrinking one finding
  // Draw calls of a hunt for worse ones, see hunting.hpp; what it finds is drawn like the others.
  std::size_t hunted = 0;
  std::uint64_t seed = 1;  // of the hunt
};

// name: of the driver. The calls are drawn in their order; what the driver can't is counted.
// Errors: those of the pool.
Audit audit_driver(const std::string& name, DriverPool& drivers, std::span<const DrawCall> calls,
                   const AuditLimits& limits = {});

// Whether the call is still violated as the finding says, at least twice as much as is allowed or,
// if the finding is of less, as much as that; how, if it is. Errors: those of the pool.
std::optional<DrawExample> example_of(DriverPool& drivers, const DrawCall& call,
                                      const DriverFinding& finding);

}  // namespace clipscope::experiments
