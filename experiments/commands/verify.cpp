// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope verify: does a clipper keep its promise on every triangle of scenes, of the catalogue
// of hard cases, or of both?
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/commands/guest_options.hpp"
#include "experiments/commands/options.hpp"
#include "experiments/judge/compare.hpp"
#include "experiments/judge/promise.hpp"
#include "experiments/judge/questions.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/scenes/text_file.hpp"
#include "experiments/selection/replay_text.hpp"
#include "experiments/survey/verdicts.hpp"
#include "experiments/table/hex_float.hpp"

namespace clipscope::experiments::commands {
namespace {

struct VerifyOptions {
  Selection selection;
  GuestOptions guests;
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

struct Verified {
  std::size_t triangles = 0, not_applicable = 0, outside_domain = 0, broken = 0;
  OutcomeCounts wrong_outside{};  // answers that are wrong where the promise does not speak
  double largest_ulps = 0;
  std::optional<Offender> worst;

  std::size_t judged() const { return triangles - not_applicable - outside_domain; }
  bool is_kept() const { return judged() > 0 && broken == 0; }

  // Whether it is the worst that is broken so far. compare() is asked what became of a triangle
  // that the promise does not speak of.
  template <class Compare>
  bool add(const PromiseCheck& check, const Compare& compare) {
    ++triangles;
    largest_ulps = std::max(largest_ulps, check.ulps);
    if (check.verdict == PromiseVerdict::outside_domain) {
      ++outside_domain;
      const Comparison comparison = compare();
      if (comparison.visible && is_failure(comparison.outcome)) {
        ++wrong_outside[static_cast<std::size_t>(comparison.outcome)];
      }
    }
    if (check.verdict != PromiseVerdict::broken) return false;
    ++broken;
    return !worst || check.ulps > worst->check.ulps;
  }
};

// A line per vertex: its first so many numbers.
std::string hex_polygon(const PolygonView& polygon, std::size_t numbers) {
  std::string text;
  for (const VertexView& v : polygon) {
    text += "   ";
    for (std::size_t i = 0; i < numbers; ++i) text += " " + hex_float(v[i].value);
    text += '\n';
  }
  return text.empty() ? "    nothing\n" : text;
}

// The triangles are those of the sample from number `first` on; they are `stride` apart.
template <class Triangle>
void verify_triangles(const Contestant& contestant, const std::string& scene, const View& view,
                      const std::vector<Triangle>& triangles, std::size_t first, std::size_t stride,
                      Verified& verified) {
  const Batch batch = batch_of(view, triangles);
  const PromiseChecker checker(batch);
  const Answers answers = clip(contestant, batch);
  std::vector<PromiseCheck> checks(triangles.size());
  tbb::parallel_for(std::size_t{0}, checks.size(), [&](std::size_t i) {
    checks[i] =
        checker.check(contestant.promise, reference::input_triangle(triangles[i]), answers[i]);
    const std::string reason = broken_bits(contestant, batch_of(view, std::span(&triangles[i], 1)));
    if (reason.empty()) return;
    checks[i].verdict = PromiseVerdict::broken;
    checks[i].reason = reason;
  });
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const auto comparison = [&] {
      return compare(answers[i],
                     truth_polygon(checker.truth(), reference::input_triangle(triangles[i])));
    };
    if (!verified.add(checks[i], comparison)) continue;
    const std::string input = projection_options(view) + "\n    " + hex_line(triangles[i]);
    verified.worst = {checks[i],  scene,
                      view.label, (first + i) * stride,
                      input,      hex_polygon(answers[i], answers.stride())};
  }
}

void verify_scene(const Contestant& contestant, const Scene& scene, std::size_t limit,
                  Verified& verified) {
  const Spacing spacing = spacing_of(scene, limit);
  Progress progress(fmt::format("verify {}", scene.name), spacing.count * scene.views.size());
  for (const View& view : scene.views) {
    const auto verify_chunk = [&](const auto& triangles, std::size_t first) {
      verify_triangles(contestant, scene.name, view, triangles, first, spacing.stride, verified);
      progress.advance(triangles.size());
    };
    if (takes_doubles(*contestant.format, scene)) {
      for_each_chunk<DoubleSceneTriangle>(scene, view, spacing, verify_chunk);
    } else {
      for_each_chunk(scene, view, spacing, verify_chunk);
    }
  }
}

std::string hex_case(const HardCase& c) {
  const bool is_view = c.space == Space::view;
  return (is_view ? frustum_options(frustum_cast<float>(c.frustum)) : "--space clip") + " " +
         volume_options(c.volume) + "\n    " +
         hex_line(c.vertices, is_view ? 3 : 4, c.attribute_count);
}

void verify_case(const Contestant& contestant, const HardCase& hard_case, Verified& verified) {
  if (!takes(contestant, hard_case)) {
    ++verified.triangles;
    ++verified.not_applicable;
    return;
  }
  const PromiseCheck check = check_case(contestant, hard_case);
  const auto comparison = [&] {
    return judge_case(contestant, hard_case, truth_polygon(hard_case));
  };
  if (!verified.add(check, comparison)) return;
  verified.worst = {
      check, "catalogue",         hard_case.name,
      0,     hex_case(hard_case), hex_polygon(clip_case(contestant, hard_case)[0], 4)};
}

// Judges all triangles of the catalogue and of the families around them, in both spaces.
void verify_catalogue(const Contestant& contestant, const std::vector<HardCase>& catalogue,
                      Verified& verified) {
  Progress progress("verify the catalogue", catalogue.size());
  for (const HardCase& original : catalogue) {
    progress.advance();
    if (original.primitive != Primitive::triangle) continue;
    verify_case(contestant, original, verified);
    for (auto&& variants : {family(original), special_values(original)}) {
      for (const HardCase& variant : variants) {
        if (is_finite(variant)) verify_case(contestant, variant, verified);
      }
    }
  }
}

nlohmann::json to_json(const Contestant& contestant, const Verified& verified) {
  nlohmann::json json = {{"clipper", contestant.clipper},
                         {"scalar", contestant.scalar()},
                         {"triangles", verified.triangles},
                         {"judged", verified.judged()},
                         {"not_applicable", verified.not_applicable},
                         {"outside_domain", verified.outside_domain},
                         {"outside_domain_wrong", sum_of(verified.wrong_outside)},
                         {"broken", verified.broken},
                         {"kept", verified.is_kept()}};
  json["largest_backward_error_ulp"] = std::isfinite(verified.largest_ulps)
                                           ? nlohmann::json(verified.largest_ulps)
                                           : nlohmann::json("inf");
  json["promised_backward_error_ulp"] = contestant.promise.ulps;
  if (verified.worst) {
    const Offender& worst = *verified.worst;
    json["worst"] = {{"scene", worst.scene},       {"view", worst.view},
                     {"triangle", worst.triangle}, {"reason", worst.check.reason},
                     {"input", worst.input},       {"output", worst.output}};
  }
  return json;
}

// "wrong answers among these: 80 (60 missing, 20 visible)".
std::string wrong_text(const OutcomeCounts& wrong) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    if (wrong[i] > 0) parts.push_back(fmt::format("{} {}", wrong[i], kOutcomeNames[i]));
  }
  if (parts.empty()) return "no answer among these is wrong";
  return fmt::format("wrong answers among these: {} ({})", sum_of(wrong), fmt::join(parts, ", "));
}

// What the promise was not judged on.
void print_unjudged(const Verified& verified) {
  if (verified.outside_domain > 0) {
    fmt::print("outside the promise's domain: {}; {}\n",
               counted(verified.outside_domain, "triangle", "triangles"),
               wrong_text(verified.wrong_outside));
  }
  if (verified.not_applicable > 0) {
    fmt::print("not taken by the clipper: {}\n",
               counted(verified.not_applicable, "triangle", "triangles"));
  }
}

void print_worst(const Verified& verified) {
  const Offender& worst = *verified.worst;
  fmt::print("broken on {} triangles; the worst: scene {}, view {}, triangle {}\n  {}\n",
             verified.broken, worst.scene, worst.view, worst.triangle, worst.check.reason);
  fmt::print(
      "  input (three vertices: coordinates, then attributes):\n    {}\n  output (x y z 1/w, attributes):\n{}",
      worst.input, worst.output);
}

// The backward error in units of the promise (spaces/clipper.hpp).
void print_error(const Promise& promise, const Format& format, double ulps) {
  if (format.is_exact()) {
    fmt::print("backward error: {}\n", ulps == 0 ? "none, as promised" : "some; none is promised");
    return;
  }
  fmt::print("largest backward error: {:.3g} u M; at most {:.3g} u M is promised\n", ulps,
             promise.ulps);
  fmt::print(
      "  u: unit roundoff of {}; M: size of the triangle's clip coordinates{}\n", format.name,
      promise.amplification == Promise::Amplification::w_ratio ? ", times w_max / w_min" : "");
}

void print(const Contestant& contestant, const Verified& verified) {
  fmt::print("{} {}: ", contestant.clipper, contestant.scalar());
  if (verified.judged() == 0) {
    fmt::print("NOTHING JUDGED: no triangle was found that the promise speaks of\n");
  } else {
    fmt::print("promise {} on {} triangles\n", verified.broken == 0 ? "kept" : "BROKEN",
               verified.judged());
    print_error(contestant.promise, *contestant.format, verified.largest_ulps);
  }
  print_unjudged(verified);
  if (verified.worst) print_worst(verified);
}

int verify(const VerifyOptions& options) {
  const Selection& selection = options.selection;
  const std::vector<std::string_view> guests = load_guests(options.guests);
  const Contestant& contestant =
      find_contestant(given_clipper(selection.clipper, guests), options.scalar);
  Verified verified;
  const bool cases = options.catalogue || options.corpus;
  if (cases) {
    verify_catalogue(contestant,
                     options.corpus ? load_catalogue(*options.corpus) : builtin_catalogue(),
                     verified);
  }
  if (!cases || !selection.scenes.empty()) {
    for (const std::string& name : scene_names(selection)) {
      verify_scene(contestant, load_selected_scene(selection, name), selection.sample, verified);
    }
  }
  if (selection.json) {
    fmt::print("{}\n", to_json(contestant, verified).dump(2));
  } else {
    print(contestant, verified);
  }
  if (verified.broken > 0) return kExitPromiseBroken;
  return verified.judged() > 0 ? kExitOk : kExitNothingJudged;
}

}  // namespace

void add_verify_command(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, verify, "verify",
      "Check a clipper's promises on every triangle of scenes or hard cases",
      R"(Exit code 0: the promise holds on every triangle that it speaks of; 1: it is broken, and the
worst offender is printed as hex floats; 5: it speaks of none of the triangles, so nothing was
judged. `clipscope list clippers` shows the promises.)");
  add_contestant_options(command, options.selection.clipper, options.scalar);
  add_guest_options(command, options.guests);
  add_guest_space_option(command, options.guests);
  command.add_flag(
      "--catalogue", options.catalogue,
      "The hard cases and their families, in view space and clip space, instead of scenes (or besides those named)");
  add_option(command, "--corpus", options.corpus, "FILE|DIR",
             "The same with hard cases of your own");
  add_scene_options(command, options.selection);
  add_json_option(command, options.selection);
}

}  // namespace clipscope::experiments::commands
