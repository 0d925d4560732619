// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the driver of the current context says that it is and can.
#pragma once

#include "experiments/drawcalls/driver.hpp"

namespace clipscope::experiments {

DriverInfo describe_driver();

}  // namespace clipscope::experiments
