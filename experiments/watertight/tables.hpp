// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tables of shared edges: empty ones with their columns and notes, and what fills them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/report/plot.hpp"
#include "experiments/report/row_view.hpp"
#include "experiments/report/table.hpp"
#include "experiments/store/cell_record.hpp"
#include "experiments/watertight/measure.hpp"

namespace clipscope::experiments {

using Contestants = std::span<const AnyContestant>;
using Tallies = std::span<const WatertightTally>;

// By scene, clipper and scalar.
Table watertight_table();
void add_scene(const std::string& scene, Contestants contestants, Tallies tallies, Table& table);

// By the plane that cuts the edge.
Table planes_table();
void add_planes(const std::string& scene, Contestants contestants, Tallies tallies, Table& table);

// The widest crack of each scene, clipper and scalar that has one, and how to see it.
Table worst_table();
void add_worst(const Scene& scene, Contestants contestants, Tallies tallies, Table& table,
               CellRecord& record);

// Over all scenes of the first table: meshes, and grazing edges apart from them.
Table summary_table(const Table& by_scene);

// The widest crack by clipper in float and double.
Plot crack_plot(const Table& summary);

// The row of the worst table with the widest crack, in a mesh if there is any; none if there is no crack.
std::optional<RowView> widest_crack(const Table& worst);

// The answer to the experiment's question.
std::string watertight_finding(const Table& summary);

}  // namespace clipscope::experiments
