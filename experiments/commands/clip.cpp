// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope clip: triangles in, polygons out.
#include <fmt/format.h>

#include <cstdio>
#include <iterator>
#include <memory>
#include <string>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/triangle_text.hpp"
#include "experiments/contestants/contestant.hpp"
#include "experiments/errors.hpp"

namespace clipscope::experiments {
namespace {

struct ClipOptions {
  TriangleTextOptions text;
  std::string clipper = "homogeneous/sutherland_hodgman";
  bool hex = false;
};

// The shortest decimal that reads back as the same number, or the number as a hex float; double-double
// to 32 digits in decimal, else to the nearest double; exact numbers to the nearest double.
template <class T>
std::string format_scalar(const T& x, bool hex) {
  if constexpr (std::same_as<T, dd_real>) {
    if (!hex) return x.to_string(32);
  }
  if (hex) return fmt::format("{:a}", nearest_double(x));
  if constexpr (ScalarTraits<T>::precision == 24)
    return fmt::format("{}", static_cast<float>(nearest_double(x)));
  return fmt::format("{}", nearest_double(x));
}

template <class T>
void append_rows(std::size_t triangle, const NdcPolygon<T, kRunTime>& polygon, bool hex,
                 std::string& csv) {
  for (int v = 0; v < polygon.size(); ++v) {
    fmt::format_to(std::back_inserter(csv), "{},{}", triangle, v);
    for (int i = 0; i < 4; ++i) csv += "," + format_scalar(polygon[v].position[i], hex);
    for (int k = 0; k < polygon[v].attributes.size(); ++k) {
      csv += "," + format_scalar(polygon[v].attributes[k], hex);
    }
    csv += '\n';
  }
}

void write_out(std::string& csv) {
  if (std::fwrite(csv.data(), 1, csv.size(), stdout) != csv.size() || std::fflush(stdout) != 0) {
    throw OutputError("standard output: can't be written");
  }
  csv.clear();
}

template <class T>
void clip_all(const Contestant<T>& contestant, const ClipOptions& options,
              const Frustum<double>& frustum, const std::vector<TextTriangle>& triangles) {
  const int attributes = options.text.attributes;
  const auto projection = projection_from<T>(frustum);
  const auto polygon = std::make_unique<NdcPolygon<T, kRunTime>>();
  std::string csv = "triangle,vertex,x,y,z,inv_w";
  for (int k = 0; k < attributes; ++k) csv += fmt::format(",a{}", k);
  csv += '\n';
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (options.text.space == "view") {
      contestant.view_one(projection, triangle_of<T, Space::view>(triangles[i], attributes),
                          *polygon);
    } else {
      contestant.clip_one(ClipVolume{.depth = frustum.depth}, triangle_of<T, Space::clip>(triangles[i], attributes),
                          *polygon);
    }
    append_rows(i, *polygon, options.hex, csv);
    if (csv.size() > (1u << 20)) write_out(csv);
  }
  write_out(csv);
}

int clip_text(const ClipOptions& options) {
  const AnyContestant chosen = find_contestant(options.clipper, options.text.scalar);
  const Frustum<double> frustum = frustum_of(options.text);
  std::visit(
      [&](const auto* contestant) {
        if (options.text.space == "clip" && contestant->clip_one == nullptr) {
          throw UsageError(fmt::format(
              "--clipper: {} starts in view space, so clip-space triangles are not applicable",
              contestant->name));
        }
        clip_all(*contestant, options, frustum, read_triangles(options.text));
      },
      chosen);
  return kExitOk;
}

}  // namespace

void add_clip_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("clip", "Clip triangles given as text; write CSV");
  command->footer(
      "Input, a triangle per line: three vertices, each x y z (view) or x y z w (clip) and its K\n"
      "attributes, decimal or C99 hex floats, separated by blanks or commas; # starts a comment.\n"
      "Output: triangle,vertex,x,y,z,inv_w,a0,... one row per polygon vertex, coordinates in NDC.\n"
      "Numbers are rounded once when read: to float for float and counting, to double otherwise.");
  const auto options = std::make_shared<ClipOptions>();
  add_triangle_text_options(*command, options->text);
  command->add_option("--clipper", options->clipper, "Name of a clipper")->type_name("NAME");
  command->add_flag("--hex", options->hex, "Write hex floats");
  command->callback([&action, options] { action = [options] { return clip_text(*options); }; });
}

}  // namespace clipscope::experiments
