// SPDX-License-Identifier: GPL-3.0-or-later
//
// The methods that clip segments of the plane by a convex polygon, against the exact answer.
#include <limits>
#include <set>

#include "tests/catch.hpp"
#include "tests/spaces/window/convex_windows.hpp"

using namespace clipscope;
using namespace clipscope::tests;
using experiments::Counted;
using experiments::Exact;
using experiments::for_each_type;
using experiments::nearest_double;
using experiments::scalar_from;

namespace {

// Calls f(name, answer) for every method that there is in T.
template <class T, class F>
void for_every_answer(const ConvexWindow<T>& window, const Segment2<T>& segment, F&& f) {
  for_each_type(AllConvexWindowClippers{}, [&]<class C>() {
    if constexpr (ClipsByConvexWindow<C, T>) f(C::name, C{}(window, segment));
  });
}

bool same_answer(const Answer<Exact>& a, const Answer<Exact>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return is_same_position((*a)[0], (*b)[0]) && is_same_position((*a)[1], (*b)[1]);
}

// Whether anything is visible.
bool check_exactly(const ConvexWindow<Exact>& window, const Segment2<Exact>& segment) {
  const Answer<Exact> expected = answer_by_all_edges(window, segment);
  for_every_answer(window, segment, [&](std::string_view name, const Answer<Exact>& found) {
    INFO(name << " of " << window.size() << " edges, from (" << nearest_double(segment[0][0])
              << ", " << nearest_double(segment[0][1]) << ") to (" << nearest_double(segment[1][0])
              << ", " << nearest_double(segment[1][1]) << ")");
    CHECK(same_answer(found, expected));
  });
  return expected.has_value();
}

Vec2<Exact> between(const Vec2<Exact>& a, const Vec2<Exact>& b, double t) {
  const Exact s(t);
  return {a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])};
}

std::vector<OwnedWindow<Exact>> windows() {
  std::vector<OwnedWindow<Exact>> r;
  for (const int n : {3, 4, 5, 7, 12, 33, 100}) {
    r.emplace_back(on_ellipse(n, 1));
    r.emplace_back(on_ellipse(n, 1.0 / 1024));
  }
  for (const std::size_t n : {2u, 3u, 8u, 32u, 50u}) r.emplace_back(on_lattice(n));
  return r;
}

// Turns once counter-clockwise from the lowest vertex, and to the left at each.
bool is_prepared(const ConvexWindow<Exact>& w) {
  bool good = true;
  for (std::size_t i = 0; i < w.size(); ++i) {
    const Vec2<Exact>& n = w.normal(i);
    const Vec2<Exact>& next = w.normal(i + 1);
    good = good && Exact(0) < n[0] * next[1] - n[1] * next[0];
    good = good && w.vertex(0)[1] <= w.vertex(i)[1];
    for (std::size_t k = 0; k < w.size(); ++k) {
      good = good && Exact(0) <= w.distance(i, w.vertex(k));
    }
  }
  return good;
}

Segment2<Exact> exactly(const Segment2<double>& s) {
  return {Vec2<Exact>(Exact(s[0][0]), Exact(s[0][1])), Vec2<Exact>(Exact(s[1][0]), Exact(s[1][1]))};
}
Segment2<Exact> exactly(const Segment2<float>& s) {
  return exactly(Segment2<double>{Vec2<double>(s[0]), Vec2<double>(s[1])});
}

template <class T>
Points<Exact> exactly(const Points<T>& points) {
  Points<Exact> r;
  for (const Vec2<T>& p : points) r.emplace_back(Exact(p[0]), Exact(p[1]));
  return r;
}

double length_of(const Segment2<Exact>& s) {
  return std::hypot(nearest_double(Exact(s[1][0] - s[0][0])),
                    nearest_double(Exact(s[1][1] - s[0][1])));
}

// A line that passes a vertex within rounding may be taken for one on its other side; how far an
// end moves by that is the rounding over the sine of an angle with an edge. A chord shorter than
// `least` may go unseen.
template <class T>
void check_nearly(const ConvexWindow<T>& window, const Segment2<T>& s,
                  const Answer<Exact>& expected, std::string_view spared = "") {
  const double least = 16 * std::sqrt(experiments::kFormat<T>.unit_roundoff());
  for_every_answer(window, s, [&](std::string_view name, const Answer<T>& found) {
    if (name == spared) return;
    INFO(name);
    if (!found || !expected) {
      if (found) CHECK(length_of(exactly(*found)) < least);
      if (expected) CHECK(length_of(*expected) < least);
      return;
    }
    const Segment2<Exact> ends = exactly(*found);
    for (std::size_t i = 0; i < 2; ++i) CHECK(length_of({ends[i], (*expected)[i]}) < least);
  });
}

}  // namespace

TEST_CASE("convex window: names are unique and every method is one in every scalar that it takes") {
  std::set<std::string_view> names;
  for_each_type(AllConvexWindowClippers{}, [&]<class C>() {
    for_each_type(experiments::AllScalars{}, []<class T>() {
      static_assert(ClipsByConvexWindow<C, T> ||
                    (std::same_as<C, ConvexDual> && !HasDualSubdivision<T>));
    });
    CHECK(names.insert(C::name).second);
  });
  CHECK(names.size() == static_cast<std::size_t>(AllConvexWindowClippers::size));
}

TEST_CASE("convex window: a line's cell lists the edges that it crosses, and few others") {
  std::mt19937_64 random(65);
  std::uniform_real_distribution<double> anywhere(-2, 2);
  for (const int n : {3, 16, 256}) {
    const OwnedWindow<double> w(points_cast<double>(on_ellipse(n, 1)));
    std::size_t listed = 0, crossing = 0;
    for (int i = 0; i < 4000; ++i) {
      Segment2<double> s;
      for (Vec2<double>& p : s) p = {anywhere(random), anywhere(random)};
      const DirectedLine<double> line(s);
      const auto edges = w.dual->edges(s);
      std::size_t crossed = 0;
      for (std::size_t e = 0; e < w.vertices.size(); ++e) {
        const bool from = 0 < line.side(w.window().vertex(e));
        const bool to = 0 < line.side(w.window().vertex(e + 1));
        if (from == to) continue;
        CHECK(std::ranges::count(edges, e) == 1);
        ++crossed;
      }
      crossing += crossed > 0;
      if (crossed > 0) listed += edges.size();
    }
    CHECK(listed < 12 * crossing);
  }
}

TEST_CASE("convex window: prepared, it begins at its lowest vertex and is convex") {
  for (const OwnedWindow<Exact>& w : windows()) {
    INFO(w.vertices.size());
    CHECK(is_prepared(w.window()));
  }
}

TEST_CASE("convex window: on a lattice every method has the exact segment") {
  std::mt19937_64 random(61);
  for (const std::size_t n : {2u, 3u, 8u, 20u}) {
    const OwnedWindow<Exact> w(on_lattice(n));
    int reach = 2;
    for (const auto& v : w.vertices) {
      reach = std::max(reach, 2 + static_cast<int>(std::abs(nearest_double(v[0]))));
      reach = std::max(reach, 2 + static_cast<int>(std::abs(nearest_double(v[1]))));
    }
    std::uniform_int_distribution<int> pick(-reach, reach);
    int visible = 0;
    for (int i = 0; i < 600; ++i) {
      Segment2<Exact> s;
      for (Vec2<Exact>& p : s) p = {Exact(pick(random)), Exact(pick(random))};
      visible += check_exactly(w.window(), s) ? 1 : 0;
    }
    CHECK(visible > 20);
  }
}

TEST_CASE(
    "convex window: through vertices, along edges, touching and ending there, all are exact") {
  std::mt19937_64 random(62);
  // Ends short of, at, and beyond the two vertices of a line, in both directions.
  constexpr std::array<double, 7> kPlaces = {-1.5, -0.25, 0, 0.25, 1, 1.5, 3};
  for (const OwnedWindow<Exact>& owned : windows()) {
    const ConvexWindow<Exact> w = owned.window();
    for (int n = 0; n < 12; ++n) {
      const std::size_t i = random() % w.size(), k = random() % w.size();
      const Vec2<Exact>& at = w.vertex(i);
      const Vec2<Exact>& next = w.vertex(i + 1);
      const Vec2<Exact>& previous = w.vertex(i + w.size() - 1);
      const Vec2<Exact> tangent = {at[0] + next[0] - previous[0], at[1] + next[1] - previous[1]};
      for (const double from : kPlaces) {
        const double to = kPlaces[random() % kPlaces.size()];
        check_exactly(w, {between(at, next, from), between(at, next, to)});
        check_exactly(w, {between(at, w.vertex(k), from), between(at, w.vertex(k), to)});
        check_exactly(w, {between(at, tangent, from), between(at, tangent, to)});
      }
    }
  }
}

TEST_CASE("convex window: random segments have the exact answer, in polygons thick and thin") {
  std::mt19937_64 random(63);
  std::uniform_real_distribution<float> anywhere(-2, 2);
  int visible = 0;
  for (const OwnedWindow<Exact>& w : windows()) {
    for (int n = 0; n < 60; ++n) {
      Segment2<Exact> s;
      for (Vec2<Exact>& p : s) p = {Exact(anywhere(random)), Exact(anywhere(random))};
      visible += check_exactly(w.window(), s) ? 1 : 0;
    }
  }
  CHECK(visible > 100);
}

TEMPLATE_TEST_CASE("convex window: rounded answers are near the exact one of the rounded input", "",
                   float, double) {
  std::mt19937_64 random(64);
  std::uniform_real_distribution<float> anywhere(-2, 2);
  for (const int n : {3, 8, 100}) {
    const OwnedWindow<TestType> owned(points_cast<TestType>(on_ellipse(n, 1)));
    const OwnedWindow<Exact> exact(exactly(owned.vertices));
    for (int i = 0; i < 1000; ++i) {
      Segment2<TestType> s;
      for (Vec2<TestType>& p : s) p = {anywhere(random), anywhere(random)};
      INFO("N = " << n << ", segment " << i);
      check_nearly(owned.window(), s, answer_by_all_edges(exact.window(), exactly(s)));
    }
  }
}

// Products of small integers are exact, and so are the sides of the vertices. Pruning asks about
// rounded ends instead and may lose a segment along an edge.
TEST_CASE("convex window: on a lattice every method but pruning sees in double what is there") {
  std::mt19937_64 random(66);
  std::uniform_int_distribution<int> pick(-9, 9);
  for (const std::size_t n : {2u, 3u, 8u}) {
    const OwnedWindow<Exact> exact(on_lattice(n));
    const OwnedWindow<double> owned(points_cast<double>(exact.vertices));
    const auto corner = [&] { return owned.vertices[random() % owned.vertices.size()]; };
    for (int i = 0; i < 3000; ++i) {
      const Vec2<double> a = corner(), b = corner();
      const Vec2<double> from = i % 3 == 0 ? Vec2<double>(pick(random), pick(random)) : a;
      const Segment2<double> s = {from - (b - a), b + (b - a)};
      INFO("N = " << 2 * n << ", segment " << i);
      check_nearly(owned.window(), s, answer_by_all_edges(exact.window(), exactly(s)),
                   ConvexPruning::name);
    }
  }
}

TEST_CASE("convex window: NaN and infinity yield nothing, and nothing not finite comes out") {
  using Limits = std::numeric_limits<float>;
  const OwnedWindow<float> w(points_cast<float>(on_ellipse(12, 1)));
  const std::array<float, 10> specials = {0.0f,
                                          0.25f,
                                          1.0f,
                                          -3.0f,
                                          Limits::max(),
                                          -Limits::max(),
                                          Limits::denorm_min(),
                                          Limits::quiet_NaN(),
                                          Limits::infinity(),
                                          -Limits::infinity()};
  for (int n = 0; n < 10000; ++n) {
    std::array<float, 4> c;
    for (std::size_t i = 0, rest = static_cast<std::size_t>(n); i < 4; ++i, rest /= 10) {
      c[i] = specials[rest % 10];
    }
    const bool finite = std::ranges::all_of(c, [](float x) { return std::isfinite(x); });
    const Segment2<float> s = {Vec2<float>(c[0], c[1]), Vec2<float>(c[2], c[3])};
    for_every_answer(w.window(), s, [&](std::string_view name, const Answer<float>& found) {
      INFO(name << ": " << c[0] << " " << c[1] << " " << c[2] << " " << c[3]);
      CHECK((finite || !found));
      if (!found) return;
      for (const Vec2<float>& p : *found) CHECK((std::isfinite(p[0]) && std::isfinite(p[1])));
    });
  }
}

TEST_CASE("convex window: Cyrus-Beck divides N times, the searches twice and in logarithmic time") {
  const auto cost = [](const auto& method, int n) {
    const OwnedWindow<Counted> w(points_cast<Counted>(on_ellipse(n, 1)));
    const Segment2<Counted> s = {Vec2<Counted>(Counted(-1.5f), Counted(-0.3f)),
                                 Vec2<Counted>(Counted(1.5f), Counted(0.7f))};
    operation_counts() = {};
    CHECK(method(w.window(), s).has_value());
    return operation_counts();
  };
  for (const int n : {8, 64, 512}) {
    CHECK(cost(ConvexCyrusBeck{}, n).divisions == static_cast<std::uint64_t>(n));
    CHECK(cost(ConvexSkala{}, n).divisions == 2);
    CHECK(cost(ConvexSkalaLogarithmic{}, n).divisions == 2);
    CHECK(cost(ConvexExtremes{}, n).divisions == 2);
    CHECK(cost(ConvexSkalaHomogeneous{}, n).divisions == 4);
    CHECK(cost(ConvexPruning{}, n).divisions >= 2);
    CHECK(cost(ConvexDual{}, n).divisions == 3);
  }
  const auto growth = [&](const auto& method) {
    return cost(method, 512).multiplications - cost(method, 8).multiplications;
  };
  CHECK(growth(ConvexSkala{}) > 400);
  CHECK(growth(ConvexSkalaLogarithmic{}) < 60);
  CHECK(growth(ConvexExtremes{}) < 60);
  CHECK(cost(ConvexDual{}, 512).multiplications < 60);
}
