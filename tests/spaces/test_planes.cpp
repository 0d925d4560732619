// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/contestants/scalars.hpp"
#include "spaces/planes.hpp"
#include "tests/catch.hpp"

#include <cmath>
#include <random>

using namespace clipscope;
using experiments::Exact;

namespace {

int sign(const Exact& x) { return x < Exact(0) ? -1 : (Exact(0) < x ? 1 : 0); }

}  // namespace

TEST_CASE("planes: view-space and clip-space forms agree in sign on every exact point") {
  std::mt19937_64 random(7);
  for (const DepthRange depth :
       {DepthRange::minus_one_to_one, DepthRange::zero_to_one, DepthRange::reversed}) {
    for (const ProjectionKind kind : {ProjectionKind::perspective, ProjectionKind::parallel}) {
      Frustum<Exact> f;
      f.kind = kind;
      f.depth = depth;
      f.left = Exact(-2);
      if (kind == ProjectionKind::parallel) f.shear_x = Exact(Exact(1) / Exact(2));
      const Projection<Exact> projection(f);
      for (int n = 0; n < 300; ++n) {
        const auto coordinate = [&] { return Exact(static_cast<int>(random() % 25) - 12); };
        const Exact x = coordinate(), y = coordinate(), z = coordinate();
        const Vec3<Exact> v(x, y, z);
        const Vec4<Exact> c = to_clip(projection, v);
        for (const Plane plane : kAllPlanes) {
          CHECK(sign(view_distance(f, plane, v)) == sign(clip_distance(depth, plane, c)));
        }
      }
    }
  }
}

TEST_CASE("planes: an outcode has the bits of the planes with a negative distance") {
  std::mt19937_64 random(8);
  for (const DepthRange depth :
       {DepthRange::minus_one_to_one, DepthRange::zero_to_one, DepthRange::reversed}) {
    for (int n = 0; n < 1000; ++n) {
      const auto coordinate = [&] { return static_cast<float>(random() % 9) - 4.0f; };
      const float x = coordinate(), y = coordinate(), z = coordinate(), w = coordinate();
      const Vec4<float> v(x, y, z, w);
      Outcode expected = 0;
      for (const Plane plane : kAllPlanes) {
        if (clip_distance(depth, plane, v) < 0) expected |= bit(plane);
      }
      CHECK(clip_outcode(depth, v) == expected);
    }
  }
}

TEST_CASE("planes: the volume is closed, one ulp beyond it is outside") {
  const float beyond = std::nextafter(1.0f, 2.0f);
  const auto code = [](float x, float y, float z) {
    return clip_outcode(DepthRange::minus_one_to_one, Vec4<float>(x, y, z, 1.0f));
  };
  CHECK(code(1, 1, 1) == 0);
  CHECK(code(-1, -1, -1) == 0);
  CHECK(code(beyond, 0, 0) == bit(Plane::right));
  CHECK(code(0, -beyond, 0) == bit(Plane::bottom));
  CHECK(code(0, 0, -beyond) == bit(Plane::near));
}

TEST_CASE("planes: a NaN coordinate is outside") {
  const float nan = std::nanf("");
  CHECK((clip_outcode(DepthRange::zero_to_one, Vec4<float>(nan, 0, 0, 1)) & bit(Plane::left)) != 0);
  CHECK((clip_outcode(DepthRange::zero_to_one, Vec4<float>(0, 0, nan, 1)) & bit(Plane::near)) != 0);
  CHECK(clip_outcode(DepthRange::zero_to_one, Vec4<float>(0, 0, 0, nan)) != 0);
}
