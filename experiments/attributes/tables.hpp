// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tables of the experiment `attributes`, its plots and its finding; the latter from rows alone.
#pragma once

#include <string>
#include <vector>

#include "experiments/attributes/attribute_errors.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/report/table.hpp"

namespace clipscope::experiments {

struct AttributeTables {
  Table errors, flat;

  AttributeTables();
};

// One row of `errors` for each treatment, one of `flat`.
void add_tally(AttributeTables& tables, int planes, const AnyContestant& contestant,
               const AttributeTally& tally);

// The median error of smooth attributes at vertices, and the largest one inside, over the planes crossed.
Plot error_over_planes(const AttributeTables& tables);
Plot error_inside(const AttributeTables& tables);

// The largest error of each treatment over the planes crossed, in float: the right ones and the wrong ones.
Plot error_of_treatments(const AttributeTables& tables);

std::string attributes_finding(const AttributeTables& tables);

}  // namespace clipscope::experiments
