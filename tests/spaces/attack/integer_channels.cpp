// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers of a triangle as integers, and what the floats of the answer are quotients of; see
// integer_clip.hpp.
#include "tests/spaces/attack/integer_vertices.hpp"

namespace clipscope::attack {
namespace {

Channel constant_denominator(const Weights& numerator, const Integer& denominator) {
  return {numerator, {denominator, denominator, denominator}};
}

Channel depth_in_view(const Vertices& vertices, const Frustum& f, Depth depth) {
  const Integer n = scaled(f.near), far = scaled(f.far);
  // (of_z z + constant) / (scale w), by the projection matrices of the textbooks.
  Integer of_z, constant, scale;
  if (f.is_infinite) {
    of_z = depth == Depth::one_to_zero ? 0 : -1;
    constant = depth == Depth::minus_one_to_one ? Integer(-2 * n)
               : depth == Depth::zero_to_one    ? Integer(-n)
                                                : n;
    scale = 1;
  } else if (f.is_perspective) {
    const Integer both = far * n;
    of_z = depth == Depth::minus_one_to_one ? Integer(-(far + n))
           : depth == Depth::zero_to_one    ? Integer(-far)
                                            : n;
    constant = depth == Depth::minus_one_to_one ? Integer(-2 * both)
               : depth == Depth::zero_to_one    ? Integer(-both)
                                                : both;
    scale = far - n;
  } else {
    of_z = depth == Depth::minus_one_to_one ? -2 : depth == Depth::zero_to_one ? -1 : 1;
    constant = depth == Depth::minus_one_to_one ? Integer(-(far + n))
               : depth == Depth::zero_to_one    ? Integer(-n)
                                                : far;
    scale = far - n;
  }
  const Weights z = vertices.floats(2);
  Channel r;
  for (std::size_t v = 0; v < 3; ++v) {
    r.numerator[v] = of_z * z[v] + constant;
    r.denominator[v] = f.is_perspective ? Integer(scale * -z[v]) : scale;
  }
  return r;
}

Channel side_in_view(const Vertices& vertices, const Frustum& f, std::size_t axis) {
  const Integer low = scaled(axis == 0 ? f.left : f.bottom),
                high = scaled(axis == 0 ? f.right : f.top), n = scaled(f.near),
                shear = scaled(axis == 0 ? f.shear_x : f.shear_y);
  const Weights c = vertices.floats(axis), z = vertices.floats(2);
  Channel r;
  for (std::size_t v = 0; v < 3; ++v) {
    if (f.is_perspective) {
      r.numerator[v] = 2 * n * c[v] + (high + low) * z[v];
      r.denominator[v] = (high - low) * -z[v];
    } else {
      r.numerator[v] = (2 * c[v] - high - low) * one() + 2 * shear * z[v];
      r.denominator[v] = (high - low) * one();
    }
  }
  return r;
}

}  // namespace

Weights w_of(const Batch& batch, const Vertices& vertices) {
  if (!batch.is_view()) return vertices.floats(3);
  if (!batch.frustum->is_perspective) return {one(), one(), one()};
  const Weights z = vertices.floats(2);
  return {Integer(-z[0]), Integer(-z[1]), Integer(-z[2])};
}

std::vector<Channel> ndc_channels(const Batch& batch, std::size_t triangle) {
  const Vertices vertices(batch, triangle);
  std::vector<Channel> r;
  const Weights w = w_of(batch, vertices);
  if (batch.is_view()) {
    r = {side_in_view(vertices, *batch.frustum, 0), side_in_view(vertices, *batch.frustum, 1),
         depth_in_view(vertices, *batch.frustum, batch.volume.depth)};
  } else {
    for (std::size_t c = 0; c < 3; ++c) r.push_back({vertices.floats(c), w});
  }
  r.push_back({{one(), one(), one()}, w});
  for (int k = 0; k < batch.attributes; ++k) {
    r.push_back(constant_denominator(vertices.attribute(k), one()));
  }
  return r;
}

std::vector<Channel> clip_channels(const Batch& batch, std::size_t triangle) {
  const Vertices vertices(batch, triangle);
  std::vector<Channel> r;
  for (std::size_t k = 0; k < batch.stride(); ++k) {
    r.push_back(constant_denominator(vertices.floats(k), one()));
  }
  return r;
}

}  // namespace clipscope::attack
