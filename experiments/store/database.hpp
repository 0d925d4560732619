// SPDX-License-Identifier: GPL-3.0-or-later
//
// The SQLite file under a store: opening it, executing statements, its errors in words.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "experiments/store/results_store.hpp"
#include "experiments/table/table.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments {

using DatabasePointer = std::shared_ptr<SQLite::Database>;

// A new store with the tables of schema.hpp and what is to be said about the run; in memory if the
// path is empty. Every transaction is on the disk (synchronous FULL) before it counts.
// Errors: OutputError. Pre-condition: there is no such file, or it is empty.
DatabasePointer create_database(const std::filesystem::path& file, const RunInfo& info);

// A store that exists, to write to it or to read it. What a killed writer left half-written is
// undone.
// Errors: InputError if there is none, it is no store, or one of another version.
DatabasePointer open_database(const std::filesystem::path& file);

// Whether a database has nothing in it once what a killed writer left half-written is undone, like
// that of a run that was killed while it wrote its first transaction. A file that is no database is
// not blank.
bool is_blank_database(const std::filesystem::path& file);

// What went wrong with the file, with the reason of the operating system if it has one:
// "results/results.sqlite: disk I/O error (File too large)".
std::string reason_of(const SQLite::Database& database, const SQLite::Exception& error);

// Does the work; what SQLite complains of becomes an Error: InputError for a reader, OutputError
// for a writer.
template <class Error, class Work>
decltype(auto) with_reasons(const SQLite::Database& database, Work&& work) {
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    throw Error(reason_of(database, error));
  }
}

// The keys of a table's columns in an SQL text: "clipper", "max_px".
std::string sql_keys(const Table& table);

// The values are bound to the statement's parameters in their order. They are stored and read to
// the bit, NaNs included (see schema.hpp), but for bytes that are no UTF-8: a text is read with
// U+FFFD in their place.
using Cells = std::vector<Cell>;
void execute(SQLite::Database& database, const std::string& sql, const Cells& values = {});

// A row with all columns of the table, in their order.
void insert(SQLite::Database& database, const std::string& table, const Cells& values);

// All rows of a query.
std::vector<Cells> rows(const SQLite::Database& database, const std::string& sql,
                        const Cells& values = {});

// A cell as the member that it initialises: a text, a number, a yes or no, an enumerator. One of
// another kind, as nobody stores it, counts as empty.
struct Value {
  const Cell& cell;

  template <class T>
  requires(!std::is_same_v<T, char> &&
           (std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, std::string>))
  operator T() const {
    constexpr bool kAsItIs = std::is_same_v<T, std::string> || std::is_same_v<T, double>;
    const auto* held = std::get_if<std::conditional_t<kAsItIs, T, std::int64_t>>(&cell);
    return held == nullptr ? T() : static_cast<T>(*held);
  }
};

// The same as structures whose first members are the query's columns.
template <class Row, std::size_t kColumns>
std::vector<Row> rows(const SQLite::Database& database, const std::string& sql,
                      const Cells& values = {}) {
  std::vector<Row> made;
  for (const Cells& cells : rows(database, sql, values)) {
    [&]<std::size_t... c>(std::index_sequence<c...>) { made.push_back(Row{Value{cells[c]}...}); }
    (std::make_index_sequence<kColumns>());
  }
  return made;
}

}  // namespace clipscope::experiments
