// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures as WebP, which is smaller than PNG and which every browser shows.
#pragma once

#include <filesystem>
#include <string>

namespace clipscope::experiments {

// The bytes of a WebP file with the same 8-bit pixels as the PNG, which has three channels and no
// alpha, as write_png leaves it. Throws OutputError if it can't be read or encoded.
std::string lossless_webp(const std::filesystem::path& png);

}  // namespace clipscope::experiments
