// SPDX-License-Identifier: GPL-3.0-or-later
//
// One driver for many threads: each call is drawn by one that nobody else uses meanwhile, and there
// are as many, each in a process of its own, as there were calls at the same time.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "experiments/drawcalls/driver.hpp"

namespace clipscope::experiments {

// Makes another one of the same kind. Errors: GuestError if there is none.
using DriverFactory = std::function<std::unique_ptr<Driver>()>;

class DriverPool {
 public:
  // Makes the first. Errors: those of the factory.
  explicit DriverPool(DriverFactory factory);

  const DriverInfo& info() const { return info_; }
  // For any thread. Errors: those of the factory.
  Drawn draw(const DrawCall& call);

 private:
  std::unique_ptr<Driver> taken();

  DriverFactory factory_;
  DriverInfo info_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Driver>> idle_;
};

}  // namespace clipscope::experiments
