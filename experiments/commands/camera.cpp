// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope camera: what a matrix to clip space means, and what its format has left of it.
#include <cmath>
#include <filesystem>
#include <optional>

#include "experiments/camera/frustum_picture.hpp"
#include "experiments/camera/meaning_text.hpp"
#include "experiments/commands/options.hpp"
#include "experiments/draw/vector_page.hpp"
#include "experiments/scenes/gltf_camera.hpp"
#include "experiments/table/json_text.hpp"

namespace clipscope::experiments::commands {
namespace {

struct CameraCommand {
  LensOptions lens;
  std::optional<DepthRange> depth;
  bool in_double = false, json = false;
  std::optional<std::string> gltf, gltf_camera, picture;
};

// What is reported: a matrix, and where it comes from.
struct Given {
  CameraMatrix matrix;
  std::string origin;
};

// The rows of the frustum's matrix as the format computes them.
template <class T>
MatrixRows<double> rows_of_frustum(const Frustum<double>& f) {
  return matrix_cast<double>(clipscope::rows_of(Projection<T>(frustum_cast<T>(f))));
}

// The numbers rounded to float, unless they are to stay doubles; says how many changed.
Given given_matrix(const std::vector<double>& numbers, const CameraCommand& options) {
  std::array<double, 16> entries;
  std::ranges::copy(numbers, entries.begin());
  int rounded = 0;
  for (double& x : entries) {
    const double kept = options.in_double ? x : double{static_cast<float>(x)};
    if (!std::isfinite(kept)) {
      usage_error("--matrix: an entry is {}; finite numbers expected", kept);
    }
    rounded += kept != x;
    x = kept;
  }
  const std::string origin =
      options.in_double ? "matrix as given, in double"
      : rounded == 0    ? "matrix as given, in float"
                     : fmt::format("matrix as given, {} of 16 entries rounded to float", rounded);
  return {{rows_of(entries, options.lens.by_columns), !options.in_double}, origin};
}

Given of_frustum(Frustum<double> f, const CameraCommand& options, std::string origin) {
  f.depth = options.depth.value_or(DepthRange::minus_one_to_one);
  const Frustum<double> kept = options.in_double ? f : frustum_cast<double>(frustum_cast<float>(f));
  if (!is_valid(kept)) {
    usage_error(
        "{}: it encloses no volume{}; expected left < right, bottom < top, near < far, and 0 < near for perspective",
        origin, options.in_double ? "" : " in float");
  }
  const MatrixRows<double> rows =
      options.in_double ? rows_of_frustum<double>(kept) : rows_of_frustum<float>(kept);
  return {{rows, !options.in_double},
          fmt::format("{}, its matrix in {}", origin, options.in_double ? "double" : "float")};
}

Given given_camera(const CameraCommand& options) {
  if (!options.gltf) {
    const auto& [name, numbers] = given_projection(options.lens, "camera takes");
    if (name == "--matrix") return given_matrix(numbers, options);
    return of_frustum(given_frustum(options.lens), options, name.substr(2));
  }
  if (!options.lens.projections.empty()) {
    usage_error("FILE: it says what the camera sees; leave {} out",
                options.lens.projections.front().first);
  }
  const std::vector<GltfCamera> cameras = read_gltf_cameras(*options.gltf);
  const GltfCamera& camera = find_camera(cameras, options.gltf_camera.value_or("0"), *options.gltf);
  CameraOptions seen;
  seen.near = options.lens.near;
  seen.far = options.lens.far;
  return of_frustum(frustum_of(camera, seen), options, fmt::format("camera {}", camera.name));
}

int describe_camera(const CameraCommand& options) {
  if (options.picture) page_format(*options.picture);
  const Given given = given_camera(options);
  const MatrixMeaning meaning = meaning_of(given.matrix, options.depth);
  if (options.json) {
    nlohmann::json json = meaning_json(meaning);
    json["given"] = given.origin;
    fmt::print("{}\n", json_text(json, 2));
  } else {
    fmt::print("given:        {}\n{}", given.origin,
               meaning_text(meaning, options.depth.has_value()));
  }
  if (options.picture) write_frustum_picture(*options.picture, meaning);
  return kExitOk;
}

}  // namespace

void add_camera_command(CLI::App& app, Action& action) {
  const auto [command, options] =
      add_command(app, action, describe_camera, "camera",
                  "What a projection matrix means: frustum, hand, depth, planes, digits",
                  R"(Examples:
  clipscope camera --matrix 1,0,0,0,0,1,0,0,0,0,-1.00002,-0.200002,0,0,-1,0
  clipscope camera --perspective 60,1.7778,0.1,10000 --depth reversed
  clipscope camera --intrinsics 525,525,319.5,239.5,640,480 --near 0.1 --far inf --picture lens.svg)");
  add_lens_options(command, options.lens);
  add_depth_option(command, [&to = options.depth](DepthRange depth) {
    to = depth;
  })->description("Depth convention to read it by [a matrix: the first that fits; else gl]");
  command.add_flag("--double", options.in_double, "The matrix is in double [float]");
  add_option(command, "file", options.gltf, "FILE", "A glTF file whose camera is meant");
  add_option(command, "--camera", options.gltf_camera, "NAME|NUMBER",
             "Which camera of the file [0]");
  add_option(command, "--picture", options.picture, "FILE",
             "Draw the volume: a file .svg, .pdf or .png");
  command.add_flag("--json", options.json, "Print JSON");
}

}  // namespace clipscope::experiments::commands
