// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>

#include "experiments/audit/hunting.hpp"
#include "experiments/pixels/own_driver.hpp"
#include "experiments/workloads/workload.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/workloads/drivers.hpp"

namespace clipscope::experiments {
namespace {

DriverPool own_drivers(RasterFault fault) {
  return DriverPool([fault] { return std::make_unique<OwnDriver>(fault); });
}

std::vector<DrawCall> few_calls(const DriverInfo& info) {
  return draws({.lattice = 200, .random = 0, .catalogue = false, .scenes = false}, info);
}

double worst_size(const Audit& audit, ViolationKind kind) {
  double worst = 0;
  for (const DriverFinding& finding : audit.findings) {
    if (finding.key.kind == kind) worst = std::max(worst, finding.worst.violation.size);
  }
  return worst;
}

}  // namespace

TEST_CASE("hunting: the audit of a driver with a fault finds it worse than the lattice has it") {
  DriverPool drivers = own_drivers(RasterFault::extrapolated);
  const std::vector<DrawCall> calls = few_calls(drivers.info());
  const Audit before = audit_driver("own", drivers, calls, {.shrinks = false});
  const Audit after = audit_driver("own", drivers, calls, {.shrinks = false, .hunted = 800});
  const ViolationKind kind = ViolationKind::outside_hull;
  CHECK(worst_size(after, kind) > 2 * worst_size(before, kind));
  CHECK(after.findings.size() >= before.findings.size());
  CHECK(after.cases > before.cases);
}

TEST_CASE("hunting: what it found has names of its own, the same each time") {
  DriverPool drivers = own_drivers(RasterFault::extrapolated);
  const std::vector<DrawCall> calls = few_calls(drivers.info());
  const Audit audit = audit_driver("own", drivers, calls, {.shrinks = false});
  const std::vector<DrawCall> found = hunted_calls(drivers, calls, audit, {.evaluations = 400});
  CHECK(found == hunted_calls(drivers, calls, audit, {.evaluations = 400}));
  REQUIRE_FALSE(found.empty());
  std::set<std::string> names;
  for (const DrawCall& call : found) names.insert(call.name);
  CHECK(names.size() == found.size());
  CHECK(found.front().name.ends_with("hunted 1)"));
}

}  // namespace clipscope::experiments
