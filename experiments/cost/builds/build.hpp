// SPDX-License-Identifier: GPL-3.0-or-later
//
// Some clippers, compiled once more with other flags: what a build is called through.
//
// Templates compiled twice are one function to the linker, which keeps the first. So each build
// compiles its clippers in a namespace of its own: it has `clipscope` defined as another name
// (CMakeLists.txt). What builds and their caller share is therefore not of that namespace.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "spaces/projection.hpp"

namespace builds {

inline constexpr int kAttributes = 4;

// Frustum<double>, which each build has as a type of its own.
using FrustumBytes = std::array<std::byte, sizeof(clipscope::Frustum<double>)>;

// View-space triangles, each vertex x y z and four attributes. They stay the owner's.
struct Input {
  FrustumBytes frustum;
  std::span<const float> numbers;
};

// Where answers go: number by number, eight for each vertex of a polygon, then its end.
struct Reader {
  virtual void number(double x) = 0;
  virtual void end_polygon() = 0;

 protected:
  ~Reader() = default;
};

// A clipper with its input, converted to its scalar.
struct Runner {
  virtual ~Runner() = default;
  // Clips triangles [first, first + count); what the last call left is gone.
  virtual void clip(std::size_t first, std::size_t count) = 0;
  virtual void read_answers(Reader& reader) const = 0;
};

struct Clipper {
  const char* clipper;
  const char* scalar;
  Runner* (*prepare)(const Input&);  // the caller's to delete
};

// A set of flags, and what is compiled with them: the same clippers in the same order for all sets.
struct Build {
  const char* flags;  // added to those of contestants
  std::span<const Clipper> (*clippers)();
};

// Those that this processor can run; the first adds no flags.
std::span<const Build> runnable();

}  // namespace builds
