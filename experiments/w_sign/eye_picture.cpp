// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/w_sign/eye_picture.hpp"

#include <fmt/format.h>

#include "experiments/scenes/families.hpp"

namespace clipscope::experiments {

Scene triangle_behind_the_eye() {
  Scene scene;
  scene.name = "triangle";
  scene.description = "one triangle with a vertex behind the eye";
  add_vertex(scene.mesh, {-1.5, -1, -3}, {0, 0, -1, -1});
  add_vertex(scene.mesh, {2, -0.6, -4}, {1, 0, 1, -1});
  add_vertex(scene.mesh, {0.2, 0.5, 1}, {0, 1, -1, 1});
  scene.mesh.triangles = {{0, 1, 2}};
  scene.views = {identity_view()};
  return scene;
}

EyePicture draw_eye_picture(const Scene& scene, const PictureSize& size) {
  const View& view = scene.views.front();
  FrameBuffer naive = draw_with(find_contestant("cvv/naive", "float"), scene, view, size);
  FrameBuffer exact = draw_exact(scene, view, size);
  const HeatMapCounts counts = compare(naive, exact).counts;
  return {scene.name, std::move(naive), std::move(exact), counts};
}

PanelRow panel_row(const EyePicture& picture) {
  const auto percent = [&](PixelFate fate) {
    return 100.0 * static_cast<double>(picture.counts[fate]) /
           static_cast<double>(picture.exact.pixels());
  };
  std::string note = fmt::format(
      "{:.1f} % of the pixels are holes, {:.1f} % show what is not there, {:.1f} % the other side",
      percent(PixelFate::hole), percent(PixelFate::extra), percent(PixelFate::flipped));
  if (picture.counts.compared() > 0) {
    note += fmt::format("; of the rest {:.1f} % are off by more than a texel",
                        100 * picture.counts.share_above_one);
  }
  return {&picture.naive, &picture.exact,
          picture.scene + ": divided first, then clipped (cvv/naive)",
          picture.scene + ": what is there", note};
}

}  // namespace clipscope::experiments
