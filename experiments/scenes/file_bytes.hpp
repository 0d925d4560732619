// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace clipscope::experiments {

// All bytes of a regular file. Errors: InputError naming it and the reason for a file that is missing,
// a directory, unreadable or empty.
std::string read_bytes(const std::filesystem::path& path);

}  // namespace clipscope::experiments
