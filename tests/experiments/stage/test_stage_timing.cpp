// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/contestants/stage_runner.hpp"
#include "experiments/scenes/builtin.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/stage/stage_timing.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/contestants/stage_inputs.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

const StageClock kFew{
    .rounds = 5, .milliseconds_per_run = 0.2, .check = {.triangles = 2000, .exact = 16}};

// Draws nothing, and notes which triangles it is asked for.
class Lazy final : public StageRunner {
 public:
  Lazy(const StageInput& input, std::vector<std::size_t>* seen)
      : StageRunner(Contract::copy, input), seen_(seen) {}

 private:
  void clip_stage(std::size_t first, std::size_t count) override {
    if (seen_ == nullptr) return;
    seen_->resize(std::max(seen_->size(), first + count));
    for (std::size_t t = first; t < first + count; ++t) ++(*seen_)[t];
  }
  StageAnswer answer() const override { return {}; }

  std::vector<std::size_t>* seen_;
};

Contestant lazy(std::vector<std::size_t>* seen = nullptr) {
  return {.clipper = "lazy",
          .format = &kFormat<float>,
          .contract = Contract::copy,
          .prepare_stage = [=](const StageInput& input) -> std::unique_ptr<Runner> {
            return std::make_unique<Lazy>(input, seen);
          }};
}

const StageTiming* fastest_of(const StageMeasurement& m, Contract contract) {
  const StageTiming* fastest = nullptr;
  for (const StageTiming& t : m.contestants) {
    if (t.contestant->contract != contract) continue;
    if (fastest == nullptr || t.timing.ns.median < fastest->timing.ns.median) fastest = &t;
  }
  return fastest;
}

}  // namespace

TEST_CASE("stage timing: every honest contestant has a sample per round and its own ratio") {
  const StageInput input = small_soup(5000);
  const StageMeasurements both = measure_stage(input, stage_contestants(input), kFew);
  const InputFrom from = GENERATE(InputFrom::memory, InputFrom::cache);
  const StageMeasurement& m = both[static_cast<std::size_t>(from)];
  CHECK(m.from == from);
  REQUIRE(m.contestants.size() > 3);
  for (const StageTiming& t : m.contestants) {
    INFO(name_of(*t.contestant) << " " << t.timing.refused);
    REQUIRE(t.timing.refused.empty());
    CHECK(t.timing.samples_ns.size() == (from == InputFrom::memory ? 5 : 10));
    CHECK(t.timing.ns.low > 0);
    CHECK(t.timing.speedup.value().median > 0);
    CHECK(t.limit_percent.median > 0);
    CHECK(t.times_fastest.median > 0);
    CHECK(t.bytes.out > 0);
  }
  CHECK(m.contestants[0].timing.speedup.value().median == 1);
  for (const Contract contract : {Contract::copy, Contract::number}) {
    const auto* fastest = fastest_of(m, contract);
    REQUIRE(fastest != nullptr);
    CHECK(fastest->times_fastest.median == 1);
    CHECK(fastest->times_fastest.low == 1);
  }
  REQUIRE(m.passes.size() == 3);
  for (const MemoryTiming& pass : m.passes) CHECK(pass.timing.ns.median > 0);
}

TEST_CASE("stage timing: who draws nothing is refused, with the reason") {
  const StageInput input = small_soup();
  const Contestant nothing = lazy();
  for (const StageMeasurement& m :
       measure_stage(input, {stage_contestants(input).front(), &nothing}, kFew)) {
    CHECK(m.contestants[1].timing.samples_ns.empty());
    CHECK(m.contestants[1].timing.refused.find("inside") != std::string::npos);
  }
}

TEST_CASE(
    "stage timing: a run takes the next blocks, so that in the end all triangles had a part") {
  const StageInput input = random_input("soup", {.inside = 1}, 3 * kStageBlock + 5, 4, 1);
  std::vector<std::size_t> seen;
  const Contestant recorder = lazy(&seen);
  const Task task = stage_task(recorder, input, {});
  for (int i = 0; i < 8; ++i) task.work(task.least_share);
  REQUIRE(seen.size() == input.array_size());
  for (const std::size_t times : seen) CHECK(times == 2);
}

TEST_CASE("stage timing: runs that share a cursor never take what another one has just read") {
  const StageInput input = random_input("soup", {.inside = 1}, 5 * kStageBlock + 5, 4, 1);
  std::vector<std::size_t> seen;  // by both
  const Contestant one = lazy(&seen), other = lazy(&seen);
  const auto cursor = std::make_shared<StageCursor>();
  const Task task = stage_task(one, input, {}, cursor),
             rival = stage_task(other, input, {}, cursor);
  const Task pass = memory_task(MemoryPass::read_everything, input, cursor);
  task.work(2.0 / 6);
  rival.work(3.0 / 6);
  REQUIRE(seen.size() == 5 * kStageBlock);
  for (const std::size_t times : seen) CHECK(times == 1);
  CHECK(pass.work(2.0 / 6) == kStageBlock + 5);  // the last, which is short, and the first
  task.work(1.0 / 6);
  CHECK(seen[0] == 1);
  CHECK(seen[kStageBlock] == 2);
}

TEST_CASE("stage timing: a pass over memory takes a share, around the end, or everything") {
  const StageInput input = small_soup(3 * kStageBlock);
  for (const MemoryPass pass : kMemoryPasses) {
    const Task task = memory_task(pass, input);
    CHECK(task.least_share == Approx(1.0 / 3));
    CHECK(task.work(1.0 / 3) == kStageBlock);
    CHECK(task.work(1) == 3 * kStageBlock);
  }
}

TEST_CASE("stage timing: from cache a run is a block that comes after the one that made ready") {
  const StageInput input = random_input("soup", {.inside = 1}, 5 * kStageBlock, 4, 1);
  const std::size_t block = cached_block(input);
  std::vector<std::size_t> seen;
  const Contestant recorder = lazy(&seen);
  const Task task = cached_stage_task(recorder, input, {});
  CHECK(task.least_share == task.most_share);
  REQUIRE(task.prepare);
  task.prepare();
  CHECK(seen == std::vector<std::size_t>(block, 1));
  CHECK(task.work(task.least_share) == block);
  CHECK(seen == std::vector<std::size_t>(2 * block, 1));
  task.prepare();
  CHECK(task.work(task.least_share) == block);
  CHECK(seen == std::vector<std::size_t>(4 * block, 1));
}

TEST_CASE("stage timing: a mesh from cache comes in draws, and is timed like a soup") {
  const Scene scene = terrain_of_levels(7, 1);
  const StageInput input = mesh_input(scene, scene.views.front());
  const StageMeasurements m = measure_stage(input, stage_contestants(input), kFew);
  for (const StageMeasurement& from : m) {
    REQUIRE(from.passes.size() == 2);
    for (const StageTiming& t : from.contestants) {
      INFO(name_of(*t.contestant) << " " << t.timing.refused);
      CHECK(t.timing.is_timed());
      CHECK(t.limit_percent.median > 0);
    }
  }
}

TEST_CASE("stage limits: bytes are those of the arrays") {
  const StageInput input = small_soup(100);
  CHECK(bytes_of(MemoryPass::read_positions, input) == 3 * 4 * sizeof(float));
  CHECK(bytes_of(MemoryPass::read_everything, input) == 3 * 8 * sizeof(float));
  const StageBytes copy = stage_bytes(input, Contract::copy, 7);
  CHECK(copy.total() == 96 + 7);
  const StageBytes number = stage_bytes(input, Contract::number, 7);
  CHECK(number.positions == 48);
  CHECK(number.rest == Approx(0.3 * 48));
}

TEST_CASE("stage limits: the limit is what the passes take for the same bytes") {
  const StageInput input = small_soup(100);
  const std::array<double, 3> passes = {1.5, 3, 4};  // ns: positions, everything, copy
  CHECK(limit_ns({.positions = 0, .rest = 96, .out = 96}, passes, input) == Approx(4));
  CHECK(limit_ns({.positions = 0, .rest = 96, .out = 0}, passes, input) == Approx(3));
  CHECK(limit_ns({.positions = 48, .rest = 0, .out = 48}, passes, input) == Approx(2));
}
