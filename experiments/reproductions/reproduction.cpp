// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/reproductions/reproduction.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/reproductions/formats.hpp"

namespace clipscope::experiments {
namespace {

std::string returned_text(const Check& check, const Violation& violation) {
  switch (check.kind) {
    case Check::Kind::ends:
      return violation.kind == ViolationKind::crashed ? "the driver crashes" : "it never ends";
    case Check::Kind::fragments:
      return fmt::format("there {} {}", check.came == 1 ? "is" : "are",
                         check.came == 0 ? "none" : std::to_string(check.came));
    default:
      return fmt::format("it is {}, and exactly {}", violation.worst.returned,
                         violation.worst.exact);
  }
}

std::vector<std::string> about(const DrawCall& call, const Violation& violation,
                               const DriverInfo& info, const Check& check) {
  const Clause clause = clause_of(info.api, call.topology, violation.kind, violation.quantity);
  return {
      fmt::format("{}: {}", call.name,
                  names_of(ViolationKind{})[static_cast<std::size_t>(violation.kind)]),
      fmt::format("Right, {}: {}.", subject_of(check), demand_of(check)),
      fmt::format("On {} {}, {}: {}.", names_of(GraphicsApi{})[static_cast<std::size_t>(info.api)],
                  info.renderer, info.version, returned_text(check, violation)),
      fmt::format("{}, section {}: {}", clause.document, clause.section, clause.meaning)};
}

}  // namespace

std::vector<Reproduction> reproductions(const DrawCall& call, const Violation& violation,
                                        const DriverInfo& info) {
  const Check check = check_of(call, violation);
  const Case it{call, check, about(call, violation, info, check)};
  const std::string name =
      fmt::format("{}_{}", names_of(Quantity{})[bit(violation.quantity)],
                  names_of(ViolationKind{})[static_cast<std::size_t>(violation.kind)]);
  std::vector<Reproduction> all = {{name + ".shader_test", piglit_test(it)},
                                   {name + ".amber", amber_script(it)}};
  std::erase_if(all, [](const Reproduction& one) { return one.text.empty(); });
  return all;
}

}  // namespace clipscope::experiments
