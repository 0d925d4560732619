// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes hard cases in the text format of tests/corpus/README.md.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/table/hex_float.hpp"

namespace clipscope::experiments {
namespace {

// A decimal where it is short, else a hex float; both are the number itself.
std::string number_text(double x) {
  constexpr std::size_t kShort = 8;
  const std::string decimal = fmt::format("{}", x);
  return decimal.size() <= kShort ? decimal : hex_float(x);
}

std::string space_text(const HardCase& c) {
  const std::string_view depth = kDepthNames[static_cast<std::size_t>(c.volume.depth)];
  if (c.space == Space::clip) return fmt::format("space clip {}", depth);
  const Frustum<double>& f = c.frustum;
  const bool parallel = f.kind == ProjectionKind::parallel;
  std::string text = parallel ? "space view parallel" : "space view perspective";
  for (const double bound : {f.left, f.right, f.bottom, f.top, f.near}) {
    text += " " + number_text(bound);
  }
  text += f.infinite_far ? " inf" : " " + number_text(f.far);
  if (parallel) text += " " + number_text(f.shear_x) + " " + number_text(f.shear_y);
  return fmt::format("{} {}", text, depth);
}

std::string volume_lines(const ClipVolume& volume) {
  std::string text;
  const DepthClamp& clamp = volume.depth_clamp;
  if (clamp) {
    text += fmt::format("depth_clamp{}\n", clamp.near && clamp.far ? ""
                                           : clamp.near            ? " near"
                                                                   : " far");
  }
  if (volume.clip_distances > 0) text += fmt::format("clip_distances {}\n", volume.clip_distances);
  if (!volume.open_sides) return text;
  text += "half_open";
  OpenSides open = volume.open_sides;
  for (const std::string_view side : {"left", "right", "bottom", "top"}) {
    if (*find_side(open, side)) text += fmt::format(" {}", side);
  }
  return text + "\n";
}

// How many of the attributes must be written, since the reader fills in the others.
int attributes_to_write(const HardCase& c) {
  for (int given = c.volume.clip_distances; given < c.attribute_count; ++given) {
    if (c.attribute_count > kSceneAttributes) break;
    HardCase filled = c;
    fill_attributes(filled, given);
    const auto same = [&](const reference::InputVertex& a, const reference::InputVertex& b) {
      return std::equal(a.attributes.begin(), a.attributes.begin() + c.attribute_count,
                        b.attributes.begin());
    };
    if (std::ranges::equal(c.vertices, filled.vertices, same)) return given;
  }
  return c.attribute_count;
}

std::string vertex_line(const HardCase& c, const reference::InputVertex& v, int attributes) {
  std::string text = "vertex";
  const std::size_t dimension = c.space == Space::view ? 3 : 4;
  for (std::size_t i = 0; i < dimension; ++i) text += " " + number_text(v.position[i]);
  if (attributes > 0) text += " |";
  for (int k = 0; k < attributes; ++k) {
    text += " " + number_text(v.attributes[static_cast<std::size_t>(k)]);
  }
  return text + "\n";
}

// Without its theme, as one word.
std::string name_in_file(std::string_view name) {
  std::string word(name.substr(name.find('/') + 1));  // npos + 1 is 0
  std::ranges::replace_if(
      word, [](unsigned char c) { return std::isspace(c) != 0; }, '_');
  return word;
}

// The name, or with the first number from 2 on that no case has.
std::string free_name(const std::vector<HardCase>& cases, const std::string& name) {
  const auto is_taken = [&](const std::string& wanted) {
    return std::ranges::any_of(cases,
                               [&](const HardCase& c) { return name_in_file(c.name) == wanted; });
  };
  std::string free = name;
  for (int i = 2; is_taken(free); ++i) free = fmt::format("{}_{}", name, i);
  return free;
}

}  // namespace

std::string case_text(const HardCase& c) {
  std::string text = fmt::format("case {}\n", name_in_file(c.name));
  if (!c.source.empty()) text += fmt::format("source {}\n", c.source);
  if (!c.why.empty()) text += fmt::format("why {}\n", c.why);
  text += fmt::format("primitive {}\n{}\n{}", to_string(c.primitive), space_text(c),
                      volume_lines(c.volume));
  const int attributes = attributes_to_write(c);
  for (const reference::InputVertex& v : c.vertices) text += vertex_line(c, v, attributes);
  return text + fmt::format("expect {}\n", to_string(exact_outcome(c)));
}

HardCase append_case(const std::filesystem::path& file, HardCase hard_case) {
  const std::string before = std::filesystem::exists(file) ? read_if_there(file) : "";
  hard_case.name = free_name(read_cases(file.string(), before), name_in_file(hard_case.name));
  std::string text = case_text(hard_case);
  if (!before.empty()) text = (before.ends_with('\n') ? "\n" : "\n\n") + text;
  const HardCase written = read_cases(file.string(), text).back();
  if (file.has_parent_path()) make_folder(file.parent_path());
  errno = 0;
  std::ofstream out(file, std::ios::binary | std::ios::app);
  if (!(out << text << std::flush)) {
    throw OutputError(fmt::format("{}: can't be written: {}", file.string(), std::strerror(errno)));
  }
  return written;
}

}  // namespace clipscope::experiments
