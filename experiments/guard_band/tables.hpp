// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tables, plots and the finding of the guard-band experiment. What is said at the end is computed from
// rows of the tables alone.
#pragma once

#include <string>

#include "experiments/guard_band/band_picture.hpp"
#include "experiments/guard_band/band_time.hpp"
#include "experiments/guard_band/band_work.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/report/table.hpp"
#include "experiments/store/cell_record.hpp"

namespace clipscope::experiments {

Table band_work_table();
// method: "full", or "band" of that half width.
void add_band_work_row(Table& table, CellRecord& record, const std::string& scene,
                       const std::string& method, double band, const BandTally& tally,
                       const BandTally& full, const BandTime& time);
// The clipper homogeneous/guard_band, whose polygons are those of full clipping.
void add_band_scissored_row(Table& table, CellRecord& record, const std::string& scene,
                            const BandTally& full, const BandTime& time);

Table band_fixed_table();
void add_band_fixed_row(Table& table, const std::string& scene, const FixedPoint& format,
                        const BandTally& tally);

Table band_points_table();
void add_band_points_row(Table& table, const std::string& scene, const PointTally& tally);

Table band_pictures_table();
void add_band_picture_row(Table& table, const std::string& scene, const BandDrawing& drawing,
                          const BandPicture& picture);

// The share of triangles that must be cut at a side, over the band, by scene.
Plot band_cut_plot(const Table& work);
// Full clipping's time over the band's, over the band, by scene, with intervals.
Plot band_time_plot(const Table& work);

std::string guard_band_finding(const Table& work, const Table& pictures);

}  // namespace clipscope::experiments
