// SPDX-License-Identifier: GPL-3.0-or-later
//
// The header of a PLY file: which elements follow, and what each is made of.
//
// Source: Turk, "The PLY Polygon File Format", 1994.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {

enum class PlyFormat { text, little_endian, big_endian };

struct PlyProperty {
  std::string name;
  std::optional<NumberType> count;  // of a list
  NumberType value;

  bool is_vertex_index_list() const {
    return count && (name == "vertex_indices" || name == "vertex_index");
  }
};

struct PlyElement {
  std::string name;
  long long count;  // 0 to 2^32 - 1
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format;
  std::vector<PlyElement> elements;
};

// Reads the header up to and with its line 'end_header'. It has one element 'vertex' with numbers
// x, y and z, and after it elements 'face' or 'tristrips' (one of each at most) with lists of whole
// numbers vertex_indices or vertex_index; the counts of the vertices and of one of those are not 0.
// Errors: InputError naming the line.
PlyHeader read_ply_header(TextFile& file);

}  // namespace clipscope::experiments
