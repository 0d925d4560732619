// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope explain: one primitive beside the exact answer, a triangle step by step in every space; as a
// picture too.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <utility>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/commands/explain_case.hpp"
#include "experiments/commands/primitive_text.hpp"
#include "experiments/commands/selection.hpp"
#include "experiments/errors.hpp"
#include "experiments/hard_cases/case_picture.hpp"
#include "experiments/hard_cases/find_case.hpp"
#include "experiments/hard_cases/judge.hpp"
#include "experiments/measure/batches.hpp"
#include "experiments/pictures/draw_scene.hpp"

namespace clipscope::experiments {
namespace {

struct ExplainOptions {
  PrimitiveTextOptions text;
  Selection selection;  // its clipper is empty if none was chosen
  std::string scene, view;
  std::size_t triangle = 0;
  std::string hard_case, beside_case;
  std::optional<std::string> corpus, picture;
};

// Errors: UsageError if something else was chosen too.
HardCase case_from_catalogue(const ExplainOptions& options) {
  if (!options.beside_case.empty()) {
    throw UsageError(fmt::format("--case: a case says all that {} would say; leave it out",
                                 options.beside_case));
  }
  if (!options.corpus) return find_case(builtin_catalogue(), options.hard_case);
  return find_case(load_catalogue(*options.corpus), options.hard_case);
}

HardCase case_from_scene(const ExplainOptions& options) {
  const Scene scene = load_selected_scene(options.selection, options.scene);
  if (options.triangle >= scene.mesh.triangles.size()) {
    throw UsageError(fmt::format("--triangle: scene {} has the triangles 0 to {}, {} was given",
                                 scene.name, scene.mesh.triangles.size() - 1, options.triangle));
  }
  const View& view = find_view(scene, options.view);
  const auto triangles =
      sampled_view_triangles(scene, view, {scene.mesh.triangles.size(), 1}, options.triangle, 1);
  HardCase r;
  r.name = fmt::format("triangle {} of {}", options.triangle, scene.name);
  r.why = fmt::format("seen from {}", view.label);
  r.space = Space::view;
  r.frustum = frustum_cast<double>(view.frustum);
  r.volume.depth = r.frustum.depth;
  for (const auto& v : triangles.front()) r.vertices.push_back(reference::input_vertex(v));
  r.attribute_count = kSceneAttributes;
  return r;
}

template <Space S>
void set_triangle(const TextPrimitive& text, int attributes, HardCase& hard_case) {
  hard_case.space = S;
  for (const auto& v : triangle_of<double, S>(text, attributes)) {
    hard_case.vertices.push_back(reference::input_vertex(v));
  }
  hard_case.attribute_count = attributes;
}

HardCase case_from_text(const ExplainOptions& options) {
  HardCase r;
  r.frustum = frustum_of(options.text);
  r.volume.depth = r.frustum.depth;
  const std::vector<TextPrimitive> triangles = read_primitives(options.text, Primitive::triangle);
  if (options.triangle >= triangles.size()) {
    throw InputError(fmt::format("{}: has {} triangles, number {} was asked for", options.text.file,
                                 triangles.size(), options.triangle));
  }
  const TextPrimitive& text = triangles[options.triangle];
  r.name = fmt::format("{}:{}", options.text.file == "-" ? "standard input" : options.text.file,
                       text.line);
  if (options.text.space == "view") {
    set_triangle<Space::view>(text, options.text.attributes, r);
  } else {
    set_triangle<Space::clip>(text, options.text.attributes, r);
  }
  return r;
}

HardCase chosen_case(const ExplainOptions& options) {
  if (!options.hard_case.empty()) return case_from_catalogue(options);
  return options.scene.empty() ? case_from_text(options) : case_from_scene(options);
}

void draw(const std::string& path, const HardCase& hard_case, const std::string& clipper,
          const std::string& scalar) {
  const auto contestants = case_contestants(hard_case.primitive, clipper, {scalar});
  const TruthPolygon truth = truth_polygon(hard_case);
  const CaseAnswer answer = contestants.front().answer(hard_case, truth);
  write_case_picture(path, {hard_case, truth, answer, clipper, scalar});
}

int explain(const ExplainOptions& options) {
  if (options.picture) check_picture_path(*options.picture);
  const HardCase hard_case = chosen_case(options);
  const std::string& wanted = options.selection.clipper;
  const std::string clipper = explain_case(
      hard_case, wanted.empty() ? std::string(default_clipper(hard_case.primitive)) : wanted,
      options.text.scalar);
  if (options.picture) draw(*options.picture, hard_case, clipper, options.text.scalar);
  return kExitOk;
}

// An option that a case leaves nothing for, if one was given; else "".
std::string given_beside_case(const CLI::App& command) {
  for (const char* option : {"file", "--space", "--attributes", "--perspective", "--frustum",
                             "--ortho", "--depth", "--scene", "--view", "--triangle"}) {
    if (command.count(option) > 0) return option;
  }
  return {};
}

void add_case_options(CLI::App& command, ExplainOptions& options) {
  CLI::Option* hard_case =
      command
          .add_option("--case", options.hard_case,
                      "Take a hard case of the catalogue, such as w_sign/two_behind")
          ->type_name("NAME");
  command.add_option("--corpus", options.corpus, "Take the case from this catalogue of your own")
      ->type_name("FILE|DIR")
      ->needs(hard_case);
}

}  // namespace

void add_explain_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "explain", "One primitive beside the exact answer, a triangle step by step in every space");
  command->footer(
      "What is explained is a triangle of a text (as for `clipscope clip`), one of a scene: "
      "--scene,\n"
      "--view and --triangle, or a hard case of any primitive: --case.");
  const auto options = std::make_shared<ExplainOptions>();
  options->selection.clipper.clear();
  add_primitive_text_options(*command, options->text);
  command
      ->add_option("--clipper", options->selection.clipper,
                   "Name of a clipper [of triangles: homogeneous/sutherland_hodgman]")
      ->type_name("NAME");
  command->add_option("--scene", options->scene, "Take the triangle from this scene or mesh file")
      ->type_name("NAME|FILE");
  command->add_option("--view", options->view, "Label of the scene's view [the first]");
  command->add_option("--triangle", options->triangle, "Number of the triangle [0]");
  add_case_options(*command, *options);
  command->add_option("--picture", options->picture, "Draw it too: a file .svg, .pdf or .png")
      ->type_name("FILE");
  command->add_option("--seed", options->selection.seed, "Seed of the random scenes [1]");
  command->add_flag("--quick", options->selection.quick, "The smaller scene of `--quick` runs");
  command->callback([&action, options, command] {
    options->beside_case = given_beside_case(*command);
    action = [options] { return explain(*options); };
  });
}

}  // namespace clipscope::experiments
