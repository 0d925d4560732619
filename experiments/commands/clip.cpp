// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope clip: points, segments, triangles or polygons in, what is left of them out.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/primitive_text.hpp"
#include "experiments/commands/vertex_rows.hpp"
#include "experiments/commands/volume_options.hpp"
#include "experiments/contestants/contestant.hpp"
#include "experiments/errors.hpp"
#include "experiments/primitives/triangulate.hpp"
#include "spaces/clippers.hpp"
#include "spaces/homogeneous/polygon.hpp"

namespace clipscope::experiments {
namespace {

struct ClipOptions {
  Primitive primitive = Primitive::triangle;
  PrimitiveTextOptions text;
  VolumeOptions volume;
  std::string clipper;  // empty: default_clipper(primitive)
  double point_size = 0;
  std::array<int, 2> viewport = {0, 0};  // 0: not given
  bool hex = false;
};

template <class T>
using PolygonClipper = HomogeneousPolygonClipper<T, kRunTime>;

// What primitives are clipped against, in one scalar.
template <class T>
struct Setting {
  bool in_view_space;
  Projection<T> projection;  // its volume is the one of both spaces
  std::vector<Vec4<T>> planes;
  int attributes;  // of the input
};

template <class T>
Setting<T> setting_of(const ClipOptions& options) {
  Setting<T> s{options.text.space == "view", projection_from<T>(frustum_of(options.text)),
               planes_in<T>(options.volume), options.text.attributes};
  s.projection.volume = volume_of(options.volume, depth_range(options.text), s.attributes);
  return s;
}

// The primitive's vertices, the distances to the user's planes in front of their attributes.
template <Space S, class T>
std::vector<Vertex<S, T, kRunTime>> vertices_in(const Setting<T>& setting,
                                                const TextPrimitive& primitive) {
  auto vertices = vertices_of<T, S>(primitive, setting.attributes);
  for (Vertex<S, T, kRunTime>& v : vertices) prepend_distances(setting.planes, v);
  return vertices;
}

// Calls clip(projection, vertices) in view space, clip(volume, vertices) in clip space.
template <class T, class Clip>
void with_vertices(const Setting<T>& setting, const TextPrimitive& primitive, Clip&& clip) {
  if (setting.in_view_space) {
    clip(setting.projection, vertices_in<Space::view>(setting, primitive));
  } else {
    clip(setting.projection.volume, vertices_in<Space::clip>(setting, primitive));
  }
}

template <class T>
VertexRows rows_of(const ClipOptions& options, const Setting<T>& setting,
                   std::string_view columns) {
  return VertexRows(columns, static_cast<int>(setting.planes.size()), setting.attributes,
                    options.hex);
}

// Errors: UsageError if the clipper does not take the input's space or the volume's options.
template <class T, std::size_t N>
void check_takes(const Contestant<T, N>& contestant, const Setting<T>& setting) {
  if (!setting.in_view_space && contestant.clip_one == nullptr) {
    throw UsageError(
        fmt::format("--clipper: {} starts in view space, so clip-space coordinates are not "
                    "applicable",
                    contestant.name));
  }
  check_applicable(contestant.name, contestant.promise, setting.projection.volume);
}

// Half of a point's square in NDC; 0 if no size was given. Errors: UsageError.
template <class T>
PointSize<T> point_size_of(const ClipOptions& options) {
  if (options.viewport[0] == 0) return {};
  const T size = scalar_from<T>(std::isfinite(options.point_size) ? options.point_size : -1);
  if (!is_finite(size) || size < T(0)) {
    throw UsageError(fmt::format("--point-size: {} is not finite in {}", options.point_size,
                                 ScalarTraits<T>::name));
  }
  return point_size_ndc<T>(size, scalar_from<T>(options.viewport[0]),
                           scalar_from<T>(options.viewport[1]));
}

// Where: a projection for a primitive in view space, a volume for one in clip space.
template <class T, std::size_t N, class Where, class Input>
void clip_one(const Contestant<T, N>& contestant, const Where& where, const Input& input,
              NdcPolygon<T, kRunTime>& out) {
  if constexpr (std::same_as<Where, ClipVolume>) {
    contestant.clip_one(where, input, out);
  } else {
    contestant.view_one(where, input, out);
  }
}

// Contestants take points of size 0 only, so the clipper of that name is called itself.
template <class T, class Where, class Point>
void clip_sized_point(std::string_view clipper, const PointSize<T>& size, const Where& where,
                      const Point& point, NdcPolygon<T, kRunTime>& out) {
  for_each_type(AllPointClippers{}, [&]<class C>() {
    if (C::name == clipper) C{}(where, point, size, out);
  });
}

template <class T, std::size_t N>
void clip_simplices_by(const Contestant<T, N>& contestant, const ClipOptions& options) {
  const Setting<T> setting = setting_of<T>(options);
  check_takes(contestant, setting);
  const PointSize<T> size = point_size_of<T>(options);
  const auto primitives = read_primitives(options.text, options.primitive);
  VertexRows rows = rows_of(options, setting, to_string(options.primitive));
  const auto out = std::make_unique<NdcPolygon<T, kRunTime>>();
  const auto clip = [&]<Space S>(const auto& where,
                                 const std::vector<Vertex<S, T, kRunTime>>& vertices) {
    const auto simplex = simplex_of<S, T, N>(vertices);
    if constexpr (N == 1) {
      clip_sized_point(contestant.name, size, where, simplex, *out);
    } else {
      clip_one(contestant, where, simplex, *out);
    }
  };
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    with_vertices(setting, primitives[i], clip);
    rows.add(std::to_string(i), *out);
  }
  rows.flush();
}

template <std::size_t N>
void clip_simplices(const ClipOptions& options) {
  std::visit([&](const auto* contestant) { clip_simplices_by(*contestant, options); },
             find_contestant<N>(options.clipper, options.text.scalar));
}

template <std::size_t D>
std::vector<std::array<double, D>> points_of(const TextPrimitive& polygon, int attributes) {
  const std::size_t stride = D + static_cast<std::size_t>(attributes);
  std::vector<std::array<double, D>> points(polygon.values.size() / stride);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::copy_n(polygon.values.begin() + static_cast<std::ptrdiff_t>(i * stride), D,
                points[i].begin());
  }
  return points;
}

// The parts that are clipped one by one: triangles, or the polygon itself where it may be `whole`.
template <std::size_t D>
std::vector<IndexPolygon> parts_of(const TextPrimitive& polygon, const ClipOptions& options,
                                   bool whole) {
  const auto points = points_of<D>(polygon, options.text.attributes);
  const std::span<const std::array<double, D>> corners = points;
  const std::string place = place_of(options.text, polygon);
  if (whole) return convex_parts(corners, place);
  std::vector<IndexPolygon> parts;
  for (const IndexTriangle& t : triangulate(corners, place)) parts.emplace_back(t.begin(), t.end());
  return parts;
}

// Of all polygons before any is clipped: nothing is written if one of them is in error.
std::vector<std::vector<IndexPolygon>> parts_of(const std::vector<TextPrimitive>& polygons,
                                                const ClipOptions& options, bool whole) {
  std::vector<std::vector<IndexPolygon>> parts;
  for (const TextPrimitive& polygon : polygons) {
    parts.push_back(options.text.space == "view" ? parts_of<3>(polygon, options, whole)
                                                 : parts_of<4>(polygon, options, whole));
  }
  return parts;
}

template <class V>
std::vector<V> part_of(const std::vector<V>& vertices, const IndexPolygon& indices) {
  std::vector<V> part;
  for (const int i : indices) part.push_back(vertices[static_cast<std::size_t>(i)]);
  return part;
}

// whole: by the clipper of convex polygons; else every triangle by the contestant.
template <class T>
void clip_polygons_by(const Contestant<T>& contestant, bool whole, const ClipOptions& options) {
  const Setting<T> setting = setting_of<T>(options);
  if (!whole) check_takes(contestant, setting);
  const auto polygons = read_primitives(options.text, options.primitive);
  const auto parts = parts_of(polygons, options, whole);
  VertexRows rows = rows_of(options, setting, "polygon,part");
  PolygonClipper<T> clip_whole;
  const auto out = std::make_unique<NdcPolygon<T, kRunTime>>();
  const auto clip_part = [&]<Space S>(const std::string& number, const auto& where,
                                      const std::vector<Vertex<S, T, kRunTime>>& part) {
    if (whole) {
      rows.add(number, clip_whole(where, part));
    } else {
      clip_one(contestant, where, simplex_of<S, T, 3>(part), *out);
      rows.add(number, *out);
    }
  };
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    with_vertices(setting, polygons[i], [&](const auto& where, const auto& vertices) {
      for (std::size_t p = 0; p < parts[i].size(); ++p) {
        clip_part(fmt::format("{},{}", i, p), where, part_of(vertices, parts[i][p]));
      }
    });
  }
  rows.flush();
}

AnyContestant triangle_clipper(const ClipOptions& options) {
  try {
    return find_contestant(options.clipper, options.text.scalar);
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("{}; of polygons there is {}", error.what(),
                                 default_clipper(Primitive::polygon)));
  }
}

void clip_polygons(const ClipOptions& options) {
  const std::string_view name = default_clipper(Primitive::polygon);
  const bool whole = options.clipper == name || name.ends_with("/" + options.clipper);
  // Stands for its scalar; an error here is about --scalar.
  AnyContestant chosen = find_contestant(default_clipper(Primitive::triangle), options.text.scalar);
  if (!whole) chosen = triangle_clipper(options);
  std::visit([&](const auto* contestant) { clip_polygons_by(*contestant, whole, options); },
             chosen);
}

int clip_text(ClipOptions options) {
  if (options.primitive != Primitive::point && options.viewport[0] != 0) {
    throw UsageError(fmt::format("--point-size and --viewport go with --primitive point, not {}",
                                 to_string(options.primitive)));
  }
  if (options.clipper.empty()) options.clipper = default_clipper(options.primitive);
  switch (options.primitive) {
    case Primitive::point: clip_simplices<1>(options); break;
    case Primitive::segment: clip_simplices<2>(options); break;
    case Primitive::triangle: clip_simplices<3>(options); break;
    case Primitive::polygon: clip_polygons(options); break;
  }
  return kExitOk;
}

// "640x480". Errors: CLI::ValidationError.
std::array<int, 2> parse_viewport(const std::string& text) {
  std::array<int, 2> size = {0, 0};
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size[0]);
  if (width.ptr != end && *width.ptr == 'x') {
    const auto height = std::from_chars(width.ptr + 1, end, size[1]);
    if (height.ptr == end && size[0] > 0 && size[1] > 0) return size;
  }
  throw CLI::ValidationError(
      "--viewport", fmt::format("'{}' given, WxH in pixels expected, such as 1920x1080", text));
}

void add_point_options(CLI::App& command, ClipOptions& options) {
  CLI::Option* size = command
                          .add_option("--point-size", options.point_size,
                                      "Side of a point's square in pixels, for point/pop_free [0]")
                          ->type_name("PX")
                          ->check(CLI::NonNegativeNumber);
  CLI::Option* viewport =
      command
          .add_option_function<std::string>(
              "--viewport",
              [&options](const std::string& text) { options.viewport = parse_viewport(text); },
              "Size in pixels of what the volume is drawn to")
          ->type_name("WxH");
  size->needs(viewport);
  viewport->needs(size);
}

constexpr const char* kFooter =
    "Input, a primitive per line: its vertices, each x y z (view) or x y z w (clip) and its K\n"
    "attributes, decimal or C99 hex floats, separated by blanks or commas; # starts a comment. A\n"
    "polygon has 3 vertices or more.\n"
    "Output: triangle,vertex,x,y,z,inv_w,a0,... one row per vertex of what is left, coordinates "
    "in\n"
    "NDC; segment,vertex,... and point,vertex,... likewise, and polygon,part,vertex,...: a "
    "concave\n"
    "polygon is triangulated and its triangles are clipped, as all polygons are by a clipper of\n"
    "triangles. --clipper is by default homogeneous/sutherland_hodgman for triangles,\n"
    "homogeneous/liang_barsky for segments, point/pop for points, homogeneous/polygon for "
    "polygons.\n"
    "Numbers are rounded once when read: to float for float and counting, to double otherwise.\n"
    "Examples:\n"
    "  echo '-2 0 0 1  2 0 0 1' | clipscope clip --space clip --primitive segment --plane "
    "1,0,0,0.5\n"
    "  echo '0 0 0 1 7  2 0 0 1 -1  0 .5 0 1 7' | clipscope clip --space clip --attributes 1 "
    "--clip-distances 1\n"
    "  echo '1.1 0 0 1' | clipscope clip --space clip --primitive point --clipper pop_free "
    "--point-size 32 --viewport 256x256";

}  // namespace

void add_clip_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("clip", "Clip primitives given as text; write CSV");
  command->footer(kFooter);
  const auto options = std::make_shared<ClipOptions>();
  static const std::map<std::string, Primitive> kPrimitives = {{"triangle", Primitive::triangle},
                                                               {"segment", Primitive::segment},
                                                               {"point", Primitive::point},
                                                               {"polygon", Primitive::polygon}};
  command
      ->add_option_function<std::string>(
          "--primitive",
          [options](const std::string& name) { options->primitive = kPrimitives.at(name); },
          "What a line holds: triangle, segment, point or polygon [triangle]")
      ->check(CLI::IsMember({"triangle", "segment", "point", "polygon"}));
  add_primitive_text_options(*command, options->text);
  command->add_option("--clipper", options->clipper, "Name of a clipper [see below]")
      ->type_name("NAME");
  add_volume_options(*command, options->volume);
  add_point_options(*command, *options);
  command->add_flag("--hex", options->hex, "Write hex floats");
  command->callback([&action, options] { action = [options] { return clip_text(*options); }; });
}

}  // namespace clipscope::experiments
