// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounding volumes against a view volume, by hand; exact arithmetic has its say in
// tests/reference/test_bounds_exact.cpp.
#include <cmath>
#include <limits>

#include "spaces/bounds/hierarchy.hpp"
#include "tests/catch.hpp"

using namespace clipscope;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
const float kNan = std::nanf("");

float above(float v) { return std::nextafter(v, kInfinity); }
float below(float v) { return std::nextafter(v, -kInfinity); }

// l = b = -1, r = t = 1, near 1, far 10: at depth -z the sides are at +-z.
CullingPlanes<float> unit_planes() { return culling_planes(Frustum<float>{}); }

Frustum<float> infinite_frustum() {
  Frustum<float> f;
  f.infinite_far = true;
  return f;
}

AxisBox<float> box(float x0, float x1, float y0, float y1, float z0, float z1) {
  return {Vec3<float>(x0, y0, z0), Vec3<float>(x1, y1, z1)};
}

OrientedBox<float> oriented(const AxisBox<float>& b) {
  OrientedBox<float> r;
  r.centre = 0.5f * b.lower + 0.5f * b.upper;
  r.half = 0.5f * b.upper - 0.5f * b.lower;
  return r;
}

}  // namespace

TEST_CASE("bounds: boxes inside, outside and across the planes of a frustum") {
  const auto planes = unit_planes();
  const auto check = [&](const AxisBox<float>& b, Visibility expected) {
    CHECK(visibility(planes, b) == expected);
    CHECK(visibility(planes, oriented(b)) == expected);
  };
  check(box(-1, 1, -1, 1, -4, -2), Visibility::accepted);
  check(box(-1, 1, -1, 1, 1, 2), Visibility::rejected);  // behind the eye
  check(box(-1, 1, -1, 1, -0.5f, 2),
        Visibility::rejected);  // around the eye, before the near plane
  check(box(-1, 1, -1, 1, -20, -11), Visibility::rejected);        // beyond the far plane
  check(box(-9, -5, -1, 1, -4, -2), Visibility::rejected);         // left
  check(box(5, 9, -1, 1, -4, -2), Visibility::rejected);           // right
  check(box(-1, 1, -9, -5, -4, -2), Visibility::rejected);         // below
  check(box(-1, 1, 5, 9, -4, -2), Visibility::rejected);           // above
  check(box(-1, 1, -1, 1, -2, -0.5f), Visibility::look_closer);    // across the near plane
  check(box(-3, 3, -1, 1, -4, -2), Visibility::look_closer);       // across left and right
  check(box(-50, 50, -50, 50, -50, 50), Visibility::look_closer);  // the frustum is inside of it
}

TEST_CASE("bounds: spheres inside, outside and across the planes of a frustum") {
  const auto planes = unit_planes();
  const auto answer = [&](float x, float y, float z, float r) {
    return visibility(planes, Sphere<float>{Vec3<float>(x, y, z), r});
  };
  CHECK(answer(0, 0, -5, 3) == Visibility::accepted);  // the sides are 5 / sqrt 2 = 3.54 away
  CHECK(answer(0, 0, -5, 3.5f) == Visibility::accepted);
  CHECK(answer(0, 0, -5, 3.6f) == Visibility::look_closer);
  CHECK(answer(9, 0, -5, 2.8f) ==
        Visibility::rejected);  // the right side is 4 / sqrt 2 = 2.83 away
  CHECK(answer(9, 0, -5, 2.9f) == Visibility::look_closer);
  CHECK(answer(0, 0, 0, 0.9f) == Visibility::rejected);
  CHECK(answer(0, 0, 0, 100) == Visibility::look_closer);
  CHECK(answer(0, 0, -5, 0) == Visibility::accepted);  // a point
}

TEST_CASE("bounds: a box that touches the frustum is not rejected, one beyond it is") {
  const auto planes = unit_planes();
  const auto at = [&](float z) { return visibility(planes, box(-0.5f, 0.5f, -0.5f, 0.5f, z, 1)); };
  CHECK(at(-1) == Visibility::look_closer);
  CHECK(at(below(-1)) == Visibility::look_closer);
  // The frustum's own box settles this one exactly: no rounding is at work.
  CHECK(at(above(-1)) == Visibility::rejected);
  const auto right_at = [&](float x) { return visibility(planes, box(x, 20, -1, 1, -10, -10)); };
  CHECK(right_at(10) == Visibility::look_closer);
  CHECK(right_at(below(10)) == Visibility::look_closer);
  CHECK(right_at(10.001f) == Visibility::rejected);
}

TEST_CASE("bounds: a box that bare comparisons would reject has a point in the frustum") {
  Frustum<float> f;
  f.kind = ProjectionKind::parallel;
  f.shear_x = 0x1.8ap-3f;
  f.left = -0x1.3ff596p-3f;
  const float x = 0x1.debcccp-2f, z = -0x1.9f0108p+1f;
  REQUIRE(x + f.shear_x * z - f.left == -0x1p-26f);
  REQUIRE(double{x} + double{f.shear_x} * z - f.left > 1e-8);  // exact: it is inside
  CHECK(visibility(culling_planes(f), box(x - 1, x, -0.5f, 0.5f, z, z)) == Visibility::look_closer);
}

TEST_CASE("bounds: a sphere that bare comparisons would reject has a point in the frustum") {
  Frustum<float> f;
  f.left = -0.7f;
  f.right = 0.7f;
  f.near = 0.3f;
  f.far = 100;
  const float x = -0x1.2ff37ep+2f, z = -0x1.4eba8p+0f, radius = 0x1.56879cp-1f;
  const float length = std::sqrt(f.near * f.near + f.left * f.left);
  REQUIRE(f.near * x + f.left * z + length * radius < 0);
  const double exact_length = std::sqrt(double{f.near} * f.near + double{f.left} * f.left);
  REQUIRE(double{f.near} * x + double{f.left} * z + exact_length * radius > 1e-8);
  CHECK(visibility(culling_planes(f), Sphere<float>{Vec3<float>(x, 0, z), radius}) ==
        Visibility::look_closer);
}

TEST_CASE("bounds: an oriented box that bare comparisons would reject has a point in the frustum") {
  Frustum<float> f;
  f.left = -0.7f;
  f.right = 0.7f;
  f.near = 0.3f;
  f.far = 100;
  const float x = -0x1.9ab49p+2f, z = -0x1.389b42p+1f, half = 0x1.5b12bap-2f;
  const Vec3<float> axis(0x1.690eaep-3f, 0, 0x1.f7fb02p-1f);
  const float naive =
      f.near * x + f.left * z + half * std::abs(f.near * axis[0] + f.left * axis[2]);
  REQUIRE(naive < 0);
  const double exact = double{f.near} * x + double{f.left} * z +
                       half * std::abs(double{f.near} * axis[0] + double{f.left} * axis[2]);
  REQUIRE(exact > 1e-9);
  OrientedBox<float> b;
  b.centre = Vec3<float>(x, 0, z);
  b.axes = {axis, Vec3<float>(0, 1, 0), Vec3<float>(axis[2], 0, -axis[0])};
  b.half = Vec3<float>(half, 0, 0);
  CHECK(visibility(culling_planes(f), b) == Visibility::look_closer);
}

TEST_CASE("bounds: a box beside the frustum but outside of no single plane is rejected") {
  // Beyond the frustum's right-most point (10, y, -10), yet its corners straddle right and far
  // plane.
  const AxisBox<float> b = box(10.5f, 30, -5, 5, -25, -5);
  const auto planes = unit_planes();
  CHECK(visibility(planes, b) == Visibility::rejected);
  CullingPlanes<float> planes_only = planes;
  planes_only.reach = CullingPlanes<float>{}.reach;
  CHECK(visibility(planes_only, b) == Visibility::look_closer);
}

TEST_CASE("bounds: nothing is beyond an infinite far plane") {
  const auto planes = culling_planes(infinite_frustum());
  CHECK(planes.count == 5);
  CHECK(visibility(planes, box(-1, 1, -1, 1, -1e30f, -1e29f)) == Visibility::accepted);
  CHECK(visibility(planes, box(-1, 1, -1, 1, 2, 3)) == Visibility::rejected);
}

TEST_CASE("bounds: an oblique parallel frustum leans") {
  Frustum<float> f;
  f.kind = ProjectionKind::parallel;
  f.shear_x = 1;  // -1 <= x + z <= 1: around x = 5 at z = -5
  const auto planes = culling_planes(f);
  CHECK(visibility(planes, box(4.5f, 5.5f, -0.5f, 0.5f, -5.25f, -4.75f)) == Visibility::accepted);
  CHECK(visibility(planes, box(-0.5f, 0.5f, -0.5f, 0.5f, -5.25f, -4.75f)) == Visibility::rejected);
  CHECK(visibility(planes, box(11.5f, 12, -0.5f, 0.5f, -20, -1)) == Visibility::rejected);
}

TEST_CASE("bounds: NaN and infinity in a volume ask for a closer look") {
  const auto planes = unit_planes();
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    for (int i = 0; i < 3; ++i) {
      AxisBox<float> b = box(5, 9, 5, 9, 5, 9);
      b.upper[i] = bad;
      CHECK(visibility(planes, b) == Visibility::look_closer);
      b = box(5, 9, 5, 9, 5, 9);
      b.lower[i] = bad;
      CHECK(visibility(planes, b) == Visibility::look_closer);
      Sphere<float> s{Vec3<float>(0, 0, 9), 1};
      s.centre[i] = bad;
      CHECK(visibility(planes, s) == Visibility::look_closer);
      OrientedBox<float> o = oriented(box(5, 9, 5, 9, 5, 9));
      o.axes[1][i] = bad;
      CHECK(visibility(planes, o) == Visibility::look_closer);
      o = oriented(box(5, 9, 5, 9, 5, 9));
      o.half[i] = bad;
      CHECK(visibility(planes, o) == Visibility::look_closer);
    }
    CHECK(visibility(planes, Sphere<float>{Vec3<float>(0, 0, 9), bad}) == Visibility::look_closer);
  }
}

TEST_CASE("bounds: an overflow asks for a closer look") {
  Frustum<float> f = infinite_frustum();
  f.near = 1e10f;
  const auto planes = culling_planes(f);
  const float most = std::numeric_limits<float>::max();
  CHECK(visibility(planes, box(-most, most, 0, 1, -most, -most)) == Visibility::look_closer);
  CHECK(visibility(planes, Sphere<float>{Vec3<float>(most, 0, -most), most}) ==
        Visibility::look_closer);
}

TEST_CASE("bounds: without finite planes every volume asks for a closer look") {
  Frustum<float> f;
  f.left = kNan;
  f.near = kNan;
  CHECK(visibility(culling_planes(f), box(0, 1, 0, 1, -3, -2)) == Visibility::look_closer);
  CHECK(visibility(CullingPlanes<float>{}, box(0, 1, 0, 1, -3, -2)) == Visibility::look_closer);
}

TEST_CASE("bounds: an empty volume is rejected") {
  const auto planes = unit_planes();
  CHECK(visibility(planes, AxisBox<float>{}) == Visibility::rejected);
  CHECK(visibility(planes, Sphere<float>{}) == Visibility::rejected);
  CHECK(visibility(planes, OrientedBox<float>{}) == Visibility::rejected);
  CHECK(is_empty(bounding_box<float>({})));
  CHECK(is_empty(bounding_sphere<float>({})));
  CHECK(is_empty(bounding_oriented_box<float>({})));
}

TEST_CASE(
    "bounds: planes of a matrix, of a projection and of a frustum agree away from the planes") {
  for (const DepthRange depth :
       {DepthRange::minus_one_to_one, DepthRange::zero_to_one, DepthRange::reversed}) {
    Frustum<float> f;
    f.depth = depth;
    const Projection<float> p(f);
    glm::mat<4, 4, float, glm::defaultp> m(0.0f);
    m[0] = Vec4<float>(p.x.own, 0, 0, 0);
    m[1] = Vec4<float>(0, p.y.own, 0, 0);
    m[2] = Vec4<float>(p.x.z, p.y.z, p.z.z, p.w.z);
    m[3] = Vec4<float>(p.x.one, p.y.one, p.z.one, p.w.one);
    for (const auto& planes : {culling_planes(p), culling_planes(depth, m)}) {
      CHECK(planes.count == 6);
      CHECK(visibility(planes, box(-1, 1, -1, 1, -4, -2)) == Visibility::accepted);
      CHECK(visibility(planes, box(-1, 1, -1, 1, -20, -11)) == Visibility::rejected);
      CHECK(visibility(planes, box(-1, 1, -1, 1, -0.5f, 2)) == Visibility::rejected);
      CHECK(visibility(planes, box(5, 9, -1, 1, -4, -2)) == Visibility::rejected);
      CHECK(visibility(planes, box(-1, 1, -1, 1, -2, -0.5f)) == Visibility::look_closer);
    }
  }
}

TEST_CASE("bounds: a length is rounded up, also of vectors whose squares underflow or overflow") {
  CHECK(length_above(Vec3<float>(3, 4, 0)) >= 5.0f);
  CHECK(length_above(Vec3<float>(3, 4, 0)) < 5.00001f);
  CHECK(length_above(Vec3<float>(3e-30f, 4e-30f, 0)) >= 5e-30f);
  CHECK(length_above(Vec3<float>(3e-30f, 4e-30f, 0)) < 5.00001e-30f);
  CHECK(length_above(Vec3<float>(3e30f, 0, -4e30f)) >= 5e30f);
  CHECK(length_above(Vec3<float>(3e30f, 0, -4e30f)) < 5.00001e30f);
  CHECK(length_above(Vec3<float>(0, 0, 0)) == 0.0f);
}

TEST_CASE("bounds: the volumes of some points") {
  const std::array<Vec3<float>, 4> points = {Vec3<float>(0, 0, 0), Vec3<float>(2, 2, 0),
                                             Vec3<float>(1, 1, 0), Vec3<float>(0, 0, 0)};
  const auto b = bounding_box<float>(points);
  CHECK(b.lower == Vec3<float>(0, 0, 0));
  CHECK(b.upper == Vec3<float>(2, 2, 0));
  const auto s = bounding_sphere<float>(points);
  CHECK(s.radius >= std::sqrt(2.0f));
  CHECK(s.radius < 1.4143f);
  // Along the diagonal, and next to flat.
  const auto o = bounding_oriented_box<float>(points);
  CHECK(o.half[0] >= 1.4142f);
  CHECK(o.half[0] < 1.4145f);
  CHECK(o.half[1] < 1e-4f);
  CHECK(o.half[2] < 1e-4f);
}

TEST_CASE("bounds: axes that are far from perpendicular are not used") {
  const std::array<Vec3<float>, 2> points = {Vec3<float>(0, 0, 0), Vec3<float>(2, 2, 2)};
  const Vec3<float> x(1, 0, 0), z(0, 0, 1), nan(kNan, 0, 0);
  CHECK(bounding_oriented_box<float>(points, {x, x, z}).axes[1] == Vec3<float>(0, 1, 0));
  CHECK(bounding_oriented_box<float>(points, {x, nan, z}).axes[1] == Vec3<float>(0, 1, 0));
}

TEST_CASE("bounds: points that aren't finite or overflow make a volume of infinite size") {
  const auto planes = unit_planes();
  for (const Vec3<float> bad : {Vec3<float>(kNan, 9, 9), Vec3<float>(9, kInfinity, 9)}) {
    const std::array<Vec3<float>, 2> points = {Vec3<float>(9, 9, 9), bad};
    CHECK(visibility(planes, bounding_box<float>(points)) == Visibility::look_closer);
    CHECK(visibility(planes, bounding_sphere<float>(points)) == Visibility::look_closer);
    CHECK(visibility(planes, bounding_oriented_box<float>(points)) == Visibility::look_closer);
  }
  const float most = std::numeric_limits<float>::max();
  const std::array<Vec3<float>, 2> far_apart = {Vec3<float>(most, most, 9),
                                                Vec3<float>(-most, -most, 9)};
  CHECK(bounding_sphere<float>(far_apart).radius == kInfinity);
  CHECK(bounding_oriented_box<float>(far_apart).half[0] == kInfinity);
}

namespace {

// A row of unit squares at z = -5, two triangles each, from x = first to x = last.
struct Strip {
  std::vector<Vec3<float>> positions;
  std::vector<std::uint32_t> indices;
};

Strip strip(int first, int last) {
  Strip r;
  for (int x = first; x < last; ++x) {
    const auto base = static_cast<std::uint32_t>(r.positions.size());
    const auto left = static_cast<float>(x);
    for (const float y : {0.0f, 1.0f}) {
      r.positions.emplace_back(left, y, -5.0f);
      r.positions.emplace_back(left + 1, y, -5.0f);
    }
    for (const std::uint32_t i : {0u, 1u, 3u, 0u, 3u, 2u}) r.indices.push_back(base + i);
  }
  return r;
}

struct Answers {
  std::vector<Visibility> of_triangle;
  std::uint32_t seen = 0;
  bool in_order = true;
};

template <class Volume>
Answers answers(const Hierarchy<float, Volume>& hierarchy, const CullingPlanes<float>& planes) {
  Answers r;
  r.of_triangle.resize(hierarchy.order().size());
  hierarchy.query(planes, [&](TriangleRange range, Visibility answer) {
    r.in_order = r.in_order && range.first == r.seen && range.count > 0;
    r.seen += range.count;
    for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
      r.of_triangle[hierarchy.order()[i]] = answer;
    }
  });
  return r;
}

}  // namespace

TEMPLATE_TEST_CASE("bounds: a hierarchy reports every triangle once, in order", "", AxisBox<float>,
                   Sphere<float>, OrientedBox<float>) {
  const Strip s = strip(-64, 64);
  const Hierarchy<float, TestType> hierarchy(s.positions, s.indices, 2);
  const Answers r = answers(hierarchy, unit_planes());
  CHECK(r.seen == 256);
  CHECK(r.in_order);
  for (int x = -64; x < 64; ++x) {
    const Visibility answer = r.of_triangle[static_cast<std::size_t>(2 * (x + 64))];
    // The sides are at x = +-5; a sphere around a square reaches 0.21 beyond it.
    if (x < -6 || x >= 6) CHECK(answer == Visibility::rejected);
    if (x >= -4 && x < 4) CHECK(answer == Visibility::accepted);
    if (x == -5 || x == 4) CHECK(answer == Visibility::look_closer);
  }
}

TEST_CASE("bounds: a hierarchy answers for a whole subtree at once") {
  const Strip s = strip(1000, 2000);
  const BoxHierarchy<float> hierarchy(s.positions, s.indices);
  int reports = 0;
  hierarchy.query(unit_planes(), [&](TriangleRange range, Visibility answer) {
    ++reports;
    CHECK(range.count == 2000);
    CHECK(answer == Visibility::rejected);
  });
  CHECK(reports == 1);
}

TEST_CASE("bounds: a hierarchy's nodes contain their children and end in leaves") {
  const Strip s = strip(-20, 17);
  const BoxHierarchy<float> hierarchy(s.positions, s.indices, 3);
  const auto& nodes = hierarchy.nodes();
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    CHECK(nodes[i].level < BoxHierarchy<float>::kMaxLevels);
    if (nodes[i].next == i + 1) {
      CHECK(nodes[i].range.count <= 3);
      continue;
    }
    const auto &left = nodes[i + 1], &right = nodes[left.next];
    CHECK(right.next == nodes[i].next);
    CHECK(left.range.first == nodes[i].range.first);
    CHECK(right.range.first == left.range.first + left.range.count);
    CHECK(left.range.count + right.range.count == nodes[i].range.count);
    const auto both = enclose(left.volume, right.volume);
    CHECK(both.lower == nodes[i].volume.lower);
    CHECK(both.upper == nodes[i].volume.upper);
  }
}

TEMPLATE_TEST_CASE(
    "bounds: a triangle that isn't finite gets a closer look, others are judged as before", "",
    AxisBox<float>, Sphere<float>, OrientedBox<float>) {
  Strip s = strip(-100, 100);
  s.positions[0][1] = kNan;
  const Hierarchy<float, TestType> hierarchy(s.positions, s.indices, 2);
  const Answers r = answers(hierarchy, unit_planes());
  CHECK(r.seen == 400);
  CHECK(r.of_triangle[0] == Visibility::look_closer);
  CHECK(r.of_triangle[10] == Visibility::rejected);
  CHECK(r.of_triangle[200] == Visibility::accepted);
}

TEST_CASE("bounds: hierarchies of every kind have the same tree") {
  const Strip s = strip(-50, 70);
  const BoxHierarchy<float> boxes(s.positions, s.indices, 3);
  const OrientedBoxHierarchy<float> oriented_boxes(s.positions, s.indices, 3);
  CHECK(boxes.order() == oriented_boxes.order());
  CHECK(boxes.order() == SphereHierarchy<float>(s.positions, s.indices, 3).order());
  REQUIRE(boxes.nodes().size() == oriented_boxes.nodes().size());
  for (std::size_t i = 0; i < boxes.nodes().size(); ++i) {
    CHECK(boxes.nodes()[i].range.first == oriented_boxes.nodes()[i].range.first);
    CHECK(boxes.nodes()[i].next == oriented_boxes.nodes()[i].next);
  }
}

TEST_CASE("bounds: hierarchies of no triangle, of one and of equal ones") {
  CHECK(answers(BoxHierarchy<float>{}, unit_planes()).seen == 0);
  CHECK(answers(BoxHierarchy<float>({}, {}), unit_planes()).seen == 0);
  const Strip one = strip(0, 1);
  const std::vector<std::uint32_t> same = {0, 1, 3, 0, 1, 3, 0, 1, 3, 0, 1, 3, 0, 1, 3};
  const Answers r = answers(BoxHierarchy<float>(one.positions, same, 1), unit_planes());
  CHECK(r.seen == 5);
  CHECK(r.of_triangle[3] == Visibility::accepted);
}
