// SPDX-License-Identifier: GPL-3.0-or-later
//
// A glTF 2.0 file in pieces: its JSON, whose parts are asked for by name, and the bytes of its
// buffers.
//
// Source: Khronos Group, "glTF 2.0 Specification", 2021 (ISO/IEC 12113:2022).
#pragma once

#include <cstddef>
#include <deque>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {

class GltfValue;

struct Gltf {
  std::string name;  // in messages
  nlohmann::json root;
  // Each as long as it announces: parts of the file itself, or of what was loaded beside it.
  std::vector<std::string_view> buffers = {};
  std::deque<std::string> loaded = {};

  // A member at the top of the document.
  GltfValue operator[](const char* member) const;
};

// A value of the JSON, or that there is none at its place, such as "accessors[3].count". A value
// that is missing or of the wrong kind throws InputError with the file and the place.
class GltfValue {
 public:
  using Json = nlohmann::json;

  // json: null if there is no value. The file must outlive this.
  GltfValue(const Gltf& file, const Json* json, std::string place)
      : file_(file), json_(json), place_(std::move(place)) {}

  // Throws InputError "FILE: PLACE MESSAGE".
  template <class... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> message, Args&&... args) const {
    refuse(file_.name, "{} {}", place_, fmt::format(message, std::forward<Args>(args)...));
  }

  explicit operator bool() const { return json_ != nullptr; }
  const Json& operator*() const { return *json_; }
  const Json* operator->() const { return json_; }
  const Gltf& file() const { return file_; }
  const std::string& place() const { return place_; }

  // A member; none where this is none or no object.
  GltfValue operator[](const char* name) const;
  // The number of elements of a list; 0 where there is none.
  std::size_t size() const;
  // An element of a list, which must be an object. Pre-condition: i < size().
  GltfValue object_at(std::size_t i) const;

  // A whole number >= 0; `otherwise` where there is none.
  std::size_t number(std::optional<std::size_t> otherwise = std::nullopt) const;
  // An index into a list at the top of the document.
  std::size_t index_into(const char* list) const;
  // A list of such indices; empty where there is none.
  std::vector<std::size_t> indices_into(const char* list) const;
  // A finite number, or a list of `count` of them; fails where it is missing or anything else.
  double real() const;
  std::vector<double> numbers(std::size_t count) const;

 private:
  void require_index(std::size_t index, const char* list) const;

  const Gltf& file_;
  const Json* json_;
  std::string place_;
};

// Takes a .gltf or .glb file apart and loads its buffers: those of the file itself, those given as
// data URIs, and those in files next to it. The content must outlive the pieces, and these stay
// where they are.
// Errors: InputError where a part is missing, truncated or shorter than announced.
Gltf read_gltf(const std::string& name, std::string_view content);

}  // namespace clipscope::experiments
