// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope verify: does a clipper keep its promise on every triangle?
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <memory>
#include <optional>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/selection.hpp"
#include "experiments/errors.hpp"
#include "experiments/measure/batches.hpp"
#include "experiments/measure/promise.hpp"
#include "experiments/report/progress.hpp"
#include "experiments/report/table.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kChunk = 1024;  // triangles

struct Offender {
  PromiseCheck check;
  std::string scene, view;
  std::size_t triangle = 0;
  std::string input, output;  // hex floats
};

struct VerifyResult {
  std::size_t triangles = 0, outside_domain = 0, broken = 0;
  double largest_ulps = 0;
  std::optional<Offender> worst;
};

std::string hex_triangle(const SceneTriangle& triangle) {
  std::string text;
  for (const auto& v : triangle) {
    for (int i = 0; i < 3; ++i) text += fmt::format("{:a} ", v.position[i]);
    for (int k = 0; k < kSceneAttributes; ++k) text += fmt::format("{:a} ", v.attributes[k]);
  }
  text.pop_back();
  return text;
}

std::string hex_frustum(const Frustum<float>& f) {
  return fmt::format("--{} {:a},{:a},{:a},{:a},{:a},{}",
                     f.kind == ProjectionKind::perspective ? "frustum" : "ortho", f.left, f.right,
                     f.bottom, f.top, f.near, f.infinite_far ? "inf" : fmt::format("{:a}", f.far));
}

template <class T>
std::string hex_polygon(std::span<const NdcVertex<T, kSceneAttributes>> polygon) {
  std::string text;
  for (const auto& v : polygon) {
    text += "   ";
    for (int i = 0; i < 4; ++i) text += fmt::format(" {:a}", nearest_double(v.position[i]));
    for (int k = 0; k < kSceneAttributes; ++k)
      text += fmt::format(" {:a}", nearest_double(v.attributes[k]));
    text += '\n';
  }
  return text.empty() ? "    nothing\n" : text;
}

bool is_worse(const PromiseCheck& a, const std::optional<Offender>& b) {
  return !b || a.ulps > b->check.ulps;
}

template <class T>
void verify_chunk(const Contestant<T>& contestant, const PromiseChecker& checker,
                  const Scene& scene, const View& view, const Sample& sample, std::size_t first,
                  std::size_t count, VerifyResult& result) {
  const std::vector<SceneTriangle> triangles =
      sampled_view_triangles(scene, view, sample, first, count);
  PolygonStream<T, kSceneAttributes> polygons;
  contestant.view(projection_of<T>(view), triangles_cast<T>(triangles), polygons);
  std::vector<PromiseCheck> checks(count);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    checks[i] = checker.check<T, kSceneAttributes>(
        contestant.promise, reference::input_triangle(triangles[i]), polygons[i]);
  });
  for (std::size_t i = 0; i < count; ++i) {
    const PromiseCheck& check = checks[i];
    ++result.triangles;
    result.outside_domain += check.verdict == PromiseVerdict::outside_domain;
    result.largest_ulps = std::max(result.largest_ulps, check.ulps);
    if (check.verdict != PromiseVerdict::broken) continue;
    ++result.broken;
    if (is_worse(check, result.worst)) {
      result.worst =
          Offender{check,
                   scene.name,
                   view.label,
                   (first + i) * sample.stride,
                   fmt::format("{}\n    {}", hex_frustum(view.frustum), hex_triangle(triangles[i])),
                   hex_polygon<T>(polygons[i])};
    }
  }
}

VerifyResult verify_scene(const AnyContestant& contestant, const Scene& scene, std::size_t limit) {
  VerifyResult result;
  const Sample sample = sample_of(scene, limit);
  Progress progress(fmt::format("verify {}", scene.name), sample.count * scene.views.size());
  for (const View& view : scene.views) {
    const PromiseChecker checker(frustum_cast<double>(view.frustum));
    for (std::size_t first = 0; first < sample.count; first += kChunk) {
      const std::size_t count = std::min(kChunk, sample.count - first);
      std::visit(
          [&](const auto* c) {
            verify_chunk(*c, checker, scene, view, sample, first, count, result);
          },
          contestant);
      progress.advance(count);
    }
  }
  return result;
}

void merge(const VerifyResult& part, VerifyResult& whole) {
  whole.triangles += part.triangles;
  whole.outside_domain += part.outside_domain;
  whole.broken += part.broken;
  whole.largest_ulps = std::max(whole.largest_ulps, part.largest_ulps);
  if (part.worst && is_worse(part.worst->check, whole.worst)) whole.worst = part.worst;
}

nlohmann::json to_json(const AnyContestant& contestant, const VerifyResult& result) {
  nlohmann::json json = {{"clipper", clipper_name(contestant)},
                         {"scalar", scalar_name(contestant)},
                         {"triangles", result.triangles},
                         {"outside_domain", result.outside_domain},
                         {"broken", result.broken},
                         {"kept", result.broken == 0}};
  json["largest_backward_error_ulp"] = std::isfinite(result.largest_ulps)
                                           ? nlohmann::json(result.largest_ulps)
                                           : nlohmann::json("inf");
  if (result.worst) {
    json["worst"] = {{"scene", result.worst->scene},       {"view", result.worst->view},
                     {"triangle", result.worst->triangle}, {"reason", result.worst->check.reason},
                     {"input", result.worst->input},       {"output", result.worst->output}};
  }
  return json;
}

void print(const AnyContestant& contestant, const VerifyResult& result) {
  fmt::print("{} {}: promise {} on {} triangles", clipper_name(contestant), scalar_name(contestant),
             result.broken == 0 ? "kept" : "BROKEN", result.triangles - result.outside_domain);
  if (result.outside_domain > 0)
    fmt::print(" ({} more are outside its domain)", result.outside_domain);
  fmt::print("\nlargest backward error: {:.3g} of the promise's unit\n", result.largest_ulps);
  if (!result.worst) return;
  const Offender& worst = *result.worst;
  fmt::print("broken on {} triangles; the worst: scene {}, view {}, triangle {}\n  {}\n",
             result.broken, worst.scene, worst.view, worst.triangle, worst.check.reason);
  fmt::print(
      "  input (three vertices: x y z and {} attributes):\n    {}\n  output (x y z 1/w, "
      "attributes):\n{}",
      kSceneAttributes, worst.input, worst.output);
}

int verify(const Selection& selection, const std::string& scalar) {
  const AnyContestant contestant = find_contestant(selection.clipper, scalar);
  VerifyResult result;
  for (const std::string& name : scene_names(selection)) {
    merge(verify_scene(contestant, load_selected_scene(selection, name), selection.sample), result);
  }
  if (selection.json) {
    fmt::print("{}\n", to_json(contestant, result).dump(2));
  } else {
    print(contestant, result);
  }
  return result.broken == 0 ? kExitOk : kExitPromiseBroken;
}

}  // namespace

void add_verify_command(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("verify", "Check a clipper's promise on every triangle of the scenes");
  command->footer(
      "Exit code 0: the promise holds on every triangle; 1: it is broken, and the worst "
      "offender is\nprinted as hex floats. `clipscope list clippers` shows the promises.");
  const auto selection = std::make_shared<Selection>();
  const auto scalar = std::make_shared<std::string>("float");
  command->add_option("--clipper", selection->clipper, "Name of a clipper")
      ->type_name("NAME")
      ->required();
  command->add_option("--scalar", *scalar, "Scalar to compute in [float]");
  add_scene_options(*command, *selection);
  add_json_option(*command, *selection);
  command->callback([&action, selection, scalar] {
    action = [selection, scalar] { return verify(*selection, *scalar); };
  });
}

}  // namespace clipscope::experiments
