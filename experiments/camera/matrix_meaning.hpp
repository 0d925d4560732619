// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a matrix to clip space means: where its camera stands, what it sees, which way round, and
// what the format that its entries are stored in has left of it.
//
// Decisions (singular? behind? mirrored? which convention encloses a volume?) are taken in exact
// arithmetic from the entries' bits; lengths and angles are rounded from exact values, with an
// error of some ulp of double where a square root is in them.
// Source of the factors: Hartley and Zisserman, "Multiple View Geometry in Computer Vision", 2004,
// section 6.2 (the centre of a camera and its axes from the rows x, y and w of its matrix).
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "spaces/planes.hpp"
#include "spaces/projection.hpp"

namespace clipscope::experiments {

struct CameraMatrix {
  MatrixRows<double> rows;  // all entries finite
  bool in_float = true;     // they are floats; else doubles
};

// A number with the values that it takes when one entry of the matrix is one float (or double)
// larger or smaller. Infinite where it lies at infinity, or leaves it open which side of it.
struct Ranged {
  double value = 0, low = 0, high = 0;
};

// near and far under one depth convention: distances from the eye along the view direction, of a
// parallel projection from the plane through the origin. far is infinite, too, where rounding put
// the far plane beyond infinity, behind the eye: all in front of near is inside then.
struct DepthReading {
  DepthRange depth = DepthRange::minus_one_to_one;
  Ranged near = {}, far = {};
  bool encloses_volume = false;  // near < far, and for perspective 0 < near
};

// A plane of the volume, a x + b y + c z + d >= 0 in the space that the matrix takes.
struct PlaneReading {
  Plane plane = Plane::left;
  std::array<double, 4> rounded{};  // the sum of two rows as the format computes it
  bool is_exact = true;             // nothing was rounded in it
  // Decimal digits that its normal has left when each entry is known to half an ulp; 0 and ±1 are
  // taken for exact. Infinite where all are; 0 or less: the plane is lost.
  double digits = 0;
  bool at_infinity = false;  // no normal at all: every point is inside (or none, if d < 0)
};

// What a matrix that can't be inverted flattens.
struct Singular {
  int rank = 0;
  std::array<double, 4> lost{};  // a direction (w = 0) or a point (x, y, z, 1) that becomes 0
};

struct MatrixMeaning {
  CameraMatrix matrix;
  std::optional<Singular> singular = {};  // nothing below is of use then
  bool perspective = true;
  bool has_negative_w = false;       // a parallel matrix whose w is negative: nothing is inside
  bool is_projection_alone = false;  // eye at the origin, axes along x, y and z

  glm::dvec3 eye = {};                           // of a perspective matrix
  glm::dvec3 forward = {}, right = {}, up = {};  // unit; up is where y of NDC grows
  // Whether right, up and back are right-handed: the usual picture of a right-handed space in an
  // API whose y of NDC goes up (OpenGL, Direct3D).
  bool right_handed = true;

  // The sides: tangents of a perspective matrix (x / distance), lengths of a parallel one.
  double left = 0, right_side = 0, bottom = 0, top = 0;
  double skew_degrees = 0;  // between the axes of the picture, 0 where they are perpendicular
  bool is_skewed = false;   // by more than rounding
  bool is_oblique = false;  // depth does not grow along the view direction (by more than rounding)

  std::vector<DepthReading> readings = {};          // gl, zero_to_one, reversed
  DepthRange depth = DepthRange::minus_one_to_one;  // the one asked for, or the first that fits
  std::vector<PlaneReading> planes = {};            // six, by that convention

  const DepthReading& reading() const { return readings[static_cast<std::size_t>(depth)]; }
  double horizontal_degrees() const;  // of perspective
  double vertical_degrees() const;
  double aspect() const;  // width over height
};

// depth: the convention to read it by; without one the first that encloses a volume. gl and
// zero_to_one can't be told apart by a matrix: where one encloses a volume the other does too, with
// another near plane.
MatrixMeaning meaning_of(const CameraMatrix& matrix, std::optional<DepthRange> depth);

// The depth buffers that digits are counted in.
enum class DepthBuffer { bits16, bits24, float32 };
inline constexpr int kDepthBuffers = 3;

// What depth can tell apart at a distance from the eye (of a parallel matrix: from near to far).
struct DepthDigits {
  double distance = 0;
  double depth = 0;  // z of NDC
  std::array<double, kDepthBuffers>
      step{};  // of distance, from one value of the buffer to the next
  // log10(distance / step).
  std::array<double, kDepthBuffers> digits{};
  // Values of the buffer from here to far, of 16 and 24 bits.
  std::array<double, 2> values_left{};
};

// At near, 10 near, 100 near and so on up to far (or 10^6 near), and at far. The buffer holds
// (z + 1) / 2 under gl, else z; the step of float is that of z in float, or of its rounding when it
// is computed as z_clip / w in float, whichever is larger. Empty where no volume is enclosed.
std::vector<DepthDigits> depth_digits(const MatrixMeaning& meaning);

}  // namespace clipscope::experiments
