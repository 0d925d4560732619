// SPDX-License-Identifier: GPL-3.0-or-later
//
// A folder for files that nobody keeps.
#pragma once

#include <filesystem>

namespace clipscope::experiments {

// A new folder below the system's folder for temporary files, which goes away with its content.
class TemporaryFolder {
 public:
  // Errors: OutputError naming the path and the reason.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::filesystem::path& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace clipscope::experiments
