// SPDX-License-Identifier: GPL-3.0-or-later
//
// The SQL tables of a store, for people who query it: sqlite3 DIR/results.sqlite.
//
// Beside those below, every table of results is an SQL table of its own name with its columns by
// their keys, then cell_id (NULL for rows that belong to no cell) and row_number:
//     SELECT clipper, max_px FROM accuracy WHERE scene = 'teapot'
// A count is an INTEGER, a measured number a REAL with the double's own bits, a text TEXT, an empty
// cell NULL. SQL has no NaN: one is kept as a BLOB of its eight bytes, most significant first.
#pragma once

namespace clipscope::experiments {

// The version of the format below, in PRAGMA user_version; PRAGMA application_id is "CLSC".
inline constexpr int kSchemaVersion = 1;
inline constexpr int kApplicationId = 0x434c5343;

inline constexpr const char* kSchema = R"(
CREATE TABLE run(             -- machine, compiler, flags, commit, seed, started, options, ...
  key TEXT PRIMARY KEY,
  value TEXT NOT NULL);
CREATE TABLE experiment(
  name TEXT PRIMARY KEY,
  position INTEGER NOT NULL,  -- as `clipscope list experiments` orders them
  question TEXT NOT NULL,
  command TEXT NOT NULL,      -- does it again
  state TEXT NOT NULL CHECK(state IN ('running', 'finished')),
  seconds REAL,
  finding TEXT);
CREATE TABLE cell(            -- a piece of an experiment's work that is done
  id INTEGER PRIMARY KEY,
  experiment TEXT NOT NULL REFERENCES experiment(name),
  name TEXT NOT NULL,
  seconds REAL NOT NULL,
  finished TEXT NOT NULL,     -- UTC
  UNIQUE(experiment, name));
CREATE TABLE sample(          -- what the figures were computed from, such as ns of each round
  cell_id INTEGER NOT NULL REFERENCES cell(id) ON DELETE CASCADE,
  series TEXT NOT NULL,
  unit TEXT NOT NULL,
  position INTEGER NOT NULL,
  value);
CREATE INDEX sample_by_cell ON sample(cell_id);
CREATE TABLE worst_input(     -- on which a contestant was farthest off
  cell_id INTEGER NOT NULL REFERENCES cell(id) ON DELETE CASCADE,
  clipper TEXT NOT NULL,
  scalar TEXT NOT NULL,
  measure TEXT NOT NULL,      -- what error is, with its unit
  error,
  input TEXT NOT NULL,        -- options of `clipscope explain`, ' : ', hex floats
  replay TEXT NOT NULL);      -- the command that shows it
CREATE TABLE figure(
  file TEXT PRIMARY KEY,      -- relative to the folder of the run; of a plot its SVG
  experiment TEXT NOT NULL REFERENCES experiment(name),
  cell_id INTEGER REFERENCES cell(id) ON DELETE CASCADE,
  kind TEXT NOT NULL CHECK(kind IN ('plot', 'picture')),
  title TEXT NOT NULL,
  caption TEXT NOT NULL);
CREATE TABLE result_table(
  name TEXT PRIMARY KEY COLLATE NOCASE,
  experiment TEXT NOT NULL REFERENCES experiment(name),
  position INTEGER NOT NULL,
  title TEXT NOT NULL,
  complete INTEGER NOT NULL); -- 0: rows are still missing
CREATE TABLE result_column(
  table_name TEXT NOT NULL COLLATE NOCASE REFERENCES result_table(name),
  position INTEGER NOT NULL,
  key TEXT NOT NULL COLLATE NOCASE,
  head TEXT NOT NULL,         -- for people
  wrap INTEGER NOT NULL,      -- characters of a line on a terminal; 0: any number
  PRIMARY KEY(table_name, position),
  UNIQUE(table_name, key));
CREATE TABLE note(            -- beneath a table
  table_name TEXT NOT NULL COLLATE NOCASE REFERENCES result_table(name),
  position INTEGER NOT NULL,
  text TEXT NOT NULL,
  PRIMARY KEY(table_name, position));
)";

}  // namespace clipscope::experiments
