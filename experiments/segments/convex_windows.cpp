// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/segments/convex_windows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "experiments/contestants/scalars.hpp"
#include "experiments/contestants/spoken.hpp"
#include "experiments/scenes/random.hpp"
#include "spaces/window/convex_clippers.hpp"

namespace clipscope::experiments::segments {
namespace {

constexpr double kRightPx = 1.0 / 256;  // an end within this of the exact one is right
constexpr double kCheckedPx = 1;        // what the backward error of a timed method is within
constexpr double kLeastTimed = 64;      // segments

// Cells of the dual subdivision along each axis.
constexpr std::size_t dual_cells(std::size_t edges) { return std::max<std::size_t>(16, edges / 2); }

template <class T>
using Answer = std::optional<Segment2<T>>;

template <class T>
Vec2<T> point_from(const Vec2<float>& p) {
  return {scalar_from<T>(p[0]), scalar_from<T>(p[1])};
}

template <class T>
Segment2<T> segment_from(const Segment2<float>& s) {
  return {point_from<T>(s[0]), point_from<T>(s[1])};
}

// A window in T that owns its vertices, and what the methods prepare.
template <class T>
class OwnedWindow {
 public:
  explicit OwnedWindow(std::span<const Vec2<float>> points) : normals_(points.size()) {
    for (const Vec2<float>& p : points) vertices_.push_back(point_from<T>(p));
    const ConvexWindow<T> prepared = prepare_window<T>(vertices_, normals_);
    if constexpr (HasDualSubdivision<T>) {
      dual_ = std::make_unique<DualSubdivision<T>>(prepared, dual_cells(points.size()));
    }
  }
  ConvexWindow<T> get() const { return {vertices_, normals_, dual_.get()}; }

 private:
  std::vector<Vec2<T>> vertices_, normals_;
  std::unique_ptr<const DualSubdivision<T>> dual_;
};

// What is inside of all edges, moved inwards by margin(edge), which is in the units of distances.
template <class T, class Margin>
Answer<T> part_inside(const ConvexWindow<T>& window, const Segment2<T>& s, Margin&& margin) {
  T from(0), to(1);
  for (std::size_t i = 0; i < window.size(); ++i) {
    const T first = window.distance(i, s[0]) - margin(i);
    const T second = window.distance(i, s[1]) - margin(i);
    if (first < T(0) && second < T(0)) return std::nullopt;
    if (T(0) <= first && T(0) <= second) continue;
    const T at = first / (first - second);
    if (first < T(0)) {
      from = larger(from, at);
    } else if (at < to) {
      to = at;
    }
  }
  if (!(from < to) || is_same_position(s[0], s[1])) return std::nullopt;
  return Segment2<T>{window.meet(0, s[0], s[1], from), window.meet(0, s[0], s[1], to)};
}

Answer<Exact> exact_answer(const ConvexWindow<Exact>& window, const Segment2<float>& segment) {
  return part_inside(window, segment_from<Exact>(segment), [](std::size_t) { return Exact(0); });
}

double length_of(const Vec2<double>& v) { return std::hypot(v[0], v[1]); }

double distance_to(const Segment2<double>& s, const Vec2<double>& p) {
  const Vec2<double> along = s[1] - s[0], to_p = p - s[0];
  const double square = along[0] * along[0] + along[1] * along[1];
  const double t = (to_p[0] * along[0] + to_p[1] * along[1]) / square;
  return length_of(to_p - std::clamp(t, 0.0, 1.0) * along);
}

double distance_outside(const ConvexWindow<double>& window, const Vec2<double>& p) {
  double outside = 0;
  for (std::size_t i = 0; i < window.size(); ++i) {
    outside = std::max(outside, -window.distance(i, p) / length_of(window.normal(i)));
  }
  return outside;
}

// Whether the answer is what is visible of a segment and in a window moved by kCheckedPx at most.
bool is_within_a_pixel(const ConvexWindow<double>& window, const Segment2<float>& segment,
                       const Answer<float>& found) {
  const double limit = kCheckedPx / kConvexRadiusPx;
  const auto s = segment_from<double>(segment);
  const Answer<double> least =
      part_inside(window, s, [&](std::size_t i) { return limit * length_of(window.normal(i)); });
  if (!found) return !least;
  const auto ends = segment_from<double>(*found);
  return std::ranges::all_of(ends,
                             [&](const Vec2<double>& p) {
                               return distance_outside(window, p) <= limit &&
                                      distance_to(s, p) <= limit;
                             }) &&
         (!least || std::ranges::all_of(*least, [&](const Vec2<double>& p) {
           return distance_to(ends, p) <= limit;
         }));
}

// One method on one window, prepared for the clock.
template <class Method>
class Contest {
 public:
  Contest(const ConvexCase& input, const ConvexWindow<float>& window, std::size_t checked)
      : input_(input), window_(window), checked_(std::min(checked, input.segments.size())) {
    answers_.resize(input.segments.size());
  }

  Task task() {
    return {.work = [this](double share) { return clip_share(share); },
            .check = [this] { return first_wrong(); },
            .least_share = std::min(1.0, kLeastTimed / static_cast<double>(input_.segments.size())),
            .most_share = kRepeated};
  }

 private:
  std::size_t clip_share(double share) {
    std::size_t clipped = 0;
    const std::size_t all = input_.segments.size();
    const auto wanted = static_cast<std::size_t>(std::ceil(share * static_cast<double>(all)));
    while (clipped < wanted) {
      const std::size_t count = std::min(all, wanted - clipped);
      for (std::size_t i = 0; i < count; ++i) answers_[i] = Method{}(window_, input_.segments[i]);
      clipped += count;
    }
    return clipped;
  }

  std::string first_wrong() const {
    const OwnedWindow<double> window(input_.vertices);
    for (std::size_t i = 0; i < checked_; ++i) {
      const Segment2<float>& s = input_.segments[i];
      if (!is_within_a_pixel(window.get(), s, Method{}(window_, s))) {
        return fmt::format("segment {} is more than {} px off", i, kCheckedPx);
      }
    }
    return "";
  }

  const ConvexCase& input_;
  ConvexWindow<float> window_;
  std::size_t checked_;
  std::vector<Answer<float>> answers_;
};

// The largest distance of an end from the exact one.
double error_px(const Segment2<float>& found, const Segment2<Exact>& exact) {
  double largest = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    Vec2<double> off;
    for (int c = 0; c < 2; ++c) off[c] = nearest_double(Exact(Exact(found[i][c]) - exact[i][c]));
    largest = std::max(largest, length_of(off) * kConvexRadiusPx);
  }
  return largest;
}

void judge(const Answer<float>& found, const Answer<Exact>& exact, ConvexRow& row) {
  row.visible += exact.has_value();
  row.lost += exact && !found;
  row.drawn += found && !exact;
  if (!found || !exact) return;
  const double px = error_px(*found, *exact);
  row.moved += px > kRightPx;
  row.max_px = std::max(row.max_px, px);
}

// What a method answers and what it divides, on the leading segments.
template <class Method>
ConvexRow judged_row(const ConvexCase& input, const ConvexWindow<float>& window,
                     const ConvexWindow<Counted>& counted,
                     const std::vector<Answer<Exact>>& exact) {
  ConvexRow row{.edges = static_cast<std::int64_t>(input.vertices.size()),
                .method = std::string(Method::name)};
  std::uint64_t divisions = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const Segment2<float>& s = input.segments[i];
    judge(Method{}(window, s), exact[i], row);
    const auto counted_segment = segment_from<Counted>(s);
    operation_counts() = {};
    Method{}(counted, counted_segment);
    divisions += operation_counts().divisions;
  }
  row.divisions = static_cast<double>(divisions) / static_cast<double>(exact.size());
  return row;
}

template <class... Methods>
std::vector<ConvexRow> measure(TypeList<Methods...>, const ConvexCase& input,
                               const std::vector<Answer<Exact>>& exact, const ContestClock& clock) {
  const OwnedWindow<float> window(input.vertices);
  const OwnedWindow<Counted> counted(input.vertices);
  std::vector<ConvexRow> rows = {judged_row<Methods>(input, window.get(), counted.get(), exact)...};
  std::tuple<Contest<Methods>...> contests{Contest<Methods>(input, window.get(), clock.checked)...};
  const std::vector<Task> tasks = {std::get<Contest<Methods>>(contests).task()...};
  const std::vector<Timing> timings =
      time_in_turn(tasks, {.rounds = clock.rounds,
                           .milliseconds_per_run = clock.milliseconds_per_run,
                           .baseline = index_of<ConvexCyrusBeck>(AllConvexWindowClippers{})});
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].timing = if_timed(timings[i]);
  return rows;
}

std::vector<ConvexRow> timed(std::vector<ConvexRow> rows) {
  std::erase_if(rows, [](const ConvexRow& row) { return !row.timing; });
  return rows;
}

const ConvexRow& fastest(const std::vector<ConvexRow>& rows) {
  return *std::ranges::min_element(rows, {},
                                   [](const ConvexRow& row) { return row.timing->ns.median; });
}

}  // namespace

ConvexCase make_convex_case(int edges, std::size_t segments, std::uint64_t seed) {
  // A square, turned so that no edge is parallel to an axis, and then the middles of the arcs.
  std::vector<Vec2<double>> points = {{0.8, 0.6}, {-0.6, 0.8}, {-0.8, -0.6}, {0.6, -0.8}};
  while (points.size() < static_cast<std::size_t>(edges)) {
    std::vector<Vec2<double>> finer;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2<double> chord = points[i] + points[(i + 1) % points.size()];
      finer.push_back(points[i]);
      finer.push_back(chord / std::sqrt(chord[0] * chord[0] + chord[1] * chord[1]));
    }
    points = std::move(finer);
  }
  ConvexCase result;
  for (const Vec2<double>& p : points) result.vertices.emplace_back(p);
  Random random(seed);
  const auto coordinate = [&] { return static_cast<float>(random.uniform(-2, 2)); };
  for (std::size_t i = 0; i < segments; ++i) {
    Segment2<float>& s = result.segments.emplace_back();
    for (Vec2<float>& p : s) {
      for (int c = 0; c < 2; ++c) p[c] = coordinate();
    }
  }
  return result;
}

std::vector<ConvexRow> measure_convex(const ConvexCase& input, std::size_t judged,
                                      const ContestClock& clock) {
  const OwnedWindow<Exact> window(input.vertices);
  std::vector<Answer<Exact>> exact;
  for (std::size_t i = 0; i < std::min(judged, input.segments.size()); ++i) {
    exact.push_back(exact_answer(window.get(), input.segments[i]));
  }
  return measure(AllConvexWindowClippers{}, input, exact, clock);
}

Plot convex_plot(const std::vector<ConvexRow>& rows) {
  Plot plot{
      .name = "segments_convex",
      .title = "Time per segment by the edges of a convex window (float)",
      .caption =
          "Methods that ask every edge rise with N, those that search with log N; the dual subdivision, prepared before, asks the same few edges whatever N.",
      .x = {.label = "edges N", .logarithmic = true},
      .y = {.label = "time [ns/segment]", .logarithmic = true}};
  const std::vector<ConvexRow> shown = timed(rows);
  for (const std::string& method : distinct(shown, &ConvexRow::method)) {
    Series& series = plot.series.emplace_back(Series{.name = method});
    for (const ConvexRow& row : rows_where(shown, &ConvexRow::method, method)) {
      series.add(static_cast<double>(row.edges), row.timing->ns);
    }
  }
  return plot;
}

std::string convex_finding(const std::vector<ConvexRow>& rows) {
  const std::vector<ConvexRow> shown = timed(rows);
  if (shown.empty()) return "";
  const auto [fewest, most] = std::ranges::minmax(shown, {}, &ConvexRow::edges);
  const auto best = [&](std::int64_t edges) {
    return spoken_clipper(fastest(rows_where(shown, &ConvexRow::edges, edges)).method);
  };
  const std::string with_few = best(fewest.edges), with_many = best(most.edges);
  if (with_few == with_many) {
    return fmt::format(" In a convex window {} is the fastest, however many edges it has.",
                       with_few);
  }
  return fmt::format(" In a convex window {} is the fastest with few edges and {} with many.",
                     with_few, with_many);
}

}  // namespace clipscope::experiments::segments
