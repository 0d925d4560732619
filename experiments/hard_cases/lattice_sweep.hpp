// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sweeps of triangles through every clipper: an exhaustive lattice, or very many random triangles.
#pragma once

#include <cstdint>
#include <string>

#include "experiments/commands/selection.hpp"
#include "experiments/report/table.hpp"

namespace clipscope::experiments {

// All classes of a named lattice (see catalogue/lattice.hpp); with --quick every 16th chunk of them.
// Pre-condition: the name is one of lattice_names().
Table sweep_lattice(const std::string& name, const Selection& selection);

// The same in two steps: the table without rows, and its rows.
Table lattice_table(const std::string& name, const Selection& selection);
void add_lattice(const std::string& name, const Selection& selection, Table& table);

// Random triangles, half in view space and half in clip space: anywhere, game-like, near planes, with
// mixed signs of w, over wide exponents. The same for a seed, whatever the number of threads.
Table sweep_random(std::uint64_t triangles, const Selection& selection);

}  // namespace clipscope::experiments
