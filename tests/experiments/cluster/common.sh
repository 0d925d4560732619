# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
#
# What the tests of experiments/cluster/ share: a folder of the test, a sweep of some seconds, and
# the comparison with the sweep that was not spread. Sourced, never run.

work=$(mktemp -d "${TMPDIR:-/tmp}/clipscope-cluster.XXXXXX")
results=$work/results
export CLIPSCOPE_SCRATCH=$work/scratch
mkdir -p "$CLIPSCOPE_SCRATCH"

fail() {
  printf 'FAILED: %s\n' "$*" >&2
  exit 1
}

# Sets `sweep` to the command.
set_sweep() { # PROGRAM
  sweep=("$1" sweep --lattice small --quick --scalar "float,double")
}

# Waits until the command succeeds; fails after so many seconds.
wait_for() { # SECONDS WHAT COMMAND…
  local left=$(($1 * 5)) what=$2
  shift 2
  until "$@" >/dev/null 2>&1; do
    ((left-- > 0)) || fail "$what: not after the time given"
    sleep 0.2
  done
}

# The process that does a shard, once there is one.
process_of() { # SHARD/N
  local file
  for _ in $(seq 1200); do
    for file in /proc/[0-9]*/cmdline; do
      [[ $({ tr '\0' ' ' <"$file"; } 2>/dev/null) == "${sweep[0]} "*"--shard $1 "* ]] || continue
      file=${file%/cmdline}
      printf '%s\n' "${file#/proc/}"
      return
    done
    sleep 0.02
  done
  fail "no process does shard $1"
}

check_same_table() {
  "${sweep[@]}" --out "$work/alone" >/dev/null 2>&1
  for file in lattice_small.csv lattice_small.md lattice_small.tex; do
    cmp "$work/alone/$file" "$results/whole/$file" || fail "$file differs"
  done
  [[ -s $results/whole/lattice_small.csv ]] || fail "no table"
  left=$(find "$CLIPSCOPE_SCRATCH" -mindepth 1 | wc -l)
  [[ $left -eq 0 ]] || fail "$left files are left in the scratch folder"
}
