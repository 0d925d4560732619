// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounding volumes against exact arithmetic: every answer over random volumes.
#ifdef __SSE__
#include <xmmintrin.h>
#endif

#include <cfenv>
#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "reference/exact_clip.hpp"
#include "spaces/bounds/hierarchy.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/volumes.hpp"

using namespace clipscope;
using namespace clipscope::reference;

namespace {

// Whether the frustum and the box are exactly disjoint along x (axis 0) or y (axis 1).
template <class T>
bool is_beside(const Frustum<T>& f, const AxisBox<T>& box, int axis) {
  const Dyadic low = double{axis == 0 ? f.left : f.bottom},
               high = double{axis == 0 ? f.right : f.top};
  const Dyadic near = double{f.near}, far = double{f.far};
  const Dyadic lower = double{box.lower[axis]}, upper = double{box.upper[axis]};
  if (f.kind == ProjectionKind::parallel) {
    const Dyadic shear = double{axis == 0 ? f.shear_x : f.shear_y};
    const Dyadic a = shear * near, b = shear * far;
    return (lower > high + a && lower > high + b) || (upper < low + a && upper < low + b);
  }
  const bool beyond_high =
      lower > high && (f.infinite_far ? high.sign() <= 0 : lower * near > high * far);
  const bool beyond_low =
      upper < low && (f.infinite_far ? low.sign() >= 0 : upper * near < low * far);
  return beyond_high || beyond_low;
}
template <class T, class Volume>
bool is_beside(const Frustum<T>&, const Volume&, int) {
  return false;
}

struct Tally {
  long volumes = 0, rejected = 0, accepted = 0, beside = 0;
  long wrong = 0;      // a promise broken
  long unsettled = 0;  // look_closer, where the same planes settle it in exact arithmetic
  long random = 0, random_unsettled = 0;  // those not made to graze a plane
};

template <class T, class Volume>
void hold(const Frustum<T>& f, const CullingPlanes<T>& planes, const Truth& truth,
          const Volume& volume, bool grazing, Tally& tally) {
  const Visibility answer = visibility(planes, volume);
  const Visibility exact = exact_answer(truth, volume);
  ++tally.volumes;
  tally.random += grazing ? 0 : 1;
  if (answer == Visibility::look_closer) {
    tally.unsettled += exact != answer ? 1 : 0;
    tally.random_unsettled += exact != answer && !grazing ? 1 : 0;
    return;
  }
  tally.accepted += answer == Visibility::accepted ? 1 : 0;
  tally.rejected += answer == Visibility::rejected ? 1 : 0;
  if (answer == exact) return;
  const bool beside =
      answer == Visibility::rejected && (is_beside(f, volume, 0) || is_beside(f, volume, 1));
  tally.beside += beside ? 1 : 0;
  tally.wrong += beside ? 0 : 1;
}

template <class T, class Volume>
Tally tally_of(std::uint64_t seed, int frusta, int volumes_each) {
  Random random(seed);
  Tally tally;
  for (int n = 0; n < frusta; ++n) {
    const Frustum<T> f = random_frustum<T>(random);
    const Truth truth = Truth::of_frustum(frustum_cast<double>(f));
    const CullingPlanes<T> planes = culling_planes(f);
    for (int i = 0; i < volumes_each; ++i) {
      const Place<T> place = random_place(random, planes, f);
      hold(f, planes, truth, make(random, place, static_cast<Volume*>(nullptr)), place.grazing,
           tally);
    }
  }
  return tally;
}

std::string report(const Tally& t) {
  std::ostringstream out;
  out << t.volumes << " volumes, " << t.rejected << " rejected (" << t.beside
      << " by the frustum's own box alone), " << t.accepted << " accepted; look_closer where exact "
      << "arithmetic needs not: " << t.unsettled << ", of " << t.random
      << " not made to graze a plane " << t.random_unsettled;
  return out.str();
}

template <class T, class Volume>
void check_conservative(std::uint64_t seed) {
  const Tally tally = tally_of<T, Volume>(seed, 5000, 100);
  INFO(report(tally));
  CHECK(tally.wrong == 0);
  CHECK(tally.rejected > tally.volumes / 20);
  CHECK(tally.accepted > tally.volumes / 100);
  CHECK(tally.random_unsettled * 1000 < tally.random);
}

// Points of a volume that T can represent: the corners and some within.
template <class T>
Vec3<T> point_of(Random& random, const AxisBox<T>& box) {
  Vec3<T> r;
  for (int i = 0; i < 3; ++i) {
    const T t = static_cast<T>(uniform(random, 0, 1));
    const T within =
        std::clamp(box.lower[i] + t * (box.upper[i] - box.lower[i]), box.lower[i], box.upper[i]);
    const auto choice = random() % 4;
    r[i] = choice == 0 ? within : (choice % 2 == 0 ? box.lower[i] : box.upper[i]);
  }
  return r;
}

template <class T>
Vec3<T> point_of(Random& random, const Sphere<T>& sphere) {
  Vec3<T> direction;
  for (int i = 0; i < 3; ++i) direction[i] = static_cast<T>(uniform(random, -1, 1));
  constexpr T shrink = T(1) - 16 * std::numeric_limits<T>::epsilon();
  return sphere.centre + sphere.radius / length_above(direction) * shrink * direction;
}

template <class T>
Vec3<T> point_of(Random& random, const OrientedBox<T>& box) {
  constexpr T shrink = T(1) - 16 * std::numeric_limits<T>::epsilon();
  Vec3<T> r = box.centre;
  for (int i = 0; i < 3; ++i) {
    r += static_cast<T>(sign_of(random)) * shrink * box.half[i] *
         box.axes[static_cast<std::size_t>(i)];
  }
  return r;
}

// One clip coordinate in each of the ways that compilers and libraries sum.
template <class T>
T row_times(int way, const Vec4<T>& row, const Vec3<T>& p) {
  switch (way) {
    case 0: return row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
    case 1: return row[3] + (row[2] * p[2] + (row[1] * p[1] + row[0] * p[0]));
    case 2: return (row[0] * p[0] + row[1] * p[1]) + (row[2] * p[2] + row[3]);
    default: return std::fma(row[0], p[0], std::fma(row[1], p[1], std::fma(row[2], p[2], row[3])));
  }
}

// A projection after a rotation and a shift: what a renderer has for a mesh.
template <class T>
std::array<Vec4<T>, 4> random_matrix(Random& random, const Frustum<T>& f) {
  const Projection<T> p(f);
  glm::mat<4, 4, T, glm::defaultp> clip(T(0)), view(T(1));
  clip[0] = Vec4<T>(p.x.own, T(0), T(0), T(0));
  clip[1] = Vec4<T>(T(0), p.y.own, T(0), T(0));
  clip[2] = Vec4<T>(p.x.z, p.y.z, p.z.z, p.w.z);
  clip[3] = Vec4<T>(p.x.one, p.y.one, p.z.one, p.w.one);
  if (random() % 2 == 0) {
    const double angle = uniform(random, -0.5, 0.5);
    view[0][0] = view[2][2] = static_cast<T>(std::cos(angle));
    view[0][2] = static_cast<T>(std::sin(angle));
    view[2][0] = -view[0][2];
    view[3][0] = static_cast<T>(uniform(random, -1, 1) * f.near);
  }
  const auto m = clip * view;
  std::array<Vec4<T>, 4> rows;
  for (int i = 0; i < 4; ++i) {
    rows[static_cast<std::size_t>(i)] = Vec4<T>(m[0][i], m[1][i], m[2][i], m[3][i]);
  }
  return rows;
}

struct ClipTally {
  long rejected = 0, accepted = 0, wrong = 0;
};

// Whether points of a volume get the outcodes that an answer promises, however they are
// transformed.
template <class T, class Volume>
bool keeps_outcodes(Random& random, DepthRange depth, const std::array<Vec4<T>, 4>& rows,
                    const Volume& volume, Visibility answer) {
  Outcode all = ~Outcode{0}, any = 0;
  bool in_front = true;
  for (int n = 0; n < 8; ++n) {
    const Vec3<T> p = point_of(random, volume);
    const int way = static_cast<int>(random() % 4);
    const Vec4<T> clip(row_times(way, rows[0], p), row_times(way, rows[1], p),
                       row_times(way, rows[2], p), row_times(way, rows[3], p));
    all &= clip_outcode(depth, clip);
    any |= clip_outcode(depth, clip);
    in_front = in_front && clip[3] > T(0);
  }
  return answer == Visibility::rejected ? all != 0 : any == 0 && in_front;
}

template <class T, class Volume>
void check_outcodes(std::uint64_t seed) {
  Random random(seed);
  ClipTally tally;
  for (int n = 0; n < 1000; ++n) {
    const Frustum<T> f = random_frustum<T>(random);
    const std::array<Vec4<T>, 4> rows = random_matrix(random, f);
    const CullingPlanes<T> planes = culling_planes(f.depth, rows);
    for (int i = 0; i < 100; ++i) {
      const Place<T> place = random_place(random, planes, f);
      const Volume volume = make(random, place, static_cast<Volume*>(nullptr));
      const Visibility answer = visibility(planes, volume);
      if (answer == Visibility::look_closer) continue;
      ++(answer == Visibility::rejected ? tally.rejected : tally.accepted);
      tally.wrong += keeps_outcodes(random, f.depth, rows, volume, answer) ? 0 : 1;
    }
  }
  INFO(tally.rejected << " rejected, " << tally.accepted << " accepted");
  CHECK(tally.wrong == 0);
  CHECK(tally.rejected > 20000);
  CHECK(tally.accepted > 500);
}

std::vector<InputTriangle> faces(const std::array<InputVertex, 8>& corners) {
  constexpr int kQuads[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  std::vector<InputTriangle> r;
  for (const auto& q : kQuads) {
    const auto at = [&](int i) { return corners[static_cast<std::size_t>(q[i])]; };
    r.push_back({{at(0), at(1), at(2)}, 0});
    r.push_back({{at(0), at(2), at(3)}, 0});
  }
  return r;
}

template <class T>
std::array<InputVertex, 8> corners_of(const AxisBox<T>& box) {
  std::array<InputVertex, 8> r;
  for (std::size_t i = 0; i < 8; ++i) {
    r[i] = input(Vec3<T>((i & 1) != 0 ? box.upper[0] : box.lower[0],
                         (i & 2) != 0 ? box.upper[1] : box.lower[1],
                         (i & 4) != 0 ? box.upper[2] : box.lower[2]));
  }
  return r;
}

// Whether a box has a point in the volume: a face has, or the whole volume is inside of the box and
// hence the middle of the near plane.
template <class T>
bool is_visible(const Truth& truth, const Frustum<T>& f, const AxisBox<T>& box) {
  for (const InputTriangle& face : faces(corners_of(box))) {
    if (!clip(truth, face).vertices.empty()) return true;
  }
  const double shear_x = double{f.shear_x} * f.near, shear_y = double{f.shear_y} * f.near;
  const double x = (double{f.left} + f.right) / 2 + shear_x,
               y = (double{f.bottom} + f.top) / 2 + shear_y;
  return box.lower[0] <= x && x <= box.upper[0] && box.lower[1] <= y && y <= box.upper[1] &&
         box.lower[2] <= -f.near && -f.near <= box.upper[2];
}

struct RoundingMode {
  explicit RoundingMode(int mode) : saved(std::fegetround()) { std::fesetround(mode); }
  ~RoundingMode() { std::fesetround(saved); }
  int saved;
};

}  // namespace

TEMPLATE_TEST_CASE("bounds: no box of half a million gets an answer that exact arithmetic denies",
                   "", float, double) {
  check_conservative<TestType, AxisBox<TestType>>(1);
}

TEMPLATE_TEST_CASE(
    "bounds: no sphere of half a million gets an answer that exact arithmetic denies", "", float,
    double) {
  check_conservative<TestType, Sphere<TestType>>(2);
}

TEMPLATE_TEST_CASE(
    "bounds: no oriented box of half a million gets an answer that exact arithmetic denies", "",
    float, double) {
  check_conservative<TestType, OrientedBox<TestType>>(3);
}

TEMPLATE_TEST_CASE("bounds: with a matrix's planes the answers foretell every outcode", "", float,
                   double) {
  check_outcodes<TestType, AxisBox<TestType>>(4);
  check_outcodes<TestType, Sphere<TestType>>(5);
  check_outcodes<TestType, OrientedBox<TestType>>(6);
}

TEMPLATE_TEST_CASE("bounds: with a projection's planes the answers are true of its exact matrix",
                   "", float, double) {
  Random random(7);
  long wrong = 0, settled = 0;
  for (int n = 0; n < 1000; ++n) {
    const Frustum<TestType> f = random_frustum<TestType>(random);
    const Projection<TestType> projection(f);
    const Truth truth = Truth::of_matrix(projection);
    const CullingPlanes<TestType> planes = culling_planes(projection);
    for (int i = 0; i < 100; ++i) {
      const Place<TestType> place = random_place(random, planes, f);
      const auto box = make(random, place, static_cast<AxisBox<TestType>*>(nullptr));
      const Visibility answer = visibility(planes, box);
      if (answer == Visibility::look_closer) continue;
      ++settled;
      wrong += answer != exact_answer(truth, box) ? 1 : 0;
    }
  }
  CHECK(wrong == 0);
  CHECK(settled > 50000);
}

TEMPLATE_TEST_CASE("bounds: no rounding mode breaks a promise", "", float, double) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    Random random(8);
    long wrong = 0;
    for (int n = 0; n < 300; ++n) {
      const Frustum<TestType> f = random_frustum<TestType>(random);
      const Truth truth = Truth::of_frustum(frustum_cast<double>(f));
      CullingPlanes<TestType> planes;
      {
        const RoundingMode rounding(mode);
        planes = culling_planes(f);
      }
      for (int i = 0; i < 100; ++i) {
        const Place<TestType> place = random_place(random, planes, f);
        const auto box = make(random, place, static_cast<OrientedBox<TestType>*>(nullptr));
        Visibility answer;
        {
          const RoundingMode rounding(mode);
          answer = visibility(planes, box);
        }
        wrong += answer != Visibility::look_closer && answer != exact_answer(truth, box) ? 1 : 0;
      }
    }
    CHECK(wrong == 0);
  }
}

#ifdef __SSE__
TEMPLATE_TEST_CASE("bounds: no promise breaks where results underflow and are flushed to zero", "",
                   float, double) {
  using T = TestType;
  constexpr int kExponent = std::numeric_limits<T>::min_exponent;
  Random random(12);
  long wrong = 0, settled = 0;
  for (int n = 0; n < 600; ++n) {
    Frustum<T> f = random_frustum<T>(random);
    const Place<T> unscaled = random_place(random, culling_planes(f), f);
    // Parallel: around the smallest normal number. Perspective: products of two are.
    const int shift = f.kind == ProjectionKind::parallel ? kExponent + 4 : kExponent / 2;
    for (T* v : {&f.left, &f.right, &f.bottom, &f.top, &f.near, &f.far}) *v = std::ldexp(*v, shift);
    const Truth truth = Truth::of_frustum(frustum_cast<double>(f));
    const CullingPlanes<T> planes = culling_planes(f);
    for (int i = 0; i < 100; ++i) {
      OrientedBox<T> box = make(random, unscaled, static_cast<OrientedBox<T>*>(nullptr));
      for (int c = 0; c < 3; ++c) {
        box.centre[c] = std::ldexp(box.centre[c], shift);
        box.half[c] = std::ldexp(box.half[c], shift);
      }
      _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
      const Visibility answer = visibility(planes, box);
      _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_OFF);
      if (answer == Visibility::look_closer) continue;
      ++settled;
      wrong += answer != exact_answer(truth, box) ? 1 : 0;
    }
  }
  CHECK(wrong == 0);
  CHECK(settled > 1000);
}
#endif

TEMPLATE_TEST_CASE(
    "bounds: a hierarchy rejects no triangle that is visible and accepts none that is cut", "",
    AxisBox<float>, Sphere<float>, OrientedBox<float>) {
  Random random(10);
  long rejected = 0, accepted = 0, wrong = 0;
  for (int n = 0; n < 60; ++n) {
    const Frustum<float> f = random_frustum<float>(random);
    const Truth truth = Truth::of_frustum(frustum_cast<double>(f));
    const CullingPlanes<float> planes = culling_planes(f);
    std::vector<Vec3<float>> positions;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < 900; ++i) {
      const Place<float> place = random_place(random, planes, f);
      const Vec3<float> base = i % 3 == 0 ? place.point : positions[i - i % 3];
      const float size = i % 3 == 0 ? 0.0f : 0.1f * place.size;
      positions.push_back(base + size * place.outwards);
      indices.push_back(i);
    }
    const Hierarchy<float, TestType> hierarchy(positions, indices, 2);
    std::uint32_t seen = 0;
    hierarchy.query(planes, [&](TriangleRange range, Visibility answer) {
      wrong += range.first != seen ? 1 : 0;
      seen += range.count;
      for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
        const std::uint32_t t = 3 * hierarchy.order()[i];
        const InputTriangle triangle{
            {input(positions[t]), input(positions[t + 1]), input(positions[t + 2])}, 0};
        const Verdict verdict = clip(truth, triangle).verdict;
        rejected += answer == Visibility::rejected ? 1 : 0;
        accepted += answer == Visibility::accepted ? 1 : 0;
        wrong += answer == Visibility::rejected && verdict != Verdict::rejected ? 1 : 0;
        wrong += answer == Visibility::accepted && verdict != Verdict::accepted ? 1 : 0;
      }
    });
    CHECK(seen == 300);
  }
  CHECK(wrong == 0);
  CHECK(rejected > 5000);
  CHECK(accepted > 100);
}

// How much is left to look at: boxes that have no point in the frustum, yet are not rejected.
TEST_CASE("bounds: few invisible boxes need a closer look") {
  Random random(11);
  long looked_at = 0, invisible = 0, boxes = 0;
  for (int n = 0; n < 500; ++n) {
    const Frustum<float> f = random_frustum<float>(random);
    const Truth truth = Truth::of_frustum(frustum_cast<double>(f));
    const CullingPlanes<float> planes = culling_planes(f);
    for (int i = 0; i < 40; ++i) {
      Place<float> place = random_place(random, planes, f);
      place.grazing = false;
      const auto box = make(random, place, static_cast<AxisBox<float>*>(nullptr));
      ++boxes;
      if (visibility(planes, box) != Visibility::look_closer) continue;
      ++looked_at;
      invisible += is_visible(truth, f, box) ? 0 : 1;
    }
  }
  INFO(boxes << " boxes, " << looked_at << " look_closer, " << invisible << " of them invisible");
  CHECK(invisible * 50 < boxes);
}
