// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a hunt brings home: shrunk, as cases of a file, as commands.
#pragma once

#include <string>
#include <string_view>

#include "experiments/hunt/hunt.hpp"

namespace clipscope::experiments::hunt {

// The smallest found on which the measure is at least half of what it is on the trophy (of `crash`:
// there is no answer either), by the shrinker (shrink/shrink.hpp).
// in_domain: as in the hunt.
Trophy shrunk(const Contestant& contestant, Measure measure, const Trophy& trophy,
              bool in_domain = false);

// The command that shows it: `explain`, of a pair `clip`.
std::string replay_command(const Contestant& contestant, const std::vector<HardCase>& cases);

// How a case is called in a file: "homogeneous_sutherland_hodgman_float_px".
std::string case_name(const Contestant& contestant, Measure measure);

// The trophy with the words of a file of cases. hunt: the command that found it.
Trophy described(const Contestant& contestant, Measure measure, Trophy trophy,
                 const std::string& hunt);

// As a file of cases has it.
std::string cases_text(const Trophy& trophy);

}  // namespace clipscope::experiments::hunt
