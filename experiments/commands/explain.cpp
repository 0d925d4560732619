// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope explain: one primitive beside the exact answer, a triangle step by step in every space;
// as a picture, too.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/commands/options.hpp"
#include "experiments/draw/vector_page.hpp"
#include "experiments/hard_cases/case_picture.hpp"
#include "experiments/judge/compare.hpp"
#include "experiments/report/decimal.hpp"
#include "experiments/report/outcode_text.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/survey/draw_scene.hpp"
#include "experiments/survey/verdicts.hpp"
#include "experiments/table/row.hpp"
#include "spaces/cut.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments::commands {
namespace {

struct ExplainOptions {
  PrimitiveTextOptions text;
  Selection selection;  // its clipper is empty if none was chosen
  std::string scene, view;
  std::size_t triangle = 0;
  std::string hard_case;
  std::optional<std::string> corpus, picture;
  const CLI::App* command = nullptr;  // that has these options
};

// --- What is explained --------------------------------------------------------------------------

// Errors: UsageError if something else was chosen too.
HardCase case_from_catalogue(const ExplainOptions& options) {
  for (const char* option : {"file", "--space", "--attributes", "--perspective", "--frustum",
                             "--ortho", "--depth", "--scene", "--view", "--triangle"}) {
    if (options.command->count(option) == 0) continue;
    usage_error("--case: a case says all that {} would say; leave it out", option);
  }
  if (!options.corpus) return find_case(builtin_catalogue(), options.hard_case);
  return find_case(load_catalogue(*options.corpus), options.hard_case);
}

// The first primitive of the batch, a triangle.
HardCase case_of(const Batch& batch, const std::string& name, const std::string& why) {
  HardCase r;
  r.name = name;
  r.why = why;
  r.space = batch.space;
  r.frustum = batch.frustum;
  r.volume = batch.volume;
  r.vertices = input_vertices(batch, 0);
  r.attribute_count = batch.attributes;
  return r;
}

HardCase case_from_scene(const ExplainOptions& options) {
  const Scene scene = load_selected_scene(options.selection, options.scene);
  const std::size_t all = scene.mesh.triangles.size();
  if (options.triangle >= all) {
    usage_error("--triangle: scene {} has the triangles 0 to {}, {} was given", scene.name, all - 1,
                options.triangle);
  }
  const View& view = find_view(scene, options.view);
  const auto triangles = sampled_view_triangles(scene, view, {all, 1}, options.triangle, 1);
  return case_of(batch_of(view, triangles),
                 fmt::format("triangle {} of {}", options.triangle, scene.name),
                 fmt::format("seen from {}", view.label));
}

HardCase case_from_text(const ExplainOptions& options) {
  Batch batch = described_batch(options.text);
  const std::vector<TextPrimitive> triangles = read_primitives(options.text, Primitive::triangle);
  if (options.triangle >= triangles.size()) {
    throw InputError(fmt::format("{}: has {} triangles, number {} was asked for", options.text.file,
                                 triangles.size(), options.triangle));
  }
  const TextPrimitive& chosen = triangles[options.triangle];
  batch.numbers = std::span<const double>(chosen.values);
  return case_of(batch, chosen.place, "");
}

HardCase chosen_case(const ExplainOptions& options) {
  if (!options.hard_case.empty()) return case_from_catalogue(options);
  return options.scene.empty() ? case_from_text(options) : case_from_scene(options);
}

// Errors: UsageError if there is no such clipper or scalar, or if it does not take such input.
const Contestant& chosen_contestant(const ExplainOptions& options, const HardCase& hard_case) {
  const std::string& wanted = options.selection.clipper;
  const Contestant& contestant =
      find_contestant(wanted.empty() ? default_clipper(hard_case.primitive) : wanted,
                      options.text.scalar, static_cast<int>(vertices_of(hard_case.primitive)));
  if (hard_case.space == Space::clip && !contestant.takes_clip_space) {
    usage_error("--clipper: {} starts in view space, so clip-space {}s are not applicable",
                contestant.clipper, to_string(hard_case.primitive));
  }
  if (!takes(contestant, hard_case)) {
    usage_error("--clipper: {} does not take depth clamp or clip distances", contestant.clipper);
  }
  return contestant;
}

// --- Where it is in each space, and each cut of a triangle --------------------------------------

template <Space S, class T>
using Vertices = std::vector<Vertex<S, T, kRunTime>>;

// The case in the scalar T, each number rounded once.
template <Space S, class T>
Vertices<S, T> vertices_in(const HardCase& hard_case) {
  Vertices<S, T> vertices;
  for (const reference::InputVertex& given : hard_case.vertices) {
    Vertex<S, T, kRunTime>& v = vertices.emplace_back();
    const double *next = given.position.data(), *attribute = given.attributes.data();
    for (int i = 0; i < v.kDimension; ++i) v.position[i] = scalar_from<T>(*next++);
    v.attributes.resize(hard_case.attribute_count);
    for (int k = 0; k < v.attributes.size(); ++k) v.attributes[k] = scalar_from<T>(*attribute++);
  }
  return vertices;
}

// x y z, and of clip space and NDC the fourth coordinate.
template <Space S, class T>
std::string position_text(const Vertex<S, T, kRunTime>& v) {
  std::string text;
  for (int i = 0; i < v.kDimension; ++i) {
    text += fmt::format(" {:>16.9g}", nearest_double(v.position[i]));
  }
  return text;
}

// Cuts by each plane of the volume that some vertex is outside of, and prints what is left.
// where: the frustum in view space, else the depth range.
template <Space S, class T, class Where>
void print_cuts(Vertices<S, T> polygon, const ClipVolume& volume, const Where& where) {
  static constexpr std::array kOrder = {Plane::near,  Plane::far,    Plane::left,
                                        Plane::right, Plane::bottom, Plane::top};
  for_each_plane(planes_of(volume), kOrder, [&](Plane plane) {
    const auto distance = [&](const auto& v) { return signed_distance(where, plane, v); };
    std::string distances;
    bool crossed = false;
    for (const auto& v : polygon) {
      const T d = distance(v);
      distances += fmt::format(" {:.6g}", nearest_double(d));
      crossed = crossed || !(T(0) <= d);
    }
    if (!crossed) return;
    Vertices<S, T> left;
    cut(polygon, left, distance);
    fmt::print("    {}: distances{}; {} vertices become {}\n", plane_text(plane), distances,
               polygon.size(), left.size());
    polygon = std::move(left);
    for (std::size_t v = 0; v < polygon.size(); ++v) {
      fmt::print("      {}: {}\n", v, position_text(polygon[v]));
    }
  });
  if (polygon.size() < 3) fmt::print("    nothing is left\n");
}

// Prints each vertex in view space or clip space, and what it is outside of; then the cuts.
template <Space S, class T, class Where>
void print_space(const Vertices<S, T>& vertices, const ClipVolume& volume, const Where& where,
                 bool with_cuts) {
  constexpr bool kView = S == Space::view;
  fmt::print("{}\n", kView ? "View space: x y z" : "\nClip space: x y z w");
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    Outcode code = clip_distance_outcode(volume, vertices[i].attributes);
    if constexpr (kView) code |= view_outcode(where, vertices[i].position);
    if constexpr (!kView) code |= clip_outcode(where, vertices[i].position);
    fmt::print("  v{}: {}  {}\n", i, position_text(vertices[i]),
               outcode_text(code & planes_of(volume)));
  }
  if (!with_cuts) return;
  fmt::print("  cuts in {} space\n", kView ? "view" : "clip");
  print_cuts(vertices, volume, where);
}

template <class T>
void print_ndc(const Vertices<Space::clip, T>& vertices, const ClipVolume& volume) {
  fmt::print("\nCanonical view volume, divided before any cut: x y z 1/w\n");
  Vertices<Space::ndc, T> divided;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const T& w = vertices[i].position[3];
    if (!can_divide_by(w)) {
      fmt::print("  v{} has w = 0: it can't be divided\n", i);
      return;
    }
    const auto& v = divided.emplace_back(to_ndc(vertices[i]));
    fmt::print("  v{}: {}  {}{}\n", i, position_text(v),
               outcode_text(ndc_outcode(volume.depth, v.position) & planes_of(volume)),
               T(0) < w ? "" : "; w <= 0: mirrored through the eye or at infinity");
  }
  fmt::print("  cuts in the volume\n");
  print_cuts(divided, volume, volume.depth);
}

template <class T>
void print_spaces(const HardCase& hard_case) {
  const bool is_triangle = hard_case.primitive == Primitive::triangle;
  const ClipVolume& volume = hard_case.volume;
  Vertices<Space::clip, T> projected;
  if (hard_case.space == Space::view) {
    const Projection<T> projection = projection_from<T>(hard_case.frustum);
    const auto vertices = vertices_in<Space::view, T>(hard_case);
    print_space(vertices, volume, projection.frustum, is_triangle);
    for (const auto& v : vertices) projected.push_back(to_clip(projection, v));
  } else {
    projected = vertices_in<Space::clip, T>(hard_case);
  }
  print_space(projected, volume, volume.depth, is_triangle);
  if (is_triangle) print_ndc(projected, volume);
}

// --- The answer beside the exact one ------------------------------------------------------------

// The exact vertex nearest to a vertex of the answer, on the screen.
const reference::ExactVertex& nearest_vertex(const TruthPolygon& truth, const VertexView& v) {
  const auto distance = [&](const std::vector<double>& a) {
    return std::hypot(v[0].value - a[0], v[1].value - a[1]);
  };
  const auto nearest = std::ranges::min_element(truth.approximation, std::less(), distance);
  return truth.exact.vertices[static_cast<std::size_t>(nearest - truth.approximation.begin())];
}

std::string coordinate_name(std::size_t i) {
  static constexpr std::array<const char*, 4> kNames = {"x", "y", "z", "1/w"};
  return i < 4 ? kNames[i] : fmt::format("a{}", i - 4);
}

// Digits that tell the format's numbers apart.
int digits_of(const Format& format) {
  return format.is_exact() ? 34 : (format.precision * 302) / 1000 + 3;
}

void print_coordinate(const Format& format, std::size_t i, const Number& value,
                      const reference::Fraction& exact) {
  const std::string name = coordinate_name(i);
  const Exact right = reference::to_rational(exact);
  const std::string right_text = decimal(right, digits_of(format));
  if (!is_finite(value)) {
    fmt::print("      {:5}  {} (not finite), exact {}\n", name, value.value, right_text);
    return;
  }
  const Exact found = to_exact(value);
  const double error = reference::error_of(found, exact);
  const double ulp = format.ulp_at(reference::approximate(exact));
  fmt::print("      {:5}  {}\n", name, marked_decimal(found, right, digits_of(format)));
  fmt::print("      exact  {}  error {:.2g}{}\n", right_text, error,
             ulp > 0 ? fmt::format(" = {:.3g} ulp", std::abs(error) / ulp) : "");
}

// Prints what an empty answer lacks.
void print_exact_vertices(const Format& format, const TruthPolygon& truth) {
  for (std::size_t v = 0; v < truth.exact.vertices.size(); ++v) {
    fmt::print("    exact vertex {}\n", v);
    for (std::size_t i = 0; i < truth.approximation[v].size(); ++i) {
      const Exact value =
          reference::to_rational(coordinate(truth.exact.vertices[v], static_cast<int>(i)));
      fmt::print("      {:5}  {}\n", coordinate_name(i), decimal(value, digits_of(format)));
    }
  }
}

void print_answer(const Contestant& contestant, const PolygonView& polygon,
                  const TruthPolygon& truth) {
  fmt::print("\nAnswer of {} in {}\n", contestant.clipper, contestant.scalar());
  fmt::print("  {} vertices, exact {}; outcome: {}\n", polygon.size(), truth.exact.vertices.size(),
             name_of(compare(polygon, truth).outcome));
  if (truth.exact.vertices.empty()) return;
  if (polygon.empty()) return print_exact_vertices(polygon.format(), truth);
  fmt::print("  the first wrong digit is in brackets\n");
  for (std::size_t v = 0; v < polygon.size(); ++v) {
    const VertexView vertex = polygon[v];
    const reference::ExactVertex& exact = nearest_vertex(truth, vertex);
    fmt::print("    vertex {}\n", v);
    for (std::size_t i = 0; i < vertex.size(); ++i) {
      print_coordinate(polygon.format(), i, vertex[i], coordinate(exact, static_cast<int>(i)));
    }
  }
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
  print_heading(hard_case);
  with_scalar(*contestant.format, [&]<class T>() { print_spaces<T>(hard_case); });
  const Answers answers = clip_case(contestant, hard_case);
  print_answer(contestant, answers[0], truth_polygon(hard_case));
  if (options.picture) {
    hard_cases::write_case_picture(*options.picture, hard_cases::picture_of(hard_case, contestant));
  }
  return kExitOk;
}

}  // namespace

void add_explain_command(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, explain, "explain",
      "One primitive beside the exact answer, a triangle step by step in every space",
      R"(What is explained is a triangle of a text (as for `clipscope clip`), one of a scene: --scene,
--view and --triangle, or a hard case of any primitive: --case.)");
  options.command = &command;
  options.selection.clipper.clear();
  add_primitive_text_options(command, options.text);
  add_option(command, "--clipper", options.selection.clipper, "NAME",
             "Name of a clipper [of triangles: homogeneous/sutherland_hodgman]");
  add_option(command, "--scene", options.scene, "NAME|FILE",
             "Take the triangle from this scene or mesh file");
  command.add_option("--view", options.view, "Label of the scene's view [the first]");
  command.add_option("--triangle", options.triangle, "Number of the triangle [0]");
  CLI::Option* hard_case =
      add_option(command, "--case", options.hard_case, "NAME",
                 "Take a hard case of the catalogue, such as w_sign/two_behind");
  add_option(command, "--corpus", options.corpus, "FILE|DIR",
             "Take the case from this catalogue of your own")
      ->needs(hard_case);
  add_option(command, "--picture", options.picture, "FILE",
             "Draw it too: a file .svg, .pdf or .png");
  command.add_option("--seed", options.selection.seed, "Seed of the random scenes [1]");
  command.add_flag("--quick", options.selection.quick, "The smaller scene of `--quick` runs");
}

}  // namespace clipscope::experiments::commands
