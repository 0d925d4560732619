#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Contestants are compiled as a renderer compiles the clippers, and what was compiled so is what runs.
#   - No source of theirs reads a header of CGAL, and their flags are those that timings are recorded with.
#   - Every function of a template that they compile stands in the program as they compiled it. Rooms with
#     other flags compile some of them, too, and the linker keeps one.
#   - What is compiled once more with other flags (experiments/cost/builds) is used by nothing else.
# Usage: check_compiled.sh BUILD_DIR MAP "FLAGS". The map is the linker's, of the program.
set -eu
build=$1 map=$2 recorded=$3
objects=$build/experiments/contestants/CMakeFiles/clipscope_compiled.dir
failed=0
complain() {
  printf '%s\n' "$*"
  failed=1
}

commands=$(mktemp)
trap 'rm -f "$commands" "$commands".*' EXIT
sed -n 's/^ *"command": "\(.*clipscope_compiled\.dir.*\)",$/\1/p' "$build/compile_commands.json" >"$commands"
[ -s "$commands" ] || { echo "no source of clipscope_compiled in $build/compile_commands.json"; exit 1; }

while IFS= read -r command; do
  source=${command##* }
  for flag in $recorded; do
    case " $command " in *" $flag "*) ;; *) complain "$source is compiled without $flag" ;; esac
  done
  case $command in
    *-frounding-math* | *-fno-tree-slp-vectorize*) complain "$source is compiled with a flag of CGAL, or a work-around" ;;
  esac
  (cd "$build" && eval "$(printf '%s' "$command" | sed 's/ -o [^ ]* -c / -M /')") >"$commands.read"
  grep -q 'experiments/contestants' "$commands.read" || complain "what $source reads was not listed"
  ! grep -q 'CGAL/' "$commands.read" || complain "$source reads $(grep -o '[^ ]*CGAL/[^ ]*' "$commands.read" | head -n 1)"
done <"$commands"

# Weak: functions of templates, and inline ones.
nm --defined-only "$objects"/*.o | awk '$2 == "W" && /9clipscope/ { print $3 }' | sort -u >"$commands.weak"
awk '
  FILENAME != ARGV[2] { is_ours[$1] = 1; next }
  /^Linker script and memory map/ { in_map = 1 }
  !in_map { next }
  /^ \.text[.a-z]*\._Z/ { section = $1; sub(/^\.text(\.unlikely|\.hot)?\./, "", section) }
  section != "" && match($0, /0x[0-9a-f]+ +0x[0-9a-f]+ .+/) {
    from = $NF
    if (section in is_ours) {
      ++kept
      if (from !~ /clipscope_compiled\.dir/) { print section " of " from; failed = 1 }
    } else if (from ~ /cost.*build\.cpp/ && section !~ /clipscope_|6builds/) {
      print section " of a build with other flags"; failed = 1
    }
    section = ""
  }
  /^ [^ ]/ && !/^ \.text/ { section = "" }
  END {
    printf "%d functions of templates run as contestants compile them\n", kept
    if (kept < 100) { print "these are too few: was the map read?"; failed = 1 }
    exit failed
  }' "$commands.weak" "$map" || failed=1
exit "$failed"
