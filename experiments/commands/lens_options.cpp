// SPDX-License-Identifier: GPL-3.0-or-later
//
// The options that say what a camera sees, for commands whose camera stands at the origin.
#include <fmt/ranges.h>

#include <cmath>

#include "experiments/commands/options.hpp"

namespace clipscope::experiments::commands {
namespace {

// Errors: UsageError.
std::vector<double> perspective_sides(const std::vector<double>& p) {
  if (!(p[0] > 0 && p[0] < 180 && p[1] > 0)) {
    usage_error(
        "--perspective: FOVY {} must lie in (0, 180) degrees and ASPECT {} must be positive", p[0],
        p[1]);
  }
  const double top = p[2] * std::tan(p[0] * (M_PI / 360.0));
  const double right = p[1] * top;
  return {-right, right, -top, top, p[2], p[3]};
}

}  // namespace

void add_lens_options(CLI::App& command, LensOptions& options) {
  const auto add_projection = [&](const char* name, std::size_t count, const char* type,
                                  const char* help) {
    const auto set = [&options, name](const std::vector<double>& numbers) {
      options.projections.emplace_back(name, numbers);
    };
    return add_number_list(command, name, count, type, set, help);
  };
  add_projection("--perspective", 4, "FOVY,ASPECT,NEAR,FAR",
                 "Perspective projection, FOVY in degrees; FAR may be inf");
  add_projection("--frustum", 6, "L,R,B,T,N,F",
                 "Perspective projection, sides measured on the near plane; F may be inf");
  CLI::Option* const ortho = add_projection("--ortho", 6, "L,R,B,T,N,F", "Orthographic projection");
  const auto set_shear = [&options](const std::vector<double>& v) {
    if (!std::isfinite(v[0] + v[1])) {
      throw CLI::ValidationError("--shear",
                                 fmt::format("{},{} given, finite numbers expected", v[0], v[1]));
    }
    options.shear = {v[0], v[1]};
  };
  add_number_list(command, "--shear", 2, "SX,SY", set_shear,
                  "With --ortho: an oblique view, whose sides bound x + SX z and y + SY z")
      ->needs(ortho);
  add_projection("--intrinsics", 6, "FX,FY,CX,CY,W,H", kIntrinsicsHelp);
  command.add_option("--near", options.near, "Distance of the near plane, with --intrinsics");
  command.add_option("--far", options.far, "Distance of the far plane, with --intrinsics");
  const auto set = [&options](const std::array<double, 16>& m) {
    options.projections.emplace_back("--matrix", std::vector<double>(m.begin(), m.end()));
  };
  add_matrix_option(
      command, "--matrix", set,
      "Matrix to clip space as given, of any handedness and sign of y, from the space of the input: the camera's, or the world");
  add_matrix_order(command, options.by_columns);
}

std::string given_text(const LensOptions& options) {
  std::vector<std::string> names;
  for (const auto& [name, numbers] : options.projections) names.push_back(name);
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, " and "));
}

const GivenProjection& given_projection(const LensOptions& options, const std::string& who) {
  if (options.projections.size() == 1) return options.projections.front();
  usage_error("{} one of --perspective, --frustum, --ortho, --intrinsics and --matrix, {} given",
              who, options.projections.empty() ? "none is" : given_text(options) + " are");
}

Frustum<double> given_frustum(const LensOptions& options) {
  const auto& [option, v] = options.projections.front();
  if (option == "--intrinsics") {
    if (!options.near || !options.far) {
      usage_error("--intrinsics: it says nothing of depth; give --near and --far too");
    }
    return intrinsics_frustum({v[0], v[1], v[2], v[3], v[4], v[5]}, *options.near, *options.far);
  }
  if (options.near || options.far) {
    usage_error("--near and --far go with --intrinsics; {} has its own", option);
  }
  Frustum<double> frustum = frustum_of_numbers(
      option == "--ortho" ? ProjectionKind::parallel : ProjectionKind::perspective,
      option == "--perspective" ? perspective_sides(v) : v);
  if (options.shear) {
    frustum.shear_x = (*options.shear)[0];
    frustum.shear_y = (*options.shear)[1];
  }
  return frustum;
}

}  // namespace clipscope::experiments::commands
