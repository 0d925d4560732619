// SPDX-License-Identifier: GPL-3.0-or-later
//
// The header of a PLY file: its encoding, and the elements that follow with their properties.
//
// Source: Turk, "The PLY Polygon File Format", 1994.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

constexpr bool is_integer(PlyType type) {
  return type != PlyType::float32 && type != PlyType::float64;
}

struct PlyProperty {
  std::string name;
  std::optional<PlyType> count;  // of a list
  PlyType value;

  bool is_vertex_index_list() const {
    return count && (name == "vertex_indices" || name == "vertex_index");
  }
};

struct PlyElement {
  std::string name;
  long long count;  // 0 to 2^32 - 1
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { text, little_endian, big_endian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::text;
  std::vector<PlyElement> elements;
};

// Reads the header, up to and with its line 'end_header'.
// Guarantee: there is one element 'vertex' with numbers x, y and z, and after it one element 'face' with
// a list of whole numbers vertex_indices or vertex_index; both counts are positive.
// Errors: InputError naming the line.
PlyHeader read_ply_header(TextFile& file);

}  // namespace clipscope::experiments
