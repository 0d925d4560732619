// SPDX-License-Identifier: GPL-3.0-or-later
//
// A row of a table is a type. Its columns stand beside its members; headings, cells and reading
// back follow from them, and a column that is not there does not compile.
//
//   struct CostRow {
//     std::string mix, clipper, scalar;
//     std::optional<Timing> timing;  // a group: empty cells where there is none
//     std::int64_t triangles = 0;
//
//     static constexpr std::string_view kName = "cost", kTitle = "Time per triangle";
//     static constexpr std::array kNotes = {"Not timed (-): the answers break the promise."};
//     static constexpr auto columns() {
//       return std::tuple(column("mix", &CostRow::mix),
//                         contestant_columns(&CostRow::clipper, &CostRow::scalar),
//                         group(&CostRow::timing), column("triangles", &CostRow::triangles));
//     }
//   };
//
//   TableOf<CostRow> table;
//   table.add({.mix = "soup", ...});
//   for (const CostRow& row : table.rows()) ...
//
// A member is a text, a count (any integer), a number (double), a yes or no (bool), an enumeration
// whose names_of(E) lists its texts, or an optional of these: an empty cell.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "experiments/table/statistics.hpp"
#include "experiments/table/table.hpp"

namespace clipscope::experiments {

template <class E>
concept Named = std::is_enum_v<E> && requires(E e) {
  names_of(e);
};

// The text of an enumerator; names_of(E) gives the texts in the order of the enumerators.
template <Named E>
constexpr std::string_view name_of(E value) {
  return names_of(value)[static_cast<std::size_t>(value)];
}

// From a member to a cell and back.
template <class V>
struct CellOf;

template <>
struct CellOf<std::string> {
  static Cell write(const std::string& text) { return text; }
  static std::string read(const Cell& cell) { return std::get<std::string>(cell); }
};

template <std::integral I>
struct CellOf<I> {
  static Cell write(I count) { return static_cast<std::int64_t>(count); }
  static I read(const Cell& cell) { return static_cast<I>(std::get<std::int64_t>(cell)); }
};

template <>
struct CellOf<bool> {
  static Cell write(bool yes) { return std::string(yes ? "yes" : "no"); }
  static bool read(const Cell& cell) {
    const std::string& text = std::get<std::string>(cell);
    if (text != "yes" && text != "no") throw MissingFigure("neither yes nor no: " + text);
    return text == "yes";
  }
};

template <>
struct CellOf<double> {
  static Cell write(double number) { return number; }
  static double read(const Cell& cell) { return std::get<double>(cell); }
};

template <Named E>
struct CellOf<E> {
  static Cell write(E value) { return std::string(name_of(value)); }
  static E read(const Cell& cell) {
    const std::string& text = std::get<std::string>(cell);
    for (std::size_t i = 0; i < names_of(E{}).size(); ++i) {
      if (names_of(E{})[i] == text) return static_cast<E>(i);
    }
    throw MissingFigure("no such name: " + text);
  }
};

template <class V>
struct CellOf<std::optional<V>> {
  static Cell write(const std::optional<V>& value) {
    return value ? CellOf<V>::write(*value) : Cell();
  }
  static std::optional<V> read(const Cell& cell) {
    if (std::holds_alternative<std::monostate>(cell)) return std::nullopt;
    return CellOf<V>::read(cell);
  }
};

template <class T>
struct OptionalOf : std::false_type {
  using type = T;
};
template <class T>
struct OptionalOf<std::optional<T>> : std::true_type {
  using type = T;
};

// Where the value is, which may be optional; null if it is not there.
template <class V>
auto* address_of(V& value) {
  if constexpr (OptionalOf<std::remove_const_t<V>>::value) {
    return value ? &*value : nullptr;
  } else {
    return &value;
  }
}

// Whether an optional value is not there, its first cell being empty; it is reset then.
template <class V>
bool read_nothing(const Cell* cells, V& value) {
  if constexpr (OptionalOf<V>::value) value.reset();
  return OptionalOf<V>::value && std::holds_alternative<std::monostate>(*cells);
}

// One member, one column; or a function of the row, whose figure is written, not read back.
template <class Row, class M>
struct MemberColumn {
  using V = std::remove_cvref_t<std::invoke_result_t<M, const Row&>>;
  static constexpr bool kIsRead = std::is_member_object_pointer_v<M>;
  static constexpr std::size_t kCells = 1;

  std::string_view key, head;
  M member;
  std::size_t wrap = 0;  // see Column

  void declare(std::vector<Column>& columns) const {
    columns.push_back({std::string(key), std::string(head), wrap});
  }
  void write(const Row& row, Cell* cells) const {
    *cells = CellOf<V>::write(std::invoke(member, row));
  }
  void read(const Cell* cells, Row& row) const {
    if constexpr (kIsRead) row.*member = CellOf<V>::read(*cells);
  }
  std::string_view key_of(M m) const requires kIsRead { return m == member ? key : ""; }
};

template <class Row, class V>
constexpr auto column(std::string_view key, std::string_view head, V Row::*member,
                      std::size_t wrap = 0) {
  return MemberColumn<Row, V Row::*>{key, head, member, wrap};
}
template <class Row, class V>
constexpr auto column(std::string_view key, V Row::*member) {
  return column(key, key, member);
}
template <class Row, class V>
constexpr auto derived(std::string_view key, std::string_view head, V (Row::*figure)() const) {
  return column(key, head, figure);
}

// A structure of doubles, or an optional of one: a column for each.
template <class Row, class V>
struct NumberColumns {
  static constexpr std::size_t kCells = sizeof(typename OptionalOf<V>::type) / sizeof(double);
  using Numbers = std::array<double, kCells>;
  struct Name {  // in two parts each, one of which all of them may share
    std::string_view key, key_end, head, head_end;
  };

  V Row::*member;
  std::array<Name, kCells> names;

  void declare(std::vector<Column>& columns) const {
    for (const auto& [key, key_end, head, head_end] : names) {
      columns.push_back({std::string(key).append(key_end), std::string(head).append(head_end)});
    }
  }
  void write(const Row& row, Cell* cells) const {
    const auto* const value = address_of(row.*member);
    if (value != nullptr) std::ranges::copy(std::bit_cast<Numbers>(*value), cells);
  }
  void read(const Cell* cells, Row& row) const {
    if (read_nothing(cells, row.*member)) return;
    Numbers numbers;
    for (double& number : numbers) number = std::get<double>(*cells++);
    row.*member = std::bit_cast<typename OptionalOf<V>::type>(numbers);
  }
};

// A median with its interval: three columns, KEY, PREFIX_low and PREFIX_high, so that `diff` knows
// them for one figure (store/diff.hpp). V is MedianInterval or an optional of it.
template <class Row, class V>
constexpr auto interval(std::string_view key, std::string_view prefix, std::string_view head,
                        V Row::*member) {
  return NumberColumns<Row, V>{
      member,
      {{{key, "", head, ""}, {prefix, "_low", "95 % low", ""}, {prefix, "_high", "high", ""}}}};
}

// The columns median_KEY and max_KEY; `head` is their unit as headings have it.
template <class Row>
constexpr auto spread(std::string_view key, std::string_view head,
                      std::optional<Spread> Row::*member) {
  return NumberColumns<Row, std::optional<Spread>>{
      member, {{{"median_", key, "median ", head}, {"max_", key, "max ", head}}}};
}

// An array member: a column for each of its elements, by the names given.
template <class Row, class V, std::size_t N>
struct ArrayColumns {
  static constexpr std::size_t kCells = N;

  std::array<V, N> Row::*member;
  std::array<std::string_view, N> names;

  void declare(std::vector<Column>& columns) const {
    for (const std::string_view name : names) {
      columns.push_back({std::string(name), std::string(name)});
    }
  }
  void write(const Row& row, Cell* cells) const {
    for (const V& value : row.*member) *cells++ = CellOf<V>::write(value);
  }
  void read(const Cell* cells, Row& row) const {
    for (V& value : row.*member) value = CellOf<V>::read(*cells++);
  }
};

template <class Row, class V, std::size_t N>
constexpr auto columns_of_array(std::array<V, N> Row::*member,
                                const std::array<std::string_view, N>& names) {
  return ArrayColumns<Row, V, N>{member, names};
}

template <class C>
inline constexpr std::size_t kCellsOf = C::kCells;
template <class... Cs>
inline constexpr std::size_t kCellsOf<std::tuple<Cs...>> = (0 + ... + kCellsOf<Cs>);

// Calls f(column, its first cell) for each of the columns, which may stand in tuples of their own.
template <class Columns, class F>
constexpr void for_each_column(const Columns& columns, F&& f, std::size_t at = 0) {
  const auto visit = [&]<class C>(const C& each) {
    if constexpr (requires { C::kCells; }) {
      f(each, at);
    } else {
      for_each_column(each, f, at);
    }
    at += kCellsOf<C>;
  };
  std::apply([&](const auto&... each) { (visit(each), ...); }, columns);
}

// A member that has columns of its own. Those of an optional that is not there are empty.
template <class Row, class V, class Columns>
struct GroupColumns {
  using Group = typename OptionalOf<V>::type;
  static constexpr std::size_t kCells = kCellsOf<Columns>;

  V Row::*member;
  Columns columns;

  void declare(std::vector<Column>& declared) const {
    for_each_column(columns, [&](const auto& c, std::size_t) { c.declare(declared); });
  }
  void write(const Row& row, Cell* cells) const {
    const Group* const group = address_of(row.*member);
    if (group == nullptr) return;
    for_each_column(columns, [&](const auto& c, std::size_t at) { c.write(*group, cells + at); });
  }
  void read(const Cell* cells, Row& row) const {
    if (read_nothing(cells, row.*member)) return;
    Group group;
    for_each_column(columns, [&](const auto& c, std::size_t at) { c.read(cells + at, group); });
    row.*member = std::move(group);
  }
};

// The group's own columns, or those given.
template <class Row, class V, class Columns>
constexpr auto group(V Row::*member, const Columns& columns) {
  return GroupColumns<Row, V, Columns>{member, columns};
}
template <class Row, class V>
constexpr auto group(V Row::*member) {
  return group(member, OptionalOf<V>::type::columns());
}

template <class Row>
std::vector<Column> columns_of() {
  std::vector<Column> columns;
  for_each_column(Row::columns(), [&](const auto& c, std::size_t) { c.declare(columns); });
  return columns;
}

template <class Row>
std::vector<Cell> cells_of(const Row& row) {
  std::vector<Cell> cells(kCellsOf<decltype(Row::columns())>);
  for_each_column(Row::columns(), [&](const auto& c, std::size_t at) { c.write(row, &cells[at]); });
  return cells;
}

// The rows of a table in its erased form, as a store gives it back. The table may have further
// columns. Errors: MissingFigure, where a column is not there or holds something else.
template <class Row>
std::vector<Row> rows_of(const Table& table) {
  std::vector<std::size_t> places;
  for (const Column& column : columns_of<Row>()) places.push_back(place_of(table, column.key));
  std::vector<Row> rows;
  std::vector<Cell> cells(places.size());
  for (const std::vector<Cell>& source : table.rows()) {
    for (std::size_t i = 0; i < places.size(); ++i) cells[i] = source[places[i]];
    try {
      Row& row = rows.emplace_back();
      for_each_column(Row::columns(),
                      [&](const auto& c, std::size_t at) { c.read(&cells[at], row); });
    } catch (const std::bad_variant_access&) {
      throw MissingFigure("table " + table.name() +
                          ": a cell holds something else than its column says");
    }
  }
  return rows;
}

// A table whose rows are of one type.
template <class Row>
class TableOf : public Table {
 public:
  TableOf() : TableOf(std::string(Row::kName), std::string(Row::kTitle)) {}
  // A table whose row type other tables have too.
  TableOf(std::string name, std::string title)
      : Table(std::move(name), std::move(title), columns_of<Row>()) {
    if constexpr (requires { Row::kNotes; }) {
      for (const std::string_view note : Row::kNotes) add_note(std::string(note));
    }
  }
  void add(const Row& row) { add_row(cells_of(row)); }
  std::vector<Row> rows() const { return rows_of<Row>(static_cast<const Table&>(*this)); }
};

// The key of the column that shows a member; empty for one that has no column of its own.
template <class Row, class M>
std::string_view key_of(M member) {
  std::string_view key;
  for_each_column(Row::columns(), [&](const auto& c, std::size_t) {
    if constexpr (requires { c.key_of(member); }) {
      if (key.empty()) key = c.key_of(member);
    }
  });
  return key;
}

// What is asked of a row, as pairs of a member and a value, and then how it is told in a message:
// matches(row, &Row::mix, "soup", &Row::clipper, "textbook"); " mix=soup clipper=textbook".
template <class Row>
bool matches(const Row&) {
  return true;
}
template <class Row, class M, class V, class... Rest>
bool matches(const Row& row, M member, const V& value, const Rest&... rest) {
  return std::invoke(member, row) == value && matches(row, rest...);
}
template <class Row>
std::string conditions_text() {
  return "";
}
template <class Row, class M, class V, class... Rest>
std::string conditions_text(M member, const V& value, const Rest&... rest) {
  std::string text = " " + std::string(key_of<Row>(member)) + "=";
  if constexpr (std::convertible_to<V, std::string_view>) {
    text += std::string_view(value);
  } else {
    text += format_cell(CellOf<V>::write(value));
  }
  return text + conditions_text<Row>(rest...);
}

// The first row that has the values; null if there is none.
template <class Row, class... Conditions>
const Row* find_row(const std::vector<Row>& rows, const Conditions&... conditions) {
  for (const Row& row : rows) {
    if (matches(row, conditions...)) return &row;
  }
  return nullptr;
}

// The rows that have the values, in their order.
template <class Row, class... Conditions>
std::vector<Row> rows_where(std::vector<Row> rows, const Conditions&... conditions) {
  std::erase_if(rows, [&](const Row& row) { return !matches(row, conditions...); });
  return rows;
}

// The values of a member, each once, in the order of the rows.
template <class Row, class M>
auto distinct(const std::vector<Row>& rows, M member) {
  std::vector<std::remove_cvref_t<std::invoke_result_t<M, const Row&>>> values;
  for (const Row& row : rows) {
    const auto& value = std::invoke(member, row);
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
  }
  return values;
}

}  // namespace clipscope::experiments
