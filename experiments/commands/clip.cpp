// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope clip: points, segments, triangles or polygons in, what is left of them out.
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "experiments/commands/guest_options.hpp"
#include "experiments/commands/options.hpp"
#include "experiments/contestants/contestant.hpp"
#include "experiments/machine/warning.hpp"
#include "experiments/scenes/flatness.hpp"
#include "experiments/scenes/triangulate.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/table/hex_float.hpp"

namespace clipscope::experiments::commands {
namespace {

constexpr std::size_t kBlock = 1024;  // primitives clipped at once, so that memory does not grow

struct ClipOptions {
  Primitive primitive = Primitive::triangle;
  PrimitiveTextOptions text;
  std::string clipper;  // empty: that of a guest, or default_clipper(primitive)
  GuestOptions guests;
  VolumeOptions volume;
  std::optional<double> point_size;
  std::optional<std::array<double, 2>> viewport;
  std::optional<Scissor> scissor;      // whose viewport is not filled
  bool hex = false, fraction = false;  // how numbers are written: decimal without either
};

// All but the primitives. Errors: UsageError.
Batch batch_without_primitives(const ClipOptions& options, const Contestant& contestant) {
  const Format& format = *contestant.format;
  Batch batch = described_batch(options.text);
  set_volume(options.volume, format, batch);
  if (options.point_size && !is_finite_in(format, *options.point_size)) {
    usage_error("--point-size: {} is not finite in {}", *options.point_size, format.name);
  }
  batch.vertices = contestant.vertices;
  if (options.point_size) batch.point = PointOptions{*options.point_size, *options.viewport};
  return batch;
}

// A clipper of triangles does for polygons, too. Errors: UsageError.
const Contestant& chosen_clipper(const ClipOptions& options) {
  const std::string& name = options.clipper;
  const std::string& scalar = options.text.scalar;
  if (options.primitive != Primitive::polygon) {
    return find_contestant(name, scalar, static_cast<int>(vertices_of(options.primitive)));
  }
  const Contestant* guest = find_in_contract(name, scalar, Contract::full, 0);
  if (guest != nullptr && guest->is_guest) return *guest;
  const Contestant& whole = find_contestant(default_clipper(Primitive::polygon), scalar, 0);
  if (name == whole.clipper || whole.clipper.ends_with("/" + name)) return whole;
  try {
    return find_contestant(name, scalar);
  } catch (const UsageError& error) {
    usage_error("{}; of polygons there is {}", error.what(), whole.clipper);
  }
}

// A primitive, or a part of a polygon: what gets an answer of its own.
struct Part {
  std::string label;  // what the columns in front say of it: "7" or "7,0"
  std::vector<double> values;
};

// The polygons that do not lie in a plane.
struct NotFlat {
  std::size_t count = 0;
  std::string place;  // of the one that is farthest off
  Departure largest;

  void add(const std::string& polygon_place, const Departure& departure) {
    if (departure.is_flat()) return;
    ++count;
    if (departure.distance <= largest.distance) return;
    place = polygon_place;
    largest = departure;
  }
  // Which surface was clipped is for the user to know.
  void report() const {
    if (count == 0) return;
    fmt::print(
        stderr,
        "clipscope: note: {} not flat and clipped as triangles, whose diagonals are chosen here; the most at {}, where vertex {} (counted from 0) is {:.3g} off the plane of others; give triangles to choose the diagonals\n",
        count == 1 ? "1 polygon is" : fmt::format("{} polygons are", count), place, largest.vertex,
        largest.distance);
  }
};

// What a polygon is clipped in: its convex parts if it may stay whole, else its triangles.
// D: coordinates of a vertex; stride: all its numbers. Errors: InputError.
template <std::size_t D>
std::vector<IndexPolygon> parts_of(const TextPrimitive& polygon, std::size_t stride, bool whole,
                                   NotFlat& not_flat) {
  std::vector<std::array<double, D>> points(polygon.values.size() / stride);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::copy_n(&polygon.values[i * stride], D, points[i].begin());
  }
  const std::span<const std::array<double, D>> corners = points;
  std::vector<IndexPolygon> parts;
  if (whole) {
    parts = convex_parts(corners, polygon.place);
  } else {
    for (const IndexTriangle& t : triangulate(corners, polygon.place)) {
      parts.emplace_back(t.begin(), t.end());
    }
  }
  not_flat.add(polygon.place, departure_from_plane(corners));
  return parts;
}

// Errors: InputError.
std::vector<Part> read_parts(const ClipOptions& options, const Batch& batch) {
  std::vector<TextPrimitive> primitives = read_primitives(options.text, options.primitive);
  const auto parts_of_polygon = batch.space == Space::view ? parts_of<3> : parts_of<4>;
  std::vector<Part> parts;
  NotFlat not_flat;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    std::vector<double>& values = primitives[i].values;
    if (options.primitive != Primitive::polygon) {
      parts.push_back({std::to_string(i), std::move(values)});
      continue;
    }
    int number = 0;
    for (const IndexPolygon& indices :
         parts_of_polygon(primitives[i], batch.stride(), batch.vertices == 0, not_flat)) {
      Part& part = parts.emplace_back(Part{fmt::format("{},{}", i, number++), {}});
      for (const int v : indices) {
        const double* first = &values[static_cast<std::size_t>(v) * batch.stride()];
        part.values.insert(part.values.end(), first, first + batch.stride());
      }
    }
  }
  not_flat.report();
  return parts;
}

Answers clip_parts(std::span<const Part> parts, const Contestant& contestant, Batch batch) {
  std::vector<double> values;
  std::vector<std::size_t> ends;
  for (const Part& part : parts) {
    values.insert(values.end(), part.values.begin(), part.values.end());
    ends.push_back(values.size() / batch.stride());
  }
  batch.numbers = std::span<const double>(values);
  batch.ends = ends;
  return clip(contestant, batch);
}

// Numerator/denominator in lowest terms, an integer without the denominator 1; "inf", "-inf" or
// "nan" of what has none.
std::string fraction_text(const Number& x) {
  return is_finite(x) ? to_exact(x).get_str() : fmt::format("{}", x.value);
}

// A fraction, a hex float, or the shortest decimal that reads back as the same number. As a float
// what a double does not hold is the nearest double, but decimals of double-double have 32 digits.
std::string number_text(const Format& format, const Number& x, const ClipOptions& options) {
  if (options.fraction) return fraction_text(x);
  if (options.hex) return hex_float(x.value);
  if (format.precision == kFormat<dd_real>.precision) return dd_real(x.value, x.rest).to_string(32);
  return format.is_float() ? fmt::format("{}", static_cast<float>(x.value))
                           : fmt::format("{}", x.value);
}

std::string head_row(const ClipOptions& options) {
  const bool in_parts = options.primitive == Primitive::polygon;
  std::string row =
      fmt::format("{}{},vertex,x,y,z,inv_w", to_string(options.primitive), in_parts ? ",part" : "");
  for (int k = 0; k < options.text.attributes; ++k) row += fmt::format(",a{}", k);
  return row + '\n';
}

// A row for each vertex. The distances to planes, which lead the attributes, are left out.
void add_rows(const std::string& label, const PolygonView& polygon, const ClipOptions& options,
              std::string& text) {
  for (std::size_t v = 0; v < polygon.size(); ++v) {
    const VertexView vertex = polygon[v];
    fmt::format_to(std::back_inserter(text), "{},{}", label, v);
    for (std::size_t i = 0; i < vertex.size(); ++i) {
      if (i >= 4 && i < 4 + options.volume.planes.size()) continue;
      text += ',' + number_text(polygon.format(), vertex[i], options);
    }
    text += '\n';
  }
}

// Errors: OutputError.
void write_out(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw OutputError("standard output: can't be written");
  }
}

// Errors: UsageError if an option is given without that which it is for.
void check_viewport(const ClipOptions& options) {
  if (options.point_size && options.primitive != Primitive::point) {
    usage_error("--point-size goes with --primitive point, not {}", to_string(options.primitive));
  }
  if (options.viewport && !options.point_size && !options.scissor) {
    usage_error("--viewport goes with --scissor or --point-size; neither is given");
  }
}

// The sides of the scissor rectangle become user planes.
void add_scissor_planes(ClipOptions& options) {
  if (!options.scissor) return;
  options.scissor->viewport = *options.viewport;
  std::ranges::copy(scissor_planes(*options.scissor, described_batch(options.text)),
                    std::back_inserter(options.volume.planes));
}

int clip_text(ClipOptions options) {
  check_viewport(options);
  add_scissor_planes(options);
  const std::vector<std::string_view> guests = load_guests(options.guests);
  options.clipper = given_clipper(options.clipper, guests, default_clipper(options.primitive));
  const Contestant& contestant = chosen_clipper(options);
  const Batch batch = batch_without_primitives(options, contestant);
  check_takes(contestant, batch);
  const std::vector<Part> parts = read_parts(options, batch);
  std::string text = head_row(options);
  for (std::size_t first = 0; first < parts.size(); first += kBlock) {
    const auto block = std::span(parts).subspan(first, std::min(kBlock, parts.size() - first));
    const Answers answers = clip_parts(block, contestant, batch);
    for (std::size_t i = 0; i < block.size(); ++i) {
      if (const Failure* failure = answers[i].failure()) {
        warn(fmt::format("{}: no answer to primitive {}: {} {}", contestant.brought_by,
                         block[i].label, contestant.clipper, failure->reason));
      }
      add_rows(block[i].label, answers[i], options, text);
    }
    write_out(std::exchange(text, ""));
  }
  write_out(text);
  return kExitOk;
}

// Those that count in pixels.
void add_viewport_options(CLI::App& command, ClipOptions& options) {
  CLI::Option* size = add_option(command, "--point-size", options.point_size, "PX",
                                 "Side of a point's square in pixels, for point/pop_free [0]")
                          ->check(CLI::NonNegativeNumber);
  const auto set_scissor = [&options](const std::vector<double>& numbers) {
    options.scissor = parse_scissor(numbers);
  };
  CLI::Option* scissor = add_number_list(
      command, "--scissor", 4, "X,Y,W,H", set_scissor,
      "Clip to a rectangle of the viewport, X,Y its lower left corner in pixels, y upwards; counts as 4 planes");
  const auto set = [&options](const std::array<double, 2>& viewport) {
    options.viewport = viewport;
  };
  CLI::Option* viewport =
      add_viewport_option(command, set, "Size in pixels of what the volume is drawn to");
  size->needs(viewport);
  scissor->needs(viewport);
}

constexpr const char* kClipFooter =
    R"(Input, a primitive per line: its vertices, each x y z (view) or x y z w (clip) and its K
attributes, decimal or C99 hex floats, separated by blanks or commas; # starts a comment. A
polygon has 3 vertices or more; its first one may be there again as the last. One that is not flat
is clipped as triangles, and a note on standard error says so.
Output: triangle,vertex,x,y,z,inv_w,a0,... one row per vertex of what is left, coordinates in
NDC; segment,vertex,... and point,vertex,... likewise, and polygon,part,vertex,...: a concave
polygon is triangulated and its triangles are clipped, as all polygons are by a clipper of
triangles. --clipper is by default homogeneous/sutherland_hodgman for triangles,
homogeneous/liang_barsky for segments, point/pop for points, homogeneous/polygon for polygons.
Numbers are rounded once when read: to float for float and counting, to double otherwise. What
the scalar exact answers is written as the nearest double; --fraction writes all of it.
Examples:
  echo '-2 0 0 1  2 0 0 1' | clipscope clip --space clip --primitive segment --plane 1,0,0,0.5
  echo '1 0 0 3  0 1 0 3  0 0 1 3' | clipscope clip --space clip --scalar exact --fraction
  echo '-4 0 0 4  4 0 0 4  0 2 0 4' | clipscope clip --space clip --viewport 8x8 --scissor 0,0,4,8
  echo '0 0 0 1 5  2 0 0 1 6  0 2 0 1 7' | clipscope clip --space clip --attributes 1 --flat 1
  echo '0 0 0 1 7  2 0 0 1 -1  0 .5 0 1 7' |
    clipscope clip --space clip --attributes 1 --clip-distances 1
  echo '1 0 0 1  1 .5 0 1' | clipscope clip --space clip --primitive segment --half-open=right
  echo '1.1 0 0 1' | clipscope clip --space clip --primitive point --clipper pop_free \
    --point-size 32 --viewport 256x256)";

}  // namespace

void add_clip_command(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, clip_text, "clip", "Clip primitives given as text; write CSV", kClipFooter);
  add_primitive_option(command, options.primitive);
  add_primitive_text_options(command, options.text);
  add_option(command, "--clipper", options.clipper, "NAME", "Name of a clipper [see below]");
  add_guest_options(command, options.guests);
  add_volume_options(command, options.volume);
  add_viewport_options(command, options);
  CLI::Option* hex = command.add_flag("--hex", options.hex, "Write hex floats");
  command
      .add_flag("--fraction", options.fraction,
                "Write numerator/denominator, exactly, of whatever scalar")
      ->excludes(hex);
}

}  // namespace clipscope::experiments::commands
