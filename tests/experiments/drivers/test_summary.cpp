// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/drivers/rows.hpp"
#include "experiments/table/prose.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::drivers {
namespace {

DriverRow driver(const char* name, std::size_t findings) {
  DriverRow row;
  row.driver = name;
  row.findings = findings;
  return row;
}

DriverFindingRow violation(const char* driver, ViolationKind kind) {
  DriverFindingRow row;
  row.driver = driver;
  row.row.kind = kind;
  return row;
}

std::string checked(const std::string& text) {
  CHECK(faults_of_prose(text) == std::vector<std::string>{});
  return text;
}

TEST_CASE("drivers: without one the finding says so", "[drivers]") {
  CHECK(checked(finding({}, {})) == "No driver was there to be asked.");
}

TEST_CASE("drivers: the finding turns round when the last violation goes", "[drivers]") {
  CHECK(checked(finding({driver("a", 0), driver("b", 0)}, {})) ==
        "No driver violates its specification on what was drawn.");
  CHECK(checked(finding({driver("a", 0), driver("b", 1)},
                        {violation("b", ViolationKind::shared_edge)})) ==
        "Of two drivers one violates its specification somewhere.");
  CHECK(checked(finding({driver("b", 1)}, {violation("b", ViolationKind::facing)})) ==
        "The only driver here, b, violates its specification.");
}

TEST_CASE("drivers: the finding names the gravest ways and who is guilty of them", "[drivers]") {
  const std::vector<DriverRow> all = {driver("a", 2), driver("b", 2), driver("c", 1)};
  CHECK(
      checked(finding(
          all,
          {violation("a", ViolationKind::missing), violation("b", ViolationKind::primitive_lost),
           violation("a", ViolationKind::not_finite), violation("b", ViolationKind::not_finite),
           violation("c", ViolationKind::not_finite)})) ==
      "All drivers violate their specification somewhere. Whole primitives are lost by b; values that are no numbers come from a, b and c.");
}

TEST_CASE("drivers: the gravest is what loses most, not what comes first", "[drivers]") {
  CHECK(gravest({}) == nullptr);
  const std::vector<DriverFindingRow> findings = {violation("a", ViolationKind::facing),
                                                  violation("a", ViolationKind::not_finite),
                                                  violation("b", ViolationKind::primitive_lost)};
  CHECK(gravest(findings) == &findings[2]);
  const std::vector<DriverFindingRow> mild = {violation("a", ViolationKind::facing)};
  CHECK(gravest(mild) == &mild[0]);
}

TEST_CASE("drivers: rows are read back from their table", "[drivers]") {
  TableOf<DriverFindingRow> table;
  DriverFindingRow row = violation("a", ViolationKind::missing);
  row.row.exact = 1;
  row.row.example = "triangles";
  table.add(row);
  const DriverFindingRow back = table.rows().front();
  CHECK(back.driver == "a");
  CHECK(back.row.kind == ViolationKind::missing);
  CHECK(back.row.exact == 1.0);
  CHECK_FALSE(back.row.returned);
  CHECK(back.row.example == "triangles");
}

}  // namespace
}  // namespace clipscope::experiments::drivers
