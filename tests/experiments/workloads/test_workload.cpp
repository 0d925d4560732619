// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <utility>

#include "experiments/machine/errors.hpp"
#include "experiments/workloads/lattice_draws.hpp"
#include "experiments/workloads/plain_call.hpp"
#include "experiments/workloads/random_draws.hpp"
#include "experiments/workloads/workload.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/workloads/drivers.hpp"

namespace clipscope::experiments {
namespace {

const WorkloadOptions kFew{.lattice = 600, .random = 80, .scenes = false};

}  // namespace

TEST_CASE("workload: the same options make the same draw calls") {
  CHECK(draws(kFew, able_driver()) == draws(kFew, able_driver()));
}

TEST_CASE("workload: another seed makes other lattice and random draw calls") {
  const WorkloadOptions options{.lattice = 50, .random = 50, .catalogue = false, .scenes = false};
  WorkloadOptions other = options;
  other.seed = 2;
  CHECK(draws(options, able_driver()) != draws(other, able_driver()));
}

TEST_CASE("workload: more lattice draw calls begin with the fewer") {
  const WorkloadOptions few{.lattice = 40, .random = 0, .catalogue = false, .scenes = false};
  WorkloadOptions many = few;
  many.lattice = 90;
  const std::vector<DrawCall> all = draws(many, able_driver());
  REQUIRE(all.size() == 90);
  CHECK(std::vector<DrawCall>(all.begin(), all.begin() + 40) == draws(few, able_driver()));
}

TEST_CASE("workload: a driver is given nothing that it can't draw, and what it can't is counted") {
  WorkloadOptions options = kFew;
  options.scenes = true;
  for (const DriverInfo& info : {able_driver(), poor_driver()}) {
    std::size_t drawn = 0;
    const LeftOut left_out = for_each_draw_call(options, info, [&](const DrawCall& call) {
      ++drawn;
      CHECK(inability(info, call).empty());
      CHECK(is_finite(call));
    });
    CHECK(drawn > 3000);
    CHECK(left_out.contains("has no depth clamp") == !info.depth_clamp);
    CHECK(left_out.contains("can't tell noperspective") ==
          !info.quantities[bit(Quantity::noperspective)]);
  }
}

TEST_CASE("workload: every name stands for one draw call") {
  std::set<std::string> names;
  const std::vector<DrawCall> all = draws(kFew, able_driver());
  for (const DrawCall& call : all) names.insert(call.name);
  CHECK(names.size() == all.size());
}

TEST_CASE("workload: a size is that of all targets") {
  WorkloadOptions options = kFew;
  options.size = 64;
  for (const DrawCall& call : draws(options, able_driver())) {
    CHECK((call.width == 64 && call.height == 64));
  }
}

TEST_CASE("workload: a file of cases needs no expected outcome, and comes first") {
  const std::filesystem::path file = "workload.cases";
  std::ofstream(file) << "case given\nsource us\nwhy it was given\nprimitive point\n"
                         "space clip gl\nvertex 0 0 0 1\n";
  const WorkloadOptions options{
      .lattice = 0, .random = 0, .catalogue = false, .scenes = false, .cases = file};
  CHECK(draws(options, able_driver()).front().name == "workload/given");
  std::filesystem::remove(file);
  CHECK_THROWS_AS(draws(options, able_driver()), InputError);
}

TEST_CASE("workload: a camera walks through a mesh file, and what it cuts is drawn") {
  const std::filesystem::path file = "workload.obj";
  std::ofstream(file) << "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 1\n"
                         "f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n";
  const WorkloadOptions options{
      .lattice = 0, .random = 0, .catalogue = false, .scenes = false, .scene = file.string()};
  const std::vector<DrawCall> all = draws(options, able_driver());
  std::filesystem::remove(file);
  CHECK(all.size() >= 3);  // of six views, two of which see all of it
  for (const DrawCall& call : all) {
    CHECK(call.vertices.size() == 4);
    CHECK(primitives_of(call).size() == 4);
  }
}

TEST_CASE("lattice: 500 draw calls are of all strata") {
  STATIC_REQUIRE(kLatticeStrata <= 500);
  std::vector<LatticeStratum> seen;
  for (std::size_t i = 0; i < kLatticeStrata; ++i) {
    const LatticeStratum s = lattice_stratum(i);
    CHECK(std::ranges::find(seen, s) == seen.end());
    seen.push_back(s);
    CHECK(lattice_stratum(i + kLatticeStrata) == s);
  }
}

TEST_CASE("lattice: a draw call keeps to the signs of w of its stratum") {
  for (std::size_t i = 0; i < kLatticeStrata; ++i) {
    const LatticeStratum s = lattice_stratum(i);
    const DrawCall call = lattice_draw(1, i, able_driver());
    CAPTURE(call.name);
    int behind = 0, on = 0;
    for (std::size_t v = 0; v < s.primitive; ++v) {
      behind += call.vertices[v].position[3] < 0;
      on += call.vertices[v].position[3] == 0;
    }
    switch (s.signs) {
      case WSigns::in_front: CHECK((behind == 0 && on == 0)); break;
      case WSigns::one_on: CHECK((behind == 0 && on == 1)); break;
      case WSigns::one_behind: CHECK((behind == 1 && on == 0)); break;
      case WSigns::two_behind: CHECK((behind == 2 && on == 0)); break;
      case WSigns::on_and_behind: CHECK((behind == 1 && on == 1)); break;
      case WSigns::none_in_front: CHECK(behind + on == static_cast<int>(s.primitive)); break;
    }
  }
}

TEST_CASE("random: a mesh around a vertex is closed") {
  for (std::size_t i = 0; i < 80; ++i) {
    if (random_kind(i) != RandomKind::fan_mesh) continue;
    const DrawCall call = random_draw(1, i, able_driver());
    std::map<std::uint32_t, int> used;
    for (const auto& triangle : primitives_of(call)) {
      CHECK(triangle[0] == 0);
      ++used[triangle[1]];
      ++used[triangle[2]];
    }
    CHECK(used.size() >= 4);
    for (const auto& [vertex, times] : used) CHECK(times == 2);
  }
}

TEST_CASE("random: every kind comes in turn, with indices within the vertices") {
  std::set<RandomKind> kinds;
  for (std::size_t i = 0; i < 64; ++i) {
    kinds.insert(random_kind(i));
    const DrawCall call = random_draw(1, i, able_driver());
    for (const std::uint32_t index : call.indices) CHECK(index < call.vertices.size());
    CHECK_FALSE(primitives_of(call).empty());
  }
  CHECK(kinds.size() == names_of(RandomKind{}).size());
}

}  // namespace clipscope::experiments
