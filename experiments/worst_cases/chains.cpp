// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/worst_cases/chains.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/hunt/evaluation.hpp"
#include "experiments/hunt/hunt.hpp"

namespace clipscope::experiments::worst_cases {

std::string name_of(const ChainKind& kind) {
  std::string name = fmt::format("{}_{}", kind.contestant->clipper, name_of(kind.measure));
  std::ranges::replace(name, '/', '_');
  return kind.inputs == Inputs::any ? name : name + "_in_domain";
}

std::string_view unit_of(hunt::Measure measure) {
  switch (measure) {
    case hunt::Measure::px: return "px";
    case hunt::Measure::ulp: return "ulp";
    case hunt::Measure::depth: return "ulp of 1 in z";
    default: return "of the largest attribute";
  }
}

Contestants chain_contestants(const Selection& selection, std::string_view scalar) {
  Contestants chains = select_contestants(selection, {std::string(scalar)});
  std::erase_if(chains, [](const Contestant* c) {
    return c->is_guest || c->clipper.starts_with("barycentric/") ||
           c->clipper.starts_with("whole/");
  });
  return chains;
}

std::vector<ChainKind> chain_kinds(const Contestants& contestants) {
  std::vector<ChainKind> kinds;
  for (const Contestant* contestant : contestants) {
    for (const Inputs inputs : {Inputs::any, Inputs::in_domain}) {
      for (const hunt::Measure measure : kChainMeasures) {
        kinds.push_back({contestant, inputs, measure});
      }
    }
  }
  return kinds;
}

double figure_of(const ChainKind& kind, const HardCase& hard_case) {
  const hunt::Prey prey = hunt::prey_of(hard_case);
  return hunt::Evaluator(*kind.contestant, kind.measure, kind.inputs == Inputs::in_domain)
      .exact_values(hunt::setting_of(hard_case), {&prey, 1})
      .front();
}

ChainResult searched(const ChainKind& kind, const Record* kept, const Search& search) {
  hunt::HuntOptions options{.measure = kind.measure,
                            .seed = search.seed,
                            .evaluations = search.sample,
                            .plain = true,
                            .in_domain = kind.inputs == Inputs::in_domain};
  double again = 0;
  if (kept != nullptr) {
    options.begin_with = kept->hard_case;
    again = figure_of(kind, kept->hard_case);
  }
  const hunt::Hunted hunted = hunt::hunt(*kind.contestant, options);
  ChainResult result;
  if (!hunted.worst) return result;
  const auto& [figure, cases] = *hunted.worst;
  result.worst = Record{figure, cases.front()};
  result.worst->hard_case.name = name_of(kind);
  result.worst->hard_case.source = search.text("hunt");
  if (kept == nullptr) {
    result.standing = Standing::added;
  } else if (figure > again) {
    result.standing = Standing::improved;
  } else {
    result.worst->hard_case = kept->hard_case;
    result.standing = again == kept->figure ? Standing::kept : Standing::moved;
  }
  return result;
}

}  // namespace clipscope::experiments::worst_cases
