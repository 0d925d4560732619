#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Holds every #include to the layering of experiments/CMakeLists.txt: spaces/ knows itself, reference/
# also spaces/, a room of experiments/ also both and the rooms before it. A question knows no other; the
# last three, history, claims and answers, read those before them. Programs of their own, example/ and
# explorer/, read what they like, and nobody reads them.
# Usage: check_layers.sh SOURCE_DIR "ROOM ..." "QUESTION ..." "ROOM ...", the last above the questions.
set -eu
cd "$1"

grep -rHoE '^#include "(spaces|reference|experiments)/[a-z_]+' spaces reference experiments \
    --include=*.hpp --include=*.cpp --include=*.in |
  awk -F'[:"]' -v below="$2" -v questions="$3" -v above="$4" '
    # A file or an include by its room, "experiments/clock/clock.cpp" by "clock"; those of spaces/ and
    # reference/, and the sources of experiments/ itself, by their folder.
    function room_of(path, parts) {
      split(path, parts, "/")
      return parts[1] == "experiments" && parts[2] !~ /\./ ? parts[2] : parts[1]
    }
    BEGIN {
      count = split("spaces reference " below " " questions " " above " experiments", rooms, " ")
      for (i = 1; i <= count; ++i) level[rooms[i]] = i
      n = split(questions, list, " ")
      for (i = 1; i < n - 2; ++i) is_question[list[i]] = 1
    }
    {
      from = room_of($1); to = room_of($3); ++seen[from]
      if (from == to || from == "example" || from == "explorer") next
      if (!(from in level) || !(to in level)) problem = "stands in no list of rooms"
      else if (is_question[from] && is_question[to]) problem = "is another question"
      else if (level[to] > level[from]) problem = "is a room above"
      else next
      print $1 " includes " $3 ", which " problem
      failed = 1
    }
    END {
      for (room in level) {
        if (seen[room] || room == "experiments") continue
        print room " was not looked at"
        failed = 1
      }
      exit failed
    }'

# shellcheck disable=SC2016 # the backquotes are Markdown's
listed=$(sed -n 's/^| `\([a-z_]*\)\/` |.*/\1/p; s/^| questions |.*/questions/p' experiments/README.md | xargs)
if [ "$listed" != "$2 questions $4" ]; then
  echo "experiments/README.md lists the rooms: $listed"
  echo "experiments/CMakeLists.txt has:        $2 questions $4"
  exit 1
fi
echo "every include leads down"
