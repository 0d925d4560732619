// SPDX-License-Identifier: GPL-3.0-or-later
//
// The words that the sentences about claims are made of.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace clipscope::experiments::claims {

// Three digits, and all of those before the point: "0.87", "94.6", "129510".
std::string number_text(double number);

// How fast something is that is so many times as fast as another: "is 27 % faster than", "is 2.5
// times as fast as", "takes 47 % longer than", "takes 2.5 times as long as", or "is as fast as"
// within half a percent. `up_to` stands before the figure.
std::string pace_text(double times_as_fast, std::string_view up_to = "");

// A clipper and others: where their names tell of one place at most, their methods alone, such as
// "Cohen-Sutherland", not "Cohen-Sutherland in the window".
std::vector<std::string> spoken_methods(std::string_view clipper,
                                        const std::vector<std::string_view>& others);

// What a case, by the name that the tables give it, is called behind "on".
using Speak = std::string (*)(std::string_view);

// The name of the case that a convex polygon of so many edges is.
std::string edges_name(std::int64_t edges);

// Of triangles: "the game-like mix in batches" for "soup in batches".
std::string spoken_triangles(std::string_view name);
// Of segments, in the plane, in space and in a convex polygon: "lines beside the window", "lines in
// a polygon of 8 edges" for "8 edges".
std::string spoken_lines(std::string_view name);

// The cases in which something holds, as a condition: "The input consists of slivers or the
// teapot", "The input is anything but slivers", or where that is long "The input suits it, as 4
// of 10 cases do". Neighbours on a scale are one: "lines in polygons of 8 or more edges".
// Pre-condition: some hold, and some do not.
std::string where_text(const std::vector<std::string>& holding,
                       const std::vector<std::string>& failing, Speak speak);

}  // namespace clipscope::experiments::claims
