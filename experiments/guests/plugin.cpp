// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/plugin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <list>
#include <system_error>

#include "experiments/guests/plugin_runner.hpp"
#include "experiments/guests/plugin_said.hpp"
#include "experiments/guests/plugin_task.hpp"
#include "experiments/guests/texts.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/machine/shell_word.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kMostNameBytes = 60;

// They live as long as contestants do.
std::list<Plugin>& loaded_plugins() {
  static std::list<Plugin> all;
  return all;
}

std::string absolute_path(const std::string& library) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::is_regular_file(library, error)) {
    throw GuestError(fmt::format(
        "--plugin: {}: there is no such file; expected a shared library, such as ./libmine.so",
        library));
  }
  return fs::absolute(library).string();
}

bool is_word(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.' || c == '-';
  });
}

bool is_name(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (text.size() > kMostNameBytes) return false;
  if (slash == std::string_view::npos) return is_word(text);
  return is_word(text.substr(0, slash)) && is_word(text.substr(slash + 1));
}

// What is wrong with what a plug-in says of itself; empty if nothing is.
std::string fault_of(const plugin::Description& d) {
  constexpr std::uint32_t kKnown = 2 * CLIPSCOPE_THREAD_SAFE - 1;
  const auto lacks = [&](std::uint32_t bits) { return (d.capabilities & bits) == 0; };
  if (!is_name(text_of(d.name))) {
    return fmt::format(
        "its name is '{}'; expected {} characters at most of [a-z0-9_.-], a folder and '/' may stand before",
        text_of(d.name), kMostNameBytes);
  }
  if (d.most_attributes > CLIPSCOPE_MOST_ATTRIBUTES) {
    return fmt::format("its most_attributes are {}; expected {} at most", d.most_attributes,
                       CLIPSCOPE_MOST_ATTRIBUTES);
  }
  if ((d.capabilities & ~kKnown) != 0) {
    return fmt::format("its capabilities {:#x} have bits that version {} of the interface lacks",
                       d.capabilities, CLIPSCOPE_PLUGIN_ABI);
  }
  if (lacks(CLIPSCOPE_FLOAT | CLIPSCOPE_DOUBLE)) return "its capabilities name no scalar";
  if (lacks(CLIPSCOPE_VIEW_SPACE | CLIPSCOPE_CLIP_SPACE)) return "its capabilities name no space";
  if (lacks(CLIPSCOPE_POINTS | CLIPSCOPE_SEGMENTS | CLIPSCOPE_TRIANGLES | CLIPSCOPE_POLYGONS)) {
    return "its capabilities name no primitive";
  }
  if (lacks(CLIPSCOPE_DEPTH_MINUS_ONE_TO_ONE | CLIPSCOPE_DEPTH_ZERO_TO_ONE |
            CLIPSCOPE_DEPTH_REVERSED)) {
    return "its capabilities name no depth convention";
  }
  if (!lacks(CLIPSCOPE_ANSWERS_IN_CLIP_SPACE) && !lacks(CLIPSCOPE_VIEW_SPACE)) {
    return "it answers in clip space, but takes view space; expected CLIPSCOPE_CLIP_SPACE alone";
  }
  return "";
}

std::string_view text_or(const plugin::Text& text, const std::string& otherwise) {
  return kept_text(text[0] == '\0' ? otherwise : text_of(text));
}

// What its contestants have in common.
Contestant describe_plugin(Plugin& plugin, const std::string& library) {
  const plugin::Description& d = plugin.description();
  Contestant contestant;
  contestant.clipper = kept_text(text_of(d.name));
  contestant.summary = text_or(d.summary, "a plug-in");
  contestant.source = text_or(d.source, library);
  contestant.promise = no_promise();
  contestant.promise.depth_clamp = plugin.can(CLIPSCOPE_DEPTH_CLAMP);
  contestant.promise.clip_distances = plugin.can(CLIPSCOPE_CLIP_DISTANCES);
  contestant.promise.open_sides = plugin.can(CLIPSCOPE_OPEN_SIDES);
  contestant.takes_clip_space = plugin.can(CLIPSCOPE_CLIP_SPACE);
  contestant.is_guest = true;
  contestant.brought_by = kept_text(fmt::format("--plugin {}", shell_word(library)));
  for (std::size_t i = 0; i < contestant.depths.size(); ++i) {
    contestant.depths[i] = plugin.can(depth_bit(static_cast<DepthRange>(i)));
  }
  contestant.most_attributes = static_cast<int>(d.most_attributes);
  // What it does not take in view space it is asked in clip space.
  if (!contestant.takes_clip_space) {
    contestant.takes_frustum = [&plugin](const Frustum<double>& frustum) {
      return takes_in_view_space(plugin, frustum);
    };
  }
  return contestant;
}

void add_contestants(Plugin& plugin, Contestant contestant) {
  for (const Format* format : {&kFormat<float>, &kFormat<double>}) {
    if (!plugin.can(format->is_float() ? CLIPSCOPE_FLOAT : CLIPSCOPE_DOUBLE)) continue;
    for (const int vertices : {3, 2, 1, 0}) {
      if (!plugin.can(primitive_bit(vertices))) continue;
      contestant.format = format;
      contestant.vertices = vertices;
      contestant.prepare = nullptr;
      contestant.prepare = [&plugin, self = contestant](std::span<const Batch> batches) {
        return make_plugin_runner(plugin, self, batches);
      };
      add_guest(contestant);
    }
  }
}

}  // namespace

std::string_view add_plugin(const std::string& library, double seconds) {
  Plugin& plugin = loaded_plugins().emplace_back(absolute_path(library), seconds);
  const std::string fault = fault_of(plugin.description());
  if (!fault.empty()) throw GuestError(fmt::format("--plugin: {}: {}", library, fault));
  const Contestant contestant = describe_plugin(plugin, library);
  add_contestants(plugin, contestant);
  return contestant.clipper;
}

}  // namespace clipscope::experiments
