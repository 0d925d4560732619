// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/audit/draw_cases.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/audit/draw_text.hpp"

namespace clipscope::experiments {
namespace {

HardCase case_of(const DrawCall& call, const std::vector<std::uint32_t>& primitive) {
  HardCase c;
  c.primitive = primitive_of(call.topology);
  c.space = Space::clip;
  c.volume = call.volume;
  c.frustum.depth = call.volume.depth;
  for (const std::uint32_t number : primitive) {
    const DrawVertex& vertex = call.vertices[number];
    reference::InputVertex& v = c.vertices.emplace_back();
    std::ranges::copy(vertex.position, v.position.begin());
    std::copy_n(vertex.clip_distances.begin(), call.volume.clip_distances, v.attributes.begin());
  }
  fill_attributes(c, call.volume.clip_distances);
  return c;
}

}  // namespace

std::vector<HardCase> cases_of(const Audit& audit, const DriverFinding& finding) {
  const DrawExample& example = finding.example();
  auto primitives = primitives_of(example.call);
  const auto violated =
      primitives.begin() + static_cast<std::ptrdiff_t>(example.violation.primitive);
  std::rotate(primitives.begin(), violated, violated + 1);
  if (primitives.size() > kMostCases) primitives.resize(1);
  std::string name = fmt::format("{}_{}", audit.driver, file_stem(finding_text(finding.key)));
  std::ranges::replace(name, '/', '_');
  std::vector<HardCase> cases;
  for (const std::vector<std::uint32_t>& primitive : primitives) {
    HardCase& c = cases.emplace_back(case_of(example.call, primitive));
    c.name = cases.size() == 1 ? name : fmt::format("{}_{}", name, cases.size());
    c.source = fmt::format("clipscope audit of {}", driver_text(audit.info));
    c.why = fmt::format("{}; {}", finding_text(finding.key), draw_text(example.call));
  }
  return cases;
}

}  // namespace clipscope::experiments
