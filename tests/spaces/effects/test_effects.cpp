// SPDX-License-Identifier: GPL-3.0-or-later
//
// Planned pipelines against the full one: on scenes made to be just inside, just outside and
// neither, and by trying to get a plan that leaves out too much.
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "spaces/effects/pipeline.hpp"
#include "tests/catch.hpp"

using namespace clipscope;

namespace {

constexpr int kAttributes = 4;
constexpr Outcode kSixPlanes = (Outcode{1} << kPlanes) - 1;

template <class T>
using SceneOf = std::vector<ViewTriangle<T, kAttributes>>;

template <class T>
using Polygons = std::vector<NdcPolygon<T, kAttributes>>;

template <class T>
struct Into {
  Polygons<T>& polygons;
  void operator()(const NdcPolygon<T, kAttributes>& p) { polygons.push_back(p); }
};

template <class T>
std::span<const ViewTriangle<T, kAttributes>> all_of(const SceneOf<T>& scene) {
  return scene;
}

template <class T>
Polygons<T> fully(const Projection<T>& projection, const SceneOf<T>& scene) {
  Polygons<T> polygons;
  clip_fully(projection, all_of(scene), Into<T>{polygons});
  return polygons;
}

template <class T>
Polygons<T> as_planned(const Plan<T>& plan, const SceneOf<T>& scene, std::uint64_t revision = 0) {
  Polygons<T> polygons;
  clip_as_planned(plan, revision, all_of(scene), Into<T>{polygons});
  return polygons;
}

template <class T>
SceneFacts<T> facts_of(const Projection<T>& projection, const SceneOf<T>& scene,
                       const LookOptions<T>& options = {}) {
  return SceneFacts<T>(projection, all_of(scene), attribute_facts(all_of(scene)), options);
}

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

// The number of polygons that differ, what the plan leaves out aside.
template <class T>
std::size_t changed(const EffectSet& effects, const Polygons<T>& full, const Polygons<T>& planned) {
  if (full.size() != planned.size()) return full.size() + 1;
  std::size_t count = 0;
  for (std::size_t i = 0; i < full.size(); ++i) {
    bool same = full[i].size() == planned[i].size();
    for (int v = 0; same && v < full[i].size(); ++v) {
      const auto &a = full[i][v], &b = planned[i][v];
      for (int c = 0; c < 4; ++c) {
        if (c == 2 && !effects.depth()) continue;
        if (c == 3 && effects.divide() && !effects.perspective()) continue;
        same = same && same_bits(a.position[c], b.position[c]);
      }
      for (int k = 0; k < kAttributes; ++k) {
        same = same && same_bits(a.attributes[k], b.attributes[k]);
      }
    }
    count += !same;
  }
  return count;
}

template <class T>
class Scenes {
 public:
  explicit Scenes(std::uint64_t seed) : random_(seed) {}

  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  T uniform(double low, double high) {
    return static_cast<T>(std::uniform_real_distribution<double>(low, high)(random_));
  }

  Projection<T> projection() {
    Frustum<T> f;
    f.depth = static_cast<DepthRange>(below(3));
    f.kind = below(3) == 0 ? ProjectionKind::parallel : ProjectionKind::perspective;
    f.near = uniform(0.5, 2);
    f.far = f.near * uniform(1.001, 20);
    f.infinite_far = f.kind == ProjectionKind::perspective && below(4) == 0;
    f.left = uniform(-1, -0.1);
    f.top = uniform(0.2, 2);
    if (f.kind == ProjectionKind::parallel && below(2) == 0) f.shear_x = uniform(-1, 1);
    Projection<T> p(f);
    p.volume.depth_clamp = below(6) == 0;
    p.volume.clip_distances = below(6) == 0 ? 2 : 0;
    p.volume.open_sides = below(6) == 0;
    return p;
  }

  // A point at NDC-like coordinates: inside for x, y in [-1, 1] and depth in [0, 1].
  Vec3<T> at(const Frustum<T>& f, T x, T y, T depth) {
    const T far = f.infinite_far ? 8 * f.near : f.far;
    const T d = f.near + depth * (far - f.near);
    const T k = f.kind == ProjectionKind::perspective ? d / f.near : T(1);
    const T cx = ((1 - x) * f.left + (1 + x) * f.right) / 2 * k;
    const T cy = ((1 - y) * f.bottom + (1 + y) * f.top) / 2 * k;
    return Vec3<T>(cx + f.shear_x * d, cy + f.shear_y * d, -d);
  }

  // Triangles in a box that reaches up to `reach` times the volume; to its very border for 1.
  SceneOf<T> scene(const Projection<T>& p) {
    static constexpr std::array<double, 6> kReach = {0.5, 0.99, 1, 1, 1.01, 3};
    SceneOf<T> triangles(static_cast<std::size_t>(1 + below(150)));
    const std::array<double, 3> reach = {kReach[below(6)], kReach[below(6)], kReach[below(6)]};
    const bool flat = below(3) == 0;
    for (auto& triangle : triangles) {
      const T base = uniform(0, 1);
      for (auto& v : triangle) {
        v.position = at(p.frustum, coordinate(reach[0]), coordinate(reach[1]),
                        (coordinate(reach[2]) + 1) / 2);
        for (int k = 0; k < kAttributes; ++k) {
          v.attributes[k] = flat ? base + T(k) : uniform(below(4) == 0 ? -0.1 : 0, 1);
        }
      }
      if (below(300) == 0) spoil(triangle);
    }
    return triangles;
  }

 private:
  T coordinate(double reach) {
    return below(4) == 0 ? static_cast<T>(below(2) == 0 ? reach : -reach) : uniform(-reach, reach);
  }
  void spoil(ViewTriangle<T, kAttributes>& triangle) {
    static constexpr T kBad[] = {
        std::numeric_limits<T>::quiet_NaN(),  std::numeric_limits<T>::infinity(),
        -std::numeric_limits<T>::infinity(),  std::numeric_limits<T>::max(),
        std::numeric_limits<T>::denorm_min(), T(0)};
    triangle[static_cast<std::size_t>(below(3))].position[below(3)] = kBad[below(6)];
  }

  std::mt19937_64 random_;
};

// What the header says of facts, checked triangle by triangle.
template <class T>
bool facts_hold(const SceneFacts<T>& facts, const SceneOf<T>& scene) {
  const Projection<T>& p = facts.projection();
  bool hold = true;
  for (const auto& triangle : scene) {
    const auto clip = to_clip(p, triangle);
    const OutcodeSummary code = summarize_outcodes(p.volume, triangle, [&](std::size_t i) {
      return clip_outcode(p.volume.depth, clip[i].position);
    });
    T low = clip[0].position[3], high = low;
    for (const auto& v : clip) {
      const T& w = v.position[3];
      hold = hold && (!facts.has_unit_w() || w == T(1));
      hold = hold && (code.all != 0 || facts.has_bad_w() || (T(0) < w && is_finite(w)));
      low = std::min(low, w);
      high = std::max(high, w);
    }
    if (code.all != 0) {
      hold = hold && (code.all & (facts.crossed() | facts.rejecting())) != 0;
    } else {
      hold = hold && (code.any & ~facts.crossed()) == 0;
      hold = hold && (facts.has_bad_w() || high / low <= facts.w_ratio());
    }
  }
  return hold;
}

// Something wholly inside, a parallel projection aside.
template <class T>
ViewTriangle<T, kAttributes> middle_triangle(const Frustum<T>& f) {
  Scenes<T> make(1);
  return {{{make.at(f, T(-0.25), T(-0.25), T(0.5)), {{0, 0, 0, 0}}},
           {make.at(f, T(0.25), T(-0.25), T(0.5)), {{1, 0, 1, 0}}},
           {make.at(f, T(0), T(0.25), T(0.5)), {{0, 1, 0, 1}}}}};
}

template <class E>
concept CanBeTakenOut = requires(E e) {
  e - e;
}
|| requires(E e) { e &= e; }
|| requires(E e) { e.perspective(false); }
|| requires(E e) {
  e.planes_ = {};
};

}  // namespace

TEMPLATE_TEST_CASE("effects: planned polygons are those of the full pipeline to the bit", "", float,
                   double) {
  using T = TestType;
  Scenes<T> make(7);
  EffectSet other;
  int lean = 0, without_test = 0, without_perspective = 0, flat = 0;
  for (int i = 0; i < 4000; ++i) {
    const Projection<T> projection = make.projection();
    const SceneOf<T> scene = make.scene(projection);
    const SceneFacts<T> facts = facts_of(projection, scene);
    const Plan<T> plan(facts, {.tolerance = make.uniform(0, 0.1), .depth = i % 3 != 0});
    const Polygons<T> full = fully(projection, scene);
    CAPTURE(i);
    REQUIRE(facts_hold(facts, scene));
    REQUIRE(changed(plan.effects(), full, as_planned(plan, scene)) == 0);
    // With more than is called for nothing changes either.
    const Plan<T> more = plan.with(other);
    REQUIRE(changed(more.effects() | plan.effects(), full, as_planned(more, scene)) == 0);
    REQUIRE((more.effects() | plan.effects()) == more.effects());
    other = plan.effects();
    lean += !(plan.effects() == EffectSet());
    without_test += !plan.effects().has_plane(PlaneEffect::reject);
    without_perspective += plan.effects().divide() && !plan.effects().perspective();
    flat += plan.effects().has_plane(PlaneEffect::cut) && !plan.effects().interpolation();
  }
  // All of that was put to the test.
  CHECK(lean > 3000);
  CHECK(without_test > 100);
  CHECK(without_perspective > 100);
  CHECK(flat > 100);
}

TEST_CASE("effects: nobody but a plan that asked the facts can take an effect out") {
  STATIC_REQUIRE_FALSE(CanBeTakenOut<EffectSet>);
  STATIC_REQUIRE_FALSE(std::is_aggregate_v<EffectSet>);
  STATIC_REQUIRE_FALSE(std::is_default_constructible_v<SceneFacts<float>>);
  STATIC_REQUIRE_FALSE(std::is_constructible_v<Plan<float>, Projection<float>, EffectSet>);

  const Projection<float> projection{Frustum<float>{}};
  const Plan<float> unknown(projection);
  const EffectSet& e = unknown.effects();
  for (const Plane plane : kAllPlanes) CHECK(e.plane(plane) == PlaneEffect::cut);
  CHECK((e.w_guard() && e.divide() && e.perspective() && e.depth() && e.interpolation()));

  // Joined with whatever, nothing goes away.
  const SceneOf<float> scene = {middle_triangle(projection.frustum)};
  const Plan<float> lean(facts_of(projection, scene), {});
  REQUIRE_FALSE(lean.effects().has_plane(PlaneEffect::reject));
  CHECK((lean.effects() | EffectSet()) == EffectSet());
  CHECK(lean.with(EffectSet()).effects() == EffectSet());
}

TEMPLATE_TEST_CASE("effects: an ulp beyond a plane is planned for, an ulp within is not", "", float,
                   double) {
  using T = TestType;
  const auto kind = GENERATE(ProjectionKind::perspective, ProjectionKind::parallel);
  const auto depth =
      GENERATE(DepthRange::minus_one_to_one, DepthRange::zero_to_one, DepthRange::reversed);
  const Frustum<T> frustum{.kind = kind,
                           .left = T(-0.7),
                           .right = T(1.3),
                           .near = T(0.9),
                           .far = T(7.7),
                           .depth = depth};
  const Projection<T> projection(frustum);
  Scenes<T> make(1);
  for (const Plane plane : kAllPlanes) {
    CAPTURE(static_cast<int>(plane));
    const bool is_depth = plane == Plane::near || plane == Plane::far;
    const T x = plane == Plane::left ? T(-1) : plane == Plane::right ? T(1) : T(0);
    const T y = plane == Plane::bottom ? T(-1) : plane == Plane::top ? T(1) : T(0);
    const T d = plane == Plane::near ? T(0) : plane == Plane::far ? T(1) : T(0.5);
    const int axis = is_depth ? 2 : y != T(0) ? 1 : 0;
    const Vec3<T> on_plane = make.at(frustum, x, y, d);
    int inside = 0, outside = 0;
    for (int ulps = -40; ulps <= 40; ++ulps) {
      SceneOf<T> scene(70, middle_triangle(frustum));
      Vec3<T>& v = scene[33][1].position;
      v = on_plane;
      const T away =
          ulps < 0 ? -std::numeric_limits<T>::infinity() : std::numeric_limits<T>::infinity();
      for (int i = 0; i < std::abs(ulps); ++i) v[axis] = std::nextafter(v[axis], away);
      const bool is_out = (clip_outcode(depth, to_clip(projection, v)) & bit(plane)) != 0;
      const Plan<T> plan(facts_of(projection, scene), {});
      REQUIRE((plan.effects().plane(plane) == PlaneEffect::cut) == is_out);
      REQUIRE(changed(plan.effects(), fully(projection, scene), as_planned(plan, scene)) == 0);
      ++(is_out ? outside : inside);
    }
    CHECK((inside > 0 && outside > 0));
  }
}

TEST_CASE("effects: NaN and infinity, wherever they are, are planned for") {
  const Projection<float> projection{Frustum<float>{}};
  const float bad =
      GENERATE(std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
               -std::numeric_limits<float>::infinity());
  for (std::size_t at = 0; at < 65; ++at) {
    SceneOf<float> scene(65, middle_triangle(projection.frustum));
    scene[at][at % 3].position[static_cast<int>(at / 3) % 3] = bad;
    const SceneFacts<float> facts = facts_of(projection, scene);
    const Plan<float> plan(facts, {});
    REQUIRE(facts_hold(facts, scene));
    REQUIRE(plan.effects().has_plane(PlaneEffect::reject));
    REQUIRE(changed(plan.effects(), fully(projection, scene), as_planned(plan, scene)) == 0);
  }
}

TEST_CASE("effects: the origin of clip space, outside by definition, calls for the w guard") {
  Projection<float> projection{Frustum<float>{}};
  projection.z.one = 0;  // so that the eye goes to (0, 0, 0, 0), which no plane is violated by
  SceneOf<float> scene = {middle_triangle(projection.frustum)};
  scene[0][0].position = Vec3<float>(0, 0, 0);
  const Plan<float> plan(facts_of(projection, scene), {});
  CHECK(plan.effects().w_guard());
  CHECK(as_planned(plan, scene)[0].empty());
  CHECK(fully(projection, scene)[0].empty());
}

TEST_CASE("effects: attributes are flat only where interpolation keeps their bits") {
  SceneOf<float> scene(1);
  const auto is_flat = [&](float a, float b, float c) {
    for (int k = 0; k < kAttributes; ++k) {
      scene[0][0].attributes[k] = a;
      scene[0][1].attributes[k] = b;
      scene[0][2].attributes[k] = c;
    }
    return attribute_facts(all_of(scene)).flat;
  };
  const float infinity = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(is_flat(3, 3, 3));
  CHECK(is_flat(0, 0, 0));
  CHECK_FALSE(is_flat(3, 3, std::nextafter(3.0f, 4.0f)));
  CHECK_FALSE(is_flat(-0.0f, -0.0f, -0.0f));
  CHECK_FALSE(is_flat(0, 0, -0.0f));
  CHECK_FALSE(is_flat(infinity, infinity, infinity));
  CHECK_FALSE(is_flat(nan, nan, nan));
  CHECK_FALSE(is_flat(1, nan, 1));
}

TEST_CASE("effects: affine attributes stay within the bound, and reach it on an edge") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  const Projection<double> projection{Frustum<double>{.near = 1, .far = 1000}};
  double closest = 0;
  for (int n = 0; n < 500; ++n) {
    SceneOf<double> scene(1);
    const double w0 = 2 + uniform(random), spread = uniform(random);
    for (auto& v : scene[0]) {
      const double w = w0 * (1 + spread * uniform(random));
      v.position = Vec3<double>(w * uniform(random) / 2, w * uniform(random) / 2, -w);
      for (int k = 0; k < kAttributes; ++k) v.attributes[k] = uniform(random) * (k + 1);
    }
    const Plan<double> plan(facts_of(projection, scene), {.tolerance = 0});
    REQUIRE(plan.effects().perspective());
    const Polygons<double> polygons = fully(projection, scene);
    const NdcPolygon<double, kAttributes>& p = polygons[0];
    REQUIRE(p.size() == 3);
    double found = 0;
    for (int i = 0; i <= 100; ++i) {
      for (int j = 0; i + j <= 100; ++j) {
        const std::array<double, 3> b = {i / 100.0, j / 100.0, (100 - i - j) / 100.0};
        const double q =
            b[0] * p[0].position[3] + b[1] * p[1].position[3] + b[2] * p[2].position[3];
        for (int k = 0; k < kAttributes; ++k) {
          double error = 0;
          for (int v = 0; v < 3; ++v) {
            const double share = b[static_cast<std::size_t>(v)];
            error += share * (1 - p[v].position[3] / q) * p[v].attributes[k];
          }
          found = std::max(found, std::abs(error));
        }
      }
    }
    REQUIRE(found <= plan.affine_error());
    closest = std::max(closest, found / plan.affine_error());
    // Just under what was found, the tolerance calls for perspective correction; at the bound not.
    const SceneFacts<double> facts = facts_of(projection, scene);
    CHECK(Plan<double>(facts, {.tolerance = found * 0.999}).effects().perspective());
    CHECK_FALSE(Plan<double>(facts, {.tolerance = plan.affine_error()}).effects().perspective());
  }
  CHECK(closest > 0.99);
}

TEST_CASE("effects: where rounding may take w to nothing the bound is the attribute's range") {
  Frustum<float> frustum;
  frustum.near = 0x1p-10f;
  frustum.far = 0x1p20f;
  const Projection<float> projection{frustum};
  SceneOf<float> scene(1);
  // In front of the eye, the largest w just below and above 1 / 96 of 2^23 times the least.
  const auto bound_for = [&](float ratio) {
    for (int v = 0; v < 3; ++v) {
      scene[0][v].position = Vec3<float>(0, 0, v == 0 ? -1.0f : -ratio);
      for (int k = 0; k < kAttributes; ++k) scene[0][v].attributes[k] = v == 0 ? 0.0f : 1.0f;
    }
    const Plan<float> plan(facts_of(projection, scene), {.tolerance = 0.5f});
    CHECK(plan.effects().perspective());
    return plan.affine_error();
  };
  CHECK(bound_for(0x1p16f) < 1);
  CHECK(bound_for(0x1p17f) >= 1);
  CHECK(bound_for(0x1p17f) < 1.001f);
}

TEST_CASE("effects: a tolerance that is NaN or attributes that are keep perspective correction") {
  const Projection<float> projection{Frustum<float>{}};
  SceneOf<float> scene = {middle_triangle(projection.frustum)};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(Plan<float>(facts_of(projection, scene), {.tolerance = nan}).effects().perspective());
  REQUIRE_FALSE(Plan<float>(facts_of(projection, scene), {.tolerance = 1}).effects().perspective());
  scene[0][2].attributes[3] = nan;
  CHECK(Plan<float>(facts_of(projection, scene), {.tolerance = 1}).effects().perspective());
}

TEST_CASE("effects: what moved since it was planned is clipped by the full pipeline") {
  const Projection<float> projection{Frustum<float>{}};
  SceneOf<float> scene = {middle_triangle(projection.frustum)};
  const Plan<float> plan(facts_of(projection, scene, {.revision = 5}), {});
  REQUIRE_FALSE(plan.effects().has_plane(PlaneEffect::reject));
  scene[0][0].position[0] = -100;
  const Polygons<float> full = fully(projection, scene);
  CHECK(changed(EffectSet(), full, as_planned(plan, scene, 6)) == 0);
  // Had the caller not said so, the plan would be too lean.
  CHECK(changed(EffectSet(), full, as_planned(plan, scene, 5)) == 1);
}

TEST_CASE("effects: facts stop asking where everything is called for, and know nothing then") {
  const Projection<float> projection{Frustum<float>{}};
  SceneOf<float> scene;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float far_away : {-50.0f, 50.0f}) {
      scene.push_back(middle_triangle(projection.frustum));
      scene.back()[0].position[axis] = far_away;
    }
  }
  scene.resize(64, middle_triangle(projection.frustum));
  scene.push_back(middle_triangle(projection.frustum));
  const SceneFacts<float> facts = facts_of(projection, scene);
  CHECK(facts.crossed() == kSixPlanes);
  CHECK(facts.has_bad_w());
  CHECK(facts_hold(facts, scene));
}

TEST_CASE("effects: a group behind the eye is rejected by one plane and cut by none") {
  const Projection<float> projection{Frustum<float>{}};
  SceneOf<float> scene(64, middle_triangle(projection.frustum));
  for (auto& triangle : scene) {
    for (auto& v : triangle) v.position[2] = -v.position[2];
  }
  const Plan<float> plan(facts_of(projection, scene), {});
  CHECK_FALSE(plan.effects().has_plane(PlaneEffect::guard_band));
  CHECK(plan.effects().has_plane(PlaneEffect::reject));
  CHECK_FALSE(plan.effects().interpolation());
  CHECK(changed(plan.effects(), fully(projection, scene), as_planned(plan, scene)) == 0);
}

TEST_CASE("effects: clip distances are planned for where one is negative") {
  Projection<float> projection{Frustum<float>{}};
  projection.volume.clip_distances = 2;
  SceneOf<float> scene = {middle_triangle(projection.frustum)};
  CHECK(Plan<float>(facts_of(projection, scene), {}).effects().user_planes() == PlaneEffect::none);
  scene[0][1].attributes[1] = -std::numeric_limits<float>::denorm_min();
  const Plan<float> plan(facts_of(projection, scene), {});
  CHECK(plan.effects().user_planes() == PlaneEffect::cut);
  CHECK(changed(plan.effects(), fully(projection, scene), as_planned(plan, scene)) == 0);
}

TEST_CASE("effects: what a guard band leaves to the scissor is what the sides would have cut") {
  // x and y up to 3 times, w from 2 to 9: nothing is beyond a band of 4, sides are crossed, near is
  // not. Each way of cutting is off by at most kChainUlps u M / w in x and y, M below 40; the area
  // by that along the polygon's border, at most 8 long, twice.
  constexpr double kTolerance = 2 * 8 * kChainUlps * 0x1p-53 * 40 / 2;
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> side(-3, 3), depth(2, 9);
  const Projection<double> projection{Frustum<double>{}};
  SceneOf<double> scene(500);
  for (auto& triangle : scene) {
    for (auto& v : triangle) {
      const double w = depth(random);
      v = {Vec3<double>(side(random) * w, side(random) * w, -w), {{w, 1, 2, 3}}};
    }
  }
  const SceneFacts<double> facts = facts_of(projection, scene, {.guard_band = 4});
  const Plan<double> plan(facts, {});
  for (const Plane p : {Plane::left, Plane::right, Plane::bottom, Plane::top}) {
    REQUIRE(plan.effects().plane(p) == PlaneEffect::guard_band);
  }
  const auto area = [](const auto& polygon) {
    double sum = 0;
    for (int i = 0; i < polygon.size(); ++i) {
      const auto &a = polygon[i].position, &b = polygon[(i + 1) % polygon.size()].position;
      sum += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
    return std::abs(sum);
  };
  const Polygons<double> full = fully(projection, scene), planned = as_planned(plan, scene);
  int reaching_out = 0;
  for (std::size_t i = 0; i < scene.size(); ++i) {
    NdcPolygon<double, kAttributes> polygon = planned[i], scratch;
    reaching_out += area(polygon) > area(full[i]) + kTolerance;
    const auto& scissored =
        cut_by_planes(polygon, scratch, kSixPlanes & ~bit(Plane::near) & ~bit(Plane::far),
                      kAllPlanes, [](Plane plane, const NdcVertex<double, kAttributes>& v) {
                        return ndc_distance(DepthRange::minus_one_to_one, plane, v.position);
                      });
    REQUIRE(std::abs(area(scissored) - area(full[i])) <= kTolerance);
  }
  CHECK(reaching_out > 100);
  // A band that the scene leaves is no band.
  const Plan<double> narrow(facts_of(projection, scene, {.guard_band = 2}), {});
  CHECK(narrow.effects().plane(Plane::left) == PlaneEffect::cut);
}
