// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks of mesh files before assimp reads them: what each format promises is there and in range.
//
// A file that passes has all the data that it announces, indices that point at existing vertices and
// coordinates that a float can hold. Keywords, elements and properties that do not concern geometry are
// skipped unread. Each check throws InputError at the first offence: the file, the line (text) or the
// element (binary), what was found and what would be right. The check of glTF is in gltf.hpp.
#pragma once

#include <string>
#include <string_view>

namespace clipscope::experiments {

// `name` is what messages call the file, `content` all of it.
void check_ply(const std::string& name, std::string_view content);

// Checks an STL file and yields it in its binary form.
std::string geometry_of_stl(const std::string& name, std::string content);

// Checks an OBJ file and yields its vertices, texture coordinates, normals and faces alone, one plain
// line each: assimp knows no comments behind a face.
std::string geometry_of_obj(const std::string& name, std::string_view content);

}  // namespace clipscope::experiments
