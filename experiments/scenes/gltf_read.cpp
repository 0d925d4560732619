// SPDX-License-Identifier: GPL-3.0-or-later
//
// Takes glTF files apart: chunks, JSON and buffers.
#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <optional>
#include <utility>

#include "experiments/errors.hpp"
#include "experiments/scenes/file_bytes.hpp"
#include "experiments/scenes/gltf.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kGlbHeaderBytes = 12, kChunkHeaderBytes = 8;

std::size_t word_at(std::string_view bytes, std::size_t offset) {
  std::size_t value = 0;
  for (std::size_t i = 4; i-- > 0;) {
    value = value << 8 | static_cast<unsigned char>(bytes[offset + i]);
  }
  return value;
}

// The parts of a binary file; a text file is all JSON.
struct Chunks {
  std::string_view json;
  std::optional<std::string_view> binary;
};

class ChunkReader {
 public:
  ChunkReader(const std::string& name, std::string_view content) : name_(name), content_(content) {}

  Chunks read() {
    if (!content_.starts_with("glTF")) {
      return {content_, std::nullopt};
    }
    if (content_.size() < kGlbHeaderBytes) {
      fail(fmt::format("{} bytes are too few for a binary glTF file: it is truncated",
                       content_.size()));
    }
    if (word_at(content_, 4) != 2) {
      fail(fmt::format("the binary glTF version is {}; 2 expected", word_at(content_, 4)));
    }
    if (word_at(content_, 8) != content_.size()) {
      fail(fmt::format("the header announces {} bytes, but the file has {}", word_at(content_, 8),
                       content_.size()));
    }
    Chunks chunks;
    chunks.json = next_chunk("JSON");
    if (offset_ < content_.size()) {
      chunks.binary = next_chunk(std::string_view("BIN\0", 4));
    }
    return chunks;
  }

 private:
  std::string_view next_chunk(std::string_view type) {
    const std::size_t start = offset_ + kChunkHeaderBytes;
    if (start > content_.size() || word_at(content_, offset_) > content_.size() - start) {
      fail(fmt::format("the chunk at byte {} reaches past the end of the file", offset_));
    }
    if (content_.substr(offset_ + 4, 4) != type) {
      fail(fmt::format("the chunk at byte {} is not of type {}", offset_,
                       type.substr(0, type.find('\0'))));
    }
    const std::size_t length = word_at(content_, offset_);
    offset_ = start + length;
    return content_.substr(start, length);
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(fmt::format("{}: {}", name_, message));
  }

  const std::string& name_;
  std::string_view content_;
  std::size_t offset_ = kGlbHeaderBytes;
};

// RFC 4648, section 4; none where a character does not belong.
std::optional<std::string> decode_base64(std::string_view text) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  while (text.ends_with('=')) {
    text.remove_suffix(1);
  }
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) {
      return std::nullopt;
    }
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes.push_back(static_cast<char>(bits >> count & 0xff));
    }
  }
  return bytes;
}

// RFC 3986, section 2.1.
std::string decode_percent(std::string_view uri) {
  const auto digit = [](char c) { return '0' <= c && c <= '9' ? c - '0' : (c | 32) - 'a' + 10; };
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size() &&
        std::isxdigit(static_cast<unsigned char>(uri[i + 1])) &&
        std::isxdigit(static_cast<unsigned char>(uri[i + 2]))) {
      text.push_back(static_cast<char>(digit(uri[i + 1]) * 16 + digit(uri[i + 2])));
      i += 2;
    } else {
      text.push_back(uri[i]);
    }
  }
  return text;
}

// Appends buffer `i` to the bytes, all of what it announces and no more.
void append_buffer(Gltf& gltf, std::size_t i, const std::filesystem::path& folder,
                   const std::optional<std::string_view>& binary) {
  const GltfDocument& document = gltf.document;
  const std::string at = GltfDocument::place("buffers", i);
  const auto& buffer = document.object_of("buffers", i);
  const std::size_t length = document.size_in(buffer, "byteLength", at);
  const auto append = [&](std::string_view bytes, const std::string& source) {
    if (bytes.size() < length) {
      document.fail(fmt::format("{}.byteLength is {}, but {} has only {} bytes", at, length, source,
                                bytes.size()));
    }
    gltf.bytes.append(bytes.substr(0, length));
  };
  const auto uri = buffer.find("uri");
  if (uri == buffer.end()) {
    if (i != 0 || !binary) {
      document.fail(fmt::format("{}.uri is missing, and there is no binary chunk for it", at));
    }
    append(*binary, "the binary chunk");
  } else if (!uri->is_string()) {
    document.fail(fmt::format("{}.uri is no text", at));
  } else if (const std::string& text = uri->get_ref<const std::string&>();
             text.starts_with("data:")) {
    const std::size_t comma = text.find(";base64,");
    const auto bytes = comma == std::string::npos
                           ? std::nullopt
                           : decode_base64(std::string_view(text).substr(comma + 8));
    if (!bytes) {
      document.fail(fmt::format("{}.uri is no base64 data URI", at));
    }
    append(*bytes, "the data URI");
  } else {
    const std::filesystem::path file = folder / decode_percent(text);
    append(read_bytes(file), fmt::format("'{}'", file.string()));
  }
}

}  // namespace

Gltf read_gltf(const std::filesystem::path& path, std::string_view content) {
  const std::string name = path.string();
  const Chunks chunks = ChunkReader(name, content).read();
  Gltf gltf{GltfDocument(name, chunks.json), {}, {}};
  const std::size_t buffers = gltf.document.count_of("buffers");
  for (std::size_t i = 0; i < buffers; ++i) {
    gltf.buffer_start.push_back(gltf.bytes.size());
    append_buffer(gltf, i, path.parent_path(), chunks.binary);
  }
  gltf.buffer_start.push_back(gltf.bytes.size());
  return gltf;
}

}  // namespace clipscope::experiments
