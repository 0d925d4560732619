// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texts, tables and verdicts as HTML.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <string_view>

#include "experiments/table/table.hpp"

namespace clipscope::experiments {

// A file's relative path as an address: what an address would not take as itself is encoded
// (RFC 3986, 2.1 and 2.3), slashes are not.
std::string url_of(std::string_view path);

// Base64 (RFC 4648), padded, in one line.
std::string base64(std::string_view bytes);

// A verdict on a claim, coloured by what it is.
std::string verdict_html(const std::string& verdict);

// How a table stands in a page.
struct TableSetting {
  std::set<std::string> parts = {};  // what the page has sections of, by their ids
  std::string csv = {};              // the address of the table's CSV; empty: there is none
  // The address of the script that has the rows that are not in the page; empty: all are in it.
  std::string script = {};
  std::string css = {};  // one more class of the whole
  // One more class of a cell, by its row and column; nothing: none has one.
  std::function<std::string(std::size_t, std::size_t)> look = {};
  // HTML that follows a cell's text, by its row and column; nothing: none has any.
  std::function<std::string(std::size_t, std::size_t)> more = {};
};

// Tables of more rows have all but the first few in a script.
inline constexpr std::size_t kRowsInPage = 50, kFirstRows = 20;

// A table with the title, the rows, the notes, and the tools that the page's script brings to life.
// Numbers are shown as people read them, and carry their full value in data-v where that is another
// text. The cells of a column
// with the key "verdict" are coloured by what they say; those of "experiment" lead to the part of
// the page with that id, if there is one.
std::string table_html(const Table& table, const TableSetting& setting = {});

// Head and rows alone, as they are.
std::string plain_table_html(const Table& table);

// The script with all rows of a table, for the page's own to call in.
std::string rows_script(const Table& table, const TableSetting& setting = {});

}  // namespace clipscope::experiments
