// SPDX-License-Identifier: GPL-3.0-or-later
//
// Input as the commands `clip` and `explain` read it, to the bit: what a command that replays a
// case is made of.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "experiments/contestants/batch.hpp"
#include "reference/truth.hpp"
#include "spaces/projection.hpp"

namespace clipscope::experiments {

// The depth convention as --depth names it.
std::string_view depth_option(DepthRange depth);

// "--depth gl", and the volume's other options, as " --depth-clamp=near --clip-distances 1".
std::string volume_options(const ClipVolume& volume);

// "--frustum L,R,B,T,N,F" or "--ortho ...", with "--shear SX,SY" if it is oblique, in hex floats.
std::string frustum_options(const Frustum<float>& frustum);

// "--matrix M00,M01,..." by rows, in hex floats.
std::string matrix_option(const MatrixRows<float>& rows);

// What the view is clipped against: its frustum or its matrix, as an option.
std::string projection_options(const View& view);

// One line of hex floats: of each vertex `dimension` coordinates (3: view space, 4: clip space),
// then the attributes.
std::string hex_line(std::span<const reference::InputVertex> vertices, int dimension,
                     int attribute_count);

// A view-space or clip-space primitive with all its attributes, or with the first so many.
template <Space S, std::floating_point T, int K, std::size_t N>
std::string hex_line(const Simplex<S, T, K, N>& primitive, int attribute_count = K) {
  std::array<reference::InputVertex, N> vertices;
  for (std::size_t i = 0; i < N; ++i) vertices[i] = reference::input_vertex(primitive[i]);
  return hex_line(vertices, Vertex<S, T, K>::kDimension, attribute_count);
}

// What `clip` and `explain` need to see a segment or a triangle again: options, " : ", its line.
std::string replay_text(const Batch& batch, std::size_t primitive);

}  // namespace clipscope::experiments
