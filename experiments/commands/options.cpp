// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/commands/options.hpp"
#include "experiments/table/json_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace clipscope::experiments::commands {
namespace {

// Empty unless the whole text is numbers separated by single commas.
std::vector<double> parse_numbers(const std::string& text) {
  std::vector<double> numbers;
  const char* next = text.c_str();
  while (true) {
    char* end = nullptr;
    numbers.push_back(std::strtod(next, &end));
    if (end == next || (*end != ',' && *end != '\0')) return {};
    if (*end == '\0') return numbers;
    next = end + 1;
  }
}

// "640x480". Errors: CLI::ValidationError.
std::array<double, 2> parse_viewport(const std::string& text) {
  int width = 0, height = 0;
  const char* const end = text.data() + text.size();
  const char* const x = std::from_chars(text.data(), end, width).ptr;
  if (x != end && *x == 'x' && std::from_chars(x + 1, end, height).ptr == end && width > 0 &&
      height > 0) {
    return {static_cast<double>(width), static_cast<double>(height)};
  }
  throw CLI::ValidationError(
      "--viewport", fmt::format("'{}' given, WxH in pixels expected, such as 1920x1080", text));
}

// What is clipped against in view space. Errors: UsageError.
Frustum<double> frustum_of(const PrimitiveTextOptions& options) {
  Frustum<double> f = given_frustum(options);
  if (reads_floats(options)) f = frustum_cast<double>(frustum_cast<float>(f));
  if (is_valid(f) && std::isfinite(f.left + f.right + f.bottom + f.top + f.near + f.far)) return f;
  usage_error(
      "the frustum left={} right={} bottom={} top={} near={} far={} encloses no volume; expected left < right, bottom < top, near < far, and 0 < near for perspective",
      f.left, f.right, f.bottom, f.top, f.near, f.infinite_far ? HUGE_VAL : f.far);
}

// The matrix, its numbers rounded as those of primitives are. Errors: UsageError.
MatrixRows<double> matrix_of(const PrimitiveTextOptions& options) {
  std::array<double, 16> numbers;
  std::ranges::copy(given_projection(options, "what is in view space takes").second,
                    numbers.begin());
  for (double& x : numbers) {
    if (reads_floats(options)) x = static_cast<float>(x);
    if (!std::isfinite(x)) {
      usage_error("--matrix: an entry is {}{}; finite numbers expected", x,
                  reads_floats(options) ? " in float" : "");
    }
  }
  return rows_of(numbers, options.by_columns);
}

}  // namespace

CLI::Option* add_number_list(CLI::App& command, const std::string& name, std::size_t count,
                             const std::string& type,
                             std::function<void(const std::vector<double>&)> set,
                             const std::string& help) {
  const auto parse = [=, set = std::move(set)](const std::string& text) {
    const std::vector<double> numbers = parse_numbers(text);
    if (numbers.size() == count) return set(numbers);
    throw CLI::ValidationError(
        name, fmt::format("'{}' given, {} numbers expected: {}", text, count, type));
  };
  return command.add_option_function<std::string>(name, parse, help)->type_name(type);
}

void add_scene_options(CLI::App& command, Selection& selection) {
  add_option(
      command, "--scene", selection.scenes, "NAME|FILE",
      "A built-in scene (see `clipscope list scenes`) or a mesh file (OBJ, PLY, STL, glTF); may be repeated [all built-in scenes]")
      ->allow_extra_args(false);
  command.add_option("--seed", selection.seed, "Seed of the random scenes [1]");
  command.add_option("--sample", selection.sample,
                     "At most this many triangles per view, evenly spaced; 0: all");
  command.add_flag("--quick", selection.quick, "Smaller scenes, for a first look");
  command.add_flag(
      "--recentre", selection.recentre,
      "Subtract an origin near the centre of each mesh in double before its positions become floats; the camera stays in the file's coordinates");
  add_camera_options(command, selection.camera);
}

void add_contestant_options(CLI::App& command, Selection& selection) {
  add_option(command, "--clipper", selection.clipper, "GLOB",
             "Shell pattern of clipper names, such as 'cvv/*' (see `clipscope list clippers`)");
  add_option(command, "--scalar", selection.scalars, "LIST",
             fmt::format("Scalars, separated by commas (see `clipscope list scalars`) [{}]",
                         fmt::join(selection.scalars, ",")))
      ->delimiter(',')
      ->allow_extra_args(false);
}

void add_contestant_options(CLI::App& command, std::string& clipper, std::string& scalar) {
  clipper.clear();
  add_option(command, "--clipper", clipper, "NAME", "Name of a clipper [that of --plugin]");
  command.add_option("--scalar", scalar, "Scalar to compute in [float]");
}

void add_json_option(CLI::App& command, Selection& selection) {
  command.add_flag("--json", selection.json, "Print JSON (run: one table per line)");
}

void add_realtime_option(CLI::App& command, Selection& selection) {
  command.add_flag(
      "--realtime", selection.realtime,
      "Time in the real-time class (SCHED_FIFO), so that no program takes the processor; the others on it stand still meanwhile");
}

void add_single_file_option(CLI::App& command, PageForm& form) {
  command.add_flag_callback(
      "--single-file", [&form] { form = PageForm::single_file; },
      "Put pictures and long tables into the page of results, so that it needs no other file");
}

void add_out_option(CLI::App& command, std::optional<std::string>& out) {
  add_option(command, "--out", out, "DIR",
             "Also write the table as Markdown, CSV and LaTeX into this folder");
}

RunInfo run_info_of(const Selection& selection, const std::string& command) {
  RunInfo info = run_info_of(selection);
  std::ranges::find(info, "command", &RunInfo::value_type::first)->second = command;
  return info;
}

void print_table(const Table& table, bool json, const std::optional<std::string>& out) {
  if (out) table.write(*out);
  fmt::print("{}\n", json ? json_text(table.to_json(), 2) : table.to_text());
}

void add_format_option(CLI::App& command, std::string& format) {
  add_option(
      command, "--format", format, "NAME",
      "How to print: text (at most 100 columns wide), markdown, csv (full precision), latex, json [text]")
      ->check(CLI::IsMember({"text", "markdown", "csv", "latex", "json"}));
}

std::string formatted(const Table& table, const std::string& format) {
  if (format == "markdown") return table.to_markdown();
  if (format == "csv") return table.to_csv();
  if (format == "latex") return table.to_latex();
  if (format == "json") return json_text(table.to_json(), 2) + "\n";
  return table.to_text();
}

CLI::Option* add_viewport_option(CLI::App& command,
                                 std::function<void(const std::array<double, 2>&)> set,
                                 const std::string& help) {
  const auto parse = [set = std::move(set)](const std::string& text) { set(parse_viewport(text)); };
  return command.add_option_function<std::string>("--viewport", parse, help)->type_name("WxH");
}

void add_projection_options(CLI::App& command, PrimitiveTextOptions& options) {
  add_lens_options(command, options);
  add_depth_option(command, options.depth);
}

void add_primitive_text_options(CLI::App& command, PrimitiveTextOptions& options) {
  command
      .add_option("--space", options.space,
                  "Space of the input: view (x y z) or clip (x y z w) [view]")
      ->check(CLI::IsMember({"view", "clip"}));
  command.add_option("--scalar", options.scalar,
                     "Scalar to compute in (see `clipscope list scalars`) [float]");
  add_option(command, "--attributes", options.attributes, "K", "Attributes per vertex [0]")
      ->check(CLI::Range(0, kMaxAttributes));
  add_option(command, "--flat", options.flat, "N",
             "The last N attributes are flat: all of a primitive has those of one vertex [0]")
      ->check(CLI::Range(0, kMaxAttributes));
  command
      .add_option("--provoking", options.provoking,
                  "The vertex that gives the flat attributes: first or last [first]")
      ->check(CLI::IsMember({"first", "last"}));
  add_projection_options(command, options);
  add_option(command, "file", options.file, "FILE", "Primitives, one per line [standard input]");
}

Batch described_batch(const PrimitiveTextOptions& options) {
  Batch batch{.space = options.space == "view" ? Space::view : Space::clip,
              .attributes = options.attributes};
  if (batch.space == Space::view) {
    if (given_projection(options, "what is in view space takes").first == "--matrix") {
      batch.matrix = matrix_of(options);
    } else {
      batch.frustum = frustum_of(options);
    }
  } else if (!options.projections.empty()) {
    usage_error("{} goes with --space view: clip-space coordinates are projected already",
                given_text(options));
  }
  batch.volume.depth = options.depth;
  batch.frustum.depth = batch.volume.depth;
  return batch;
}

std::vector<TextPrimitive> read_primitives(const PrimitiveTextOptions& options,
                                           Primitive primitive) {
  if (options.flat > options.attributes) {
    usage_error("--flat: {} asked for, but --attributes gives {} per vertex", options.flat,
                options.attributes);
  }
  return primitives_in(read_lines(options.file), options, primitive);
}

std::string_view default_clipper(Primitive primitive) {
  constexpr std::string_view kNames[] = {"point/pop", "homogeneous/liang_barsky",
                                         "homogeneous/sutherland_hodgman", "homogeneous/polygon"};
  return kNames[static_cast<std::size_t>(primitive)];
}

}  // namespace clipscope::experiments::commands
