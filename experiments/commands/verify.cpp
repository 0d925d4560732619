// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope verify: does a clipper keep its promise on every triangle of scenes, of the catalogue of hard
// cases, or of both?
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/catalogue/families.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/commands/selection.hpp"
#include "experiments/errors.hpp"
#include "experiments/hard_cases/judge.hpp"
#include "experiments/hex_float.hpp"
#include "experiments/measure/batches.hpp"
#include "experiments/measure/bit_promise.hpp"
#include "experiments/measure/promise.hpp"
#include "experiments/report/progress.hpp"
#include "experiments/report/replay_text.hpp"
#include "experiments/report/table.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kChunk = 1024;  // triangles

struct VerifyOptions {
  Selection selection;
  std::string scalar = "float";
  bool catalogue = false;
  std::optional<std::string> corpus;
};

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

template <class T>
std::string hex_polygon(std::span<const NdcVertex<T, kSceneAttributes>> polygon) {
  std::string text;
  for (const auto& v : polygon) {
    text += "   ";
    for (int i = 0; i < 4; ++i) text += " " + hex_float(nearest_double(v.position[i]));
    for (int k = 0; k < kSceneAttributes; ++k)
      text += " " + hex_float(nearest_double(v.attributes[k]));
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
  contestant.view(projection_of<T>(view), simplices_cast<T>(triangles), polygons);
  const Frustum<double> frustum = frustum_cast<double>(view.frustum);
  const ClipVolume volume{.depth = frustum.depth};
  std::vector<PromiseCheck> checks(count);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    checks[i] = checker.check<T, kSceneAttributes>(
        contestant.promise, reference::input_triangle(triangles[i]), polygons[i]);
    break_by_bits(checks[i],
                  broken_bits<T>(contestant, frustum, volume,
                                 with_run_time_attributes(simplex_cast<T>(triangles[i]))));
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
                   fmt::format("{}\n    {}", frustum_options(view.frustum), hex_line(triangles[i])),
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

std::string hex_case(const HardCase& c) {
  const bool is_view = c.space == Space::view;
  return (is_view ? frustum_options(frustum_cast<float>(c.frustum)) : "--space clip") + "\n    " +
         hex_line(c.vertices, is_view ? 3 : 4, c.attribute_count);
}

std::string hex_answer(const CaseAnswer& answer) {
  std::string text;
  for (const std::array<double, 4>& p : answer.polygon) {
    text += fmt::format("    {} {} {} {}\n", hex_float(p[0]), hex_float(p[1]), hex_float(p[2]),
                        hex_float(p[3]));
  }
  return text.empty() ? "    nothing\n" : text;
}

void verify_case(const CaseContestant& contestant, const HardCase& hard_case,
                 VerifyResult& result) {
  const PromiseCheck check = contestant.keeps_promise(hard_case);
  ++result.triangles;
  result.outside_domain += check.verdict == PromiseVerdict::outside_domain;
  result.largest_ulps = std::max(result.largest_ulps, check.ulps);
  if (check.verdict != PromiseVerdict::broken) return;
  ++result.broken;
  if (is_worse(check, result.worst)) {
    result.worst =
        Offender{check, "catalogue",         hard_case.name,
                 0,     hex_case(hard_case), hex_answer(contestant.polygon_of(hard_case))};
  }
}

// All triangles of the catalogue and of the families around them, in view space and clip space.
VerifyResult verify_catalogue(const AnyContestant& any, const std::vector<HardCase>& catalogue) {
  const std::vector<CaseContestant> contestants =
      case_contestants(Primitive::triangle, clipper_name(any), {std::string(scalar_name(any))});
  VerifyResult result;
  Progress progress("verify the catalogue", catalogue.size());
  for (const HardCase& original : catalogue) {
    progress.advance();
    if (original.primitive != Primitive::triangle) continue;
    verify_case(contestants.front(), original, result);
    for (auto&& variants : {family(original), special_values(original)}) {
      for (const CaseVariant& variant : variants) {
        if (is_finite(variant)) verify_case(contestants.front(), variant.hard_case, result);
      }
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
      "  input (three vertices: coordinates, then attributes):\n    {}\n  output (x y z 1/w, "
      "attributes):\n{}",
      worst.input, worst.output);
}

int verify(const VerifyOptions& options) {
  const Selection& selection = options.selection;
  const AnyContestant contestant = find_contestant(selection.clipper, options.scalar);
  VerifyResult result;
  const bool cases = options.catalogue || options.corpus;
  if (cases) {
    merge(verify_catalogue(contestant,
                           options.corpus ? load_catalogue(*options.corpus) : builtin_catalogue()),
          result);
  }
  if (!cases || !selection.scenes.empty()) {
    for (const std::string& name : scene_names(selection)) {
      merge(verify_scene(contestant, load_selected_scene(selection, name), selection.sample),
            result);
    }
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
  CLI::App* command = app.add_subcommand(
      "verify", "Check a clipper's promises on every triangle of scenes or of the hard cases");
  command->footer(
      "Exit code 0: the promise holds on every triangle; 1: it is broken, and the worst "
      "offender is\nprinted as hex floats. `clipscope list clippers` shows the promises.");
  const auto options = std::make_shared<VerifyOptions>();
  command->add_option("--clipper", options->selection.clipper, "Name of a clipper")
      ->type_name("NAME")
      ->required();
  command->add_option("--scalar", options->scalar, "Scalar to compute in [float]");
  command->add_flag("--catalogue", options->catalogue,
                    "The hard cases and their families, in view space and clip space, instead of "
                    "scenes (or besides those named)");
  command->add_option("--corpus", options->corpus, "The same with hard cases of your own")
      ->type_name("FILE|DIR");
  add_scene_options(*command, options->selection);
  add_json_option(*command, options->selection);
  command->callback([&action, options] { action = [options] { return verify(*options); }; });
}

}  // namespace clipscope::experiments
