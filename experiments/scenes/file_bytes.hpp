// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace clipscope::experiments {

// Errors: InputError naming the file if it is missing, a directory or no regular file.
void require_file(const std::filesystem::path& path);

// All bytes of a file. Errors: those of require_file; InputError if it is unreadable or empty.
std::string read_bytes(const std::filesystem::path& path);

}  // namespace clipscope::experiments
