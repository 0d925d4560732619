// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/commands/verify_sources.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/machine/shell_word.hpp"
#include "experiments/survey/case_batch.hpp"
#include "experiments/survey/lattice_sweep.hpp"

namespace clipscope::experiments::commands {
namespace {

constexpr std::size_t kTogether = 4096;     // triangles in a batch
constexpr std::size_t kGuestSample = 1000;  // per view, unless the user says how many

bool is_wanted(const VerifySources& sources, Space space) {
  return !sources.space || *sources.space == space;
}

// Scenes are in view space. Who is to be asked, or can be asked, about clip space alone gets them
// by the matrix of their projection.
Batch batch_in_space(Batch batch, const VerifySources& sources, const Contestant& contestant) {
  const bool by_matrix = sources.space == Space::clip || !contestant.takes(batch);
  if (by_matrix && !batch.matrix) {
    batch.matrix =
        matrix_cast<double>(rows_of(Projection<float>(frustum_cast<float>(batch.frustum))));
  }
  return batch;
}

void examine_scene(const Scene& scene, const VerifySources& sources, std::size_t sample,
                   Examination& found) {
  const Spacing spacing = spacing_of(scene, sample);
  Progress progress(fmt::format("verify {}", scene.name), spacing.count * scene.views.size());
  for (const View& view : scene.views) {
    // Who needs a frustum would take nothing of it, and the user gave the matrix.
    if (view.matrix) {
      check_takes(found.contestant(), batch_of(view, std::span<const SceneTriangle>()));
    }
    const auto examine_chunk = [&](const auto& triangles, std::size_t first) {
      const auto name_of = [&](std::size_t i) {
        return fmt::format("{}, view {}, triangle {}", scene.name, view.label,
                           (first + i) * spacing.stride);
      };
      found.add(batch_in_space(batch_of(view, triangles), sources, found.contestant()), name_of);
      progress.advance(triangles.size());
    };
    if (takes_doubles(*found.contestant().format, scene)) {
      for_each_chunk<DoubleSceneTriangle>(scene, view, spacing, examine_chunk);
    } else {
      for_each_chunk(scene, view, spacing, examine_chunk);
    }
  }
}

// The triangles of a catalogue and of the families around them, in both spaces.
std::vector<HardCase> with_families(const std::vector<HardCase>& catalogue,
                                    const VerifySources& sources) {
  std::vector<HardCase> cases;
  const auto add = [&](const HardCase& c, const HardCase& original) {
    const std::string& name = sources.hard_case;
    const bool is_named = name.empty() || c.name == name || original.name == name;
    if (is_named && is_finite(c) && is_wanted(sources, c.space)) cases.push_back(c);
  };
  for (const HardCase& original : catalogue) {
    if (original.primitive != Primitive::triangle) continue;
    if (!sources.hard_case.empty() && !sources.hard_case.starts_with(original.name)) continue;
    add(original, original);
    for (auto&& variants : {family(original), special_values(original)}) {
      for (const HardCase& variant : variants) add(variant, original);
    }
  }
  return cases;
}

void examine_cases(const std::vector<HardCase>& catalogue, const VerifySources& sources,
                   Examination& found) {
  const std::vector<HardCase> cases = with_families(catalogue, sources);
  if (cases.empty() && !sources.hard_case.empty()) {
    usage_error("--case: there is no triangle '{}' among the hard cases and their families",
                sources.hard_case);
  }
  std::vector<const HardCase*> all;
  for (const HardCase& c : cases) all.push_back(&c);
  Progress progress("verify the hard cases", all.size());
  for (const auto& group : alike(all, kTogether)) {
    found.add(CaseBatch(group), [&](std::size_t i) { return group[i]->name; });
    progress.advance(group.size());
  }
}

// Chunks of either space and of all depth conventions, until there are so many triangles that the
// contestant takes.
void examine_random(const VerifySources& sources, std::uint64_t seed, Examination& found) {
  constexpr std::size_t kChunks = 8, kMostSkipped = 64;
  const std::size_t together = std::clamp<std::size_t>(sources.random / kChunks, 1, kTogether);
  Progress progress("verify random triangles", sources.random);
  std::size_t first = 0, skipped = 0;
  for (std::size_t chunk = 0; first < sources.random && skipped < kMostSkipped; ++chunk) {
    const std::size_t count = std::min(together, sources.random - first);
    const SweepChunk triangles = random_chunk(seed, chunk, count);
    const Batch batch = triangles.batch();
    if (!is_wanted(sources, batch.space) || !found.contestant().takes(batch)) {
      ++skipped;
      continue;
    }
    skipped = 0;
    found.add(batch, [&](std::size_t i) { return fmt::format("random triangle {}", first + i); });
    first += count;
    progress.advance(count);
  }
  found.add_untaken(sources.random - first);
}

// What --input's triangles are clipped against: what a camera sees, by --frustum, --ortho or
// --matrix.
Batch described_input(const VerifySources& sources, const CameraOptions& camera,
                      const Format& format) {
  Batch batch{.space = sources.space.value_or(Space::view), .attributes = sources.attributes};
  const auto rounded = [&](double x) { return format.is_float() ? static_cast<float>(x) : x; };
  if (batch.space == Space::view && camera.frustum.has_value() == camera.matrix.has_value()) {
    usage_error("--input: triangles in view space take one of --frustum, --ortho and --matrix");
  }
  if (batch.space == Space::view && camera.frustum) {
    batch.frustum = *camera.frustum;
    if (format.is_float()) batch.frustum = frustum_cast<double>(frustum_cast<float>(batch.frustum));
  }
  if (batch.space == Space::view && camera.matrix) {
    batch.matrix = rows_of(*camera.matrix, camera.by_columns);
    for (Vec4<double>& row : *batch.matrix) {
      for (int i = 0; i < 4; ++i) row[i] = rounded(row[i]);
    }
  }
  batch.volume.depth = camera.depth;
  batch.frustum.depth = camera.depth;
  set_volume(sources.volume, format, batch);
  return batch;
}

void examine_input(const VerifySources& sources, const Selection& selection, Examination& found) {
  const Format& format = *found.contestant().format;
  Batch batch = described_input(sources, selection.camera, format);
  PrimitiveTextOptions text;
  text.space = batch.space == Space::view ? "view" : "clip";
  text.scalar = format.name;
  text.attributes = sources.attributes;
  text.file = *sources.input;
  const std::vector<TextPrimitive> all = read_primitives(text, Primitive::triangle);
  for (std::size_t first = 0; first < all.size(); first += kTogether) {
    std::vector<double> numbers;
    for (std::size_t i = first; i < std::min(first + kTogether, all.size()); ++i) {
      numbers.insert(numbers.end(), all[i].values.begin(), all[i].values.end());
    }
    batch.numbers = std::span<const double>(numbers);
    found.add(batch, [&](std::size_t i) { return all[first + i].place; });
  }
}

}  // namespace

std::vector<SourceFindings> examine_sources(const VerifySources& sources, Selection selection,
                                            const Examination& empty) {
  std::vector<SourceFindings> all;
  const auto examine = [&](SourceFindings source, const auto& add) {
    add(source.found);
    all.push_back(std::move(source));
  };
  const bool is_guest = empty.contestant().is_guest;
  const bool has_cases = sources.catalogue || sources.corpus;
  const bool has_other = has_cases || sources.random > 0 || sources.input;
  const bool by_default = !has_other && selection.scenes.empty();
  if (sources.catalogue || (by_default && is_guest)) {
    examine({"the catalogue", "--catalogue", true, empty},
            [&](Examination& found) { examine_cases(builtin_catalogue(), sources, found); });
  }
  if (sources.corpus) {
    examine({*sources.corpus, "--corpus " + shell_word(*sources.corpus), true, empty},
            [&](Examination& f) { examine_cases(load_catalogue(*sources.corpus), sources, f); });
  }
  if (sources.random > 0) {
    examine({"random triangles", "", false, empty},
            [&](Examination& found) { examine_random(sources, selection.seed, found); });
  }
  if (sources.input) {
    examine({*sources.input == "-" ? "standard input" : *sources.input, "", false, empty},
            [&](Examination& found) { examine_input(sources, selection, found); });
  }
  if (has_other && selection.scenes.empty()) return all;
  const std::size_t sample = selection.sample_or(kGuestSample, is_guest ? kGuestSample : 0);
  for (const std::string& name : scene_names(selection)) {
    examine({"scene " + name, "", false, empty}, [&](Examination& found) {
      examine_scene(load_selected_scene(selection, name), sources, sample, found);
    });
  }
  return all;
}

}  // namespace clipscope::experiments::commands
