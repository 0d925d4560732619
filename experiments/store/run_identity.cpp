// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/store/run_identity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <fstream>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "experiments/errors.hpp"
#include "experiments/measure/build_info.hpp"
#include "experiments/measure/machine.hpp"
#include "experiments/store/date.hpp"

namespace clipscope::experiments {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::optional<glm::dvec3>& v) {
  if (!v) return nullptr;
  return Json::array({(*v)[0], (*v)[1], (*v)[2]});
}

Json json_of(const std::optional<double>& value) {
  if (!value) return nullptr;
  return *value;
}

// The options that decide the results, by their names on the command line.
Json options_of(const Selection& s) {
  return {{"scene", s.scenes},
          {"clipper", s.clipper},
          {"scalar", s.scalars},
          {"seed", s.seed},
          {"sample", s.sample},
          {"quick", s.quick},
          {"pictures", s.pictures},
          {"eye", json_of(s.camera.eye)},
          {"target", json_of(s.camera.target)},
          {"up", json_of(s.camera.up)},
          {"fovy", s.camera.fovy_degrees},
          {"aspect", s.camera.aspect},
          {"near", json_of(s.camera.near)},
          {"far", json_of(s.camera.far)},
          {"walk", s.camera.walk}};
}

std::string shell_quoted(const std::string& text) {
  constexpr const char* kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./,:+=@";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string value_text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.is_null() ? "" : value.dump();
  std::vector<std::string> parts;
  for (const Json& part : value) parts.push_back(value_text(part));
  return fmt::format("{}", fmt::join(parts, ","));
}

std::string as_option(const std::string& name, const Json& value) {
  if (value.is_boolean()) return fmt::format(" --{}", name);
  if (name != "scene") return fmt::format(" --{} {}", name, shell_quoted(value_text(value)));
  std::string options;  // may be repeated
  for (const Json& scene : value) options += fmt::format(" --scene {}", shell_quoted(scene));
  return options;
}

// FNV-1a of 64 bits, as hexadecimal digits: tells files apart that were not made alike on purpose.
std::string fingerprint(const std::filesystem::path& path) {
  std::uint64_t hash = 0xcbf29ce484222325;
  std::ifstream file(path, std::ios::binary);
  std::array<char, 1 << 16> block{};
  while (file.read(block.data(), block.size()) || file.gcount() > 0) {
    for (std::streamsize i = 0; i < file.gcount(); ++i) {
      hash =
          (hash ^ static_cast<unsigned char>(block[static_cast<std::size_t>(i)])) * 0x100000001b3;
    }
  }
  return fmt::format("{:016x}", hash);
}

std::string files_read(const Selection& selection) {
  std::vector<std::string> files;
  for (const std::string& scene : selection.scenes) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(scene, ignored)) {
      files.push_back(fmt::format("{} {}", scene, fingerprint(scene)));
    }
  }
  return fmt::format("{}", fmt::join(files, ", "));
}

// Processor and how many there are.
std::string machine_name() {
  const std::string description = machine_description();
  return description.substr(0, description.find(';'));
}

std::string shown(const std::string& text) { return text.empty() ? "none" : text; }

}  // namespace

Selection default_run_selection() {
  Selection selection;
  selection.scalars = {"float", "double", "double_double", "exact"};
  return selection;
}

RunInfo run_info_of(const Selection& selection) {
  return {{"machine", machine_name()},
          {"compiler", fmt::format("{} {}", kCompiler, kCompilerVersion)},
          {"flags", kFlags},
          {"version", kVersion},
          {"commit", kCommit},
          {"program", fingerprint("/proc/self/exe")},
          {"seed", std::to_string(selection.seed)},
          {"started", date_now()},
          {"command", run_command(selection, "")},
          {"options", options_of(selection).dump()},
          {"files", files_read(selection)}};
}

std::string value_of(const RunInfo& info, const std::string& key) {
  for (const auto& [k, value] : info) {
    if (k == key) return value;
  }
  return {};
}

std::string run_command(const Selection& selection, const std::string& experiment) {
  std::string command = "clipscope run";
  if (!experiment.empty()) command += " " + experiment;
  const Json defaults = options_of(default_run_selection());
  const Json options = options_of(selection);
  for (const auto& [name, value] : options.items()) {
    if (value != defaults.at(name)) command += as_option(name, value);
  }
  return command;
}

void check_resumable(const RunInfo& stored, const RunInfo& now, const std::filesystem::path& file) {
  std::vector<std::string> differences;
  const Json now_options = Json::parse(value_of(now, "options"));
  const Json stored_options = Json::parse(value_of(stored, "options"), nullptr, false);
  for (const auto& [name, value] : now_options.items()) {
    const Json before = stored_options.is_object() ? stored_options.value(name, Json()) : Json();
    if (before == value) continue;
    differences.push_back(fmt::format("--{}: {} then, {} now", name, shown(value_text(before)),
                                      shown(value_text(value))));
  }
  for (const char* key : {"version", "commit", "compiler", "flags", "machine", "files"}) {
    const std::string before = value_of(stored, key), value = value_of(now, key);
    if (before == value) continue;
    differences.push_back(fmt::format("{}: {} then, {} now", key, shown(before), shown(value)));
  }
  if (value_of(stored, "program") != value_of(now, "program") &&
      value_of(stored, "commit") == value_of(now, "commit")) {
    differences.push_back("program: built anew since");
  }
  if (differences.empty()) return;
  throw UsageError(
      fmt::format("--resume: the results in {} are of another run ({}); resume with "
                  "what it was run with, or run anew without --resume",
                  file.string(), fmt::join(differences, "; ")));
}

}  // namespace clipscope::experiments
