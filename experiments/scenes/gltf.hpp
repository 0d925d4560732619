// SPDX-License-Identifier: GPL-3.0-or-later
//
// A glTF 2.0 file in pieces: its JSON, and the bytes of all its buffers.
//
// Source: Khronos Group, "glTF 2.0 Specification", 2021 (ISO/IEC 12113:2022).
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace clipscope::experiments {

// A JSON document whose parts are asked for by name; everything that is missing or of the wrong kind
// throws InputError with the file and the place in the document, such as "accessors[3].count".
class GltfDocument {
 public:
  using Json = nlohmann::json;

  // Errors: InputError where the text is no JSON object.
  GltfDocument(std::string name, std::string_view text);

  [[noreturn]] void fail(const std::string& message) const;

  const Json& root() const { return root_; }
  // How many objects a list at the top of the document has; 0 where it is missing.
  std::size_t count_of(const char* list) const;
  // The i-th object of such a list, and what messages call it. Pre-condition: i < count_of(list).
  const Json& object_of(const char* list, std::size_t i) const;
  static std::string place(const char* list, std::size_t i);

  // A whole number >= 0; `otherwise` where it is missing.
  std::size_t size_in(const Json& object, const char* name, const std::string& at,
                      std::optional<std::size_t> otherwise = std::nullopt) const;
  // An index into a list; none where it is missing.
  std::optional<std::size_t> index_in(const Json& object, const char* name, const char* list,
                                      const std::string& at) const;
  // The same where it must not be missing.
  std::size_t required_index_in(const Json& object, const char* name, const char* list,
                                const std::string& at) const;
  // A list of indices into another list; empty where it is missing.
  std::vector<std::size_t> indices_in(const Json& object, const char* name, const char* list,
                                      const std::string& at) const;
  // `count` finite numbers, or nothing where they are missing.
  void require_numbers(const Json& object, const char* name, std::size_t count,
                       const std::string& at) const;

 private:
  void require_index(std::size_t index, const char* list, const std::string& at) const;

  std::string name_;
  Json root_;
};

struct Gltf {
  GltfDocument document;
  std::vector<std::size_t> buffer_start;  // of each buffer within `bytes`; one more for the end
  std::string bytes;                      // all buffers end to end
};

// Takes a .gltf or .glb file apart and loads its buffers: those of the file itself, those given as
// data URIs, and those in files next to it.
// Errors: InputError where a part is missing, truncated or shorter than announced.
Gltf read_gltf(const std::filesystem::path& path, std::string_view content);

// Checks everything that concerns the geometry of the default scene and yields it as a binary glTF
// file of one buffer. Materials, animations, skins, cameras and extensions are left out.
// Errors: InputError.
std::string geometry_of(const Gltf& gltf);

}  // namespace clipscope::experiments
