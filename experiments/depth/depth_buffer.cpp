// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/depth/depth_buffer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "experiments/contestants/scalars.hpp"

namespace clipscope::experiments {
namespace {

Frustum<double> frustum(const DepthConvention& convention, float near, float far) {
  const double n = near, f = far;
  return {.left = -n,
          .right = n,
          .bottom = -n,
          .top = n,
          .near = n,
          .far = f,
          .infinite_far = convention.infinite_far,
          .depth = convention.range};
}

// The largest code of a fixed-point format; 0 for float.
double largest_code(DepthFormat format) {
  switch (format) {
    case DepthFormat::unorm16: return 0xffff;
    case DepthFormat::unorm24: return 0xffffff;
    case DepthFormat::float32: break;
  }
  return 0;
}

template <class T>
T window_depth_in(const Projection<T>& projection, float distance) {
  const Vec4<T> clip = to_clip(projection, Vec3<T>(T(0), T(0), -T(distance)));
  const T ndc = clip[2] / clip[3];
  if (projection.volume.depth == DepthRange::minus_one_to_one) return T(0.5) * ndc + T(0.5);
  return ndc;
}

}  // namespace

std::string_view format_name(DepthFormat format) {
  switch (format) {
    case DepthFormat::unorm16: return "unorm16";
    case DepthFormat::unorm24: return "unorm24";
    case DepthFormat::float32: break;
  }
  return "float32";
}

DepthBuffer::DepthBuffer(const DepthConvention& convention, DepthFormat format,
                         DepthArithmetic arithmetic, float near, float far)
    : convention_(convention),
      format_(format),
      arithmetic_(arithmetic),
      near_(near),
      far_(far),
      in_float_(projection_from<float>(frustum(convention, near, far))),
      in_double_(projection_from<double>(frustum(convention, near, far))),
      truth_(reference::Truth::of_frustum(frustum(convention, near, far))) {}

double DepthBuffer::window_depth(float distance) const {
  return arithmetic_ == DepthArithmetic::in_float ? double{window_depth_in(in_float_, distance)}
                                                  : window_depth_in(in_double_, distance);
}

double DepthBuffer::stored(float distance) const {
  const double depth = std::clamp(window_depth(distance), 0.0, 1.0);
  if (format_ == DepthFormat::float32) return static_cast<float>(depth);
  const double largest = largest_code(format_);
  return std::nearbyint(depth * largest) / largest;
}

std::int64_t DepthBuffer::code(float distance) const {
  const double depth = stored(distance);
  // The bits of floats >= 0 are in the order of their values.
  const std::int64_t place = format_ == DepthFormat::float32
                                 ? std::bit_cast<std::int32_t>(static_cast<float>(depth) + 0.0f)
                                 : std::llround(depth * largest_code(format_));
  return convention_.range == DepthRange::reversed ? -place : place;
}

reference::Rational DepthBuffer::exact(float distance) const {
  reference::InputVertex vertex;
  vertex.position = {0, 0, -double{distance}, 1};
  const auto clip = truth_.clip_position(vertex);
  const reference::Rational ndc = clip[2] / clip[3];
  if (convention_.range != DepthRange::minus_one_to_one) return ndc;
  const reference::Rational window = (ndc + 1) / 2;
  return window;
}

double DepthBuffer::error_ulp(float distance) const {
  const reference::Rational right = exact(distance);
  const reference::Rational difference = reference::to_rational(stored(distance)) - right;
  const double error = std::abs(CGAL::to_double(difference));
  if (format_ == DepthFormat::float32) return error / ulp_at<float>(CGAL::to_double(right));
  return error * largest_code(format_);
}

}  // namespace clipscope::experiments
