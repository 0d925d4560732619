// SPDX-License-Identifier: GPL-3.0-or-later
//
// The folder of a run: one process at a time writes into it, and what an older run left there is kept.
#pragma once

#include <filesystem>
#include <memory>

#include "experiments/store/results_store.hpp"

namespace clipscope::experiments {

// Held by the process that writes into a folder; the system gives it up when the process ends, however it
// ends. Nothing is held where the file system has no locks.
class FolderLock {
 public:
  // Errors: OutputError if another process holds it. Pre-condition: the folder exists.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

struct OpenedStore {
  std::shared_ptr<SQLite::Database> database;
  std::filesystem::path file;
  std::filesystem::path kept =
      {};  // where the store of an older run is now; empty if there was none
  bool resumed = false;
};

// A new store for the run. One that is there already is renamed by the date on which it was started:
// results-20260301-123456.sqlite.
// Errors: OutputError.
OpenedStore start_store(const std::filesystem::path& folder, const RunInfo& info);

// The store that is there; a new one if there is none.
// Errors: UsageError if it is of a run that differs (see check_resumable); InputError if it can't be read;
// OutputError.
OpenedStore resume_store(const std::filesystem::path& folder, const RunInfo& info);

}  // namespace clipscope::experiments
