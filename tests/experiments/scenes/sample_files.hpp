// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small mesh files of each format, all of the same pyramid: the square base (0,0,0) (1,0,0) (1,1,0)
// (0,1,0) and the apex (0.5,0.5,1), in the order of kPyramid. Text formats hold the base as a
// polygon where they can.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/machine/temporary_folder.hpp"

namespace clipscope::experiments {

inline constexpr std::array<std::array<float, 3>, 5> kPyramid = {
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5f, 0.5f, 1}}};

// A folder for files of a test.
struct FolderOfFiles : TemporaryFolder {
  // Writes a file in the folder and yields its path.
  std::filesystem::path write(const std::string& name, const std::string& content) const;
};

struct SampleFile {
  std::string name;
  std::string content;
};

std::string sample_obj();
std::string sample_ply_text();
std::string sample_ply_binary(bool big_endian);
std::string sample_ply_strips();  // in double
std::string sample_stl_text();
std::string sample_stl_binary();
// One node with translation (10, 20, 30) over one with the mesh and scale 2.
std::string sample_gltf();  // buffer as a data URI
std::string sample_glb();   // buffer as a chunk
// The same with positions in an accessor without a buffer view: zeros, of which all but the first
// are replaced.
std::string sample_sparse_glb();
// The JSON of a glTF file with such a member for the buffer's place, such as "\"uri\":\"a.bin\",",
// and the bytes of the buffer.
std::string sample_gltf_json(const std::string& uri_member);
std::string sample_gltf_buffer();
std::string as_glb(const std::string& json, const std::string& buffer);

// One of each.
std::vector<SampleFile> sample_files();

// The text with the first occurrence of a part replaced, which must be there.
std::string replaced(std::string text, const std::string& part, const std::string& by);

}  // namespace clipscope::experiments
