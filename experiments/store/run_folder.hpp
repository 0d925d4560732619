// SPDX-License-Identifier: GPL-3.0-or-later
//
// The folder of a run: one process at a time writes into it, what an older run left there is kept,
// and a run is resumed only by its like, with the same options, program, machine and files read.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "experiments/selection/select.hpp"
#include "experiments/store/results_store.hpp"

namespace clipscope::experiments {

// Held by the process that writes into a folder; the system gives it up when the process ends,
// however it ends. Nothing is held where the file system has no locks.
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
  std::filesystem::path kept = {};  // the store of an older run, where it is now; empty: none
  bool resumed = false;
};

// A new store for the run. One that is there already is renamed by the date on which it was
// started: results-20260301-123456.sqlite.
// Errors: OutputError.
OpenedStore start_store(const std::filesystem::path& folder, const RunInfo& info);

// The store that is there; a new one if there is none.
// Errors: UsageError naming every option that differs, and whether program, machine or files do;
// InputError if the store can't be read; OutputError.
OpenedStore resume_store(const std::filesystem::path& folder, const RunInfo& info);

// What `clipscope run` takes where no option says otherwise.
Selection default_run_selection();

// All that is known when a run starts, its date included.
RunInfo run_info_of(const Selection& selection);

// The command that runs the experiment with these options, quoted for a shell. An empty name: all.
std::string run_command(const Selection& selection, const std::string& experiment);

}  // namespace clipscope::experiments
