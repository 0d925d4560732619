// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rows of a run's tables, selected as the entries of the paper's contents say.
//
// An entry, a JSON object, selects rows by
//   "table"  the table's name
//   "where"  {"mix": "soup"}: those that have these texts
//   "only"   {"clipper": ["a", "b"]}: those with one of these, in this order; each must be there
//   "order"  {"by": "ns", "descending": true}: by that figure; rows without it are left out
//   "top"    5: the first so many of them
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "experiments/store/results_store.hpp"

namespace clipscope::experiments {

using PaperEntry = nlohmann::ordered_json;  // columns stay in the order given

class PaperRows {
 public:
  // names: what the paper calls other things that tables have, by the words of these.
  PaperRows(const ResultsStore& store, PaperEntry names)
      : store_(store), names_(std::move(names)) {}

  // The rows of an entry, each with its cells in the order of `columns`. Errors: MissingFigure
  // where there is no such table, column, or row of "only".
  std::vector<std::vector<Cell>> cells(const PaperEntry& entry,
                                       const std::vector<std::string>& columns) const;
  // The numbers and counts in a column of them. Errors: MissingFigure where there is none.
  std::vector<double> numbers(const PaperEntry& entry, const std::string& column) const;
  // The distinct texts in a column of them, in the order of "only", else of appearance.
  std::vector<std::string> texts(const PaperEntry& entry, const std::string& column) const;

  // What the paper calls a text of that column: clippers and scalars as sentences do.
  std::string name_of(const std::string& column, const std::string& text) const;

 private:
  const Table& table(const std::string& name) const;

  const ResultsStore& store_;
  PaperEntry names_;
  mutable std::map<std::string, Table> tables_;  // each is read once
};

}  // namespace clipscope::experiments
