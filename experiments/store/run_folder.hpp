// SPDX-License-Identifier: GPL-3.0-or-later
//
// The folder of a run: one process at a time writes into it, what an older run left there is kept,
// and a run is resumed only by its like, with the same options, program, machine and files read.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

// Says on standard error where an older store is now, if there was one.
void tell_kept(const OpenedStore& opened);

// A new store for the run. One that is there already is renamed by the date on which it was
// started: results-20260301-123456.sqlite.
// Errors: OutputError.
OpenedStore start_store(const std::filesystem::path& folder, const RunInfo& info);

// The store that is there; a new one if there is none.
// Errors: UsageError naming every option that differs, and whether program, machine or files do;
// InputError if the store can't be read; OutputError.
OpenedStore resume_store(const std::filesystem::path& folder, const RunInfo& info);

// What differs between two runs that should be one: every option, program and files, the machine
// where both name one. Empty if nothing does. One entry: "--seed: 1 then, 2 now", with the words
// given.
std::vector<std::string> differences_of(const RunInfo& a, const RunInfo& b, std::string_view of_a,
                                        std::string_view of_b);

// What `clipscope run` takes where no option says otherwise.
Selection default_run_selection();

// All that is known when a run starts, its date included.
RunInfo run_info_of(const Selection& selection);

// Sets an option beside those of the selection, by its name on the command line; takes it out where
// there is no value.
void set_option(RunInfo& info, const std::string& name, const std::optional<std::string>& value);

// The command that runs the experiment with these options, quoted for a shell. An empty name: all.
std::string run_command(const Selection& selection, const std::string& experiment);

}  // namespace clipscope::experiments
