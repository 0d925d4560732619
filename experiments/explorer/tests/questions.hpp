// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random questions for the engine, hard ones among them: the same for a number on every machine.
#pragma once

#include <array>
#include <cstdint>

namespace clipscope::explorer {

// What was asked beside the triangle: the arguments of clipscope_set_frustum, in their order, then
// those of clipscope_set_volume, and whether the triangle is in clip space.
inline constexpr int kSettingNumbers = 16;
using Setting = std::array<double, kSettingNumbers>;

// Sets frustum, volume and triangle. The frustum encloses a volume in float and in double, and its
// numbers are floats.
Setting ask(std::uint64_t number);

constexpr bool is_clip(const Setting& setting) { return setting.back() != 0; }

}  // namespace clipscope::explorer
