// SPDX-License-Identifier: GPL-3.0-or-later
//
// The mutation test of the workload: what is drawn shows every fault that we can think of.
#include "experiments/pixels/judgement.hpp"
#include "experiments/pixels/own_driver.hpp"
#include "experiments/workloads/lattice_draws.hpp"
#include "experiments/workloads/workload.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/workloads/drivers.hpp"

namespace clipscope::experiments {
namespace {

bool is_accused(Driver& driver, const DrawCall& call) {
  const Drawn drawn = driver.draw(call);
  const Judgement judgement = judge_pixels(call, std::get<Pixels>(drawn), driver.info());
  return judgement.apart.empty() && !judgement.violations.empty();
}

// A call that the driver draws wrong and that is drawn right without the fault.
const DrawCall* first_accused(RasterFault fault, const std::vector<DrawCall>& calls) {
  OwnDriver faulty(fault), right;
  for (const DrawCall& call : calls) {
    if (is_accused(faulty, call) && !is_accused(right, call)) return &call;
  }
  return nullptr;
}

}  // namespace

TEST_CASE("workload: the lattice alone shows every fault of our own rasteriser") {
  const WorkloadOptions options{
      .lattice = 2 * kLatticeStrata, .random = 0, .catalogue = false, .scenes = false};
  const std::vector<DrawCall> calls = draws(options, OwnDriver().info());
  for (std::size_t i = 1; i < names_of(RasterFault{}).size(); ++i) {
    CAPTURE(names_of(RasterFault{})[i]);
    CHECK(first_accused(static_cast<RasterFault>(i), calls) != nullptr);
  }
}

TEST_CASE("workload: the catalogue shows every fault of our own rasteriser") {
  const WorkloadOptions options{.lattice = 0, .random = 0, .scenes = false};
  const std::vector<DrawCall> calls = draws(options, OwnDriver().info());
  for (std::size_t i = 1; i < names_of(RasterFault{}).size(); ++i) {
    CAPTURE(names_of(RasterFault{})[i]);
    CHECK(first_accused(static_cast<RasterFault>(i), calls) != nullptr);
  }
}

}  // namespace clipscope::experiments
