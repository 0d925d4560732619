// SPDX-License-Identifier: GPL-3.0-or-later
//
// All that the engine answers to a random question, as text and as a number: a program of the
// machine (answers_program.cpp) and WebAssembly are asked the same, and must answer the same.
#pragma once

#include <cstdint>

extern "C" {

// Asks the question of that number and returns its Setting (questions.hpp); it stays until the next
// call.
const double* clipscope_ask(std::uint32_t number);

// Of the questions from `first` on, as many as there is room for: a hash of all answers to each.
void clipscope_digests(std::uint32_t first, std::uint64_t* digests, std::uint32_t count);

// The question's setting and triangle, then the answers to it, one a line, as in "clip 4 float 3
// 3ff0000000000000 ...": what was asked, the clipper's number, the scalar, how many vertices or
// polygons there are, and the bits of the numbers as doubles. It stays until the next call.
const char* clipscope_answers(std::uint32_t number);
}
