// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cost/rows.hpp"
#include "experiments/cost/walk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <random>

#include "experiments/clock/thread_team.hpp"
#include "experiments/machine/machine.hpp"
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
  return random_input(kGameLikeStage, {.inside = 58, .outside = 37, .straddling = 5}, triangles,
                      attributes, options.seed);
}

// One n: what every contestant does, and the baseline, which is slow; nothing if it has no part.
struct Point {
  std::size_t n;
  InputFrom from;
  std::size_t part;  // of the input, that each thread has
  Load load, baseline;
  int rounds;
  std::size_t threads = 1;

  const Load& load_of(const Contestant& c) const { return is_baseline(c) ? baseline : load; }
};

// Each thread's walk. From memory contestants share it, and nobody finds what the one before it has
// read; from cache each has its own, the same for all, and reads what it will clip before it does.
using Walks = std::shared_ptr<std::vector<Walk>>;

Walks walks_of(const Point& point) {
  const auto walks = std::make_shared<std::vector<Walk>>();
  for (std::size_t i = 0; i < point.threads; ++i) walks->push_back({i * point.part, point.part});
  return walks;
}

Task task_of(const Contestant& c, const StageInput& input, const Point& point, const Walks& walks,
             const std::shared_ptr<ThreadTeam>& team, const StageCheckOptions& check) {
  std::vector<std::shared_ptr<Runner>> runners(point.threads);
  for (auto& runner : runners) runner = c.prepare_stage(input);
  const Load load = point.load_of(c);
  const auto on_each = [=](auto&& f) { team ? team->run(f) : f(std::size_t{0}); };
  Task task;
  task.check = [=, &c, &input] { return first_broken_promise(c, *runners[0], input, check); };
  task.work = [=](double) {
    on_each([&](std::size_t i) {
      Walk& walk = (*walks)[i];
      walk = walk.over(
          load, [&](std::size_t first, std::size_t count) { runners[i]->clip(0, first, count); });
    });
    return load.total * runners.size();
  };
  if (point.from == InputFrom::cache) {
    task.prepare = [=, &c, &input] {
      on_each([&](std::size_t i) {
        (*walks)[i].over(load, [&](std::size_t first, std::size_t count) {
          touch(c.contract, input, first, count);
        });
      });
    };
  }
  if (team) task.interruptions = [=] { return team->interruptions(); };
  return task;
}

// The contestants of a point, in their order, and their times.
struct TimedPoint {
  Point point;
  Contestants contestants;
  std::vector<Timing> timings;
};

// All of the points side by side, in the same rounds.
std::vector<TimedPoint> time_together(const std::vector<Point>& points, const StageInput& input,
                                      const StageCheckOptions& check) {
  std::vector<TimedPoint> timed;
  std::vector<Task> tasks;
  for (const Point& point : points) {
    Contestants contestants = growing_contestants();
    if (point.baseline.total == 0) contestants.erase(contestants.begin());
    const auto team = points.size() > 1 ? std::make_shared<ThreadTeam>(point.threads) : nullptr;
    const Walks shared = walks_of(point);
    for (const Contestant* c : contestants) {
      const bool is_shared = point.from == InputFrom::memory;
      tasks.push_back(task_of(*c, input, point, is_shared ? shared : walks_of(point), team, check));
    }
    timed.push_back({point, contestants, {}});
  }
  std::vector<Timing> timings = time_in_turn(tasks, {.rounds = points.front().rounds});
  for (auto next = timings.begin(); TimedPoint & point : timed) {
    const auto end = next + static_cast<std::ptrdiff_t>(point.contestants.size());
    point.timings.assign(next, end);
    next = end;
  }
  return timed;
}

// How many times faster one is than another, in the same rounds; nothing if one was not timed.
std::optional<MedianInterval> speedup(const Timing& slower, const Timing& faster) {
  if (!slower.is_timed() || !faster.is_timed()) return std::nullopt;
  return median_interval(ratios(slower.samples_ns, faster.samples_ns));
}

// `one`: the point of a single thread; null where threads are not what grows.
void add_rows(Growing growing, const TimedPoint& timed, const TimedPoint* one,
              TableOf<GrowthRow>& table, PieceRecord& record) {
  const Point& point = timed.point;
  const bool has_baseline = is_baseline(*timed.contestants.front());
  for (std::size_t i = 0; i < timed.timings.size(); ++i) {
    const Contestant& c = *timed.contestants[i];
    const Timing& timing = timed.timings[i];
    GrowthRow row{growing,
                  static_cast<std::int64_t>(point.n),
                  point.from,
                  std::string(c.clipper),
                  std::string(c.scalar()),
                  c.contract};
    if (timing.is_timed()) {
      row.triangles = static_cast<double>(point.load_of(c).total * point.threads);
      row.ns = timing.ns;
      const auto to_baseline = has_baseline ? speedup(timed.timings[0], timing) : std::nullopt;
      if (to_baseline) row.speedup = to_baseline->median;
      if (one != nullptr) row.speedup_by_threads = speedup(one->timings[i], timing);
    }
    table.add(row);
    record.add(fmt::format("growth {} {} from {} {} {} {}", name_of(growing), point.n,
                           name_of(point.from), c.clipper, c.build, name_of(c.contract)),
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

namespace {

constexpr std::size_t kLeast = 1000;
constexpr int kShortRounds = 8;  // rounds of short runs in place of one of the usual length

// Whether an input of so many triangles stays in cache by itself.
InputFrom place_of(const StageInput& input) {
  return input.array_size() <= cached_triangles(input) ? InputFrom::cache : InputFrom::memory;
}

// Lists of n triangles, each time others: from memory, and from cache where they fit into it.
std::vector<Point> triangle_points(const StageInput& input, const GrowthOptions& options) {
  constexpr std::size_t kLeastTotal = 100'000;
  constexpr int kFewer = 7;  // rounds, where one takes long
  const int rounds = options.clock.rounds;
  const std::size_t all = input.array_size(), cached = std::min(cached_triangles(input), all);
  std::vector<Point> points;
  for (std::size_t n = kLeast; n <= options.most; n *= 10) {
    const bool again = n > all;  // and again: too long for the baseline
    const auto add = [&](InputFrom from, const Load& load, int usual_rounds) {
      points.push_back({n, from, all, load, again ? Load{} : load, again ? kFewer : usual_rounds});
    };
    if (std::min(n, all) <= cached) {
      add(InputFrom::cache, {n, std::max(cached / n * n, n)}, kShortRounds * rounds);
    }
    if (place_of(input) == InputFrom::memory) {
      add(InputFrom::memory, {n, std::max(n, kLeastTotal)}, rounds);
    }
  }
  return points;
}

// As many threads as there are processors for, up to two: each clips its part, from memory; and as
// many triangles as a cache holds, again and again, so that the threads share nothing at all. What
// these repeat the branch predictor knows, on one thread as on two.
std::vector<Point> thread_points(InputFrom from, const StageInput& input,
                                 const GrowthOptions& options) {
  constexpr std::size_t kTimes = 4;   // beside which the start of the threads is nothing
  constexpr std::size_t kSlower = 8;  // the baseline has that part to do, once
  const std::size_t all = input.array_size();
  std::vector<Point> points;
  for (std::size_t n = 1; n <= std::min<std::size_t>(2, allowed_processors().size()); ++n) {
    const std::size_t own = all / n;
    const std::size_t part =
        from == InputFrom::memory ? own : std::min(cached_triangles(input), own);
    points.push_back(
        {n, from, part, {part, kTimes * own}, {part, own / kSlower}, options.clock.rounds, n});
  }
  return points;
}

}  // namespace

void measure_growth(Growing growing, const GrowthOptions& options, TableOf<GrowthRow>& table,
                    PieceRecord& record) {
  constexpr std::size_t kTimes = 16;
  constexpr double kNsAtLeast = 100;  // of the baseline, per triangle
  const auto share =
      static_cast<std::size_t>(options.clock.milliseconds_per_run * 1e6 / kNsAtLeast);
  // The points are timed side by side where they are compared, else one after the other.
  const auto time = [&](const std::vector<Point>& points, const StageInput& input) {
    const auto timed = time_together(points, input, options.clock.check);
    const bool has_threads = growing == Growing::threads;
    for (const TimedPoint& point : timed) {
      add_rows(growing, point, has_threads ? &timed.front() : nullptr, table, record);
    }
  };
  const auto time_all_of = [&](int n, const StageInput& input) {
    const std::size_t all = input.array_size();
    time({{static_cast<std::size_t>(n),
           place_of(input),
           all,
           {all, all},
           {all, std::min(all, share)},
           options.clock.rounds}},
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
  } else {
    const StageInput input = game_like(options.soup, kSceneAttributes, options);
    if (growing == Growing::triangles) {
      for (const Point& point : triangle_points(input, options)) time({point}, input);
    } else {
      time(thread_points(InputFrom::cache, input, options), input);
      if (place_of(input) == InputFrom::memory) {
        time(thread_points(InputFrom::memory, input, options), input);
      }
    }
  }
}

}  // namespace clipscope::experiments::cost
