// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/store/database.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <system_error>

#include "experiments/errors.hpp"
#include "experiments/store/schema.hpp"

namespace clipscope::experiments {
namespace {

constexpr int kPatience = 10000;  // ms to wait for a process that reads or commits

void set_up(SQLite::Database& database) {
  database.setBusyTimeout(kPatience);
  database.exec("PRAGMA foreign_keys = ON");
  database.exec("PRAGMA synchronous = FULL");
}

int pragma(const SQLite::Database& database, const char* name) {
  SQLite::Statement statement(database, fmt::format("PRAGMA {}", name));
  statement.executeStep();
  return statement.getColumn(0).getInt();
}

void check_version(const SQLite::Database& database) {
  const std::string& file = database.getFilename();
  if (pragma(database, "application_id") != kApplicationId) {
    throw InputError(fmt::format("{}: is no results store of clipscope", file));
  }
  if (const int version = pragma(database, "user_version"); version != kSchemaVersion) {
    throw InputError(
        fmt::format("{}: is a results store of format {}; this clipscope reads format {}", file,
                    version, kSchemaVersion));
  }
}

using Bytes = std::array<unsigned char, sizeof(double)>;

Bytes bytes_of(double value) {
  Bytes bytes{};
  auto bits = std::bit_cast<std::uint64_t>(value);
  for (std::size_t i = bytes.size(); i-- > 0; bits >>= 8) {
    bytes[i] = static_cast<unsigned char>(bits & 0xFF);
  }
  return bytes;
}

double double_of(const void* blob) {
  const auto* bytes = static_cast<const unsigned char*>(blob);
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < sizeof bits; ++i) bits = bits << 8 | bytes[i];
  return std::bit_cast<double>(bits);
}

// The last failed call on the file, whose number a failed commit does not pass on to the connection; else
// that of the connection; 0 if there was none.
int system_error_of(sqlite3* connection) {
  int number = 0;
  sqlite3_file_control(connection, "main", SQLITE_FCNTL_LAST_ERRNO, &number);
  return number != 0 ? number : sqlite3_system_errno(connection);
}

}  // namespace

DatabasePointer create_database(const std::filesystem::path& file, const RunInfo& info) {
  const std::string name = file.empty() ? ":memory:" : file.string();
  DatabasePointer database;
  try {
    database =
        std::make_shared<SQLite::Database>(name, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  } catch (const SQLite::Exception& error) {
    throw OutputError(fmt::format("{}: can't be written: {}", name, error.what()));
  }
  with_reasons<OutputError>(*database, [&] {
    set_up(*database);
    SQLite::Transaction transaction(*database);
    database->exec(kSchema);
    database->exec(fmt::format("PRAGMA application_id = {}", kApplicationId));
    database->exec(fmt::format("PRAGMA user_version = {}", kSchemaVersion));
    SQLite::Statement insert(*database, "INSERT INTO run(key, value) VALUES(?, ?)");
    for (const auto& [key, value] : info) {
      insert.bind(1, key);
      insert.bind(2, value);
      insert.exec();
      insert.reset();
    }
    transaction.commit();
  });
  return database;
}

DatabasePointer open_database(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    throw InputError(fmt::format("{}: there is no such file; `clipscope run --out DIR` writes it",
                                 file.string()));
  }
  DatabasePointer database;
  try {
    // Read only where the file can't be written; else writable for readers, too: only so can SQLite undo
    // what a killed writer has left.
    database = std::make_shared<SQLite::Database>(file.string(), SQLite::OPEN_READWRITE);
  } catch (const SQLite::Exception& error) {
    throw InputError(fmt::format("{}: can't be opened: {}", file.string(), error.what()));
  }
  with_reasons<InputError>(*database, [&] {
    set_up(*database);
    check_version(*database);
  });
  return database;
}

bool is_blank_database(const std::filesystem::path& file) {
  try {
    SQLite::Database database(file.string(), SQLite::OPEN_READWRITE);
    set_up(database);
    return database.execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0;
  } catch (const SQLite::Exception&) {
    return false;
  }
}

std::string reason_of(const SQLite::Database& database, const SQLite::Exception& error) {
  std::string text = fmt::format("{}: {}", database.getFilename(), error.what());
  switch (error.getErrorCode()) {
    case SQLITE_IOERR:
    case SQLITE_CANTOPEN:
    case SQLITE_FULL:
      if (const int number = system_error_of(database.getHandle()); number != 0) {
        text += fmt::format(" ({})", std::generic_category().message(number));
      }
      break;
    default: break;
  }
  return text;
}

std::string sql_name(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

void bind_cell(SQLite::Statement& statement, int index, const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) {
    statement.bind(index, *text);
  } else if (const auto* count = std::get_if<std::int64_t>(&cell)) {
    statement.bind(index, *count);
  } else if (const auto* number = std::get_if<double>(&cell)) {
    if (std::isnan(*number)) {
      const Bytes bytes = bytes_of(*number);
      statement.bind(index, bytes.data(), static_cast<int>(bytes.size()));
    } else {
      statement.bind(index, *number);
    }
  } else {
    statement.bind(index);
  }
}

Cell cell_of(const SQLite::Column& column) {
  if (column.isInteger()) return std::int64_t{column.getInt64()};
  if (column.isFloat()) return column.getDouble();
  if (column.isText()) return column.getString();
  if (column.isBlob() && column.getBytes() == sizeof(double)) return double_of(column.getBlob());
  return std::monostate();
}

}  // namespace clipscope::experiments
