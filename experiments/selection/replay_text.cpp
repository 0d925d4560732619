// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/selection/replay_text.hpp"

#include <fmt/format.h>

#include <utility>

#include "experiments/table/hex_float.hpp"

namespace clipscope::experiments {

std::string_view depth_option(DepthRange depth) {
  constexpr std::array<std::string_view, 3> kNames = {"gl", "zero_to_one", "reversed"};
  return kNames[static_cast<std::size_t>(depth)];
}

std::string volume_options(const ClipVolume& volume) {
  std::string text = fmt::format("--depth {}", depth_option(volume.depth));
  const DepthClamp& clamp = volume.depth_clamp;
  if (clamp) {
    text += " --depth-clamp";
    if (!clamp.far) text += "=near";
    if (!clamp.near) text += "=far";
  }
  const OpenSides& open = volume.open_sides;
  std::string sides;
  for (const auto& [is_open, side] :
       {std::pair(open.left, "left"), std::pair(open.right, "right"),
        std::pair(open.bottom, "bottom"), std::pair(open.top, "top")}) {
    if (is_open) sides += (sides.empty() ? " --half-open=" : ",") + std::string(side);
  }
  text += sides;
  if (volume.clip_distances > 0) text += fmt::format(" --clip-distances {}", volume.clip_distances);
  return text;
}

std::string frustum_options(const Frustum<float>& f) {
  const bool is_oblique = f.shear_x != 0 || f.shear_y != 0;
  return fmt::format(
      "--{} {},{},{},{},{},{}{}", f.kind == ProjectionKind::perspective ? "frustum" : "ortho",
      hex_float(f.left), hex_float(f.right), hex_float(f.bottom), hex_float(f.top),
      hex_float(f.near), f.infinite_far ? "inf" : hex_float(f.far),
      is_oblique ? fmt::format(" --shear {},{}", hex_float(f.shear_x), hex_float(f.shear_y)) : "");
}

std::string matrix_option(const MatrixRows<float>& rows) {
  std::string text;
  for (const Vec4<float>& row : rows) {
    for (int k = 0; k < 4; ++k) text += (text.empty() ? "" : ",") + hex_float(row[k]);
  }
  return "--matrix " + text;
}

std::string projection_options(const View& view) {
  return view.matrix ? matrix_option(*view.matrix) : frustum_options(view.frustum);
}

std::string hex_line(std::span<const reference::InputVertex> vertices, int dimension,
                     int attribute_count) {
  std::string text;
  const auto add = [&](double value) { text += (text.empty() ? "" : " ") + hex_float(value); };
  for (const reference::InputVertex& v : vertices) {
    for (int c = 0; c < dimension; ++c) add(v.position[static_cast<std::size_t>(c)]);
    for (int k = 0; k < attribute_count; ++k) add(v.attributes[static_cast<std::size_t>(k)]);
  }
  return text;
}

std::string replay_text(const Batch& batch, std::size_t primitive) {
  std::string options = batch.space == Space::view ? "--space view " : "--space clip ";
  if (batch.vertices == 2) options += "--primitive segment ";
  if (batch.matrix) {
    options += matrix_option(matrix_cast<float>(*batch.matrix)) + " ";
  } else if (batch.space == Space::view) {
    options += frustum_options(frustum_cast<float>(batch.frustum)) + " ";
  }
  return fmt::format(
      "{}{} --attributes {} : {}", options, volume_options(batch.volume), batch.attributes,
      hex_line(input_vertices(batch, primitive), batch.dimension(), batch.attributes));
}

}  // namespace clipscope::experiments
