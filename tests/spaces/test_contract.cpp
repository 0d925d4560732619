// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every clipper must keep in every scalar, floating-point ones included.
#include <algorithm>
#include <set>
#include <string>

#include "tests/catch.hpp"
#include "tests/spaces/clippers.hpp"

using namespace clipscope;
using namespace clipscope::tests;
using experiments::AllScalars;
using experiments::for_each_type;
using experiments::is_finite;
using experiments::nearest_double;

namespace {

template <class T>
double signed_area(const NdcPolygon<T, K>& p) {
  double area = 0;
  for (int i = 0; i < p.size(); ++i) {
    const auto& a = p[i].position;
    const auto& b = p[(i + 1) % p.size()].position;
    area +=
        nearest_double(a[0]) * nearest_double(b[1]) - nearest_double(a[1]) * nearest_double(b[0]);
  }
  return area / 2;
}

void check_equal(const NdcPolygon<float, kRunTime>& found, const NdcPolygon<float, K>& expected) {
  REQUIRE(found.size() == expected.size());
  for (int v = 0; v < found.size(); ++v) {
    CHECK(found[v].position == expected[v].position);
    REQUIRE(found[v].attributes.size() == K);
    for (int k = 0; k < K; ++k) CHECK(found[v].attributes[k] == expected[v].attributes[k]);
  }
}

// Inside the volume.
const Corners kInside = {{{-0.5, -0.5, -0.25, 1}, {0.5, -0.5, 0, 1}, {0, 0.5, 0.25, 1}}};

}  // namespace

TEST_CASE("contract: names are unique and every clipper models the concept") {
  std::set<std::string_view> names;
  for_each_type(AllClippers{}, [&]<class C>() {
    static_assert(Clipper<C>);
    CHECK(names.insert(C::name).second);
  });
  CHECK(names.size() == static_cast<std::size_t>(AllClippers::size));
}

TEST_CASE("contract: a triangle inside comes out as it is, divided") {
  for_every_clipper([]<class T>(const ClipperIn<T, 3>& clip) {
    if (!clip.takes_clip_space()) return;
    const auto out = clip(clip_triangle<T>(kInside));
    REQUIRE(out.size() == 3);
    for (int v = 0; v < 3; ++v) {
      CHECK(nearest_double(out[v].position[0]) == kInside[static_cast<std::size_t>(v)][0]);
      CHECK(nearest_double(out[v].position[3]) == 1.0);
      CHECK(nearest_double(out[v].attributes[v]) == 1.0);
    }
  });
}

TEST_CASE("contract: the volume is closed, a triangle between its corners is untouched") {
  const Corners corners = {{{-1, -1, -1, 1}, {1, 1, -1, 1}, {1, -1, 1, 1}}};
  for_every_clipper([&]<class T>(const ClipperIn<T, 3>& clip) {
    if (!clip.takes_clip_space()) return;
    const auto out = clip(clip_triangle<T>(corners));
    REQUIRE(out.size() == 3);
    CHECK(nearest_double(out[0].position[0]) == -1.0);
    CHECK(nearest_double(out[1].position[1]) == 1.0);
  });
}

TEST_CASE("contract: a triangle outside one plane yields nothing") {
  for_every_clipper([]<class T>(const ClipperIn<T, 3>& clip) {
    CHECK(clip(view_triangle<T>({{{9, 0, -2, 0}, {8, 0, -2, 0}, {9, 1, -3, 0}}})).empty());
    CHECK(clip(view_triangle<T>({{{0, 0, -11, 0}, {1, 0, -12, 0}, {0, 1, -11, 0}}})).empty());
  });
}

TEST_CASE("contract: a triangle behind the eye yields nothing") {
  for_every_clipper([]<class T>(const ClipperIn<T, 3>& clip) {
    if (!keeps_contract(clip.promise)) return;
    CHECK(clip(view_triangle<T>({{{0, 0, 2, 0}, {1, 0, 3, 0}, {0, 1, 4, 0}}})).empty());
  });
}

TEST_CASE("contract: a triangle through the eye plane is cut at the near plane") {
  for_every_clipper([]<class T>(const ClipperIn<T, 3>& clip) {
    if (!keeps_contract(clip.promise)) return;
    const auto out = clip(view_triangle<T>({{{-0.5, 0, -2, 0}, {0.5, 0, -2, 0}, {0, 0.5, 2, 0}}}));
    REQUIRE(out.size() == 4);
    for (const auto& v : out) {
      CHECK(is_finite(v.position[0]));
      CHECK(nearest_double(v.position[2]) >= -1.00001);
    }
  });
}

TEST_CASE(
    "contract: six planes leave nine vertices at most, and there is a triangle that has them") {
  // Three corners of the cube's hexagonal cross-section, pulled out until each edge crosses two
  // planes.
  const Corners nine = {{{1.75, -0.5, -1.25, 1}, {-1.25, 1.75, -0.5, 1}, {-0.5, -1.25, 1.75, 1}}};
  for_every_clipper([&]<class T>(const ClipperIn<T, 3>& clip) {
    if (keeps_clip_contract(clip)) CHECK(clip(clip_triangle<T>(nine)).size() == 9);
  });
}

TEST_CASE("contract: winding is kept") {
  std::mt19937_64 random(4);
  for (int n = 0; n < 1000; ++n) {
    Corners corners = random_corners(random, 3);
    for (auto& corner : corners) corner[3] = 2;  // all in front: the area before tells the winding
    const auto triangle = clip_triangle<double>(corners);
    NdcPolygon<double, K> whole;
    for (const auto& v : triangle) whole.push_back(to_ndc(v));
    for (const auto& clip : clippers<double>()) {
      if (!keeps_clip_contract(clip)) continue;
      const double area = signed_area(clip(triangle));
      if (std::abs(area) > 1e-9) CHECK((area < 0) == (signed_area(whole) < 0));
    }
  }
}

TEST_CASE("contract: the homogeneous point 0 0 0 0 is outside") {
  for_every_clipper([]<class T>(const ClipperIn<T, 3>& clip) {
    if (!keeps_clip_contract(clip)) return;
    CHECK(clip(clip_triangle<T>({{{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}}})).empty());
    CHECK(clip(clip_triangle<T>({{{0, 0, 0, 1}, {0, 0, 0, 0}, {0, 0, 0, 0}}})).empty());
  });
}

TEST_CASE("contract: a near cut first makes the division safe for view space, not for clip space") {
  for_each_type(AllScalars{}, []<class T>() {
    NdcPolygon<T, K> view;
    CvvNearFirst{}(Projection<T>(Frustum<T>{}),
                   view_triangle<T>({{{-0.5, 0, -2, 0}, {0.5, 0, -2, 0}, {0, 0.5, 2, 0}}}), view);
    CHECK(view.size() == 4);
    // In front of the near plane (z + w > 0) though w < 0: no projection makes such a vertex.
    const auto behind = clip_triangle<T>({{{0, 0, 0, 1}, {0.5, 0, 0, 1}, {0, 0.5, 3, -1}}});
    CHECK(clip<CvvNearFirst>(behind).empty());
    CHECK(clip<HomogeneousSutherlandHodgman>(behind).size() >= 3);
  });
}

TEST_CASE("contract: run-time attribute counts give what compile-time ones give") {
  std::mt19937_64 random(9);
  for (int n = 0; n < 200; ++n) {
    const Corners corners = random_corners(random, 3);
    const auto triangle = clip_triangle<float>(corners);
    ClipTriangle<float, kRunTime> dynamic;
    for (std::size_t i = 0; i < 3; ++i) {
      dynamic[i].position = triangle[i].position;
      dynamic[i].attributes.resize(K);
      for (int k = 0; k < K; ++k) dynamic[i].attributes[k] = triangle[i].attributes[k];
    }
    for_each_type(AllClippers{}, [&]<class C>() {
      if constexpr (ClipsClipSpace<C, float, K>) {
        NdcPolygon<float, kRunTime> found;
        C{}(ClipVolume{}, dynamic, found);
        check_equal(found, clip<C>(triangle));
      }
    });
  }
}
