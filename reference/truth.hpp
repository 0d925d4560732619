// SPDX-License-Identifier: GPL-3.0-or-later
//
// Truth: which volume a triangle is clipped against, and which projection it then goes through, in
// exact numbers made from the bits given.
//
//   frustum   view-space triangle, exact frustum numbers: what the user meant
//   matrix    view-space triangle, the float matrix as given: what is true after its rounding
//   clip      clip-space triangle as given: what is true after the transform's rounding
//
// The differences between the three are the error budget: transform, cut, divide.
//
// The volume is given by linear forms d_p over the input coordinates: d_p >= 0 is inside; 0, on the
// plane, is inside, unless the plane is an open side. Where w = 0 the clip position is
// (0, 0, 0, 0): outside by definition. Forms of view space, perspective (parallel: x + shear_x z
// instead of the quotient):
//
//   left    near x + left z      right  -near x - right z      near   -z - near
//   bottom  near y + bottom z    top    -near y - top z        far     z + far
//
// and of clip space w + x, w - x, w + y, w - y, and by depth range z + w or z, and w - z.
//
// Options of the volume (spaces/volume.hpp): a plane of depth that is clamped is left out. The
// sides leave w >= 0 by themselves: (w + x) + (w - x) = 2 w. A clip distance is the form of an
// attribute.
#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <span>
#include <vector>

#include "reference/fraction.hpp"
#include "spaces/projection.hpp"
#include "spaces/vertex.hpp"
#include "spaces/volume.hpp"

namespace clipscope::reference {

// A vertex as given: float or double bits, all of them exactly doubles.
// position: view space (x, y, z, 1) or clip space (x, y, z, w).
struct InputVertex {
  std::array<double, 4> position{0, 0, 0, 1};
  std::array<double, kMaxAttributes> attributes{};
};

struct InputTriangle {
  std::array<InputVertex, 3> vertices;
  int attribute_count = 0;
};

// Whether no coordinate or attribute in use is NaN or infinite: the pre-condition of all that
// follows.
bool is_finite(std::span<const InputVertex> vertices, int attribute_count);
bool is_finite(const InputTriangle& triangle);

// A vertex of a clipper, bit for bit.
template <Space S, std::floating_point T, int K>
requires(S != Space::ndc && sizeof(T) <= sizeof(double)) InputVertex
    input_vertex(const Vertex<S, T, K>& vertex) {
  InputVertex r;
  for (int c = 0; c < Vertex<S, T, K>::kDimension; ++c) r.position[c] = vertex.position[c];
  for (int k = 0; k < vertex.attributes.size(); ++k) r.attributes[k] = vertex.attributes[k];
  return r;
}

// The triangle of a clipper, bit for bit.
template <Space S, std::floating_point T, int K>
InputTriangle input_triangle(const Triangle<S, T, K>& triangle) {
  return {{input_vertex(triangle[0]), input_vertex(triangle[1]), input_vertex(triangle[2])},
          triangle[0].attributes.size()};
}

// sum of coefficient * coordinate. Coordinates 0 to 3 are those of InputVertex::position; kOne is
// the constant 1, in clip space too; kFirstAttribute + i is attribute i.
inline constexpr int kOne = 4;
inline constexpr int kFirstAttribute = 5;

struct Term {
  double coefficient;
  int coordinate;
};
using LinearForm = std::vector<Term>;

// The exact value, and the sign of it: -1, 0 or 1. The sign comes from doubles wherever their error
// bound settles it.
Dyadic value(const LinearForm& form, const InputVertex& vertex);
int sign(const LinearForm& form, const InputVertex& vertex);

// One row of the exact projection matrix, times `scale` > 0: where the frustum's numbers ask for a
// quotient, its divisor is the scale. Coefficients go by coordinate, as in LinearForm;
// attributes take no part.
struct ProjectionForm {
  std::array<Dyadic, 5> coefficients;
  Dyadic scale = 1;

  Dyadic value(const InputVertex& vertex) const;  // scale times the clip coordinate
};

enum class TruthKind { frustum, matrix, clip };

class Truth {
 public:
  // Throws std::invalid_argument unless the frustum is finite and encloses a volume; with a volume
  // given, if the two differ in depth range.
  static Truth of_frustum(const Frustum<double>& frustum);
  static Truth of_frustum(const Frustum<double>& frustum, const ClipVolume& volume);
  // All planes come from the matrix as given, with an infinite far plane too; of the frustum
  // nothing is used. Throws std::invalid_argument if the matrix isn't finite.
  static Truth of_matrix(const Projection<float>& projection);
  static Truth of_matrix(const Projection<double>& projection);
  // Any matrix, of whatever entries.
  static Truth of_matrix(const MatrixRows<double>& rows, const ClipVolume& volume);
  static Truth of_clip(DepthRange depth);
  static Truth of_clip(const ClipVolume& volume);

  // With further planes a x + b y + c z + d >= 0 of view space, in clip space with d w. Throws
  // std::invalid_argument if a number isn't finite.
  Truth with_planes(std::span<const std::array<double, 4>> planes) const;

  // The same projection, each plane moved inwards so that d_p >= distance holds, where d_p is the
  // form w + x and so on of the true clip coordinates (w = -z_view for perspective, 1 for
  // parallel), and each clip distance so that it is >= attribute_distance.
  // A negative distance moves outwards, but w >= 0 remains a condition then, and vertices with w =
  // 0 remain outside. The distance is turned into view-space forms in double: it is a loose bound.
  // The plane of an infinite far stays where it is. Pre-condition: there are no further planes.
  Truth inset(double distance, double attribute_distance = 0) const;

  TruthKind kind() const { return kind_; }
  const ClipVolume& volume() const { return volume_; }

  // The exact clip coordinates (x, y, z, w) of a vertex.
  std::array<Rational, 4> clip_position(const InputVertex& vertex) const;

  // The half-spaces of the volume in the order of Plane, then the clip distances and further
  // planes; and w. Absent are near and far where they are clamped, and the infinite far plane of a
  // frustum's truth. An outward inset appends w >= 0.
  struct HalfSpace {
    LinearForm form;
    double clip_scale = 1;  // form times clip_scale is w + x and so on
    bool is_open = false;   // does not own its points (OpenSides in spaces/volume.hpp)
  };
  const std::vector<HalfSpace>& half_spaces() const { return half_spaces_; }
  const LinearForm& w() const { return w_; }

  // x, y and z of the clip position; w has the scale 1.
  const std::array<ProjectionForm, 3>& projection() const { return projection_; }

 private:
  static Truth of_rows(const ClipVolume& volume, const std::array<LinearForm, 4>& rows);
  void set_half_spaces(std::vector<HalfSpace> six);

  TruthKind kind_ = TruthKind::clip;
  ClipVolume volume_;
  std::vector<HalfSpace> half_spaces_;
  LinearForm w_;
  std::array<ProjectionForm, 3> projection_;
};

// Anything that says what its primitives are clipped against: those of view space by a matrix where
// there is one, else by a frustum.
template <class Setting>
concept ClipSetting = requires(const Setting& s) {
  { s.space } -> std::convertible_to<Space>;
  { s.frustum } -> std::convertible_to<Frustum<double>>;
  { s.matrix } -> std::convertible_to<std::optional<MatrixRows<double>>>;
  { s.volume } -> std::convertible_to<ClipVolume>;
  { s.planes } -> std::convertible_to<std::span<const std::array<double, 4>>>;
};

// Errors: those of Truth.
template <ClipSetting Setting>
Truth truth_of(const Setting& s) {
  const Truth truth = s.space == Space::clip ? Truth::of_clip(s.volume)
                      : s.matrix             ? Truth::of_matrix(*s.matrix, s.volume)
                                             : Truth::of_frustum(s.frustum, s.volume);
  return s.planes.empty() ? truth : truth.with_planes(s.planes);
}

}  // namespace clipscope::reference
