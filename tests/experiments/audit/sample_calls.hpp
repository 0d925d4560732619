// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draw calls for tests of audits, and a driver that fails where it is told to.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiments/audit/driver_pool.hpp"
#include "experiments/pixels/own_driver.hpp"
#include "experiments/workloads/lattice_draws.hpp"
#include "experiments/workloads/plain_call.hpp"

namespace clipscope::experiments {

inline DrawCall triangle_call(std::string name,
                              const std::array<std::array<float, 4>, 3>& positions,
                              const DriverInfo& info = OwnDriver().info()) {
  return plain_call(std::move(name), Topology::triangles, positions, info);
}
// All in the volume; one that crosses the near plane with its far end behind the eye.
inline DrawCall inside_call(const std::string& name) {
  return triangle_call(name, {{{-0.5f, -0.5f, 0, 1}, {0.5f, -0.5f, 0, 1}, {0, 0.5f, 0, 1}}});
}
inline DrawCall behind_call(const std::string& name) {
  return triangle_call(name, {{{-0.5f, -0.5f, 0, 1}, {0.5f, -0.5f, 0, 1}, {0, 3, -2, -1}}});
}

inline std::vector<DrawCall> lattice_calls(std::size_t count) {
  std::vector<DrawCall> calls;
  for (std::size_t i = 0; i < count; ++i) calls.push_back(lattice_draw(1, i, OwnDriver().info()));
  return calls;
}

// Draws rightly but for calls whose name is that of a failure.
class FailingDriver : public Driver {
 public:
  const DriverInfo& info() const override { return own_.info(); }
  Drawn draw(const DrawCall& call) override {
    for (std::size_t i = 0; i < names_of(DrawFailure::Kind{}).size(); ++i) {
      if (call.name == names_of(DrawFailure::Kind{})[i]) {
        return DrawFailure{static_cast<DrawFailure::Kind>(i), "last words"};
      }
    }
    return own_.draw(call);
  }

 private:
  OwnDriver own_;
};

inline DriverFactory own_driver(RasterFault fault) {
  return [fault] { return std::make_unique<OwnDriver>(fault); };
}

}  // namespace clipscope::experiments
