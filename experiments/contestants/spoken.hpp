// SPDX-License-Identifier: GPL-3.0-or-later
//
// What sentences call clippers, scalars and sets of triangles: the one home of these names, for
// findings, claims and answers.
//
// A name is a noun, so that it can be the subject of a sentence or stand behind a preposition.
// What has no name here (a clipper or a mesh of the user's) is called by its own, in words.
#pragma once

#include <string>
#include <string_view>

namespace clipscope::experiments {

// Whether a clipper of that name is a guest of this run.
bool is_guest(std::string_view clipper);

// "clip space" for homogeneous/sutherland_hodgman, "Cohen-Sutherland in the window" for
// window/cohen_sutherland; "all planes in clip space" for an unknown homogeneous/all_planes; a
// guest's own name.
std::string spoken_clipper(std::string_view clipper);

// "float", "double-double", "exact arithmetic".
std::string spoken_scalar(std::string_view scalar);

// "clip space in double"; the scalar is left out where there is the clipper in no other.
std::string spoken_contestant(std::string_view clipper, std::string_view scalar);

// A built-in scene or a mix of triangles, behind "on": "the game-like mix", "slivers".
std::string spoken_set(std::string_view set);

}  // namespace clipscope::experiments
