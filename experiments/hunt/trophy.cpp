// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hunt/trophy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/hunt/evaluation.hpp"
#include "experiments/selection/replay_text.hpp"
#include "experiments/shrink/case_groups.hpp"
#include "experiments/shrink/shrink.hpp"
#include "experiments/survey/verdicts.hpp"

namespace clipscope::experiments::hunt {
namespace {

// 2 at half of the worst, so that the shrinker keeps that much.
double excess_over(double worst, double value) {
  if (std::isinf(worst)) return std::isinf(value) ? value : 0;
  return std::isnan(value) ? 0 : 4 * value / worst;
}

// A pair as a case of four vertices: those of the triangle, then the third of its neighbour.
HardCase carrier_of(const std::vector<HardCase>& pair) {
  HardCase carrier = pair.front();
  carrier.vertices.push_back(pair.back().vertices.back());
  carrier.attribute_count = 0;
  return carrier;
}

Prey prey_of_carrier(const HardCase& carrier) {
  Prey prey;
  for (std::size_t i = 0; i < Prey::kVertices; ++i) {
    std::ranges::transform(carrier.vertices[i].position, prey.position[i].begin(),
                           [](double x) { return static_cast<float>(x); });
  }
  set_attributes(prey, 0);
  return prey;
}

std::vector<HardCase> pair_of(const Contestant& contestant, const HardCase& carrier) {
  const Prey prey = prey_of_carrier(carrier);
  const int attributes = Evaluator(contestant, Measure::crack).attributes();
  return {case_of(setting_of(carrier), prey, attributes),
          neighbour_of(setting_of(carrier), prey, attributes)};
}

// Carriers with the same setting are asked in one batch.
Failing failing_by_crack(const Contestant& contestant, double worst) {
  return [&contestant, worst](std::span<const HardCase> carriers) {
    const Evaluator evaluator(contestant, Measure::crack);
    std::vector<double> excess(carriers.size(), 0.0);
    for (const CaseGroup& group : grouped(carriers)) {
      const Setting setting = setting_of(carriers[group.places.front()]);
      if (group.batch.matrix || !contestant.takes(group.batch)) continue;
      std::vector<Prey> litter;
      for (const std::size_t p : group.places) litter.push_back(prey_of_carrier(carriers[p]));
      const std::vector<double> values = evaluator.exact_values(setting, litter);
      for (std::size_t i = 0; i < values.size(); ++i) {
        excess[group.places[i]] = excess_over(worst, values[i]);
      }
    }
    return excess;
  };
}

Failing failing_by_measure(const Contestant& contestant, Measure measure, double worst) {
  return failing_by(contestant, [measure, worst](const HardCase& c, const PolygonView& polygon,
                                                 const Comparison& comparison) {
    Errors errors{comparison, 0, largest_attribute(c)};
    // The comparison does not have it, and costs less than the exact answer.
    if (measure == Measure::depth) errors = errors_of(c, polygon, truth_polygon(c));
    return excess_over(worst, measure == Measure::containment ? overshoot(c.volume, polygon)
                                                              : value_of(measure, errors));
  });
}

}  // namespace

Trophy shrunk(const Contestant& contestant, Measure measure, const Trophy& trophy, bool in_domain) {
  if (measure == Measure::crash) {
    return {trophy.value, {shrink(contestant, trophy.cases.front(), Question::total)}};
  }
  const bool is_pair = measure == Measure::crack;
  Failing failing = is_pair ? failing_by_crack(contestant, trophy.value)
                            : failing_by_measure(contestant, measure, trophy.value);
  if (in_domain && !is_pair) failing = failing_in_domain(contestant, std::move(failing));
  const Shrunk small = shrink(is_pair ? carrier_of(trophy.cases) : trophy.cases.front(), failing);
  return {std::isinf(trophy.value) ? trophy.value : small.excess * trophy.value / 4,
          is_pair ? pair_of(contestant, small.hard_case) : std::vector{small.hard_case}};
}

std::string replay_command(const Contestant& contestant, const std::vector<HardCase>& cases) {
  std::string options, lines;
  for (const CaseGroup& group : grouped(cases)) {
    for (std::size_t i = 0; i < group.places.size(); ++i) {
      const std::string text = replay_text(group.batch, i);
      const std::size_t colon = text.find(" : ");
      options = text.substr(0, colon);
      lines += (lines.empty() ? "" : "\\n") + text.substr(colon + 3);
    }
  }
  const bool is_pair = cases.size() > 1;
  return fmt::format("{} '{}{}' | clipscope {} {} {}", is_pair ? "printf" : "echo", lines,
                     is_pair ? "\\n" : "", is_pair ? "clip" : "explain", options,
                     options_of(contestant));
}

std::string case_name(const Contestant& contestant, Measure measure) {
  std::string name =
      fmt::format("{}_{}_{}", contestant.clipper, contestant.scalar(), name_of(measure));
  std::ranges::replace(name, '/', '_');
  return name;
}

Trophy described(const Contestant& contestant, Measure measure, Trophy trophy,
                 const std::string& hunt) {
  for (HardCase& c : trophy.cases) {
    c.name = case_name(contestant, measure);
    if (&c != &trophy.cases.front()) c.name += "_neighbour";
    c.source = hunt;
    c.why = fmt::format("{} {:.6g} of {}", name_of(measure), trophy.value,
                        experiments::name_of(contestant));
  }
  return trophy;
}

std::string cases_text(const Trophy& trophy) {
  std::string text;
  for (const HardCase& c : trophy.cases) text += (text.empty() ? "" : "\n") + case_text(c);
  return text;
}

}  // namespace clipscope::experiments::hunt
