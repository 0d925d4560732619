// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/store/database.hpp"

#include <endian.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <system_error>

#include "experiments/machine/errors.hpp"
#include "experiments/store/schema.hpp"

namespace clipscope::experiments {
namespace {

constexpr int kPatience = 10000;  // ms to wait for a process that reads or commits

void set_up(SQLite::Database& database) {
  database.setBusyTimeout(kPatience);
  database.exec("PRAGMA foreign_keys = ON");
  database.exec("PRAGMA synchronous = FULL");
}

// The database, set up. refused: what can't be done with the file if it can't be opened.
template <class Error>
DatabasePointer connect(const std::string& name, int flags, const char* refused) {
  DatabasePointer database;
  try {
    database = std::make_shared<SQLite::Database>(name, flags);
  } catch (const SQLite::Exception& error) {
    throw Error(fmt::format("{}: can't be {}: {}", name, refused, error.what()));
  }
  with_reasons<Error>(*database, [&] { set_up(*database); });
  return database;
}

void check_version(SQLite::Database& database) {
  const std::string& file = database.getFilename();
  if (database.execAndGet("PRAGMA application_id").getInt() != kApplicationId) {
    throw InputError(fmt::format("{}: is no results store of clipscope", file));
  }
  const int version = database.execAndGet("PRAGMA user_version").getInt();
  if (version == kSchemaVersion) return;
  throw InputError(
      fmt::format("{}: is a results store of format {}; this clipscope reads format {}", file,
                  version, kSchemaVersion));
}

void bind(SQLite::Statement& statement, int index, double number) {
  if (!std::isnan(number)) return statement.bind(index, number);
  const std::uint64_t bytes = htobe64(std::bit_cast<std::uint64_t>(number));
  statement.bind(index, &bytes, sizeof bytes);
}
void bind(SQLite::Statement& statement, int index, std::monostate) { statement.bind(index); }
void bind(SQLite::Statement& statement, int index, const auto& value) {
  statement.bind(index, value);
}

void bind_all(SQLite::Statement& statement, const Cells& values) {
  int index = 0;
  for (const Cell& cell : values) {
    ++index;
    std::visit([&](const auto& value) { bind(statement, index, value); }, cell);
  }
}

double double_of(const void* blob) {
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, blob, sizeof bytes);
  return std::bit_cast<double>(be64toh(bytes));
}

// A results file may come from anywhere, and nobody above it expects text that is no UTF-8.
Cell cell_of(const SQLite::Column& column) {
  if (column.isInteger()) return std::int64_t{column.getInt64()};
  if (column.isFloat()) return column.getDouble();
  if (column.isText()) return valid_utf8(column.getString());
  if (column.isBlob() && column.getBytes() == sizeof(double)) return double_of(column.getBlob());
  return std::monostate();
}

// The last failed call on the file, whose number a failed commit does not pass on to the
// connection; else that of the connection; 0 if there was none.
int system_error_of(sqlite3* connection) {
  int number = 0;
  sqlite3_file_control(connection, "main", SQLITE_FCNTL_LAST_ERRNO, &number);
  return number != 0 ? number : sqlite3_system_errno(connection);
}

}  // namespace

DatabasePointer create_database(const std::filesystem::path& file, const RunInfo& info) {
  DatabasePointer database =
      connect<OutputError>(file.empty() ? ":memory:" : file.string(),
                           SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, "written");
  with_reasons<OutputError>(*database, [&] {
    SQLite::Transaction transaction(*database);
    database->exec(kSchema);
    database->exec(fmt::format("PRAGMA application_id = {}", kApplicationId));
    database->exec(fmt::format("PRAGMA user_version = {}", kSchemaVersion));
    for (const auto& [key, value] : info) insert(*database, "run", {key, value});
    transaction.commit();
  });
  return database;
}

DatabasePointer open_database(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    throw InputError(
        fmt::format("{}: there is no such file; `clipscope run --out DIR`, or a shard, writes it",
                    file.string()));
  }
  // Read only where the file can't be written; else writable for readers, too: only so can SQLite
  // undo what a killed writer has left.
  DatabasePointer database = connect<InputError>(file.string(), SQLite::OPEN_READWRITE, "opened");
  with_reasons<InputError>(*database, [&] { check_version(*database); });
  return database;
}

bool is_blank_database(const std::filesystem::path& file) {
  try {
    const auto database = connect<InputError>(file.string(), SQLite::OPEN_READWRITE, "opened");
    return database->execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0;
  } catch (const std::runtime_error&) {
    return false;
  }
}

std::string reason_of(const SQLite::Database& database, const SQLite::Exception& error) {
  const std::string text = fmt::format("{}: {}", database.getFilename(), error.what());
  const int code = error.getErrorCode();
  if (code != SQLITE_IOERR && code != SQLITE_CANTOPEN && code != SQLITE_FULL) return text;
  const int number = system_error_of(database.getHandle());
  return number == 0 ? text : fmt::format("{} ({})", text, std::generic_category().message(number));
}

std::string sql_keys(const Table& table) {
  std::vector<std::string> keys;
  for (const Column& column : table.columns()) keys.push_back(double_quoted(column.key));
  return fmt::format("{}", fmt::join(keys, ", "));
}

void execute(SQLite::Database& database, const std::string& sql, const Cells& values) {
  SQLite::Statement statement(database, sql);
  bind_all(statement, values);
  statement.exec();
}

void insert(SQLite::Database& database, const std::string& table, const Cells& values) {
  const std::vector<const char*> parameters(values.size(), "?");
  execute(
      database,
      fmt::format("INSERT INTO {} VALUES({})", double_quoted(table), fmt::join(parameters, ", ")),
      values);
}

std::vector<Cells> rows(const SQLite::Database& database, const std::string& sql,
                        const Cells& values) {
  SQLite::Statement statement(database, sql);
  bind_all(statement, values);
  std::vector<Cells> rows;
  while (statement.executeStep()) {
    Cells& cells = rows.emplace_back();
    for (int c = 0; c < statement.getColumnCount(); ++c) {
      cells.push_back(cell_of(statement.getColumn(c)));
    }
  }
  return rows;
}

}  // namespace clipscope::experiments
