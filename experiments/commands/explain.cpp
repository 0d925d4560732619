// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope explain: one triangle, step by step in every space, beside the exact answer.
#include <fmt/format.h>

#include <memory>
#include <utility>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/primitive_text.hpp"
#include "experiments/commands/selection.hpp"
#include "experiments/errors.hpp"
#include "experiments/measure/batches.hpp"
#include "experiments/measure/compare.hpp"
#include "experiments/pictures/draw_scene.hpp"
#include "experiments/report/decimal.hpp"
#include "spaces/cut.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::array<const char*, kPlanes> kPlaneNames = {"left", "right", "bottom",
                                                          "top",  "near",  "far"};

struct ExplainOptions {
  PrimitiveTextOptions text;
  Selection selection;
  std::string scene, view;
  std::size_t triangle = 0;
};

// What is explained: one triangle and its volume.
struct Subject {
  TextPrimitive triangle;
  Frustum<double> frustum;
  bool view_space = true;
  int attributes = 0;
};

const char* plane_name(Plane plane) { return kPlaneNames[static_cast<std::size_t>(plane)]; }

std::string outcode_text(Outcode code) {
  std::string text;
  for (const Plane plane : kAllPlanes) {
    if (code & bit(plane)) text += fmt::format("{}{}", text.empty() ? "" : " ", plane_name(plane));
  }
  return text.empty() ? "inside" : "outside " + text;
}

template <class Numbers>
std::string numbers_text(const Numbers& numbers, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += fmt::format(" {:>16.9g}", nearest_double(numbers[i]));
  return text;
}

template <Space S, class T>
void print_polygon(const Polygon<S, T, kRunTime>& polygon) {
  for (int v = 0; v < polygon.size(); ++v) {
    fmt::print("      {}: {}\n", v, numbers_text(polygon[v].position, Vertex<S, T, 0>::kDimension));
  }
}

// Cuts by each plane that some vertex is outside of and prints what is left; then the polygon.
template <Space S, class T, class Distance>
Polygon<S, T, kRunTime> print_cuts(const Triangle<S, T, kRunTime>& triangle, Distance&& distance) {
  Polygon<S, T, kRunTime> polygon, cut_off;
  polygon.assign(triangle);
  for (const Plane plane :
       {Plane::near, Plane::far, Plane::left, Plane::right, Plane::bottom, Plane::top}) {
    const auto d = [&](const Vertex<S, T, kRunTime>& v) { return distance(plane, v.position); };
    std::string distances;
    bool crossed = false;
    for (int v = 0; v < polygon.size(); ++v) {
      const T value = d(polygon[v]);
      distances += fmt::format(" {:.6g}", nearest_double(value));
      crossed = crossed || !(T(0) <= value);
    }
    if (!crossed) continue;
    cut(polygon, cut_off, d);
    fmt::print("    {}: distances{}; {} vertices become {}\n", plane_name(plane), distances,
               polygon.size(), cut_off.size());
    std::swap(polygon, cut_off);
    print_polygon(polygon);
  }
  if (polygon.size() < 3) fmt::print("    nothing is left\n");
  return polygon;
}

template <class T>
void explain_view(const Projection<T>& projection, const ViewTriangle<T, kRunTime>& triangle) {
  fmt::print("View space: x y z\n");
  for (int v = 0; v < 3; ++v) {
    fmt::print("  v{}: {}  {}\n", v, numbers_text(triangle[v].position, 3),
               outcode_text(view_outcode(projection.frustum, triangle[v].position)));
  }
  fmt::print("  cuts in view space\n");
  print_cuts<Space::view>(triangle, [&](Plane plane, const Vec3<T>& p) {
    return view_distance(projection.frustum, plane, p);
  });
}

template <class T>
void explain_clip(DepthRange depth, const ClipTriangle<T, kRunTime>& triangle) {
  fmt::print("\nClip space: x y z w\n");
  for (int v = 0; v < 3; ++v) {
    fmt::print("  v{}: {}  {}\n", v, numbers_text(triangle[v].position, 4),
               outcode_text(clip_outcode(depth, triangle[v].position)));
  }
  fmt::print("  cuts in clip space\n");
  print_cuts<Space::clip>(
      triangle, [&](Plane plane, const Vec4<T>& p) { return clip_distance(depth, plane, p); });
}

template <class T>
void explain_ndc(DepthRange depth, const ClipTriangle<T, kRunTime>& triangle) {
  fmt::print("\nCanonical view volume, divided before any cut: x y z 1/w\n");
  Triangle<Space::ndc, T, kRunTime> divided;
  for (int v = 0; v < 3; ++v) {
    const T& w = triangle[v].position[3];
    if (!can_divide_by(w)) {
      fmt::print("  v{} has w = 0: it can't be divided\n", v);
      return;
    }
    divided[v] = to_ndc(triangle[v]);
    fmt::print("  v{}: {}  {}{}\n", v, numbers_text(divided[v].position, 4),
               outcode_text(ndc_outcode(depth, divided[v].position)),
               T(0) < w ? "" : "; w <= 0: mirrored through the eye or at infinity");
  }
  fmt::print("  cuts in the volume\n");
  print_cuts<Space::ndc>(
      divided, [&](Plane plane, const Vec4<T>& p) { return ndc_distance(depth, plane, p); });
}

// The exact vertex nearest to a vertex of the answer, on the screen.
template <class T>
const reference::ExactVertex& nearest_vertex(const TruthPolygon& truth,
                                             const NdcVertex<T, kRunTime>& v) {
  std::size_t best = 0;
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < truth.approximation.size(); ++i) {
    const auto& a = truth.approximation[i];
    const double distance =
        std::hypot(nearest_double(v.position[0]) - a[0], nearest_double(v.position[1]) - a[1]);
    if (distance < least) {
      least = distance;
      best = i;
    }
  }
  return truth.exact.vertices[best];
}

template <class T>
void print_coordinate(const std::string& name, const T& value, const reference::Fraction& exact) {
  constexpr int kDigits =
      ScalarTraits<T>::precision == 0 ? 34 : (ScalarTraits<T>::precision * 302) / 1000 + 3;
  if (!is_finite(value)) {
    fmt::print("      {:5}  {} (not finite), exact {}\n", name, nearest_double(value),
               decimal(reference::to_rational(exact), kDigits));
    return;
  }
  const Exact found = to_exact(value);
  const Exact right = reference::to_rational(exact);
  const double error = reference::error_of(found, exact);
  const double ulp = ulp_at<T>(reference::approximate(exact));
  fmt::print("      {:5}  {}\n", name, marked_decimal(found, right, kDigits));
  fmt::print("      exact  {}  error {:.2g}{}\n", decimal(right, kDigits), error,
             ulp > 0 ? fmt::format(" = {:.3g} ulp", std::abs(error) / ulp) : "");
}

template <class T>
void print_answer(const NdcPolygon<T, kRunTime>& polygon, const TruthPolygon& truth) {
  const Comparison comparison =
      compare<T, kRunTime>(std::span(polygon.begin(), polygon.end()), truth);
  fmt::print("  {} vertices, exact {}; outcome: {}\n", polygon.size(), truth.exact.vertices.size(),
             outcome_name(comparison.outcome));
  if (truth.exact.vertices.empty()) return;
  fmt::print("  the first wrong digit is in brackets\n");
  static constexpr std::array<const char*, 4> kNames = {"x", "y", "z", "1/w"};
  for (int v = 0; v < polygon.size(); ++v) {
    const reference::ExactVertex& exact = nearest_vertex(truth, polygon[v]);
    fmt::print("    vertex {}\n", v);
    for (int i = 0; i < 4; ++i) {
      print_coordinate(kNames[static_cast<std::size_t>(i)], polygon[v].position[i],
                       coordinate(exact, i));
    }
    for (int k = 0; k < polygon[v].attributes.size(); ++k) {
      print_coordinate(fmt::format("a{}", k), polygon[v].attributes[k],
                       exact.attributes[static_cast<std::size_t>(k)]);
    }
  }
}

template <class T>
void explain_with(const Contestant<T>& contestant, const Subject& subject) {
  const auto polygon = std::make_unique<NdcPolygon<T, kRunTime>>();
  const DepthRange depth = subject.frustum.depth;
  TruthPolygon truth;
  if (subject.view_space) {
    const auto projection = projection_from<T>(subject.frustum);
    const auto triangle = triangle_of<T, Space::view>(subject.triangle, subject.attributes);
    const auto bits = triangle_of<double, Space::view>(subject.triangle, subject.attributes);
    explain_view(projection, triangle);
    explain_clip(depth, to_clip(projection, triangle));
    explain_ndc(depth, to_clip(projection, triangle));
    contestant.view_one(projection, triangle, *polygon);
    truth = truth_polygon(reference::Truth::of_frustum(subject.frustum),
                          reference::input_triangle(bits));
  } else {
    const auto triangle = triangle_of<T, Space::clip>(subject.triangle, subject.attributes);
    const auto bits = triangle_of<double, Space::clip>(subject.triangle, subject.attributes);
    if (contestant.clip_one == nullptr) {
      throw UsageError(
          fmt::format("--clipper: {} starts in view space, so clip-space triangles are "
                      "not applicable",
                      contestant.name));
    }
    explain_clip(depth, triangle);
    explain_ndc(depth, triangle);
    contestant.clip_one(ClipVolume{.depth = depth}, triangle, *polygon);
    truth = truth_polygon(reference::Truth::of_clip(depth), reference::input_triangle(bits));
  }
  fmt::print("\nAnswer of {} in {}\n", contestant.name, ScalarTraits<T>::name);
  print_answer(*polygon, truth);
}

Subject subject_from_scene(const ExplainOptions& options) {
  const Scene scene = load_selected_scene(options.selection, options.scene);
  if (options.triangle >= scene.mesh.triangles.size()) {
    throw UsageError(fmt::format("--triangle: scene {} has the triangles 0 to {}, {} was given",
                                 scene.name, scene.mesh.triangles.size() - 1, options.triangle));
  }
  const View& view = find_view(scene, options.view);
  const auto triangles =
      sampled_view_triangles(scene, view, {scene.mesh.triangles.size(), 1}, options.triangle, 1);
  Subject subject{{0, {}}, frustum_cast<double>(view.frustum), true, kSceneAttributes};
  for (const auto& v : triangles.front()) {
    for (int i = 0; i < 3; ++i) subject.triangle.values.push_back(v.position[i]);
    for (int k = 0; k < kSceneAttributes; ++k) subject.triangle.values.push_back(v.attributes[k]);
  }
  return subject;
}

Subject subject_from_text(const ExplainOptions& options) {
  const Frustum<double> frustum = frustum_of(options.text);
  std::vector<TextPrimitive> triangles = read_primitives(options.text, Primitive::triangle);
  if (options.triangle >= triangles.size()) {
    throw InputError(fmt::format("{}: has {} triangles, number {} was asked for", options.text.file,
                                 triangles.size(), options.triangle));
  }
  return {std::move(triangles[options.triangle]), frustum, options.text.space == "view",
          options.text.attributes};
}

int explain(const ExplainOptions& options) {
  const AnyContestant chosen = find_contestant(options.selection.clipper, options.text.scalar);
  const Subject subject =
      options.scene.empty() ? subject_from_text(options) : subject_from_scene(options);
  std::visit([&](const auto* contestant) { explain_with(*contestant, subject); }, chosen);
  return kExitOk;
}

}  // namespace

void add_explain_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "explain", "One triangle step by step in every space, beside the exact answer");
  command->footer(
      "The triangle is one of a text (as for `clipscope clip`) or of a scene: --scene, --view and "
      "--triangle.");
  const auto options = std::make_shared<ExplainOptions>();
  options->selection.clipper = "homogeneous/sutherland_hodgman";
  add_primitive_text_options(*command, options->text);
  command->add_option("--clipper", options->selection.clipper, "Name of a clipper")
      ->type_name("NAME");
  command->add_option("--scene", options->scene, "Take the triangle from this scene or mesh file")
      ->type_name("NAME|FILE");
  command->add_option("--view", options->view, "Label of the scene's view [the first]");
  command->add_option("--triangle", options->triangle, "Number of the triangle [0]");
  command->add_option("--seed", options->selection.seed, "Seed of the random scenes [1]");
  command->add_flag("--quick", options->selection.quick, "The smaller scene of `--quick` runs");
  command->callback([&action, options] { action = [options] { return explain(*options); }; });
}

}  // namespace clipscope::experiments
