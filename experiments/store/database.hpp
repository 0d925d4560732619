// SPDX-License-Identifier: GPL-3.0-or-later
//
// The SQLite file under a store: opening it, its errors in words, and cells as its values.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>
#include <memory>
#include <string>

#include "experiments/report/table.hpp"
#include "experiments/store/results_store.hpp"

namespace clipscope::experiments {

using DatabasePointer = std::shared_ptr<SQLite::Database>;

// A new store with the tables of schema.hpp and what is to be said about the run; in memory if the path is
// empty. Every transaction is on the disk (synchronous FULL) before it counts.
// Errors: OutputError. Pre-condition: there is no such file, or it is empty.
DatabasePointer create_database(const std::filesystem::path& file, const RunInfo& info);

// A store that exists, to write to it or to read it. What a killed writer left half-written is undone.
// Errors: InputError if there is none, it is no store, or one of another version.
DatabasePointer open_database(const std::filesystem::path& file);

// Whether a database has nothing in it once what a killed writer left half-written is undone: all that there is
// of a run that was killed while it wrote its first transaction. Of a file that is no database: false.
bool is_blank_database(const std::filesystem::path& file);

// What went wrong with the file, with the reason of the operating system if it has one:
// "results/results.sqlite: disk I/O error (File too large)".
std::string reason_of(const SQLite::Database& database, const SQLite::Exception& error);

// Does the work; what SQLite complains of becomes an Error: InputError for a reader, OutputError for a
// writer.
template <class Error, class Work>
decltype(auto) with_reasons(const SQLite::Database& database, Work&& work) {
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    throw Error(reason_of(database, error));
  }
}

// A name in an SQL text: "max_px", in double quotes.
std::string sql_name(const std::string& name);

// To the bit, NaNs included (see schema.hpp).
void bind_cell(SQLite::Statement& statement, int index, const Cell& cell);
Cell cell_of(const SQLite::Column& column);

}  // namespace clipscope::experiments
