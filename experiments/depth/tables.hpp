// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tables, plots and the finding of the depth experiment. What is said at the end is computed from
// rows of the tables alone.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "experiments/commands/selection.hpp"
#include "experiments/depth/depth_precision.hpp"
#include "experiments/depth/pseudo_depth.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/report/table.hpp"
#include "experiments/store/cell_record.hpp"

namespace clipscope::experiments {

// What --scalar asks for. Errors: UsageError if neither float nor double is among the scalars.
std::vector<DepthArithmetic> depth_arithmetics(const Selection& selection);

struct DepthMeasures {
  std::array<std::optional<double>, 3> resolution_m;  // near, half way in logarithms, far
  std::int64_t codes = 0;                             // numbers of the format from near to far
  std::size_t distinct = 0;
  NeighbourOrder order;
  LargestError error;
};
DepthMeasures measure_depth(const DepthBuffer& buffer, std::span<const float> distances,
                            std::size_t error_stride);

Table depth_precision_table();
void add_depth_precision_row(Table& table, CellRecord& record, const DepthConvention& convention,
                             DepthFormat format, DepthArithmetic arithmetic, double ratio,
                             const DepthMeasures& measures);

Table depth_curve_table(double ratio);
Table depth_forms_table();
void add_form_rows(Table& table, double ratio, std::span<const DepthCheck> checks);
Table depth_eye_plane_table();
void add_eye_plane_row(Table& table, const EyePlanePoint& point);

// Resolution over distance, from rows of the curve table.
Plot depth_curve_plot(const Table& curve);
// The share of neighbours that a float pipeline does not put in order, over far / near.
Plot depth_lost_order_plot(const Table& precision);

std::string depth_finding(const Table& precision, const Table& forms);

}  // namespace clipscope::experiments
