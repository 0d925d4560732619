// SPDX-License-Identifier: GPL-3.0-or-later
//
// What commands share: options for scenes, cameras, clippers, scalars and primitives; how a table
// is printed.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/commands/primitive_text.hpp"
#include "experiments/contestants/batch.hpp"
#include "experiments/contestants/contestant.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/report/report.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/store/run_folder.hpp"
#include "experiments/table/table.hpp"

namespace clipscope::experiments::commands {

// Throws UsageError with the message that fmt::format makes.
template <class... Args>
[[noreturn]] void usage_error(fmt::format_string<Args...> format, Args&&... args) {
  throw UsageError(fmt::format(format, std::forward<Args>(args)...));
}

// A command and what its options fill; the action, once the user chose it, is `run` of them.
template <class Options, class Filled = std::remove_cvref_t<Options>>
std::pair<CLI::App&, Filled&> add_command(CLI::App& app, Action& action, int (*run)(Options),
                                          const std::string& name, const std::string& help,
                                          const std::string& footer = "") {
  CLI::App* command = app.add_subcommand(name, help);
  // Without one of its own a command shows that of the program.
  if (!footer.empty()) command->footer(footer);
  const auto options = std::make_shared<Filled>();
  command->callback([=, &action] { action = [=] { return run(*options); }; });
  return {*command, *options};
}

// An option whose help shows `type` in place of the value, such as "NAME|FILE".
template <class Value>
CLI::Option* add_option(CLI::App& command, const std::string& name, Value& value,
                        const std::string& type, const std::string& help) {
  return command.add_option(name, value, help)->type_name(type);
}

// An option of `count` numbers separated by commas, such as --eye 0,1,2; `set` is called with them.
// Anything else is a usage error that names the option, what was given and what it takes (`type`,
// such as "X,Y,Z").
CLI::Option* add_number_list(CLI::App& command, const std::string& name, std::size_t count,
                             const std::string& type,
                             std::function<void(const std::vector<double>&)> set,
                             const std::string& help);

// What --intrinsics says in every command.
inline constexpr const char* kIntrinsicsHelp =
    "Focal lengths, principal point and size of the image in px, as OpenCV has them: y down, pixel centres at whole numbers";

// A frustum of L,R,B,T,N,F; F may be infinite.
Frustum<double> frustum_of_numbers(ProjectionKind kind, const std::vector<double>& numbers);

// An option of 16 numbers, separated by commas, blanks or brackets, or of a file that holds them.
void add_matrix_option(CLI::App& command, const std::string& name,
                       std::function<void(const std::array<double, 16>&)> set,
                       const std::string& help, const std::string& group = "");
// --matrix-order row|column.
void add_matrix_order(CLI::App& command, bool& by_columns, const std::string& group = "");
// --depth gl|zero_to_one|reversed.
CLI::Option* add_depth_option(CLI::App& command, std::function<void(DepthRange)> set);
CLI::Option* add_depth_option(CLI::App& command, DepthRange& depth);

// --perspective, --frustum, --ortho, --intrinsics and --matrix as given: option and numbers.
using GivenProjection = std::pair<std::string, std::vector<double>>;
struct LensOptions {
  std::vector<GivenProjection> projections;
  bool by_columns = false;                     // the numbers of --matrix
  std::optional<double> near, far;             // of --intrinsics
  std::optional<std::array<double, 2>> shear;  // of --ortho
};
void add_lens_options(CLI::App& command, LensOptions& options);
// "--ortho and --matrix"; "none".
std::string given_text(const LensOptions& options);
// The only one. who: "what is in view space takes", say. Errors: UsageError unless there is one.
const GivenProjection& given_projection(const LensOptions& options, const std::string& who);
// The frustum of the first, in double. Pre-condition: it is no --matrix. Errors: UsageError.
Frustum<double> given_frustum(const LensOptions& options);

// Where the camera is: --eye, --target, --up, --orientation, --pose, --axes, --camera.
void add_place_options(CLI::App& command, CameraOptions& camera);
// The same and what it sees.
void add_camera_options(CLI::App& command, CameraOptions& camera);

// --scene, --seed, --quick, --sample and the camera.
void add_scene_options(CLI::App& command, Selection& selection);

// --clipper GLOB and --scalar LIST.
void add_contestant_options(CLI::App& command, Selection& selection);
// --clipper NAME, empty unless it is given, and --scalar; see given_clipper.
void add_contestant_options(CLI::App& command, std::string& clipper, std::string& scalar);

void add_json_option(CLI::App& command, Selection& selection);
// --realtime, of commands that time; see measure_in_real_time.
void add_realtime_option(CLI::App& command, Selection& selection);

// --single-file: what the page of results needs beside it.
void add_single_file_option(CLI::App& command, PageForm& form);

// --out: a folder for the table that the command prints.
void add_out_option(CLI::App& command, std::optional<std::string>& out);
// Prints the table as text or JSON, and writes its files if there is a folder. Errors: OutputError.
void print_table(const Table& table, bool json, const std::optional<std::string>& out = {});

// What is told of a run that another command than `clipscope run` makes.
RunInfo run_info_of(const Selection& selection, const std::string& command);

// --format, and the table as it says.
void add_format_option(CLI::App& command, std::string& format);
std::string formatted(const Table& table, const std::string& format);

// --viewport WxH, in px.
CLI::Option* add_viewport_option(CLI::App& command,
                                 std::function<void(const std::array<double, 2>&)> set,
                                 const std::string& help);

// Primitives as text, and what they are clipped against.
struct PrimitiveTextOptions : LensOptions, PrimitiveForm {
  DepthRange depth = DepthRange::minus_one_to_one;
  std::string file = "-";  // "-": standard input
};

// What is clipped against: --perspective and so on, and --depth.
void add_projection_options(CLI::App& command, PrimitiveTextOptions& options);
// The same and space, scalar, attributes and file.
void add_primitive_text_options(CLI::App& command, PrimitiveTextOptions& options);

// A batch without its primitives: space, frustum or matrix, depth range and attributes. The numbers
// of frustum and matrix are rounded as those of primitives are.
// Errors: UsageError unless exactly one projection is given for view space and none for clip space,
// or if a frustum encloses no volume.
Batch described_batch(const PrimitiveTextOptions& options);

// What clips beside the planes of a projection, and how these clip: --depth-clamp, --half-open,
// --clip-distances and --plane.
struct VolumeOptions {
  DepthClamp depth_clamp = {};
  OpenSides open_sides = {};
  int clip_distances = 0;
  std::vector<std::array<double, 4>> planes;
};

void add_volume_options(CLI::App& command, VolumeOptions& options);
// The same without --plane.
void add_boundary_options(CLI::App& command, VolumeOptions& options);
void add_primitive_option(CLI::App& command, Primitive& primitive);

// Pixels of a viewport from its lower left corner on, y upwards.
struct Scissor {
  double x, y, width, height;
  std::array<double, 2> viewport = {0, 0};
};
// Errors: CLI::ValidationError unless they are finite and the sides are positive.
Scissor parse_scissor(const std::vector<double>& numbers);
// The four sides of the closed rectangle as user clip planes in the space of the batch. In clip
// space they are exact for whole numbers of pixels; in view space each coefficient is rounded once.
std::vector<std::array<double, 4>> scissor_planes(const Scissor& scissor, const Batch& batch);

// Whether the format can hold the number, rounded.
bool is_finite_in(const Format& format, double x);

// Adds the options to a batch that is clipped in that format. Errors: UsageError if there are more
// clip distances than attributes, more of anything than fits, or a plane that is not finite.
void set_volume(const VolumeOptions& options, const Format& format, Batch& batch);

// Errors: UsageError if the clipper does not take the input's space or the volume's options.
void check_takes(const Contestant& contestant, const Batch& batch);

// All primitives of the file. Errors: those of primitives_in; InputError if it can't be read;
// UsageError if more attributes are flat than there are.
std::vector<TextPrimitive> read_primitives(const PrimitiveTextOptions& options,
                                           Primitive primitive);

// The clipper that is taken where none is named.
std::string_view default_clipper(Primitive primitive);

}  // namespace clipscope::experiments::commands
