// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope_draw_webgl OPTION...: the process that WebGL 2 of a browser is drawn from. The options
// go to Chromium; without any it draws with what it finds, a graphics card if there is one.
#include <memory>
#include <string>

#include "experiments/backends/webgl/webgl_driver.hpp"
#include "experiments/drawcalls/wire.hpp"

int main(int count, char** words) {
  using namespace clipscope::experiments;
  std::unique_ptr<WebglDriver> driver;
  std::string reason;
  try {
    driver = std::make_unique<WebglDriver>(std::vector<std::string>(words + 1, words + count));
  } catch (const NoBrowser& none) {
    reason = none.what();
  }
  return serve(driver.get(), reason);
}
