// SPDX-License-Identifier: GPL-3.0-or-later
//
// WebglDriver: WebGL 2 of a browser as a driver.
//
// A browser that ends, or whose context is lost, is an outcome of the draw call; the next call gets
// a fresh one.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "experiments/backends/webgl/browser.hpp"
#include "experiments/drawcalls/driver.hpp"

namespace clipscope::experiments {

class WebglDriver : public Driver {
 public:
  // options: of Chromium. Errors: NoBrowser, also where it has no WebGL 2 with targets of floats.
  explicit WebglDriver(std::vector<std::string> options);

  const DriverInfo& info() const override { return info_; }
  Drawn draw(const DrawCall& call) override;

 private:
  void start();

  std::vector<std::string> options_;
  std::unique_ptr<Browser> browser_;
  DriverInfo info_ = {};
  std::size_t most_attachments_ = 4;
};

}  // namespace clipscope::experiments
