// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/machine/files.hpp"

#include <fmt/core.h>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "experiments/machine/errors.hpp"

namespace clipscope::experiments {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw InputError(fmt::format("{}: {}", path.string(), reason));
}

}  // namespace

void require_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    fail(path,
         error && error != std::errc::no_such_file_or_directory ? error.message() : "no such file");
  }
  if (std::filesystem::is_directory(status)) fail(path, "a directory; a mesh file expected");
  if (!std::filesystem::is_regular_file(status)) {
    fail(path, "not a regular file; a mesh file expected");
  }
}

std::string read_bytes(const std::filesystem::path& path) {
  require_file(path);
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(path, fmt::format("can't be opened: {}", std::strerror(errno)));
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (error) fail(path, error.message());
  if (size == 0) fail(path, "the file is empty");
  std::string bytes(size, '\0');
  if (!file.read(bytes.data(), static_cast<std::streamsize>(size))) {
    fail(path, fmt::format("can't be read to its end of {} bytes", size));
  }
  return bytes;
}

std::string read_if_there(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string extension_of(const std::filesystem::path& path) {
  return lower_case(path.extension().string());
}

void make_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw OutputError(fmt::format("{}: {}", path.string(), error.message()));
}

void write_file(const std::filesystem::path& path, const std::string& content) {
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  const std::filesystem::path temporary = path.string() + ".part";
  if (!error) {
    errno = 0;
    std::ofstream file(temporary, std::ios::binary);
    file << content;
    file.close();
    if (file) {
      std::filesystem::rename(temporary, path, error);
    } else {
      error.assign(errno != 0 ? errno : EIO, std::generic_category());
    }
  }
  if (error) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw OutputError(fmt::format("{}: can't be written: {}", path.string(), error.message()));
  }
}

}  // namespace clipscope::experiments
