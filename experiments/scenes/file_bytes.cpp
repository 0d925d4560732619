// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/file_bytes.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "experiments/errors.hpp"

namespace clipscope::experiments {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw InputError(fmt::format("{}: {}", path.string(), reason));
}

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

void require_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    fail(path,
         error && error != std::errc::no_such_file_or_directory ? error.message() : "no such file");
  }
  if (std::filesystem::is_directory(status)) {
    fail(path, "a directory; a mesh file expected");
  }
  if (!std::filesystem::is_regular_file(status)) {
    fail(path, "not a regular file; a mesh file expected");
  }
}

std::string read_bytes(const std::filesystem::path& path) {
  require_file(path);
  const std::unique_ptr<std::FILE, Closer> file(std::fopen(path.c_str(), "rb"));
  if (!file) {
    fail(path, fmt::format("can't be opened: {}", std::strerror(errno)));
  }
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (error) {
    fail(path, error.message());
  }
  if (size == 0) {
    fail(path, "the file is empty");
  }
  std::string bytes(size, '\0');
  if (std::fread(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) {
    fail(path, fmt::format("can't be read to its end of {} bytes", size));
  }
  return bytes;
}

}  // namespace clipscope::experiments
