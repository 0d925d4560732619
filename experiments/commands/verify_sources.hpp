// SPDX-License-Identifier: GPL-3.0-or-later
//
// The triangles that `clipscope verify` asks a clipper about, source by source.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/commands/options.hpp"
#include "experiments/commands/verification.hpp"

namespace clipscope::experiments::commands {

struct VerifySources {
  std::optional<Space> space;         // these alone
  bool catalogue = false;             // the built-in hard cases and their families
  std::optional<std::string> corpus;  // the user's
  std::string hard_case;              // of these the one of that name, or of whose family it is
  std::size_t random = 0;             // so many random triangles
  std::optional<std::string> input;   // a file of triangles, "-": standard input
  int attributes = 0;                 // of these
  VolumeOptions volume;               // of these
};

// All that were chosen, examined. Where none was: scenes, for a guest and the catalogue.
// empty: an examination that has seen nothing. Errors: UsageError, InputError.
std::vector<SourceFindings> examine_sources(const VerifySources& sources, Selection selection,
                                            const Examination& empty);

}  // namespace clipscope::experiments::commands
