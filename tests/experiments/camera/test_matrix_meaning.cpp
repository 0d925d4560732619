// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/camera/matrix_meaning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/camera/meaning_text.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

MatrixRows<double> rows_of(const Frustum<float>& frustum) {
  return matrix_cast<double>(clipscope::rows_of(Projection<float>(frustum)));
}

// Sides at 45 degrees, near at 1; z = -z - 2.
MatrixRows<double> infinite_far() {
  return {Vec4<double>(1, 0, 0, 0), Vec4<double>(0, 1, 0, 0), Vec4<double>(0, 0, -1, -2),
          Vec4<double>(0, 0, -1, 0)};
}

Frustum<float> frustum(float near, float far, DepthRange depth = DepthRange::minus_one_to_one) {
  Frustum<float> f{ProjectionKind::perspective, -near, near, -near, near, near, far};
  f.depth = depth;
  return f;
}

TEST_CASE("meaning: the frustum, the angles and the axes of a projection come back") {
  const MatrixMeaning m = meaning_of({rows_of(frustum(0.5f, 8))}, {});
  REQUIRE(!m.singular);
  CHECK(m.perspective);
  CHECK(m.is_projection_alone);
  CHECK(m.right_handed);
  CHECK(!m.is_oblique);
  CHECK(!m.is_skewed);
  CHECK(m.eye == glm::dvec3(0));
  CHECK(m.forward == glm::dvec3(0, 0, -1));
  CHECK(m.right == glm::dvec3(1, 0, 0));
  CHECK(m.up == glm::dvec3(0, 1, 0));
  CHECK(m.horizontal_degrees() == Approx(90));
  CHECK(m.vertical_degrees() == Approx(90));
  CHECK(m.depth == DepthRange::minus_one_to_one);
  CHECK(m.reading().near.value == Approx(0.5));
  CHECK(m.reading().far.value == Approx(8));
}

TEST_CASE("meaning: each depth convention reads near and far of its own matrix") {
  const auto depth =
      GENERATE(DepthRange::minus_one_to_one, DepthRange::zero_to_one, DepthRange::reversed);
  const MatrixMeaning m = meaning_of({rows_of(frustum(0.25f, 64, depth))}, depth);
  CHECK(m.reading().near.value == Approx(0.25));
  CHECK(m.reading().far.value == Approx(64).epsilon(1e-4));
  CHECK(m.reading().encloses_volume);
}

TEST_CASE("meaning: a reversed matrix encloses nothing as gl or zero_to_one, and is read so") {
  const MatrixMeaning m = meaning_of({rows_of(frustum(0.25f, 64, DepthRange::reversed))}, {});
  CHECK(m.depth == DepthRange::reversed);
  CHECK(!m.readings[0].encloses_volume);
  CHECK(!m.readings[1].encloses_volume);
}

TEST_CASE("meaning: a far plane that cancels is lost, a near one is not") {
  // far / near = 1e9: the entries of z and w are the same float.
  const MatrixMeaning lost = meaning_of({rows_of(frustum(1e-3f, 1e6f))}, {});
  CHECK(lost.reading().far.value == kInfinity);
  CHECK(lost.reading().near.value == Approx(1e-3));
  CHECK(lost.planes[static_cast<std::size_t>(Plane::far)].at_infinity);
  // 2e7: one ulp is left, and one less puts the far plane at infinity.
  const MatrixMeaning doubtful = meaning_of({rows_of(frustum(0.05f, 1e6f))}, {});
  CHECK(doubtful.reading().far.high == kInfinity);
  CHECK(doubtful.planes[static_cast<std::size_t>(Plane::far)].digits < 1);
  // 10: all digits but one.
  const MatrixMeaning sound = meaning_of({rows_of(frustum(1, 10))}, {});
  CHECK(sound.reading().far.low == Approx(10).epsilon(1e-5));
  CHECK(sound.reading().far.high == Approx(10).epsilon(1e-5));
  CHECK(sound.reading().far.low < sound.reading().far.high);
  CHECK(sound.planes[static_cast<std::size_t>(Plane::far)].digits > 5);
}

TEST_CASE("meaning: an infinite far plane of whole numbers is exact, and at infinity") {
  const MatrixMeaning m = meaning_of({infinite_far()}, {});
  CHECK(m.reading().near.value == 1);
  CHECK(m.reading().far.value == kInfinity);
  for (const PlaneReading& p : m.planes) CHECK(p.is_exact);
  CHECK(m.planes[static_cast<std::size_t>(Plane::far)].at_infinity);
}

TEST_CASE("meaning: a far plane that rounding put behind the eye bounds nothing") {
  // One float less than 1: the far plane lies at a negative distance.
  MatrixRows<double> rows = infinite_far();
  rows[2][2] = -double{std::nextafter(1.0f, 0.0f)};
  const MatrixMeaning m = meaning_of({rows}, {});
  CHECK(m.depth == DepthRange::minus_one_to_one);
  CHECK(m.reading().encloses_volume);
  CHECK(m.reading().far.value == kInfinity);
}

TEST_CASE("meaning: y down turns up over, and the hand with it") {
  MatrixRows<double> rows = infinite_far();
  rows[1] = -rows[1];
  const MatrixMeaning m = meaning_of({rows}, {});
  CHECK(m.up == glm::dvec3(0, -1, 0));
  CHECK(!m.right_handed);
  CHECK(m.bottom == -1);
  CHECK(m.top == 1);
}

TEST_CASE("meaning: a left-handed matrix looks down +z") {
  const MatrixMeaning m = meaning_of({{Vec4<double>(1, 0, 0, 0), Vec4<double>(0, 1, 0, 0),
                                       Vec4<double>(0, 0, 1, -2), Vec4<double>(0, 0, 1, 0)}},
                                     {});
  CHECK(m.forward == glm::dvec3(0, 0, 1));
  CHECK(!m.right_handed);
  CHECK(m.reading().near.value == 1);
}

TEST_CASE("meaning: a view-projection matrix, scaled as a whole, gives the eye in the world") {
  // The camera stands at (10, 20, 30); every row is multiplied by 2.
  MatrixRows<double> rows = infinite_far();
  for (Vec4<double>& row : rows) {
    row[3] -= row[0] * 10 + row[1] * 20 + row[2] * 30;
    row *= 2.0;
  }
  const MatrixMeaning m = meaning_of({rows}, {});
  CHECK(!m.is_projection_alone);
  CHECK(m.eye == glm::dvec3(10, 20, 30));
  CHECK(m.forward == glm::dvec3(0, 0, -1));
  CHECK(m.horizontal_degrees() == Approx(90));
  CHECK(m.reading().near.value == Approx(1));
}

TEST_CASE("meaning: off-centre sides, skewed axes and an oblique near plane are told apart") {
  Frustum<float> off = frustum(1, 10);
  off.left = 0;
  const MatrixMeaning centre = meaning_of({rows_of(off)}, {});
  CHECK(centre.left == Approx(0).margin(1e-12));
  CHECK(centre.right_side == Approx(1));
  CHECK(!centre.is_skewed);
  MatrixRows<double> skewed = infinite_far();
  skewed[0][1] = 0.5;
  CHECK(meaning_of({skewed}, {}).is_skewed);
  MatrixRows<double> oblique = infinite_far();
  oblique[2] = Vec4<double>(0, 0.5, -1, -2);
  const MatrixMeaning m = meaning_of({oblique}, {});
  CHECK(m.is_oblique);
  CHECK(!m.is_skewed);
}

TEST_CASE("meaning: an orthographic matrix has lengths for sides and distances for depth") {
  Frustum<float> f{ProjectionKind::parallel, -2, 4, -1, 1, 3, 11};
  const MatrixMeaning m = meaning_of({rows_of(f)}, {});
  CHECK(!m.perspective);
  CHECK(m.forward == glm::dvec3(0, 0, -1));
  CHECK(m.left == Approx(-2));
  CHECK(m.right_side == Approx(4));
  CHECK(m.top == Approx(1));
  CHECK(m.reading().near.value == Approx(3));
  CHECK(m.reading().far.value == Approx(11));
  CHECK(m.aspect() == Approx(3));
}

TEST_CASE("meaning: a singular matrix says what it flattens") {
  MatrixRows<double> rows = infinite_far();
  rows[2] = rows[3];  // depth is 1 everywhere
  const MatrixMeaning m = meaning_of({rows}, {});
  REQUIRE(m.singular);
  CHECK(m.singular->rank == 3);
  CHECK(m.singular->lost == std::array<double, 4>{0, 0, 0, 1});
  CHECK(meaning_text(m, false).find("singular (rank 3 of 4)") != std::string::npos);
}

TEST_CASE("depth digits: steps of distance grow with its square, and the counts with the buffer") {
  const MatrixMeaning m = meaning_of({rows_of(frustum(1, 1000))}, {});
  const std::vector<DepthDigits> rows = depth_digits(m);
  REQUIRE(rows.size() == 4);  // 1, 10, 100, far
  CHECK(rows[0].depth == Approx(-1));
  CHECK(rows.back().depth == Approx(1));
  for (std::size_t b = 0; b < 2; ++b) CHECK(rows[2].step[b] / rows[1].step[b] == Approx(100));
  // z = (f + n) / (f - n) - 2 f n / ((f - n) d): dz/dd at 1 is 2000 / 999; half of it is stored.
  CHECK(rows[0].step[0] == Approx(999.0 / 1000 / 65535).epsilon(1e-4));
  CHECK(rows[0].values_left[0] == 65535);
  CHECK(rows.back().values_left[1] == 0);
}

TEST_CASE("depth digits: reversed depth in float keeps its digits far away, gl does not") {
  const auto last_digits = [](DepthRange depth) {
    const auto rows = depth_digits(meaning_of({rows_of(frustum(0.125f, 4096, depth))}, depth));
    return rows[rows.size() - 2].digits[2];
  };
  CHECK(last_digits(DepthRange::reversed) > 6.5);
  CHECK(last_digits(DepthRange::minus_one_to_one) < 4);
}

TEST_CASE("meaning text: no line is wider than 100 columns") {
  for (const MatrixRows<double>& rows :
       {rows_of(frustum(1e-3f, 1e6f)), infinite_far(), rows_of(frustum(0.1f, 123456.7f))}) {
    const std::string text = meaning_text(meaning_of({rows}, {}), false);
    for (std::size_t i = 0; i < text.size(); i = text.find('\n', i) + 1) {
      const std::string line = text.substr(i, text.find('\n', i) - i);
      const auto bytes_beyond_ascii =
          std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xc0) == 0x80; });
      INFO(line);
      CHECK(static_cast<std::ptrdiff_t>(line.size()) - bytes_beyond_ascii <= 100);
    }
  }
}

}  // namespace
}  // namespace clipscope::experiments
