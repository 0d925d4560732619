// SPDX-License-Identifier: GPL-3.0-or-later
//
// The catalogue of hard cases, the built-in one and what a user adds to it, and their families.
//
// Cases are written in files NAME.cases; tests/corpus/README.md describes the format. The built-in
// files are part of the program.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"

namespace clipscope::experiments {

// All cases of tests/corpus as they were when the program was built, file by file.
const std::vector<HardCase>& builtin_catalogue();

// The cases of a file, or of all files *.cases of a directory, in the order of their names. Errors:
// InputError naming file and line, what was found and what was expected; also if an expected
// outcome is not the exact one, if two cases have the same name, and if there are none.
std::vector<HardCase> load_catalogue(const std::filesystem::path& path);

// The cases of a text, as if it were a file of that name. Errors: those of load_catalogue.
std::vector<HardCase> parse_catalogue(const std::string& file, std::string_view text);

// The same without a look at names and at whether there is a case.
std::vector<HardCase> read_cases(const std::string& file, std::string_view text);

// The case of that name, "theme/name", or "name" if only one theme has it. Errors: UsageError that
// names those whose names are most like it.
const HardCase& find_case(std::span<const HardCase> cases, std::string_view name);

// The case in the format of a file, with its exact outcome as `expect`; the name without its theme.
// Attributes that the reader would fill in are left out. Pre-conditions: no matrix and no planes;
// finite, and all numbers are floats.
std::string case_text(const HardCase& hard_case);

// Adds the case to the end of a file of cases, which is made if there is none; what it holds stays.
// Where it has a case of that name, _2 or the next free number is added to the name. Returns the
// case as the file has it, with its name there. Errors: InputError if the file holds something else
// than cases; OutputError.
HardCase append_case(const std::filesystem::path& file, HardCase hard_case);

// Families: what is made from one hard case by small or exact changes.
//
// The exact result of an exact change (a scaling by 2^k, a rotation of the vertices, a mirrored
// axis, another depth range) follows from the original's. That relation holds for every right
// clipper, whatever the result is ("metamorphic": Chen, Cheung and Yiu, "Metamorphic Testing",
// 1998).
//
// Every variant is called "theme/name (label)", and has floats for coordinates and the outcome that
// the exact reference gives.

// In this order, as far as they apply and all numbers remain floats:
//   scaled       all clip coordinates, or all view coordinates and the lengths of the frustum,
//                times 2^k: k = -60, -20, -1, 1, 20, 60
//   rotated      the vertices begin with another one; the ends of segments are swapped; triangles
//                and polygons are also reversed
//   mirrored     x, y, x and y negated, x and y swapped
//   depth        clip space: depth mirrored (gl), or near and far exchanged (zero_to_one,
//                reversed); view space: the two other depth ranges
//   neighbours   one coordinate of one vertex moved by one float ulp up or down (not for polygons,
//                which would not be planar)
std::vector<HardCase> family(const HardCase& hard_case);

// One coordinate of one vertex replaced by NaN, an infinity, a zero of either sign, the smallest
// and the largest subnormal and the largest finite float, of either sign; in polygons only by NaN
// and the infinities. `expected` means nothing where is_finite(variant) is false.
std::vector<HardCase> special_values(const HardCase& hard_case);

// Whether all numbers of the vertices are finite: where they aren't there is no exact answer.
bool is_finite(const HardCase& hard_case);

}  // namespace clipscope::experiments
