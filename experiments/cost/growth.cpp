// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cost/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <random>

#include "experiments/clock/thread_team.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/survey/crossing.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments::cost {
namespace {

// The baseline, and batch clippers in SIMD.
Contestants growing_contestants() {
  Contestants growing = {find_in_contract("textbook", "float", Contract::copy)};
  for (const char* clipper : {"homogeneous/batch", "barycentric/correctly_rounded_batch"}) {
    for (const Contract contract : {Contract::copy, Contract::number}) {
      for (const Contestant& c : all_contestants()) {
        if (c.clipper == clipper && c.contract == contract && c.build == "simd") {
          growing.push_back(&c);
        }
      }
    }
  }
  return growing;
}

bool is_baseline(const Contestant& c) { return c.clipper == "textbook"; }

StageInput game_like(std::size_t triangles, int attributes, const GrowthOptions& options) {
  return random_input("game_like", {.inside = 58, .outside = 37, .straddling = 5}, triangles,
                      attributes, options.seed);
}

// What a contestant does in one run: it clips `size` triangles in blocks, again and again until
// there were `total`. In a team each thread does, with triangles of its own.
struct Load {
  std::size_t size = 0, total = 0;
};

void stream(Runner& runner, std::size_t part, const Load& load) {
  for (std::size_t done = 0; done < load.total;) {
    for (std::size_t first = 0; first < load.size && done < load.total; first += kStageBlock) {
      const std::size_t count = std::min({kStageBlock, load.size - first, load.total - done});
      runner.clip(0, part * load.size + first, count);
      done += count;
    }
  }
}

Task task_of(const Contestant& c, const StageInput& input, const Load& load, ThreadTeam* team,
             const StageCheckOptions& check) {
  std::vector<std::shared_ptr<Runner>> runners(team != nullptr ? team->size() : 1);
  for (auto& runner : runners) runner = c.prepare_stage(input);
  const auto work = [=](double) {
    if (team == nullptr) {
      stream(*runners[0], 0, load);
    } else {
      team->run([&](std::size_t i) { stream(*runners[i], i, load); });
    }
    return load.total * runners.size();
  };
  return {.work = work,
          .check = [=, &c, &input] { return first_broken_promise(c, *runners[0], input, check); }};
}

// One n: what every contestant does, and the baseline, which is slow; nothing if it has no part.
struct Point {
  std::size_t n;
  Load load, baseline;
  int rounds;
  std::size_t threads = 1;
};

void time_point(Growing growing, const Point& point, const StageInput& input,
                const StageCheckOptions& check, TableOf<GrowthRow>& table, PieceRecord& record) {
  std::optional<ThreadTeam> team;
  if (growing == Growing::threads) team.emplace(point.threads);
  Contestants contestants = growing_contestants();
  if (point.baseline.total == 0) contestants.erase(contestants.begin());
  std::vector<Task> tasks;
  for (const Contestant* c : contestants) {
    const Load& load = is_baseline(*c) ? point.baseline : point.load;
    tasks.push_back(task_of(*c, input, load, team ? &*team : nullptr, check));
  }
  ClockOptions clock{.rounds = point.rounds};
  if (is_baseline(*contestants.front())) clock.baseline = 0;
  const std::vector<Timing> timings = time_in_turn(tasks, clock);
  for (std::size_t i = 0; i < timings.size(); ++i) {
    const Contestant& c = *contestants[i];
    const Timing& timing = timings[i];
    GrowthRow row{growing, static_cast<std::int64_t>(point.n), std::string(c.clipper),
                  std::string(c.scalar()), c.contract};
    if (timing.is_timed()) {
      const Load& load = is_baseline(c) ? point.baseline : point.load;
      row.triangles = static_cast<double>(load.total * point.threads);
      row.ns = timing.ns;
      if (timing.speedup) row.speedup = timing.speedup->median;
    }
    table.add(row);
    record.add(fmt::format("growth {} {} {} {} {}", name_of(growing), point.n, c.clipper, c.build,
                           name_of(c.contract)),
               timing);
  }
}

}  // namespace

StageInput crossing_input(int planes, std::size_t different, std::size_t times,
                          std::uint64_t seed) {
  const Projection<float> projection(attribute_frustum());
  std::vector<ClipTriangle<float, kSceneAttributes>> some, all;
  for (const AttributeTriangle& triangle : crossing_triangles(planes, different, seed)) {
    auto& clip = some.emplace_back();
    for (std::size_t v = 0; v < 3; ++v) {
      clip[v].position = to_clip(projection, Vec3<float>(triangle[v].position));
      for (int k = 0; k < kSceneAttributes; ++k) {
        clip[v].attributes[k] = static_cast<float>(triangle[v].attributes[k]);
      }
    }
    // The float transform's rounding must leave each vertex on its side.
    const OutcodeSummary code = summarize_outcodes(projection.volume, clip);
    if (code.all != 0 || std::popcount(code.any) != planes) some.pop_back();
  }
  for (std::size_t i = 0; i < times; ++i) all.insert(all.end(), some.begin(), some.end());
  std::mt19937_64 generator(seed);
  for (std::size_t i = all.size(); i > 1; --i) std::swap(all[i - 1], all[generator() % i]);
  const std::span<const float> numbers = numbers_of(std::span(std::as_const(all)));
  return soup_input("crossing", projection.volume, kSceneAttributes,
                    {numbers.begin(), numbers.end()});
}

void measure_growth(Growing growing, const GrowthOptions& options, TableOf<GrowthRow>& table,
                    PieceRecord& record) {
  constexpr std::size_t kLeast = 1000, kLeastTotal = 100'000, kTimes = 16;
  constexpr int kFewer = 7;           // rounds, where one takes long
  constexpr double kNsAtLeast = 100;  // of the baseline, per triangle
  const StageClock& clock = options.clock;
  const auto share = static_cast<std::size_t>(clock.milliseconds_per_run * 1e6 / kNsAtLeast);
  const auto time = [&](const Point& point, const StageInput& input) {
    time_point(growing, point, input, clock.check, table, record);
  };
  const auto time_all_of = [&](int n, const StageInput& input) {
    const std::size_t all = input.array_size();
    time({static_cast<std::size_t>(n), {all, all}, {all, std::min(all, share)}, clock.rounds},
         input);
  };
  if (growing == Growing::attributes) {
    for (const int n : {0, 1, 2, 4, 8, 16, 32}) {
      time_all_of(n, game_like(options.attribute_soup, n, options));
    }
  } else if (growing == Growing::planes) {
    for (int n = 1; n <= kPlanes; ++n) {
      time_all_of(n, crossing_input(n, options.crossing, kTimes, options.seed));
    }
  } else if (growing == Growing::triangles) {
    const StageInput input = game_like(options.soup, kSceneAttributes, options);
    for (std::size_t n = kLeast; n <= options.most; n *= 10) {
      const Load load{std::min(n, options.soup), std::max(n, kLeastTotal)};
      if (n <= options.soup) {
        time({n, load, load, clock.rounds}, input);
      } else {  // again and again: too long for the baseline
        time({n, load, {}, kFewer}, input);
      }
    }
  } else {
    const StageInput input = game_like(options.soup, kSceneAttributes, options);
    for (const std::size_t threads : {1u, 2u}) {
      const std::size_t part = input.array_size() / threads;
      time({threads, {part, part}, {part / 8, part / 8}, clock.rounds, threads}, input);
    }
  }
}

}  // namespace clipscope::experiments::cost
