// SPDX-License-Identifier: GPL-3.0-or-later
//
// Asks a glTF document for its parts, and complains about those that are missing or wrong.
#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "experiments/errors.hpp"
#include "experiments/scenes/gltf.hpp"
#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {

GltfDocument::GltfDocument(std::string name, std::string_view text) : name_(std::move(name)) {
  try {
    root_ = Json::parse(text);
  } catch (const Json::parse_error& error) {
    fail(fmt::format(
        "the JSON is broken at its byte {}: a value, name or bracket is wrong or missing",
        error.byte));
  } catch (const Json::exception&) {
    fail("the JSON holds a number that no double can hold");
  }
  if (!root_.is_object()) {
    fail("the JSON is no object");
  }
}

void GltfDocument::fail(const std::string& message) const {
  throw InputError(fmt::format("{}: {}", name_, message));
}

std::size_t GltfDocument::count_of(const char* list) const {
  const auto found = root_.find(list);
  if (found != root_.end() && !found->is_array()) {
    fail(fmt::format("{} is no list", list));
  }
  return found == root_.end() ? 0 : found->size();
}

const GltfDocument::Json& GltfDocument::object_of(const char* list, std::size_t i) const {
  const Json& object = root_.at(list).at(i);
  if (!object.is_object()) {
    fail(fmt::format("{} is no object", place(list, i)));
  }
  return object;
}

std::string GltfDocument::place(const char* list, std::size_t i) {
  return fmt::format("{}[{}]", list, i);
}

std::size_t GltfDocument::size_in(const Json& object, const char* name, const std::string& at,
                                  std::optional<std::size_t> otherwise) const {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 40;  // so that products of two fit
  const auto found = object.find(name);
  if (found == object.end() && otherwise) {
    return *otherwise;
  }
  if (found == object.end() || !found->is_number_unsigned() ||
      found->get<std::uint64_t>() > kMost) {
    fail(fmt::format("{}.{} is {}; a whole number >= 0 expected", at, name,
                     found == object.end() ? "missing" : found->dump()));
  }
  return found->get<std::size_t>();
}

std::optional<std::size_t> GltfDocument::index_in(const Json& object, const char* name,
                                                  const char* list, const std::string& at) const {
  if (!object.contains(name)) {
    return std::nullopt;
  }
  const std::size_t index = size_in(object, name, at);
  require_index(index, list, fmt::format("{}.{}", at, name));
  return index;
}

std::size_t GltfDocument::required_index_in(const Json& object, const char* name, const char* list,
                                            const std::string& at) const {
  const auto index = index_in(object, name, list, at);
  if (!index) {
    fail(fmt::format("{}.{} is missing", at, name));
  }
  return *index;
}

std::vector<std::size_t> GltfDocument::indices_in(const Json& object, const char* name,
                                                  const char* list, const std::string& at) const {
  std::vector<std::size_t> indices;
  const auto found = object.find(name);
  if (found == object.end()) {
    return indices;
  }
  const std::string inner = fmt::format("{}.{}", at, name);
  if (!found->is_array()) {
    fail(fmt::format("{} is no list", inner));
  }
  for (const Json& index : *found) {
    if (!index.is_number_unsigned()) {
      fail(fmt::format("{} holds {}; whole numbers expected", inner, index.dump()));
    }
    require_index(index.get<std::size_t>(), list, inner);
    indices.push_back(index.get<std::size_t>());
  }
  return indices;
}

void GltfDocument::require_numbers(const Json& object, const char* name, std::size_t count,
                                   const std::string& at) const {
  const auto found = object.find(name);
  if (found == object.end()) {
    return;
  }
  const auto is_sound = [](const Json& j) {
    return j.is_number() && defect_of(j.get<double>()).empty();
  };
  if (!found->is_array() || found->size() != count || !std::ranges::all_of(*found, is_sound)) {
    fail(fmt::format("{}.{} is not a list of {} numbers that a float can hold", at, name, count));
  }
}

void GltfDocument::require_index(std::size_t index, const char* list, const std::string& at) const {
  const std::size_t count = count_of(list);
  if (index >= count) {
    fail(fmt::format("{} refers to {}, but the file has {} {}", at, place(list, index), count,
                     list));
  }
}

}  // namespace clipscope::experiments
