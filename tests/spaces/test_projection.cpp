// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/contestants/scalars.hpp"
#include "spaces/projection.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using experiments::Exact;

namespace {

// left = bottom = -1, right = top = 1, near 1, far 10.
Frustum<Exact> frustum(ProjectionKind kind, DepthRange depth, bool infinite_far = false) {
  Frustum<Exact> f;
  f.kind = kind;
  f.depth = depth;
  f.infinite_far = infinite_far;
  return f;
}

Vec4<Exact> clip(const Frustum<Exact>& f, int x, int y, int z) {
  return to_clip(Projection<Exact>(f), Vec3<Exact>(Exact(x), Exact(y), Exact(z)));
}

Exact ratio(int a, int b) { return Exact(Exact(a) / Exact(b)); }

void check(const Vec4<Exact>& v, const Exact& x, const Exact& y, const Exact& z, const Exact& w) {
  CHECK(v[0] == x);
  CHECK(v[1] == y);
  CHECK(v[2] == z);
  CHECK(v[3] == w);
}

constexpr auto kPerspective = ProjectionKind::perspective;
constexpr auto kParallel = ProjectionKind::parallel;

}  // namespace

TEST_CASE("projection: (1,1,0) has the clip coordinates (1,1,-20/9,0)") {
  const auto f = frustum(kPerspective, DepthRange::minus_one_to_one);
  check(clip(f, 1, 1, 0), Exact(1), Exact(1), ratio(-20, 9), Exact(0));
}

TEST_CASE("projection: near and far go to the ends of the depth range") {
  struct Case {
    DepthRange depth;
    int near_depth, far_depth;
  };
  for (const Case& c : {Case{DepthRange::minus_one_to_one, -1, 1},
                        Case{DepthRange::zero_to_one, 0, 1}, Case{DepthRange::reversed, 1, 0}}) {
    for (const ProjectionKind kind : {kPerspective, kParallel}) {
      const auto f = frustum(kind, c.depth);
      const Vec4<Exact> near = to_ndc(clip(f, 0, 0, -1));
      const Vec4<Exact> far = to_ndc(clip(f, 0, 0, -10));
      CHECK(near[2] == Exact(c.near_depth));
      CHECK(far[2] == Exact(c.far_depth));
    }
  }
}

TEST_CASE("projection: with the far plane at infinity depth only approaches its end") {
  const auto gl = frustum(kPerspective, DepthRange::minus_one_to_one, true);
  check(clip(gl, 0, 0, -4), Exact(0), Exact(0), Exact(2), Exact(4));
  const auto zero_to_one = frustum(kPerspective, DepthRange::zero_to_one, true);
  check(clip(zero_to_one, 0, 0, -4), Exact(0), Exact(0), Exact(3), Exact(4));
  const auto reversed = frustum(kPerspective, DepthRange::reversed, true);
  check(clip(reversed, 0, 0, -4), Exact(0), Exact(0), Exact(1), Exact(4));
}

TEST_CASE("projection: an off-centre frustum sends its own edges to -1 and 1") {
  auto f = frustum(kPerspective, DepthRange::zero_to_one);
  f.left = Exact(-1);
  f.right = Exact(3);
  f.bottom = Exact(0);
  f.top = Exact(2);
  const Vec4<Exact> low = to_ndc(clip(f, -2, 0, -2));
  const Vec4<Exact> high = to_ndc(clip(f, 6, 4, -2));
  CHECK(low[0] == Exact(-1));
  CHECK(low[1] == Exact(-1));
  CHECK(high[0] == Exact(1));
  CHECK(high[1] == Exact(1));
}

TEST_CASE("projection: an orthographic one has w = 1 and ignores depth in x and y") {
  const auto f = frustum(kParallel, DepthRange::minus_one_to_one);
  check(clip(f, 1, -1, -1), Exact(1), Exact(-1), Exact(-1), Exact(1));
  check(clip(f, 1, -1, -10), Exact(1), Exact(-1), Exact(1), Exact(1));
}

TEST_CASE("projection: an oblique one shears x and y by z") {
  auto f = frustum(kParallel, DepthRange::zero_to_one);
  f.shear_x = ratio(1, 2);
  f.shear_y = Exact(-1);
  const Vec4<Exact> v = clip(f, 3, -4, -4);  // (3 - 2, -4 + 4)
  CHECK(v[0] == Exact(1));
  CHECK(v[1] == Exact(0));
}

// Their product is beyond the largest float, below the smallest, or twice it is (far = FLT_MAX, as
// some have it who want no far plane).
TEST_CASE("projection: near and far may be such that their product leaves the format") {
  struct Bounds {
    float near, far;
  };
  for (const auto& [near, far] :
       {Bounds{0x1p+64f, 0x1.8p+66f}, Bounds{0x1.4p-80f, 0x1.8p-77f},
        Bounds{0x1.02791p-125f, 0x1.04p-123f}, Bounds{1, 0x1.fffffep+127f}}) {
    for (const DepthRange depth :
         {DepthRange::minus_one_to_one, DepthRange::zero_to_one, DepthRange::reversed}) {
      Frustum<float> f;
      f.near = near;
      f.far = far;
      f.depth = depth;
      const Exact rounded(Projection<float>(f).z.one);
      const Exact exact = Projection<Exact>(frustum_cast<Exact>(f)).z.one;
      INFO(near << " " << far);
      CHECK(abs(Exact(rounded - exact)) <= Exact(abs(exact) * Exact(3 * 0x1.001p-24)));
    }
  }
}

TEST_CASE("projection: a frustum without volume is invalid") {
  Frustum<double> f;
  CHECK(is_valid(f));
  f.right = f.left;
  CHECK_FALSE(is_valid(f));
  f = {};
  f.near = 0;
  CHECK_FALSE(is_valid(f));
  f = {};
  f.far = f.near;
  CHECK_FALSE(is_valid(f));
  f.infinite_far = true;
  CHECK(is_valid(f));
  f.kind = kParallel;
  CHECK_FALSE(is_valid(f));
}
