// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/machine/temporary_folder.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include "experiments/machine/errors.hpp"

namespace clipscope::experiments {

TemporaryFolder::TemporaryFolder() {
  std::error_code error;
  const std::filesystem::path below = std::filesystem::temp_directory_path(error);
  if (error) {
    const char* const given = std::getenv("TMPDIR");
    throw OutputError(fmt::format("TMPDIR: {}: expected a folder for temporary files: {}",
                                  given == nullptr ? "not set" : given, error.message()));
  }
  std::string name = (below / "clipscope-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw OutputError(fmt::format("{}: can't be made: {}", name, std::strerror(errno)));
  }
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace clipscope::experiments
