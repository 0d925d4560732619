// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/w_sign/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/render/canvas.hpp"
#include "experiments/render/figure.hpp"
#include "experiments/scenes/builtin.hpp"
#include "experiments/scenes/random.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/survey/verdicts.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"

namespace clipscope::experiments::w_sign {
namespace {

using Vertex4 = ClipVertex<float, kSceneAttributes>;
using Triangle4 = ClipTriangle<float, kSceneAttributes>;
using Polygon4 = ClipPolygon<float, kSceneAttributes>;

double random_w(Kind kind, Random& random) {
  switch (kind) {
    case Kind::negative: return -random.across_magnitudes(0.1, 10);
    case Kind::minus_zero: return -0.0;
    case Kind::zero: return 0.0;
    case Kind::tiny:
      return random.across_magnitudes(w_plane_epsilon(WPlane::smallest_normal), 1e-5);
    default: return random.across_magnitudes(0.1, 10);
  }
}

Vertex4 random_vertex(Kind kind, Random& random) {
  Vertex4 v;
  const auto w = static_cast<float>(random_w(kind, random));
  const bool is_direction = w == 0 || random.chance(0.5);
  const bool is_origin = w == 0 && random.chance(0.125);
  const double size = is_origin ? 0.0 : is_direction ? 1.0 : std::abs(double{w});
  for (int i = 0; i < 3; ++i) v.position[i] = static_cast<float>(random.uniform(-1.5, 1.5) * size);
  v.position[3] = w;
  for (float& a : v.attributes.values) a = static_cast<float>(random.uniform(-1, 1));
  return v;
}

// A polygon of x y z 1/w: its area on 3840 x 2160, and the smallest w.
struct Extent {
  double area_px2 = 0;
  std::optional<double> nearest_w;
};

template <class Vertices>
Extent extent_of(const Vertices& vertices) {
  Extent extent;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto& a = vertices[i];
    const auto& b = vertices[(i + 1) % vertices.size()];
    extent.area_px2 += (a[0] * b[1] - a[1] * b[0]) / 2 * (kScreenWidth / 2) * (kScreenHeight / 2);
    extent.nearest_w = std::min(extent.nearest_w.value_or(HUGE_VAL), 1 / a[3]);
  }
  extent.area_px2 = std::abs(extent.area_px2);
  return extent;
}

template <WPlane kPlane>
Polygon4 cut_by_planes_crossed(const ClipVolume& volume, const Triangle4& triangle) {
  const OutcodeSummary code = summarize_outcodes(volume, triangle);
  if (code.all != 0) return {};
  Polygon4 polygon;
  HomogeneousWFirst<kPlane>::cut_and_then(volume, code.any, triangle, [&](const auto& rest) {
    for (const auto& v : rest) polygon.push_back(v);
  });
  return polygon;
}

template <WPlane kPlane>
constexpr WPlaneClipper kClipper = {
    HomogeneousWFirst<kPlane>::name,
    kPlane == WPlane::none ? std::nullopt : std::optional<double>(w_plane_epsilon(kPlane)),
    cut_by_planes_crossed<kPlane>};

void add_hazard(const Polygon4& polygon, Hazards& hazards) {
  const auto any = [&](auto&& is) { return std::any_of(polygon.begin(), polygon.end(), is); };
  ++hazards.triangles;
  if (any([](const auto& v) { return v.position[3] == 0; })) {
    ++hazards.zero_w;
  } else if (any([](const auto& v) { return v.position[3] < 0; })) {
    ++hazards.negative_w;
  } else if (any([](const auto& v) { return !has_finite_position(to_ndc(v)); })) {
    ++hazards.overflow;
  }
}

Frustum<float> scaled(Frustum<float> f, double scale) {
  for (float* length : {&f.left, &f.right, &f.bottom, &f.top, &f.near, &f.far}) {
    *length = static_cast<float>(*length * scale);
  }
  return f;
}

constexpr int kMargin = 16;      // px
constexpr int kTextHeight = 30;  // px

std::string note_of(const Picture& picture) {
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
  return note;
}

void draw_panel(Canvas& canvas, const FrameBuffer& buffer, int x, int y,
                const std::string& caption) {
  canvas.fitted_text(x, y + kTextHeight - 10, buffer.width, caption,
                     {.size_px = 17, .weight = Weight::bold});
  const int top = y + kTextHeight;
  canvas.outline({x, top, buffer.width, buffer.height}, from_hex(0x808080));
  canvas.paste(shade(buffer), x, top, 1);
}

}  // namespace

std::vector<Pattern> all_patterns() {
  std::vector<Pattern> patterns;
  for (int a = 0; a < 5; ++a) {
    for (int b = a; b < 5; ++b) {
      for (int c = b; c < 5; ++c) {
        patterns.push_back({static_cast<Kind>(a), static_cast<Kind>(b), static_cast<Kind>(c)});
      }
    }
  }
  return patterns;
}

std::string pattern_name(const Pattern& pattern) {
  return fmt::format("{} {} {}", name_of(pattern[0]), name_of(pattern[1]), name_of(pattern[2]));
}

SweepChunk pattern_chunk(const Pattern& pattern, std::size_t triangles, std::uint64_t seed) {
  Random random(seed);
  SweepChunk chunk;
  for (std::size_t i = 0; i < triangles; ++i) {
    auto& triangle = chunk.clip.emplace_back();
    for (std::size_t v = 0; v < 3; ++v) triangle[v] = random_vertex(pattern[v], random);
    random.shuffle(std::span<Vertex4>(triangle));
  }
  return chunk;
}

std::span<const WPlaneClipper> w_plane_clippers() {
  static constexpr std::array kClippers = {
      kClipper<WPlane::none>, kClipper<WPlane::zero>, kClipper<WPlane::smallest_normal>,
      kClipper<WPlane::one_100000th>, kClipper<WPlane::one_16384th>};
  return kClippers;
}

HardCase case_of(const Surface& surface, double scale, bool depth_clamp) {
  HardCase hard_case;
  hard_case.space = Space::view;
  hard_case.volume.depth_clamp = depth_clamp;
  const auto length = [scale](double x) { return double{static_cast<float>(x * scale)}; };
  const double near = length(1e-2);
  hard_case.frustum = {ProjectionKind::perspective, -near, near, -near, near, near, length(1e3)};
  for (const auto& p : surface.corners) {
    reference::InputVertex& v = hard_case.vertices.emplace_back();
    v.position = {length(p[0]), length(p[1]), length(p[2]), 1};
  }
  return hard_case;
}

Loss loss_of(const TruthPolygon& truth, std::span<const std::array<double, 4>> drawn) {
  const Extent visible = extent_of(truth.approximation), left = extent_of(drawn);
  Loss loss{.visible_px2 = visible.area_px2,
            .drawn_px2 = left.area_px2,
            .nearest_visible = visible.nearest_w,
            .nearest_drawn = left.nearest_w};
  loss.lost_px2 = loss.visible_px2 - loss.drawn_px2;
  loss.lost_percent = 100 * loss.lost_px2 / loss.visible_px2;
  if (loss.nearest_visible && loss.nearest_drawn) {
    loss.lost_depth = std::max(0.0, *loss.nearest_drawn - *loss.nearest_visible);
  }
  return loss;
}

std::vector<SweepChunk> scaled_chunks(const Scene& scene, double scale, bool depth_clamp,
                                      std::size_t most) {
  std::vector<SweepChunk> chunks;
  const Spacing spacing = spacing_of(scene, std::max<std::size_t>(1, most / scene.views.size()));
  for (const View& view : scene.views) {
    const Projection<float> projection(scaled(view.frustum, scale));
    SweepChunk& chunk = chunks.emplace_back();
    chunk.volume = projection.volume;
    chunk.volume.depth_clamp = depth_clamp;
    for (SceneTriangle& t : sampled_view_triangles(scene, view, spacing, 0, spacing.count)) {
      for (auto& v : t) {
        for (int i = 0; i < 3; ++i) v.position[i] = static_cast<float>(v.position[i] * scale);
      }
      chunk.clip.push_back(to_clip(projection, t));
    }
  }
  return chunks;
}

Hazards count_hazards(std::span<const SweepChunk> chunks, const WPlaneClipper& clipper) {
  Hazards hazards;
  for (const SweepChunk& chunk : chunks) {
    for (const Triangle4& triangle : chunk.clip) {
      add_hazard(clipper.cut(chunk.volume, triangle), hazards);
    }
  }
  return hazards;
}

LossTally tally_loss(std::span<const SweepChunk> chunks, const WPlaneClipper& clipper) {
  LossTally tally;
  for (const SweepChunk& chunk : chunks) {
    const Batch batch = chunk.batch();
    const auto truths = truth_polygons(reference::Truth::of_clip(chunk.volume), batch);
    const Answers answers = clip(find_contestant(clipper.name, "float"), batch);
    for (std::size_t i = 0; i < truths.size(); ++i) {
      const Loss loss = loss_of(truths[i], positions_of(answers[i]));
      tally.visible_px2 += loss.visible_px2;
      tally.lost_px2 += std::max(0.0, loss.lost_px2);
      tally.vanished += loss.visible_px2 >= 1 && loss.drawn_px2 == 0;
    }
  }
  if (tally.visible_px2 != 0) tally.lost_percent = 100 * tally.lost_px2 / tally.visible_px2;
  return tally;
}

Scene triangle_behind_the_eye() {
  Scene scene{"triangle", "one triangle with a vertex behind the eye", {}, {identity_view()}};
  add_vertex(scene.mesh, {-1.5, -1, -3}, {0, 0, -1, -1});
  add_vertex(scene.mesh, {2, -0.6, -4}, {1, 0, 1, -1});
  add_vertex(scene.mesh, {0.2, 0.5, 1}, {0, 1, -1, 1});
  scene.mesh.triangles = {{0, 1, 2}};
  return scene;
}

Picture draw_picture(const Scene& scene, const PictureSize& size) {
  const View& view = scene.views.front();
  FrameBuffer naive = draw_with(find_contestant("cvv/naive", "float"), scene, view, size);
  FrameBuffer exact = draw_exact(scene, view, size);
  const HeatMapCounts counts = compare(naive, exact).counts;
  return {scene.name, std::move(naive), std::move(exact), counts};
}

Image side_by_side(std::span<const Picture> pictures) {
  const int width = pictures.front().exact.width, height = pictures.front().exact.height;
  const int row_height = height + 2 * kTextHeight + kMargin;
  const int sheet_width = 2 * width + 3 * kMargin;
  Canvas canvas(sheet_width, static_cast<int>(pictures.size()) * row_height + kMargin,
                from_hex(0xffffff));
  int y = kMargin / 2;
  for (const Picture& picture : pictures) {
    draw_panel(canvas, picture.naive, kMargin, y,
               picture.scene + ": divided first, then clipped (cvv/naive)");
    draw_panel(canvas, picture.exact, width + 2 * kMargin, y, picture.scene + ": what is there");
    canvas.fitted_text(kMargin, y + height + 2 * kTextHeight - 8, sheet_width - 2 * kMargin,
                       note_of(picture), {.size_px = 16});
    y += row_height;
  }
  return canvas.image();
}

}  // namespace clipscope::experiments::w_sign
