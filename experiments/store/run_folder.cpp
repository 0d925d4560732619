// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/store/run_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>

#include "experiments/machine/build_info.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/machine/shell_word.hpp"
#include "experiments/selection/replay_text.hpp"
#include "experiments/store/database.hpp"
#include "experiments/table/json_text.hpp"

namespace clipscope::experiments {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

// JSON knows no infinity.
Json json_of(double value) { return std::isinf(value) ? Json("inf") : Json(value); }
Json json_of(const std::optional<double>& value) { return value ? json_of(*value) : Json(); }
template <std::size_t N>
Json json_of(const std::optional<std::array<double, N>>& values) {
  return values ? Json(*values) : Json();
}
Json json_of(const std::optional<glm::dvec3>& v) {
  return v ? Json::array({(*v)[0], (*v)[1], (*v)[2]}) : Json();
}

Json json_of(const std::optional<Intrinsics>& i) {
  return i ? Json::array({i->fx, i->fy, i->cx, i->cy, i->width, i->height}) : Json();
}
// Of a frustum of that kind; nothing of the other.
Json json_of(const std::optional<Frustum<double>>& f, ProjectionKind kind) {
  if (!f || f->kind != kind) return {};
  return Json::array({f->left, f->right, f->bottom, f->top, f->near,
                      f->infinite_far ? Json("inf") : Json(f->far)});
}

// The options that brought the guests: "--plugin ./libmine.so".
std::vector<std::string> guest_options(const Selection& selection) {
  std::vector<std::string> options;
  for (const std::string_view guest : selection.guests) {
    const auto found = std::ranges::find(all_contestants(), guest, &Contestant::clipper);
    options.emplace_back(found->brought_by);
  }
  return options;
}

// The options that decide the results, by their names on the command line.
Json options_of(const Selection& s) {
  return {{"scene", s.scenes},
          {"guests", guest_options(s)},
          {"clipper", s.clipper},
          {"scalar", s.scalars},
          {"seed", s.seed},
          {"sample", s.sample},
          {"quick", s.quick},
          {"pictures", s.pictures},
          {"realtime", s.realtime},
          {"eye", json_of(s.camera.eye)},
          {"target", json_of(s.camera.target)},
          {"up", json_of(s.camera.up)},
          {"orientation", json_of(s.camera.orientation)},
          {"pose", json_of(s.camera.pose)},
          {"matrix-order", s.camera.by_columns ? "column" : "row"},
          {"axes", s.camera.axes == CameraAxes::cv ? "cv" : "gl"},
          {"camera", s.camera.gltf_camera ? Json(*s.camera.gltf_camera) : Json()},
          {"intrinsics", json_of(s.camera.intrinsics)},
          {"frustum", json_of(s.camera.frustum, ProjectionKind::perspective)},
          {"ortho", json_of(s.camera.frustum, ProjectionKind::parallel)},
          {"depth", depth_option(s.camera.depth)},
          {"fovy", s.camera.fovy_degrees},
          {"aspect", s.camera.aspect},
          {"near", json_of(s.camera.near)},
          {"far", json_of(s.camera.far)},
          {"walk", s.camera.walk}};
}

std::string value_text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.is_null() ? "" : json_text(value);
  std::vector<std::string> parts;
  std::ranges::transform(value, std::back_inserter(parts), value_text);
  return fmt::format("{}", fmt::join(parts, ","));
}

std::string as_option(const std::string& name, const Json& value) {
  if (value.is_boolean()) return fmt::format(" --{}", name);
  if (name == "guests") {
    return fmt::format(" {}", fmt::join(value.get<std::vector<std::string>>(), " "));
  }
  if (name != "scene") return fmt::format(" --{} {}", name, shell_word(value_text(value)));
  std::string options;  // may be repeated
  for (const Json& scene : value) options += fmt::format(" --scene {}", shell_word(scene));
  return options;
}

// FNV-1a of 64 bits, as hexadecimal digits: tells files apart that were not made alike on purpose.
std::string fingerprint(const fs::path& path) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : read_if_there(path)) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  }
  return fmt::format("{:016x}", hash);
}

std::string files_read(const Selection& selection) {
  std::vector<std::string> files;
  for (const std::vector<std::string>& given : {selection.scenes, selection.guest_files}) {
    for (const std::string& file : given) {
      std::error_code ignored;
      if (!fs::is_regular_file(file, ignored)) continue;
      files.push_back(fmt::format("{} {}", file, fingerprint(file)));
    }
  }
  return fmt::format("{}", fmt::join(files, ", "));
}

void check_resumable(const RunInfo& stored, const RunInfo& now, const fs::path& file) {
  const std::vector<std::string> differences = differences_of(stored, now, "then", "now");
  if (differences.empty()) return;
  throw UsageError(fmt::format(
      "--resume: the results in {} are of another run ({}); resume with what it was run with, or run anew without --resume",
      file.string(), fmt::join(differences, "; ")));
}

// A run that was killed before the end of its first transaction leaves an empty file, or one that
// is empty again when that is undone.
bool is_there(const fs::path& file) {
  std::error_code error;
  const auto size = fs::file_size(file, error);
  return !error && size > 0 && !is_blank_database(file);
}

// When the store was started; if it can't be read, when the file was last written.
std::string date_of_store(const fs::path& file) {
  try {
    const std::string started = value_of(ResultsStore(file).run_info(), "started");
    if (!started.empty()) return started;
  } catch (const InputError&) {
  }
  struct stat status {};
  return date_of(::stat(file.c_str(), &status) == 0 ? status.st_mtime : std::time(nullptr));
}

// "2026-03-01T12:34:56Z" -> "20260301-123456"
std::string as_stem(std::string date) {
  std::erase_if(date, [](char c) { return c == '-' || c == ':' || c == 'Z'; });
  std::ranges::replace(date, 'T', '-');
  return date;
}

void move_file(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (!error) return;
  throw OutputError(
      fmt::format("{}: can't be renamed to {}: {}", from.string(), to.string(), error.message()));
}

fs::path keep_under_its_date(const fs::path& file) {
  const std::string stem = "results-" + as_stem(date_of_store(file));
  fs::path kept = file.parent_path() / (stem + ".sqlite");
  for (int i = 2; fs::exists(kept); ++i) {
    kept.replace_filename(fmt::format("{}-{}.sqlite", stem, i));
  }
  // What SQLite needs to undo an interrupted transaction goes with its file.
  const fs::path journal = file.string() + "-journal";
  if (fs::exists(journal)) move_file(journal, kept.string() + "-journal");
  move_file(file, kept);
  return kept;
}

}  // namespace

std::vector<std::string> differences_of(const RunInfo& a, const RunInfo& b, std::string_view of_a,
                                        std::string_view of_b) {
  std::vector<std::string> differences;
  const auto compare = [&](const std::string& what, const std::string& x, const std::string& y) {
    const auto shown = [](const std::string& text) { return text.empty() ? "none" : text; };
    if (x == y) return;
    differences.push_back(fmt::format("{}: {} {}, {} {}", what, shown(x), of_a, shown(y), of_b));
  };
  const auto options_in = [](const RunInfo& info) {
    const Json options = Json::parse(value_of(info, "options"), nullptr, false);
    return options.is_object() ? options : Json::object();
  };
  const Json a_options = options_in(a), b_options = options_in(b);
  for (const auto& [name, value] : b_options.items()) {
    compare("--" + name, value_text(a_options.value(name, Json())), value_text(value));
  }
  for (const auto& [name, value] : a_options.items()) {
    if (!b_options.contains(name)) compare("--" + name, value_text(value), "");
  }
  for (const char* key : {"version", "commit", "compiler", "flags", "files"}) {
    compare(key, value_of(a, key), value_of(b, key));
  }
  const std::string a_machine = value_of(a, "machine"), b_machine = value_of(b, "machine");
  if (!a_machine.empty() && !b_machine.empty()) compare("machine", a_machine, b_machine);
  if (value_of(a, "program") != value_of(b, "program") &&
      value_of(a, "commit") == value_of(b, "commit")) {
    differences.push_back(fmt::format("program: another build {}", of_b));
  }
  return differences;
}

Selection default_run_selection() {
  Selection selection;
  selection.scalars = {"float", "double", "double_double", "exact"};
  return selection;
}

RunInfo run_info_of(const Selection& selection) {
  return {{"machine", machine_name()},
          {"measuring", measuring_conditions()},
          {"compiler", fmt::format("{} {}", kCompiler, kCompilerVersion)},
          {"flags", kFlags},
          {"version", kVersion},
          {"commit", kCommit},
          {"program", fingerprint("/proc/self/exe")},
          {"seed", std::to_string(selection.seed)},
          {"started", date_now()},
          {"command", run_command(selection, "")},
          {"options", json_text(options_of(selection))},
          {"files", files_read(selection)}};
}

void set_option(RunInfo& info, const std::string& name, const std::optional<std::string>& value) {
  const auto held = std::ranges::find(info, "options", &RunInfo::value_type::first);
  Json options = Json::parse(held->second);
  if (value) {
    options[name] = *value;
  } else {
    options.erase(name);
  }
  held->second = json_text(options);
}

std::string run_command(const Selection& selection, const std::string& experiment) {
  std::string command = "clipscope run";
  if (!experiment.empty()) command += " " + experiment;
  const Json defaults = options_of(default_run_selection()), options = options_of(selection);
  for (const auto& [name, value] : options.items()) {
    if (value != defaults.at(name)) command += as_option(name, value);
  }
  return command;
}

FolderLock::FolderLock(const fs::path& folder)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0 || ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) {
    return;
  }
  ::close(descriptor_);
  throw OutputError(fmt::format(
      "{}: another clipscope is writing its results into this folder; wait for it, or name another folder with --out",
      folder.string()));
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void tell_kept(const OpenedStore& opened) {
  if (opened.kept.empty()) return;
  fmt::print(stderr, "results of an older run are kept as {}\n", opened.kept.string());
}

OpenedStore start_store(const fs::path& folder, const RunInfo& info) {
  OpenedStore opened{nullptr, folder / kStoreFile};
  if (is_there(opened.file)) opened.kept = keep_under_its_date(opened.file);
  opened.database = create_database(opened.file, info);
  return opened;
}

OpenedStore resume_store(const fs::path& folder, const RunInfo& info) {
  OpenedStore opened{nullptr, folder / kStoreFile};
  if (!is_there(opened.file)) return start_store(folder, info);
  opened.database = open_database(opened.file);
  check_resumable(ResultsStore(opened.database, opened.file).run_info(), info, opened.file);
  opened.resumed = true;
  return opened;
}

}  // namespace clipscope::experiments
