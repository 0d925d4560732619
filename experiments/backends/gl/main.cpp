// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope_draw_gl: the process that an OpenGL driver lives in. The program starts it in an
// environment that leads to one driver, and talks with it as wire.hpp says.
#include <memory>
#include <stdexcept>
#include <string>

#include "experiments/backends/gl/gl_driver.hpp"
#include "experiments/drawcalls/wire.hpp"

int main() {
  using namespace clipscope::experiments;
  std::unique_ptr<GlDriver> driver;
  std::string reason;
  try {
    driver = std::make_unique<GlDriver>();
  } catch (const std::runtime_error& none) {
    reason = none.what();
  }
  return serve(driver.get(), reason);
}
