// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files cut off at every byte and with every byte changed: no crash, and no mesh that is not sound.
#include <optional>
#include <string>

#include "experiments/machine/errors.hpp"
#include "experiments/scenes/mesh_file.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/scenes/sample_files.hpp"
#include "tests/experiments/scenes/sound_mesh.hpp"

namespace clipscope::experiments {
namespace {

// The mesh, or nothing if it was refused.
std::optional<Mesh> try_load(const std::filesystem::path& path) {
  try {
    return load_mesh(path);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

TEST_CASE("damaged files: one that is cut off anywhere is refused or sound") {
  const SampleFile file = GENERATE(from_range(sample_files()));
  const FolderOfFiles folder;
  std::size_t accepted = 0;
  for (std::size_t length = 0; length < file.content.size(); ++length) {
    const auto mesh = try_load(folder.write(file.name, file.content.substr(0, length)));
    INFO(file.name << " cut to " << length << " bytes");
    CHECK((!mesh || is_sound(*mesh)));
    accepted += mesh.has_value();
  }
  INFO(file.name);
  // Nothing tells where an OBJ file ends; the others may lose their last line end, or the last
  // letters of a name.
  if (!file.name.ends_with(".obj")) CHECK(accepted <= std::string_view("a pyramid\n").size() + 1);
}

TEST_CASE("damaged files: one with a byte changed is refused or sound") {
  const SampleFile file = GENERATE(from_range(sample_files()));
  const FolderOfFiles folder;
  for (std::size_t i = 0; i < file.content.size(); ++i) {
    for (const int change : {0x01, 0x90}) {
      std::string content = file.content;
      content[i] = static_cast<char>(content[i] ^ change);
      const auto mesh = try_load(folder.write(file.name, content));
      INFO(file.name << ", byte " << i << " changed by " << change);
      CHECK((!mesh || is_sound(*mesh)));
    }
  }
}

}  // namespace
}  // namespace clipscope::experiments
