// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "experiments/audit/audit.hpp"
#include "experiments/audit/draw_text.hpp"
#include "experiments/audit/rows.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/audit/sample_calls.hpp"

namespace clipscope::experiments {
namespace {

constexpr AuditLimits kAsTheyAre{.shrinks = false};

Audit audit_of(RasterFault fault, const std::vector<DrawCall>& calls,
               const AuditLimits& limits = kAsTheyAre) {
  DriverPool drivers(own_driver(fault));
  return audit_driver("own", drivers, calls, limits);
}

const DriverFinding* find(const Audit& audit, ViolationKind kind, Quantity quantity) {
  const auto found = std::ranges::find_if(audit.findings, [&](const DriverFinding& f) {
    return f.key.kind == kind && f.key.quantity == quantity;
  });
  return found == audit.findings.end() ? nullptr : &*found;
}

// What an audit says, but for the time that it took.
std::string text_of(const Audit& audit) {
  std::string text = fmt::format("{} {} {}\n", audit.cases, audit.pixels, audit.undecided);
  for (const DriverFinding& f : audit.findings) {
    text += fmt::format("{} {} {} {} {}\n", finding_text(f.key), f.cases, f.pixels,
                        f.first.call.name, f.worst.call.name);
  }
  for (const QuantityRow& row : quantity_rows(audit)) {
    text += fmt::format("{} {} {}\n", row.values, row.max_ulp.value_or(-1), row.worst_case);
  }
  return text;
}

TEST_CASE("audit: a driver that is right comes out clean", "[audit]") {
  const Audit audit = audit_of(RasterFault::none, lattice_calls(200));
  for (const DriverFinding& finding : audit.findings) {
    CAPTURE(finding_text(finding.key), draw_text(finding.worst.call),
            pixel_text(finding.worst.violation));
    CHECK(false);
  }
  CHECK(audit.cases == 200);
  CHECK(audit.pixels > 0);
  CHECK(audit.violating == 0);
}

TEST_CASE("audit: many cases with the same fault are one finding in the same circumstances",
          "[audit]") {
  std::vector<DrawCall> calls;
  for (int i = 0; i < 20; ++i) calls.push_back(behind_call(fmt::format("behind {}", i)));
  calls.push_back(inside_call("inside"));
  const Audit audit = audit_of(RasterFault::noperspective_nan, calls);
  REQUIRE(audit.findings.size() == 1);
  const DriverFinding& finding = audit.findings.front();
  CHECK(finding_text(finding.key) == "noperspective not_finite: triangle, behind the eye");
  CHECK(finding.cases == 20);
  CHECK(finding.first.call.name == "behind 0");
  CHECK(audit.violating == 20);
  CHECK(audit.cases == 21);
}

TEST_CASE("audit: clip distances make a finding of their own only where it needs them", "[audit]") {
  DrawCall plain = behind_call("plain"), with_distances = behind_call("with distances");
  set_clip_distances(with_distances, 1);
  for (DrawVertex& vertex : with_distances.vertices) vertex.clip_distances[0] = 1;
  const Audit both = audit_of(RasterFault::noperspective_nan, {with_distances, plain});
  REQUIRE(both.findings.size() == 1);
  CHECK_FALSE(both.findings[0].key.circumstances.clip_distances);
  CHECK(both.findings[0].cases == 2);
  CHECK(both.findings[0].worst.call.name == "plain");
  const Audit alone = audit_of(RasterFault::noperspective_nan, {with_distances});
  REQUIRE(alone.findings.size() == 1);
  CHECK(alone.findings[0].key.circumstances.clip_distances);
}

TEST_CASE("audit: crash and time-out are findings, a refusal is none", "[audit]") {
  DriverPool drivers([] { return std::make_unique<FailingDriver>(); });
  const std::vector<DrawCall> calls = {inside_call("crashed"), inside_call("fine"),
                                       inside_call("timed_out"), inside_call("refused"),
                                       inside_call("unable")};
  const Audit audit = audit_driver("failing", drivers, calls, kAsTheyAre);
  CHECK(audit.cases == 3);
  CHECK(audit.refused == Counts{{"last words", 1}});
  CHECK(audit.unable == Counts{{"last words", 1}});
  REQUIRE(audit.findings.size() == 2);
  CHECK(audit.findings[0].key.kind == ViolationKind::crashed);
  CHECK(audit.findings[0].first.call.name == "crashed");
  CHECK(audit.findings[0].first.reason == "last words");
  CHECK(audit.findings[1].key.kind == ViolationKind::timed_out);
}

TEST_CASE("audit: what the driver can't is counted, not asked", "[audit]") {
  DrawCall call = inside_call("too large");
  call.width = OwnDriver().info().max_size + 1;
  const Audit audit = audit_of(RasterFault::none, {call});
  CHECK(audit.cases == 0);
  CHECK(audit.unable == Counts{{"has no target or viewport of that size", 1}});
}

TEST_CASE("audit: it finds the same whatever the number of threads", "[audit]") {
  const std::vector<DrawCall> calls = lattice_calls(150);
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return text_of(audit_of(RasterFault::near_unclipped, calls));
  };
  CHECK(with_threads(1) == with_threads(4));
}

TEST_CASE("audit: the smallest violates in the same way, in the same circumstances", "[audit]") {
  const Audit audit = audit_of(RasterFault::noperspective_nan, lattice_calls(150), {});
  const DriverFinding* const finding =
      find(audit, ViolationKind::not_finite, Quantity::noperspective);
  REQUIRE(finding != nullptr);
  REQUIRE(finding->smallest);
  CHECK(key_of(finding->smallest->call, finding->smallest->violation) == finding->key);
  CHECK(finding->smallest->call.vertices.size() <= finding->worst.call.vertices.size());
  CHECK(finding->smallest->call.quantities.count() <= finding->worst.call.quantities.count());
}

TEST_CASE("audit: its rows tell violations by class and errors by quantity", "[audit]") {
  const Audit audit = audit_of(RasterFault::noperspective_nan, {inside_call(""), behind_call("")});
  const std::vector<QuantityRow> rows = quantity_rows(audit);
  const QuantityRow* const smooth = find_row(rows, &QuantityRow::quantity, Quantity::smooth);
  const QuantityRow* const nan = find_row(rows, &QuantityRow::quantity, Quantity::noperspective);
  REQUIRE(smooth != nullptr);
  REQUIRE(nan != nullptr);
  CHECK(smooth->violations.empty());
  CHECK(smooth->values > 0);
  CHECK(smooth->median_ulp.value() <= smooth->p99_ulp.value());
  CHECK(smooth->p99_ulp.value() <= smooth->max_ulp.value());
  CHECK(nan->violations == "not_finite 1");
  const std::vector<FindingRow> findings = finding_rows(audit);
  REQUIRE(findings.size() == 1);
  CHECK(std::isnan(findings[0].returned.value()));
  CHECK(std::isfinite(findings[0].exact.value()));
}

}  // namespace
}  // namespace clipscope::experiments
