// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/store/run_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "experiments/errors.hpp"
#include "experiments/store/database.hpp"
#include "experiments/store/date.hpp"
#include "experiments/store/run_identity.hpp"

namespace clipscope::experiments {
namespace {

namespace fs = std::filesystem;

// A run that was killed before the end of its first transaction leaves an empty file, or one that is empty
// again when that is undone.
bool is_there(const fs::path& file) {
  std::error_code error;
  const auto size = fs::file_size(file, error);
  return !error && size > 0 && !is_blank_database(file);
}

// When the store was started; if it can't be read, when the file was last written.
std::string date_of_store(const fs::path& file) {
  try {
    const std::string started = value_of(ResultsStore(file).run_info(), "started");
    if (!started.empty()) return started;
  } catch (const InputError&) {
  }
  struct stat status {};
  return date_of(::stat(file.c_str(), &status) == 0 ? status.st_mtime : std::time(nullptr));
}

// "2026-03-01T12:34:56Z" -> "20260301-123456"
std::string as_stem(std::string date) {
  std::erase_if(date, [](char c) { return c == '-' || c == ':' || c == 'Z'; });
  std::ranges::replace(date, 'T', '-');
  return date;
}

void move_file(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) {
    throw OutputError(
        fmt::format("{}: can't be renamed to {}: {}", from.string(), to.string(), error.message()));
  }
}

fs::path keep_under_its_date(const fs::path& file) {
  const std::string stem = fmt::format("results-{}", as_stem(date_of_store(file)));
  fs::path kept = file.parent_path() / (stem + ".sqlite");
  for (int i = 2; fs::exists(kept); ++i) {
    kept = file.parent_path() / fmt::format("{}-{}.sqlite", stem, i);
  }
  // What SQLite needs to undo an interrupted transaction goes with its file.
  const fs::path journal = file.string() + "-journal";
  if (fs::exists(journal)) move_file(journal, kept.string() + "-journal");
  move_file(file, kept);
  return kept;
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0 || ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) {
    return;
  }
  ::close(descriptor_);
  throw OutputError(fmt::format(
      "{}: another clipscope is writing its results into this folder; wait for it, or name another "
      "folder with --out",
      folder.string()));
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

OpenedStore start_store(const fs::path& folder, const RunInfo& info) {
  OpenedStore opened{nullptr, folder / kStoreFile};
  if (is_there(opened.file)) opened.kept = keep_under_its_date(opened.file);
  opened.database = create_database(opened.file, info);
  return opened;
}

OpenedStore resume_store(const fs::path& folder, const RunInfo& info) {
  OpenedStore opened{nullptr, folder / kStoreFile};
  if (!is_there(opened.file)) return start_store(folder, info);
  opened.database = open_database(opened.file);
  check_resumable(ResultsStore(opened.database, opened.file).run_info(), info, opened.file);
  opened.resumed = true;
  return opened;
}

}  // namespace clipscope::experiments
