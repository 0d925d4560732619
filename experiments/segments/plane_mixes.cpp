// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <span>

#include "experiments/machine/errors.hpp"
#include "experiments/scenes/random.hpp"
#include "experiments/segments/clip_segments.hpp"
#include "experiments/segments/mixes.hpp"
#include "reference/truth.hpp"

namespace clipscope::experiments::segments {
namespace {

bool any_segment(const Facts&) { return true; }

// Ends are uniform in a square `box` times as large as the window.
struct BoxRecipe {
  std::string_view name;
  double box = 1;
  bool (*belongs)(const Facts&) = any_segment;
};

constexpr std::array kBoxes = {
    BoxRecipe{"box_1", 1},
    BoxRecipe{"box_2", 2},
    BoxRecipe{"box_4", 4},
    BoxRecipe{"box_10", 10},
    BoxRecipe{"box_50", 50},
    BoxRecipe{"inside", 1, [](const Facts& f) { return f.kind == Facts::accepted; }},
    BoxRecipe{"beside", 4, [](const Facts& f) { return f.share_plane; }},
    BoxRecipe{"past_corner", 3,
              [](const Facts& f) { return f.kind == Facts::rejected && !f.share_plane; }},
    BoxRecipe{"one_end_out", 2,
              [](const Facts& f) { return f.kind == Facts::shortened && f.ends_outside == 1; }},
    BoxRecipe{"both_ends_out", 3,
              [](const Facts& f) { return f.kind == Facts::shortened && f.ends_outside == 2; }}};

}  // namespace

ClipSegments thinned(const ClipSegments& segments, std::size_t limit) {
  if (segments.size() <= limit) return segments;
  ClipSegments some{segments.name, segments.in_plane};
  for (std::size_t i = 0; i < limit; ++i) {
    const auto first =
        segments.numbers.begin() + static_cast<std::ptrdiff_t>(8 * (i * segments.size() / limit));
    some.numbers.insert(some.numbers.end(), first, first + 8);
  }
  return some;
}

std::vector<std::string> plane_mixes() {
  std::vector<std::string> names;
  for (const BoxRecipe& recipe : kBoxes) names.emplace_back(recipe.name);
  return names;
}

ClipSegments make_plane_mix(std::string_view name, std::size_t size, std::uint64_t seed) {
  const auto recipe = std::ranges::find(kBoxes, name, &BoxRecipe::name);
  if (recipe == kBoxes.end()) {
    throw UsageError(fmt::format("no mix of the plane is called '{}'; there are: {}", name,
                                 fmt::join(plane_mixes(), ", ")));
  }
  const auto truth = reference::Truth::of_clip(ClipVolume{});
  Random random(seed);
  ClipSegments made{std::string(name)};
  while (made.size() < size) {
    std::array<reference::InputVertex, 2> ends;
    for (reference::InputVertex& end : ends) {
      const auto x = static_cast<float>(random.uniform(-recipe->box, recipe->box));
      const auto y = static_cast<float>(random.uniform(-recipe->box, recipe->box));
      end.position = {x, y, 0, 1};
    }
    if (recipe->belongs != any_segment && !recipe->belongs(facts_of(truth, ends))) continue;
    for (const reference::InputVertex& end : ends) {
      for (const double x : end.position) made.numbers.push_back(static_cast<float>(x));
    }
  }
  return made;
}

}  // namespace clipscope::experiments::segments
