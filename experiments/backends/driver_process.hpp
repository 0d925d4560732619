// SPDX-License-Identifier: GPL-3.0-or-later
//
// DriverProcess: a driver that lives in a process of its own, so that its crash or its endless loop
// is an outcome of the draw call, not the end of the program.
#pragma once

#include <memory>

#include "experiments/backends/known_drivers.hpp"
#include "experiments/drawcalls/driver.hpp"

namespace clipscope::experiments {

class HostProcess;

// One thread at a time; several threads have one each. Its host ends with it, and with the program.
class DriverProcess : public Driver {
 public:
  // seconds_per_draw: how long a draw call may take before it counts as timed out.
  // Errors: GuestError if there is no such driver: its host is not built or does not start, it has
  // no context, or another driver answers in its place.
  DriverProcess(const KnownDriver& driver, double seconds_per_draw);
  ~DriverProcess() override;

  const DriverInfo& info() const override { return info_; }
  // A host that has ended is started again by the next call.
  Drawn draw(const DrawCall& call) override;

 private:
  void start();

  KnownDriver driver_;
  double seconds_per_draw_;
  std::unique_ptr<HostProcess> host_;
  DriverInfo info_ = {};
};

}  // namespace clipscope::experiments
