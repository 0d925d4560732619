// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cost/growth.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <functional>
#include <random>

#include "experiments/attributes/crossing.hpp"
#include "experiments/cost/thread_team.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments {
namespace {

constexpr SoupShares kGameLike{.inside = 58, .outside = 37, .straddling = 5};

using Factory = std::function<std::unique_ptr<StageContestant>()>;

// The baseline, and what a renderer would choose from.
std::vector<Factory> growing_contestants() {
  std::vector<Factory> factories = {stage_textbook};
  for (const batch::Method method :
       {batch::Method::homogeneous, batch::Method::correctly_rounded}) {
    for (const StageContract contract : {StageContract::copy, StageContract::reference}) {
      factories.emplace_back([=] { return stage_batch(method, contract, batch::Build::simd); });
    }
  }
  return factories;
}

GrowthPoint point_of(Growing growing, std::size_t n, const StageContestant& c) {
  return {growing,    static_cast<std::int64_t>(n),
          c.method(), c.scalar(),
          c.build(),  std::string(contract_name(c.contract())),
          0.0,        {}};
}

// Clips the first `size` triangles in blocks, again and again until there were `total`; ns per triangle.
double stream(StageContestant& contestant, const StageInput& input, std::size_t size,
              std::size_t total) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  for (std::size_t done = 0; done < total;) {
    for (std::size_t first = 0; first < size && done < total; first += kStageBlock) {
      const std::size_t count = std::min({kStageBlock, size - first, total - done});
      contestant.clip(input, first, count);
      done += count;
    }
  }
  const std::chrono::duration<double, std::nano> spent = Clock::now() - start;
  return spent.count() / static_cast<double>(total);
}

struct Timed {
  GrowthPoint point;
  std::function<double()> task;
};

// Runs those of one n in turn; the first is the baseline if it is textbook.
void time_points(std::vector<Timed> timed, int rounds, std::vector<GrowthPoint>& points) {
  if (timed.empty()) return;
  std::vector<std::function<double()>> tasks;
  for (const Timed& t : timed) tasks.push_back(t.task);
  for (const auto& task : tasks) task();
  const auto samples = run_in_turn(tasks, rounds);
  const bool baseline = timed.front().point.clipper == "textbook";
  for (std::size_t i = 0; i < timed.size(); ++i) {
    Timing& timing = timed[i].point.timing;
    timing.samples_ns = samples[i];
    timing.ns = median_interval(samples[i]);
    if (baseline) timing.speedup = median_interval(ratios(samples[0], samples[i]));
    points.push_back(std::move(timed[i].point));
  }
}

// Triangles that the baseline clips in a run where it need not clip all.
std::size_t share_of_textbook(const GrowthOptions& options) {
  constexpr double kNsAtLeast = 100;
  return static_cast<std::size_t>(options.timing.milliseconds_per_run * 1e6 / kNsAtLeast);
}

// All contestants on the first `size` triangles, `total` per run. The baseline takes a leading share, but
// where triangles grow: there it takes all or, where the soup streams through again and again, has no part.
void time_stream(GrowthPoint at, const StageInput& input, std::size_t size, std::size_t total,
                 const GrowthOptions& options, int rounds, std::vector<GrowthPoint>& points) {
  std::vector<std::unique_ptr<StageContestant>> contestants;
  std::vector<Timed> timed;
  for (const Factory& make : growing_contestants()) {
    contestants.push_back(make());
    StageContestant& c = *contestants.back();
    GrowthPoint point = point_of(at.growing, static_cast<std::size_t>(at.n), c);
    std::size_t taken = total;
    if (point.clipper == "textbook") {
      if (at.growing != Growing::triangles) taken = std::min(total, share_of_textbook(options));
      if (at.growing == Growing::triangles && static_cast<std::size_t>(at.n) > size) continue;
    }
    point.timing.refused = first_broken_promise(c, input, options.timing.check);
    if (!point.timing.refused.empty()) {
      points.push_back(std::move(point));
      continue;
    }
    point.triangles = static_cast<double>(taken);
    timed.push_back(
        {std::move(point), [&c, &input, size, taken] { return stream(c, input, size, taken); }});
  }
  time_points(std::move(timed), rounds, points);
}

std::vector<GrowthPoint> grow_triangles(const GrowthOptions& options) {
  constexpr std::size_t kLeast = 1000, kLeastTotal = 100'000;
  constexpr int kFewer = 7, kFewest = 3;  // rounds, where one takes long
  std::vector<GrowthPoint> points;
  const StageInput input =
      random_input("game_like", kGameLike, options.soup, kSceneAttributes, options.seed);
  for (std::size_t n = kLeast; n <= options.most; n *= 10) {
    const int rounds = n > 10 * options.soup ? kFewest
                       : n > options.soup    ? kFewer
                                             : options.timing.rounds;
    time_stream({.growing = Growing::triangles, .n = static_cast<std::int64_t>(n)}, input,
                std::min(n, options.soup), std::max(n, kLeastTotal), options, rounds, points);
  }
  return points;
}

std::vector<GrowthPoint> grow_attributes(const GrowthOptions& options) {
  std::vector<GrowthPoint> points;
  for (const int attributes : {0, 1, 2, 4, 8, 16, 32}) {
    const StageInput input =
        random_input("game_like", kGameLike, options.attribute_soup, attributes, options.seed);
    time_stream({.growing = Growing::attributes, .n = attributes}, input, options.attribute_soup,
                options.attribute_soup, options, options.timing.rounds, points);
  }
  return points;
}

std::vector<GrowthPoint> grow_planes(const GrowthOptions& options) {
  constexpr std::size_t kTimes = 16;
  std::vector<GrowthPoint> points;
  for (int planes = 1; planes <= kPlanes; ++planes) {
    const StageInput input = crossing_input(planes, options.crossing, kTimes, options.seed);
    time_stream({.growing = Growing::planes, .n = planes}, input, input.array_size(),
                input.array_size(), options, options.timing.rounds, points);
  }
  return points;
}

std::vector<GrowthPoint> grow_threads(const GrowthOptions& options) {
  std::vector<GrowthPoint> points;
  const StageInput input =
      random_input("game_like", kGameLike, options.soup, kSceneAttributes, options.seed);
  for (const std::size_t threads : {1u, 2u}) {
    ThreadTeam team(threads);
    std::vector<std::unique_ptr<StageContestant>> contestants;
    std::vector<Timed> timed;
    for (const Factory& make : growing_contestants()) {
      const std::size_t first = contestants.size();
      for (std::size_t i = 0; i < threads; ++i) contestants.push_back(make());
      GrowthPoint point = point_of(Growing::threads, threads, *contestants[first]);
      point.timing.refused = first_broken_promise(*contestants[first], input, options.timing.check);
      if (!point.timing.refused.empty()) {
        points.push_back(std::move(point));
        continue;
      }
      const bool slow = point.clipper == "textbook";
      const std::size_t part = input.array_size() / threads / (slow ? 8 : 1);
      const std::size_t total = part * threads;
      point.triangles = static_cast<double>(total);
      timed.push_back({std::move(point), [&, first, part, total] {
                         const double ns = team.run([&](std::size_t i) {
                           for (std::size_t t = 0; t < part; t += kStageBlock) {
                             contestants[first + i]->clip(input, i * part + t,
                                                          std::min(kStageBlock, part - t));
                           }
                         });
                         return ns / static_cast<double>(total);
                       }});
    }
    time_points(std::move(timed), options.timing.rounds, points);
  }
  return points;
}

// In clip space by the float transform, whose rounding must leave each vertex on its side.
void append_if_crossing(const Projection<float>& projection, const AttributeTriangle& triangle,
                        int planes, std::vector<float>& vertices) {
  std::vector<float> flat;
  Outcode all = ~Outcode{0}, any = 0;
  for (const auto& v : triangle) {
    const Vec4<float> clip = to_clip(projection, Vec3<float>(static_cast<float>(v.position[0]),
                                                             static_cast<float>(v.position[1]),
                                                             static_cast<float>(v.position[2])));
    const Outcode code = clip_outcode(projection.volume.depth, clip);
    all &= code;
    any |= code;
    for (int c = 0; c < 4; ++c) flat.push_back(clip[c]);
    for (int k = 0; k < 4; ++k) flat.push_back(static_cast<float>(v.attributes[k]));
  }
  if (all != 0 || std::popcount(any) != planes) return;
  vertices.insert(vertices.end(), flat.begin(), flat.end());
}

}  // namespace

std::string_view growing_name(Growing growing) {
  switch (growing) {
    case Growing::triangles: return "triangles";
    case Growing::attributes: return "attributes";
    case Growing::planes: return "planes";
    default: return "threads";
  }
}

StageInput crossing_input(int planes, std::size_t different, std::size_t times,
                          std::uint64_t seed) {
  const Projection<float> projection(attribute_frustum());
  std::vector<float> some;
  for (const AttributeTriangle& triangle : crossing_triangles(planes, different, seed)) {
    append_if_crossing(projection, triangle, planes, some);
  }
  constexpr std::size_t kFloats = 3 * (4 + kSceneAttributes);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < some.size() / kFloats * times; ++i) {
    order.push_back(i % (some.size() / kFloats));
  }
  std::mt19937_64 generator(seed);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[generator() % i]);
  std::vector<float> vertices;
  for (const std::size_t i : order) {
    const auto begin = some.begin() + static_cast<std::ptrdiff_t>(i * kFloats);
    vertices.insert(vertices.end(), begin, begin + static_cast<std::ptrdiff_t>(kFloats));
  }
  return soup_input("crossing", projection.volume, kSceneAttributes, std::move(vertices));
}

std::vector<GrowthPoint> measure_growth(Growing growing, const GrowthOptions& options) {
  switch (growing) {
    case Growing::triangles: return grow_triangles(options);
    case Growing::attributes: return grow_attributes(options);
    case Growing::planes: return grow_planes(options);
    default: return grow_threads(options);
  }
}

}  // namespace clipscope::experiments
