// SPDX-License-Identifier: GPL-3.0-or-later
//
// The options that say where a camera is and what it sees.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "experiments/commands/options.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments::commands {
namespace {

constexpr const char* kGroup =
    "Camera (without a place to stand: a walk around and through the mesh)";

// What may stand between the numbers of a matrix, so that one can be pasted from Python, C or JSON.
constexpr std::string_view kBetweenEntries = ", \t\r\n;[](){}";

// The numbers of a text, or the word that is none.
struct Entries {
  std::vector<double> numbers;
  std::string bad_word;
};
Entries entries_of(std::string_view text) {
  Entries entries;
  for (auto i = text.find_first_not_of(kBetweenEntries); i != text.npos;
       i = text.find_first_not_of(kBetweenEntries)) {
    text.remove_prefix(i);
    const std::string word(text.substr(0, text.find_first_of(kBetweenEntries)));
    char* end = nullptr;
    entries.numbers.push_back(std::strtod(word.c_str(), &end));
    if (end != word.c_str() + word.size() && entries.bad_word.empty()) entries.bad_word = word;
    text.remove_prefix(word.size());
  }
  return entries;
}

// The numbers of a file. Errors: CLI::ValidationError that names the option.
Entries entries_in(const std::string& file, const std::string& option) {
  try {
    const std::string content = read_bytes(file);
    return entries_of(without_mark(file, content));
  } catch (const InputError& error) {
    throw CLI::ValidationError(option, error.what());
  }
}

// Errors: CLI::ValidationError that names the option, what was given and what it takes.
std::array<double, 16> parse_matrix(const std::string& option, const std::string& given) {
  std::error_code ignored;
  const bool is_file = std::filesystem::is_regular_file(given, ignored);
  const Entries entries = is_file ? entries_in(given, option) : entries_of(given);
  const std::string source = is_file ? "the file " + given : "'" + given + "'";
  const char* const expected =
      "16 numbers expected, separated by commas or blanks, or a FILE of them";
  if (entries.bad_word == given) {
    throw CLI::ValidationError(option, fmt::format("{} is no file; {}", source, expected));
  }
  if (!entries.bad_word.empty()) {
    throw CLI::ValidationError(option, fmt::format("{} holds '{}', which is no number; {}", source,
                                                   entries.bad_word, expected));
  }
  if (entries.numbers.size() != 16) {
    throw CLI::ValidationError(
        option, fmt::format("{} holds {}; {}", source,
                            counted(entries.numbers.size(), "number", "numbers"), expected));
  }
  std::array<double, 16> numbers;
  std::ranges::copy(entries.numbers, numbers.begin());
  return numbers;
}

void add_intrinsics(CLI::App& command, CameraOptions& camera) {
  const auto set = [&camera](const std::vector<double>& v) {
    camera.intrinsics = Intrinsics{v[0], v[1], v[2], v[3], v[4], v[5]};
  };
  add_number_list(command, "--intrinsics", 6, "FX,FY,CX,CY,W,H", set, kIntrinsicsHelp)
      ->group(kGroup);
}

void add_frusta(CLI::App& command, CameraOptions& camera) {
  const auto add = [&](const char* name, ProjectionKind kind, const char* help) {
    const auto set = [&camera, kind](const std::vector<double>& v) {
      camera.frustum = frustum_of_numbers(kind, v);
    };
    add_number_list(command, name, 6, "L,R,B,T,N,F", set, help)->group(kGroup);
  };
  add("--frustum", ProjectionKind::perspective,
      "What it sees, sides measured on the near plane; F may be inf");
  add("--ortho", ProjectionKind::parallel, "What it sees, orthographic");
}

}  // namespace

void add_matrix_option(CLI::App& command, const std::string& name,
                       std::function<void(const std::array<double, 16>&)> set,
                       const std::string& help, const std::string& group) {
  const auto parse = [=, set = std::move(set)](const std::string& text) {
    set(parse_matrix(name, text));
  };
  CLI::Option* option = command.add_option_function<std::string>(name, parse, help);
  option->type_name("M00,M01,...|FILE");
  if (!group.empty()) option->group(group);
}

void add_matrix_order(CLI::App& command, bool& by_columns, const std::string& group) {
  const auto set = [&by_columns](const std::string& order) { by_columns = order == "column"; };
  CLI::Option* option = command.add_option_function<std::string>(
      "--matrix-order", set,
      "Order of the numbers of a matrix: row (as it is printed) or column (as OpenGL and glTF store it) [row]");
  option->check(CLI::IsMember({"row", "column"}));
  if (!group.empty()) option->group(group);
}

CLI::Option* add_depth_option(CLI::App& command, DepthRange& depth) {
  return add_depth_option(command, [&depth](DepthRange d) { depth = d; });
}

CLI::Option* add_depth_option(CLI::App& command, std::function<void(DepthRange)> take) {
  const auto set = [take = std::move(take)](const std::string& name) {
    take(name == "zero_to_one" ? DepthRange::zero_to_one
         : name == "reversed"  ? DepthRange::reversed
                               : DepthRange::minus_one_to_one);
  };
  return command
      .add_option_function<std::string>(
          "--depth", set,
          "Depth convention: gl [-1, 1], zero_to_one [0, 1] or reversed [1, 0] [gl]")
      ->check(CLI::IsMember({"gl", "zero_to_one", "reversed"}));
}

Frustum<double> frustum_of_numbers(ProjectionKind kind, const std::vector<double>& v) {
  Frustum<double> f{kind, v[0], v[1], v[2], v[3], v[4], v[5]};
  f.infinite_far = std::isinf(v[5]);
  if (f.infinite_far) f.far = 0;
  return f;
}

void add_place_options(CLI::App& command, CameraOptions& camera) {
  const auto add_vector = [&](const char* name, std::optional<glm::dvec3>& value,
                              const char* help) {
    const auto set = [&value](const std::vector<double>& v) {
      value = glm::dvec3(v[0], v[1], v[2]);
    };
    add_number_list(command, name, 3, "X,Y,Z", set, help)->group(kGroup);
  };
  add_vector("--eye", camera.eye, "Where the camera is");
  add_vector("--target", camera.target, "What it looks at [centre of the mesh]");
  add_vector("--up", camera.up, "Which way is up [0,1,0]");
  const auto turn = [&camera](const std::vector<double>& v) {
    camera.orientation = {v[0], v[1], v[2], v[3]};
  };
  add_number_list(command, "--orientation", 4, "X,Y,Z,W", turn,
                  "Quaternion, world from camera, instead of --target and --up")
      ->group(kGroup);
  const auto pose = [&camera](const std::array<double, 16>& m) { camera.pose = m; };
  add_matrix_option(command, "--pose", pose,
                    "4 x 4 matrix, world from camera, instead of all these", kGroup);
  const auto axes = [&camera](const std::string& name) {
    camera.axes = name == "cv" ? CameraAxes::cv : CameraAxes::gl;
  };
  command
      .add_option_function<std::string>(
          "--axes", axes,
          "A posed camera looks: gl down -z, y up (OpenGL, glTF); cv down +z, y down (OpenCV) [gl]")
      ->check(CLI::IsMember({"gl", "cv"}))
      ->group(kGroup);
  const auto choose = [&camera](const std::string& name) { camera.gltf_camera = name; };
  command
      .add_option_function<std::string>("--camera", choose,
                                        "The camera of that name or number in the glTF file")
      ->type_name("NAME|NUMBER")
      ->group(kGroup);
}

void add_camera_options(CLI::App& command, CameraOptions& camera) {
  const auto add = [&](const char* name, auto& value, const char* help) {
    command.add_option(name, value, help)->group(kGroup);
  };
  add_place_options(command, camera);
  add("--fovy", camera.fovy_degrees, "Vertical angle of view in degrees [60]");
  add("--aspect", camera.aspect, "Width over height of the picture [16:9]");
  add("--near", camera.near, "Distance of the near plane [from the mesh]");
  add("--far", camera.far, "Distance of the far plane, may be inf [from the mesh]");
  add_intrinsics(command, camera);
  add_frusta(command, camera);
  const auto set = [&camera](const std::array<double, 16>& m) { camera.matrix = m; };
  add_matrix_option(
      command, "--matrix", set,
      "Matrix to clip space as given, of any handedness and sign of y: from the world, or with a place to stand from the camera's space",
      kGroup);
  add_matrix_order(command, camera.by_columns, kGroup);
  add_depth_option(command, camera.depth)->group(kGroup);
  add("--walk", camera.walk, "Number of camera positions of the walk [6]");
}

}  // namespace clipscope::experiments::commands
