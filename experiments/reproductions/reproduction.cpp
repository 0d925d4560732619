// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/reproductions/reproduction.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/reproductions/formats.hpp"

namespace clipscope::experiments {
namespace {

std::string came_text(const Check& check, const Violation& violation) {
  switch (check.kind) {
    case Check::Kind::ends:
      return violation.kind == ViolationKind::crashed ? "it crashed" : "it never ended";
    case Check::Kind::fragments:
      return fmt::format("{} instead of {}", fragments_text(check.came),
                         fragments_text(check.fragments));
    default:
      return fmt::format("{} instead of {}", violation.worst.returned, violation.worst.exact);
  }
}

std::vector<std::string> about(const DrawCall& call, const Violation& violation,
                               const DriverInfo& info, const Check& check) {
  const Clause clause = clause_of(info.api, call.topology, violation.kind, violation.quantity);
  return {fmt::format("{}: {}", call.name,
                      names_of(ViolationKind{})[static_cast<std::size_t>(violation.kind)]),
          fmt::format("{}, section {}: {}", clause.document, clause.section, clause.meaning),
          fmt::format("On {}, {} ({}): {}.", info.renderer, info.version, info.api_version,
                      came_text(check, violation))};
}

}  // namespace

std::string comment(const Case& it, std::string_view mark) {
  std::string text;
  for (const std::string& line : it.about) text += fmt::format("{} {}\n", mark, line);
  return text + fmt::format("{} Right, {}: {}.\n", mark, subject_of(it.check), demand_of(it.check));
}

std::vector<Reproduction> reproductions(const DrawCall& call, const Violation& violation,
                                        const DriverInfo& info) {
  const Check check = check_of(call, violation);
  const Case it{call, check, about(call, violation, info, check)};
  const std::string_view quantity = names_of(Quantity{})[bit(violation.quantity)];
  const std::string_view kind = names_of(ViolationKind{})[static_cast<std::size_t>(violation.kind)];
  const std::string name =
      kind.starts_with(quantity) ? std::string(kind) : fmt::format("{}_{}", quantity, kind);
  // By API, in the order of GraphicsApi; the driver's own comes first.
  std::vector<Reproduction> all = {{name + ".shader_test", piglit_test(it)},
                                   {name + ".amber", amber_script(it)},
                                   {name + ".html", web_page(it)}};
  const auto own = all.begin() + static_cast<std::ptrdiff_t>(info.api);
  std::rotate(all.begin(), own, own + 1);
  std::erase_if(all, [](const Reproduction& one) { return one.text.empty(); });
  return all;
}

}  // namespace clipscope::experiments
