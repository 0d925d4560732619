// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope explain: one primitive beside the exact answer, a triangle step by step in every space;
// as a picture, too.
#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/commands/explanation.hpp"
#include "experiments/commands/guest_options.hpp"
#include "experiments/commands/options.hpp"
#include "experiments/draw/vector_page.hpp"
#include "experiments/hard_cases/case_picture.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/survey/case_batch.hpp"
#include "experiments/survey/draw_scene.hpp"
#include "experiments/survey/verdicts.hpp"
#include "experiments/table/json_text.hpp"
#include "reference/convex.hpp"

namespace clipscope::experiments::commands {
namespace {

struct ExplainOptions {
  PrimitiveTextOptions text;
  Primitive primitive = Primitive::triangle;
  VolumeOptions volume;
  Selection selection;  // its clipper is empty if none was chosen
  GuestOptions guests;
  std::string scene, view;
  std::size_t triangle = 0;
  std::string hard_case;
  std::optional<std::string> corpus, picture;
  const CLI::App* command = nullptr;  // that has these options
};

// --- What is explained --------------------------------------------------------------------------

// Errors: UsageError if something else was chosen too.
HardCase case_from_catalogue(const ExplainOptions& options) {
  for (const char* option :
       {"file",      "--space", "--attributes",     "--primitive",   "--perspective",
        "--frustum", "--ortho", "--shear",          "--intrinsics",  "--matrix",
        "--depth",   "--plane", "--clip-distances", "--depth-clamp", "--half-open",
        "--scene",   "--view",  "--triangle",       "--eye",         "--pose",
        "--camera"}) {
    if (options.command->count(option) == 0) continue;
    usage_error("--case: a case says all that {} would say; leave it out", option);
  }
  if (!options.corpus) return find_case(builtin_catalogue(), options.hard_case);
  return find_case(load_catalogue(*options.corpus), options.hard_case);
}

const Format& format_of(const ExplainOptions& options) {
  return *find_contestant(default_clipper(Primitive::triangle), options.text.scalar).format;
}

// The camera: where it is by options of its own, what it sees by those of a text.
// Errors: UsageError.
CameraOptions camera_of(const ExplainOptions& options) {
  CameraOptions camera = options.selection.camera;
  const PrimitiveTextOptions& text = options.text;
  camera.depth = text.depth;
  camera.by_columns = text.by_columns;
  camera.near = text.near;
  camera.far = text.far;
  if (text.projections.empty()) return camera;
  const auto& [name, v] = text.projections.front();
  if (text.projections.size() > 1) {
    usage_error("{} and {}: a camera takes one of them", name, text.projections[1].first);
  }
  if (name == "--matrix") {
    std::ranges::copy(v, camera.matrix.emplace().begin());
  } else if (name == "--intrinsics") {
    camera.intrinsics = Intrinsics{v[0], v[1], v[2], v[3], v[4], v[5]};
  } else {
    camera.frustum = described_batch(text).frustum;
  }
  return camera;
}

HardCase case_from_scene(const ExplainOptions& options) {
  if (options.primitive != Primitive::triangle) {
    usage_error("--primitive: a scene has triangles, {} was given", to_string(options.primitive));
  }
  Selection selection = options.selection;
  selection.camera = camera_of(options);
  const Scene scene = load_selected_scene(selection, options.scene);
  const std::size_t all = scene.mesh.triangles.size();
  if (options.triangle >= all) {
    usage_error("--triangle: scene {} has the triangles 0 to {}, {} was given", scene.name, all - 1,
                options.triangle);
  }
  const View& view = find_view(scene, options.view);
  const auto in_float = sampled_view_triangles(scene, view, {all, 1}, options.triangle, 1);
  const auto in_double =
      sampled_view_triangles<DoubleSceneTriangle>(scene, view, {all, 1}, options.triangle, 1);
  Batch batch = takes_doubles(format_of(options), scene) ? batch_of(view, in_double)
                                                         : batch_of(view, in_float);
  set_volume(options.volume, format_of(options), batch);
  HardCase r = case_of(batch, 0, fmt::format("triangle {} of {}", options.triangle, scene.name));
  r.why = fmt::format("seen from {}", view.label);
  return r;
}

// Errors: InputError.
void check_convex(const HardCase& c) {
  if (c.primitive != Primitive::polygon || !reference::is_finite(c.vertices, c.attribute_count) ||
      reference::is_planar_convex(c.vertices, c.attribute_count)) {
    return;
  }
  throw InputError(fmt::format(
      "{}: the polygon is not flat and convex with attributes affine over it; expected one that is, or its triangles (`clipscope clip` cuts it into such parts)",
      c.name));
}

HardCase case_from_text(const ExplainOptions& options) {
  Batch batch = described_batch(options.text);
  set_volume(options.volume, format_of(options), batch);
  batch.vertices = static_cast<int>(vertices_of(options.primitive));
  const std::vector<TextPrimitive> all = read_primitives(options.text, options.primitive);
  if (options.triangle >= all.size()) {
    throw InputError(fmt::format("{}: has {} {}s, number {} was asked for", options.text.file,
                                 all.size(), to_string(options.primitive), options.triangle));
  }
  const TextPrimitive& chosen = all[options.triangle];
  batch.numbers = std::span<const double>(chosen.values);
  const std::size_t end = chosen.values.size() / batch.stride();
  batch.ends = std::span(&end, 1);
  const HardCase hard_case = case_of(batch, 0, chosen.place);
  check_convex(hard_case);
  return hard_case;
}

HardCase chosen_case(const ExplainOptions& options) {
  if (!options.hard_case.empty()) return case_from_catalogue(options);
  return options.scene.empty() ? case_from_text(options) : case_from_scene(options);
}

// Errors: UsageError if there is no such clipper or scalar, or if it does not take such input.
const Contestant& chosen_contestant(const ExplainOptions& options, const HardCase& hard_case) {
  const std::string wanted = given_clipper(options.selection.clipper, load_guests(options.guests),
                                           default_clipper(hard_case.primitive));
  const Contestant& contestant = find_contestant(
      wanted, options.text.scalar, static_cast<int>(vertices_of(hard_case.primitive)));
  check_takes(contestant, {.space = hard_case.space,
                           .matrix = hard_case.matrix,
                           .volume = hard_case.volume,
                           .vertices = contestant.vertices,
                           .planes = hard_case.planes});
  return contestant;
}

// Says what a case of a catalogue is about.
void print_heading(const HardCase& hard_case) {
  if (hard_case.file.empty()) return;
  fmt::print("{}: a {} in {} space\n", hard_case.name, to_string(hard_case.primitive),
             hard_case.space == Space::view ? "view" : "clip");
  fmt::print("  why it is hard: {}\n  where it was met: {}\n", hard_case.why, hard_case.source);
  // What follows in clip space starts with an empty line.
  if (hard_case.space == Space::view) fmt::print("\n");
}

int explain(const ExplainOptions& options) {
  if (options.picture) page_format(*options.picture);
  const HardCase hard_case = chosen_case(options);
  const Contestant& contestant = chosen_contestant(options, hard_case);
  const Answers answers = clip_case(contestant, hard_case);
  const TruthPolygon truth = truth_polygon(hard_case);
  const Explanation explanation{contestant, answers[0], truth, compare(answers[0], truth)};
  if (options.selection.json) {
    nlohmann::json json = answer_json(explanation);
    json["name"] = hard_case.name;
    json["input"] = spaces_json(hard_case, *contestant.format);
    fmt::print("{}\n", json_text(json, 2));
  } else {
    print_heading(hard_case);
    print_spaces(hard_case, *contestant.format);
    print_answer(explanation);
  }
  if (options.picture) {
    hard_cases::write_case_picture(*options.picture, hard_cases::picture_of(hard_case, contestant));
  }
  return kExitOk;
}

}  // namespace

void add_explain_command(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, explain, "explain",
      "One primitive beside the exact answer, step by step in every space",
      R"(What is explained is a primitive of a text (as for `clipscope clip`), a triangle of a scene:
--scene, --view and --triangle, or a hard case of any primitive: --case. A projection is, for a
scene, what its camera sees.
Examples:
  echo '0 0 -2  3 0 -2  0 1 2' | clipscope explain --perspective 90,1,1,10
  echo '0 0 -5  9 0 -5  0 1 -5' | clipscope explain --matrix 1,0,0,0,0,1,0,0,0,0,-1,-1,0,0,-1,0
  clipscope explain --case planes_touched/nine_gon --clipper barycentric/distance_matrix)");
  options.command = &command;
  options.selection.clipper.clear();
  add_primitive_option(command, options.primitive);
  add_primitive_text_options(command, options.text);
  add_volume_options(command, options.volume);
  add_option(command, "--clipper", options.selection.clipper, "NAME",
             "Name of a clipper [of triangles: homogeneous/sutherland_hodgman]");
  add_guest_options(command, options.guests);
  add_option(command, "--scene", options.scene, "NAME|FILE",
             "Take the triangle from this scene or mesh file");
  command.add_option("--view", options.view, "Label of the scene's view [the first]");
  command.add_option("--triangle", options.triangle, "Number of the triangle, or primitive [0]");
  add_place_options(command, options.selection.camera);
  CLI::Option* hard_case =
      add_option(command, "--case", options.hard_case, "NAME",
                 "Take a hard case of the catalogue, such as w_sign/two_behind");
  add_option(command, "--corpus", options.corpus, "FILE|DIR",
             "Take the case from this catalogue of your own")
      ->needs(hard_case);
  add_option(command, "--picture", options.picture, "FILE",
             "Draw it too: a file .svg, .pdf or .png");
  add_json_option(command, options.selection);
  command.add_option("--seed", options.selection.seed, "Seed of the random scenes [1]");
  command.add_flag("--quick", options.selection.quick, "The smaller scene of `--quick` runs");
}

}  // namespace clipscope::experiments::commands
