// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the paper takes from a run: numbers, tables and figures, as its list of contents asks for
// them.
//
// The list is a JSON object:
//   "values"   [{"name": "Speed", "table": "cost", "column": "ns_per_triangle",
//                "where": {"mix": "soup"}, "take": "max", "format": ".1f"}]
//              a LaTeX macro \Speed of letters; take: first (default), min, max, sum, count;
//              format: as in C++20 and fmt, default: three significant digits
//                "over": {"where": {…}}, "as": "percent more"
//              what it is of another figure, whose entry is the same but for these members; as:
//              ratio (default), percent, percent more
//                "say": [{"below": 1, "text": "slower"}, {"text": "{} times as fast"}]
//              LaTeX in its place: the first phrase whose bound it is below, {} being the number
//              The first row's text, if that column has texts.
//   "tables"   [{"file": "cost", "table": "cost", "where": {…}, "align": "lrr",
//                "columns": {"clipper": "Clipper", …}, "long": false}]
//              or, instead of columns, "pivot": {"rows": "clipper", "columns": "mix",
//              "value": "ns_per_triangle", "head": "Clipper"}
//                "else": "none", LaTeX in place of a table that a run has no row of
//   "figures"  ["cost", "pictures-floor.png"]: stems of plots, or files of pictures;
//              {"if_there": "drivers_gravest.png"}: one that a run may not have
//   "names"    {"soup": "game-like"}: what tables have for these cells
// experiments/report/paper_rows.hpp has what else selects rows of values and tables. Beside these,
// values.tex has macros for every experiment's finding, \finding{cost}, and question,
// \question{cost}, for every claim, \claimverdict{7}, and for the run, \run{machine}.
#pragma once

#include <filesystem>

#include "experiments/store/results_store.hpp"

namespace clipscope::experiments {

// Writes values.tex, a file for each table, and copies of the figures into `out`.
// Errors: InputError naming the list's entry for what is wrong in it or is not in the run;
// OutputError.
void write_paper_inputs(const ResultsStore& store, const std::filesystem::path& contents,
                        const std::filesystem::path& out);

}  // namespace clipscope::experiments
