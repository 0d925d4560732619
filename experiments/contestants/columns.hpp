// SPDX-License-Identifier: GPL-3.0-or-later
//
// The columns that name a contestant, in every table that has one.
#pragma once

#include <string>
#include <tuple>

#include "experiments/table/row.hpp"

namespace clipscope::experiments {

template <class Row>
constexpr auto contestant_columns(std::string Row::*clipper, std::string Row::*scalar) {
  return std::tuple(column("clipper", clipper), column("scalar", scalar));
}

}  // namespace clipscope::experiments
