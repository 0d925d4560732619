// SPDX-License-Identifier: GPL-3.0-or-later
//
// Driver: who draws, what it is and what it can.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "experiments/drawcalls/draw_call.hpp"

namespace clipscope::experiments {

enum class GraphicsApi : std::uint8_t { opengl, vulkan, webgl };
constexpr std::array<std::string_view, 3> names_of(GraphicsApi) {
  return {"OpenGL", "Vulkan", "WebGL"};
}

// As the driver describes itself; limits are those that it was asked for, not ours.
struct DriverInfo {
  GraphicsApi api = GraphicsApi::opengl;
  std::string api_version = {};  // "4.5 core", "1.3.230", "2.0 (OpenGL ES 3.0)"
  std::string renderer = {};     // "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string version = {};      // of the driver: "Mesa 22.3.6"

  int subpixel_bits = 4;  // of window coordinates
  int max_size = 0;       // of a target and of a viewport, px
  int max_clip_distances = 0;
  float max_point_size = 1;
  bool minus_one_to_one = false, zero_to_one = false;  // depth ranges
  bool depth_clamp = false;
  bool provoking_first = false, provoking_last = false;
  bool triangle_fans = true;
  // Vulkan 1.3: strictLines. Elsewhere the relaxed rules of lines are all that there is.
  bool strict_lines = false;
  // Vulkan 1.3, pointClippingBehavior: a point is clipped at its centre by the sides, too.
  // OpenGL leaves it open.
  bool points_clip_at_sides = false;
  Quantities quantities = {};

  friend bool operator==(const DriverInfo&, const DriverInfo&) = default;
};

// Why there are no pixels.
struct DrawFailure {
  enum class Kind : std::uint8_t {
    crashed,
    timed_out,
    refused,  // an error of the API, or out of memory
    unable    // the driver says that it can't: no outcome of the case
  };
  Kind kind = Kind::crashed;
  std::string reason = {};

  friend bool operator==(const DrawFailure&, const DrawFailure&) = default;
};
constexpr std::array<std::string_view, 4> names_of(DrawFailure::Kind) {
  return {"crashed", "timed_out", "refused", "unable"};
}

using Drawn = std::variant<Pixels, DrawFailure>;

class Driver {
 public:
  virtual ~Driver() = default;
  virtual const DriverInfo& info() const = 0;
  // Never throws for what a driver does; the next call is served however this one ended.
  virtual Drawn draw(const DrawCall& call) = 0;
};

// Why a driver of that kind can't draw it, in words that complete "the driver ..."; empty if it
// can: "has no clip distances".
std::string inability(const DriverInfo& info, const DrawCall& call);

}  // namespace clipscope::experiments
