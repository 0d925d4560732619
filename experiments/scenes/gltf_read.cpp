// SPDX-License-Identifier: GPL-3.0-or-later
//
// Takes glTF files apart: chunks, JSON and buffers.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "experiments/machine/base64.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/scenes/gltf.hpp"
#include "experiments/table/json_text.hpp"

namespace clipscope::experiments {

GltfValue Gltf::operator[](const char* member) const { return GltfValue(*this, &root, "")[member]; }

GltfValue GltfValue::operator[](const char* name) const {
  const Json* member = nullptr;
  if (json_ != nullptr && json_->is_object() && json_->contains(name)) member = &json_->at(name);
  return {file_, member, place_.empty() ? name : fmt::format("{}.{}", place_, name)};
}

std::size_t GltfValue::size() const {
  if (json_ == nullptr) return 0;
  if (!json_->is_array()) fail("is no list");
  return json_->size();
}

GltfValue GltfValue::object_at(std::size_t i) const {
  const GltfValue object(file_, &json_->at(i), fmt::format("{}[{}]", place_, i));
  if (!object->is_object()) object.fail("is no object");
  return object;
}

std::size_t GltfValue::number(std::optional<std::size_t> otherwise) const {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 40;  // so that products of two fit
  if (json_ == nullptr && otherwise) return *otherwise;
  if (json_ == nullptr || !json_->is_number_unsigned() || json_->get<std::uint64_t>() > kMost) {
    fail("is {}; a whole number >= 0 expected", json_ == nullptr ? "missing" : json_->dump());
  }
  return json_->get<std::size_t>();
}

std::size_t GltfValue::index_into(const char* list) const {
  if (json_ == nullptr) fail("is missing");
  require_index(number(), list);
  return number();
}

std::vector<std::size_t> GltfValue::indices_into(const char* list) const {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < size(); ++i) {
    const Json& index = (*json_)[i];
    if (!index.is_number_unsigned()) fail("holds {}; whole numbers expected", json_text(index));
    require_index(indices.emplace_back(index.get<std::size_t>()), list);
  }
  return indices;
}

double GltfValue::real() const {
  if (json_ == nullptr || !json_->is_number() || !std::isfinite(json_->get<double>())) {
    fail("is {}; a finite number expected", json_ == nullptr ? "missing" : json_->dump());
  }
  return json_->get<double>();
}

std::vector<double> GltfValue::numbers(std::size_t count) const {
  const auto is_sound = [](const Json& j) {
    return j.is_number() && std::isfinite(j.get<double>());
  };
  if (json_ == nullptr || !json_->is_array() || json_->size() != count ||
      !std::ranges::all_of(*json_, is_sound)) {
    fail("is not a list of {} numbers, all finite", count);
  }
  return json_->get<std::vector<double>>();
}

void GltfValue::require_index(std::size_t index, const char* list) const {
  const std::size_t count = file_[list].size();
  if (index >= count) fail("refers to {}[{}], but the file has {} {}", list, index, count, list);
}

namespace {

constexpr std::size_t kGlbHeaderBytes = 12, kChunkHeaderBytes = 8;

std::size_t word_at(std::string_view bytes, std::size_t offset) {
  return value_at<std::uint32_t>(bytes, offset);
}

// The parts of a binary file; a text file is all JSON.
struct Chunks {
  std::string_view json;
  std::optional<std::string_view> binary;
};

Chunks chunks_of(const std::string& name, std::string_view content) {
  if (!content.starts_with("glTF")) return {content, std::nullopt};
  if (content.size() < kGlbHeaderBytes) {
    refuse(name, "{} bytes are too few for a binary glTF file: it is truncated", content.size());
  }
  if (word_at(content, 4) != 2) {
    refuse(name, "the binary glTF version is {}; 2 expected", word_at(content, 4));
  }
  if (word_at(content, 8) != content.size()) {
    refuse(name, "the header announces {} bytes, but the file has {}", word_at(content, 8),
           content.size());
  }
  std::size_t offset = kGlbHeaderBytes;
  const auto next_chunk = [&](std::string_view type) {
    const std::size_t start = offset + kChunkHeaderBytes;
    if (start > content.size() || word_at(content, offset) > content.size() - start) {
      refuse(name, "the chunk at byte {} reaches past the end of the file", offset);
    }
    if (content.substr(offset + 4, 4) != type) {
      refuse(name, "the chunk at byte {} is not of type {}", offset,
             type.substr(0, type.find('\0')));
    }
    const std::size_t length = word_at(content, offset);
    offset = start + length;
    return content.substr(start, length);
  };
  Chunks chunks{next_chunk("JSON"), std::nullopt};
  if (offset < content.size()) chunks.binary = next_chunk({"BIN\0", 4});
  return chunks;
}

nlohmann::json parse_json(const std::string& name, std::string_view text) {
  nlohmann::json root;
  try {
    root = nlohmann::json::parse(without_mark(name, text));
  } catch (const nlohmann::json::parse_error& error) {
    refuse(name, "the JSON is broken at its byte {}: a value, name or bracket is wrong or missing",
           error.byte);
  } catch (const nlohmann::json::exception&) {
    refuse(name, "the JSON holds a number that no double can hold");
  }
  if (!root.is_object()) refuse(name, "the JSON is no object");
  return root;
}

// RFC 3986, section 2.1.
std::string decode_percent(std::string_view uri) {
  std::string text;
  for (const char* c = uri.data(); c != uri.data() + uri.size(); ++c) {
    std::uint8_t byte = 0;
    const bool is_escape = *c == '%' && uri.data() + uri.size() - c > 2 &&
                           std::from_chars(c + 1, c + 3, byte, 16).ptr == c + 3;
    text += is_escape ? static_cast<char>(byte) : *c;
    if (is_escape) c += 2;
  }
  return text;
}

// The bytes that a buffer is taken from, and what to call them in messages.
struct BufferSource {
  std::string_view bytes;
  std::string name;
};

BufferSource data_uri(Gltf& gltf, const GltfValue& uri, std::string_view text) {
  constexpr std::string_view kMark = ";base64,";
  const std::size_t mark = text.find(kMark);
  auto bytes = mark == std::string_view::npos ? std::nullopt
                                              : decode_base64(text.substr(mark + kMark.size()));
  if (!bytes) uri.fail("is no base64 data URI");
  return {gltf.loaded.emplace_back(*std::move(bytes)), "the data URI"};
}

BufferSource source_of(Gltf& gltf, const GltfValue& uri, bool is_first,
                       const std::optional<std::string_view>& binary) {
  if (!uri) {
    if (!is_first || !binary) uri.fail("is missing, and there is no binary chunk for it");
    return {*binary, "the binary chunk"};
  }
  if (!uri->is_string()) uri.fail("is no text");
  const std::string& text = uri->get_ref<const std::string&>();
  if (text.starts_with("data:")) return data_uri(gltf, uri, text);
  const std::filesystem::path folder = std::filesystem::path(gltf.name).parent_path();
  const std::filesystem::path file = folder / decode_percent(text);
  return {gltf.loaded.emplace_back(read_bytes(file)), fmt::format("'{}'", file.string())};
}

}  // namespace

Gltf read_gltf(const std::string& name, std::string_view content) {
  const auto [json, binary] = chunks_of(name, content);
  Gltf gltf{name, parse_json(name, json)};
  const GltfValue buffers = gltf["buffers"];
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    const GltfValue buffer = buffers.object_at(i), byte_length = buffer["byteLength"];
    const std::size_t length = byte_length.number();
    const auto [bytes, source] = source_of(gltf, buffer["uri"], i == 0, binary);
    if (bytes.size() < length) {
      byte_length.fail("is {}, but {} has only {} bytes", length, source, bytes.size());
    }
    gltf.buffers.push_back(bytes.substr(0, length));
  }
  return gltf;
}

}  // namespace clipscope::experiments
