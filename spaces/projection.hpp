// SPDX-License-Identifier: MIT
//
// Frustum and projection: from the view volume to clip coordinates.
//
// Perspective (off-centre allowed), orthographic, and oblique parallel projection (an orthographic
// one after a shear of x and y by z). Depth conventions: OpenGL [-1, 1], Direct3D and Vulkan [0,
// 1], reversed [1, 0]; each also with the far plane at infinity.
//
// Matrices: OpenGL 1.5 specification, section 2.11.2 (glFrustum, glOrtho), and the same with the
// depth row changed; far near / (far - near) as near (far / (far - near)): DirectXMath,
// XMMatrixPerspectiveOffCenterRH; far -> infinity: Lengyel, "Projection Matrix Tricks", GDC 2007.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include "spaces/vertex.hpp"
#include "spaces/volume.hpp"

namespace clipscope {

enum class ProjectionKind : std::uint8_t { perspective, parallel };

// The view volume in view space. Perspective: left, right, bottom and top are measured on the near
// plane, 0 < near < far. Parallel: they bound x + shear_x z and y + shear_y z; near < far.
// Points of the volume have -far <= z <= -near. All planes belong to it.
template <Scalar T>
struct Frustum {
  ProjectionKind kind = ProjectionKind::perspective;
  T left = T(-1), right = T(1), bottom = T(-1), top = T(1);
  T near = T(1), far = T(10);
  bool infinite_far = false;         // `far` is then ignored; perspective only
  T shear_x = T(0), shear_y = T(0);  // oblique parallel projection; 0 for perspective
  DepthRange depth = DepthRange::minus_one_to_one;

  // constexpr where the scalar's own is.
  friend bool operator==(const Frustum&, const Frustum&) = default;
};

// The same frustum in another scalar; exact where T can hold the numbers given.
template <Scalar T, Scalar U>
constexpr Frustum<T> frustum_cast(const Frustum<U>& f) {
  return {f.kind,   T(f.left),      T(f.right),   T(f.bottom),  T(f.top), T(f.near),
          T(f.far), f.infinite_far, T(f.shear_x), T(f.shear_y), f.depth};
}

// Whether the frustum encloses a volume.
template <Scalar T>
constexpr bool is_valid(const Frustum<T>& f) {
  const bool sides = f.left < f.right && f.bottom < f.top;
  if (f.kind == ProjectionKind::parallel) return sides && !f.infinite_far && f.near < f.far;
  return sides && T(0) < f.near && (f.infinite_far || f.near < f.far);
}

// One row of a projection matrix that is not zero where it may be: a * (own coordinate) + b * z +
// c.
template <Scalar T>
struct ProjectionRow {
  T own = T(0), z = T(0), one = T(0);
};

// The projection: the frustum, the clip volume that it maps to, and the rows of its matrix rounded
// to T once. Options of the volume (depth clamp, clip distances, open sides) are set after
// construction.
//   x_clip = x.own x + x.z z + x.one     z_clip = z.z z + z.one
//   y_clip = y.own y + y.z z + y.one     w_clip = w.z z + w.one
template <Scalar T>
struct Projection {
  Frustum<T> frustum;
  ClipVolume volume;
  ProjectionRow<T> x, y, z, w;
  // The frustum's planes in view space with normals of length 1, in the order of enum Plane: inside
  // is a x + b y + c z + d >= 0. All zero where T has no square root. An infinite far plane is (0,
  // 0, 0, 1).
  std::array<Vec4<T>, 6> unit_planes{};

  constexpr Projection() = default;
  // Pre-condition: is_valid(frustum).
  explicit constexpr Projection(const Frustum<T>& f) : frustum(f), volume{.depth = f.depth} {
    if (f.kind == ProjectionKind::perspective) {
      set_perspective();
    } else {
      set_parallel();
    }
    if constexpr (HasSquareRoot<T>) set_unit_planes();
  }

 private:
  constexpr void set_perspective() {
    const Frustum<T>& f = frustum;
    const T two_near = f.near + f.near;
    x.own = two_near / (f.right - f.left);
    x.z = (f.right + f.left) / (f.right - f.left);
    y.own = two_near / (f.top - f.bottom);
    y.z = (f.top + f.bottom) / (f.top - f.bottom);
    w.z = T(-1);
    if (f.infinite_far) {
      set_infinite_depth(two_near);
      return;
    }
    const T length = f.far - f.near;
    // far near / length is computed as near (far / length), as DirectXMath does: that overflows or
    // underflows where the entry itself does, while far near may do so long before.
    const T reach = f.far / length;
    switch (f.depth) {
      case DepthRange::minus_one_to_one:
        z.z = -(f.far + f.near) / length;
        z.one = -(two_near * reach);
        break;
      case DepthRange::zero_to_one:
        z.z = -reach;
        z.one = -(f.near * reach);
        break;
      case DepthRange::reversed:
        z.z = f.near / length;
        z.one = f.near * reach;
        break;
    }
  }

  constexpr void set_infinite_depth(const T& two_near) {
    switch (frustum.depth) {
      case DepthRange::minus_one_to_one:
        z.z = T(-1);
        z.one = -two_near;
        break;
      case DepthRange::zero_to_one:
        z.z = T(-1);
        z.one = -frustum.near;
        break;
      case DepthRange::reversed: z.one = frustum.near; break;
    }
  }

  constexpr void set_unit_planes() {
    const Frustum<T>& f = frustum;
    const T o(0), i(1);
    const bool perspective = f.kind == ProjectionKind::perspective;
    // x + (left / near) z for perspective, x + shear_x z - left for parallel projection.
    const auto side = [&](const T& bound, const T& shear) {
      const T slope = perspective ? T(bound / f.near) : shear;
      const T length = sqrt(T(i + slope * slope));
      const T offset = perspective ? o : T(-bound / length);
      return std::array<T, 3>{T(i / length), T(slope / length), offset};
    };
    const auto left = side(f.left, f.shear_x), right = side(f.right, f.shear_x);
    const auto bottom = side(f.bottom, f.shear_y), top = side(f.top, f.shear_y);
    unit_planes = {Vec4<T>(left[0], o, left[1], left[2]),
                   Vec4<T>(-right[0], o, -right[1], -right[2]),
                   Vec4<T>(o, bottom[0], bottom[1], bottom[2]),
                   Vec4<T>(o, -top[0], -top[1], -top[2]),
                   Vec4<T>(o, o, -i, -f.near),
                   f.infinite_far ? Vec4<T>(o, o, o, i) : Vec4<T>(o, o, i, f.far)};
  }

  constexpr void set_parallel() {
    const Frustum<T>& f = frustum;
    x.own = T(2) / (f.right - f.left);
    x.z = x.own * f.shear_x;
    x.one = -(f.right + f.left) / (f.right - f.left);
    y.own = T(2) / (f.top - f.bottom);
    y.z = y.own * f.shear_y;
    y.one = -(f.top + f.bottom) / (f.top - f.bottom);
    w.one = T(1);
    const T length = f.far - f.near;
    switch (f.depth) {
      case DepthRange::minus_one_to_one:
        z.z = T(-2) / length;
        z.one = -(f.far + f.near) / length;
        break;
      case DepthRange::zero_to_one:
        z.z = T(-1) / length;
        z.one = -f.near / length;
        break;
      case DepthRange::reversed:
        z.z = T(1) / length;
        z.one = f.far / length;
        break;
    }
  }
};

// Any matrix to clip space by its rows: row i yields clip coordinate i of the point (x, y, z, 1).
template <Scalar T>
using MatrixRows = std::array<Vec4<T>, 4>;

template <Scalar T>
constexpr MatrixRows<T> rows_of(const Projection<T>& p) {
  const T o(0);
  return {Vec4<T>(p.x.own, o, p.x.z, p.x.one), Vec4<T>(o, p.y.own, p.y.z, p.y.one),
          Vec4<T>(o, o, p.z.z, p.z.one), Vec4<T>(o, o, p.w.z, p.w.one)};
}

// The same matrix in another scalar; exact where T can hold the numbers given.
template <Scalar T, Scalar U>
constexpr MatrixRows<T> matrix_cast(const MatrixRows<U>& rows) {
  MatrixRows<T> r;
  for (std::size_t i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) r[i][k] = T(rows[i][k]);
  }
  return r;
}

// By a matrix as given, each coordinate summed from left to right.
template <Scalar T>
constexpr Vec4<T> to_clip(const MatrixRows<T>& rows, const Vec3<T>& v) {
  Vec4<T> r;
  for (std::size_t i = 0; i < 4; ++i) {
    const T sum = rows[i][0] * v[0] + rows[i][1] * v[1] + rows[i][2] * v[2] + rows[i][3];
    r[static_cast<int>(i)] = sum;
  }
  return r;
}

// View space to clip space.
template <Scalar T>
constexpr Vec4<T> to_clip(const Projection<T>& p, const Vec3<T>& v) {
  const T x = p.x.own * v[0] + p.x.z * v[2] + p.x.one;
  const T y = p.y.own * v[1] + p.y.z * v[2] + p.y.one;
  const T z = p.z.z * v[2] + p.z.one;
  const T w = p.w.z * v[2] + p.w.one;
  return Vec4<T>(x, y, z, w);
}

// p: a projection or the rows of a matrix.
template <class P, Scalar T, int K>
constexpr ClipVertex<T, K> to_clip(const P& p, const ViewVertex<T, K>& v) {
  return {to_clip(p, v.position), v.attributes};
}

template <class P, Scalar T, int K, std::size_t N>
constexpr std::array<ClipVertex<T, K>, N> to_clip(
    const P& p, const std::array<ViewVertex<T, K>, N>& primitive) {
  std::array<ClipVertex<T, K>, N> r;
  for (std::size_t i = 0; i < N; ++i) r[i] = to_clip(p, primitive[i]);
  return r;
}

// The perspective divide: (x/w, y/w, z/w, 1/w), four divisions, each rounded once. w may be
// anything that T can divide by; what w <= 0 means is the caller's business.
template <Scalar T>
constexpr Vec4<T> to_ndc(const Vec4<T>& v) {
  const T x = v[0] / v[3];
  const T y = v[1] / v[3];
  const T z = v[2] / v[3];
  const T inv_w = T(1) / v[3];
  return Vec4<T>(x, y, z, inv_w);
}

template <Scalar T, int K>
constexpr NdcVertex<T, K> to_ndc(const ClipVertex<T, K>& v) {
  return {to_ndc(v.position), v.attributes};
}

}  // namespace clipscope
