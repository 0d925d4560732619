// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope_explorer_catalogue OUT.json [CASES...]: the hard cases as the page of the explorer
// reads them (src/catalogue.ts), the built-in ones and those of files or folders of the user's. The
// page shows triangles of at most four attributes; others are left out, and how many is said.
#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/explorer/engine/engine.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/table/json_text.hpp"

namespace clipscope::explorer {
namespace {

using experiments::HardCase;
using nlohmann::json;

// As src/engine.ts has them.
json frustum_json(const HardCase& c) {
  const Frustum<double>& f = c.frustum;
  constexpr std::array kDepths = {"minus_one_to_one", "zero_to_one", "reversed"};
  // A case has no far plane beside one at infinity; the page wants one to go back to.
  const double far = f.infinite_far ? 10 * f.near : f.far;
  return {{"parallel", f.kind == ProjectionKind::parallel},
          {"left", f.left},
          {"right", f.right},
          {"bottom", f.bottom},
          {"top", f.top},
          {"near", f.near},
          {"far", far},
          {"infiniteFar", f.infinite_far},
          {"shearX", f.shear_x},
          {"shearY", f.shear_y},
          {"depth", kDepths[static_cast<std::size_t>(c.volume.depth)]}};
}

json volume_json(const ClipVolume& v) {
  const OpenSides& open = v.open_sides;
  return {
      {"clampNear", v.depth_clamp.near},
      {"clampFar", v.depth_clamp.far},
      {"clipDistances", v.clip_distances},
      {"openSides",
       {{"left", open.left}, {"right", open.right}, {"bottom", open.bottom}, {"top", open.top}}}};
}

json triangle_json(const HardCase& c) {
  json vertices = json::array();
  for (const reference::InputVertex& v : c.vertices) {
    json position = v.position;
    if (c.space == Space::view) position[3] = 0;
    vertices.push_back({{"position", std::move(position)},
                        {"attributes", std::span(v.attributes).first(kAttributes)}});
  }
  return vertices;
}

bool is_shown(const HardCase& c) {
  return c.primitive == experiments::Primitive::triangle && c.attribute_count <= kAttributes;
}

json case_json(const HardCase& c) {
  return {{"name", c.name},
          {"source", c.source},
          {"why", c.why},
          {"expected", to_string(experiments::exact_outcome(c))},
          {"question",
           {{"frustum", frustum_json(c)},
            {"volume", volume_json(c.volume)},
            {"space", c.space == Space::view ? "view" : "clip"},
            {"triangle", triangle_json(c)}}}};
}

// Errors: InputError, OutputError.
void write_catalogue(const std::string& out, std::span<char*> paths) {
  std::vector<HardCase> cases = experiments::builtin_catalogue();
  for (const char* path : paths) {
    const std::vector<HardCase> own = experiments::load_catalogue(path);
    cases.insert(cases.end(), own.begin(), own.end());
  }
  json shown = json::array();
  for (const HardCase& c : cases) {
    if (is_shown(c)) shown.push_back(case_json(c));
  }
  std::ofstream file(out, std::ios::binary);
  if (!(file << experiments::json_text(shown) << std::flush)) {
    throw experiments::OutputError(fmt::format("{}: can't be written", out));
  }
  fmt::print("{} hard cases; {} left out, which are no triangles or have more than {} attributes\n",
             shown.size(), cases.size() - shown.size(), kAttributes);
}

}  // namespace
}  // namespace clipscope::explorer

int main(int count, char** arguments) {
  using namespace clipscope::experiments;
  if (count < 2) {
    fmt::print(stderr, "usage: clipscope_explorer_catalogue OUT.json [CASES...]\n");
    return kExitUsage;
  }
  try {
    clipscope::explorer::write_catalogue(arguments[1], std::span(arguments + 2, arguments + count));
    return kExitOk;
  } catch (const InputError& error) {
    fmt::print(stderr, "clipscope_explorer_catalogue: {}\n", error.what());
    return kExitInput;
  } catch (const OutputError& error) {
    fmt::print(stderr, "clipscope_explorer_catalogue: {}\n", error.what());
    return kExitOutput;
  }
}
