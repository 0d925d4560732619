// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whole files, read and written.
#pragma once

#include <filesystem>
#include <string>

namespace clipscope::experiments {

// Errors: InputError naming the file if it is missing, a directory or no regular file.
void require_file(const std::filesystem::path& path);

// All bytes of a file. Errors: those of require_file; InputError if it is unreadable or empty.
std::string read_bytes(const std::filesystem::path& path);

// The same of a file that the program wrote itself: nothing where it can't be read.
std::string read_if_there(const std::filesystem::path& path);

// With the letters of ASCII in lower case.
std::string lower_case(std::string text);

// In lower case: ".png"; empty if there is none.
std::string extension_of(const std::filesystem::path& path);

// Makes the directory, and those above it, unless it is there. Errors: OutputError naming the path
// and the reason.
void make_folder(const std::filesystem::path& path);

// Writes a whole file under a temporary name and moves it into place, making the directory if there
// is none. Errors: OutputError naming the path and the reason.
void write_file(const std::filesystem::path& path, const std::string& content);

}  // namespace clipscope::experiments
