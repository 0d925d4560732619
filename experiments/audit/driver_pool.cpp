// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/audit/driver_pool.hpp"

#include <utility>

namespace clipscope::experiments {

DriverPool::DriverPool(DriverFactory factory) : factory_(std::move(factory)) {
  idle_.push_back(factory_());
  info_ = idle_.front()->info();
}

Drawn DriverPool::draw(const DrawCall& call) {
  std::unique_ptr<Driver> driver = taken();
  Drawn drawn = driver->draw(call);
  const std::scoped_lock lock(mutex_);
  idle_.push_back(std::move(driver));
  return drawn;
}

std::unique_ptr<Driver> DriverPool::taken() {
  {
    const std::scoped_lock lock(mutex_);
    if (!idle_.empty()) {
      std::unique_ptr<Driver> driver = std::move(idle_.back());
      idle_.pop_back();
      return driver;
    }
  }
  return factory_();
}

}  // namespace clipscope::experiments
