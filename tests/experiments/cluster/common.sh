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

# Sets `sweep` to the command of the program, and `mishaps` to the same of a program that meets with
# mishaps: shard 1 is killed once in the middle of its work, and, by Slurm, shard 0 stands still once.
set_sweep() { # PROGRAM
  [[ -x $1 ]] || fail "there is no program $1"
  local arguments=(sweep --lattice small --quick --clipper '*/sutherland_hodgman' --scalar "float,double")
  sweep=("$1" "${arguments[@]}")
  # shellcheck disable=SC2034  # for the tests
  mishaps=("$work/clipscope" "${arguments[@]}")
  cat >"$work/clipscope" <<END
#!/usr/bin/env bash
set -u
all="\$* "
out=\${all#*--out }
out=\${out%% *}
case " \$all" in
  *" --shard 1/"*)
    if mkdir "$work/killed" 2>/dev/null; then
      "$1" "\$@" &
      while [[ ! -s \$out/results.sqlite ]] && kill -0 \$!; do sleep 0.01; done
      kill -9 \$! || touch "$work/was_too_quick"
      wait \$!
      exit
    fi ;;
  *" --shard 0/"*)
    if [[ -n \${SLURM_JOB_ID:-} ]] && mkdir "$work/stands_still" 2>/dev/null; then exec sleep 600; fi ;;
esac
exec "$1" "\$@"
END
  chmod +x "$work/clipscope"
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

# That the results are those of one process, though the mishaps happened.
check_same_table() {
  [[ -e $work/killed && ! -e $work/was_too_quick ]] || fail "nothing was killed"
  "${sweep[@]}" --out "$work/alone" >/dev/null 2>&1
  for file in lattice_small.csv lattice_small.md lattice_small.tex; do
    cmp "$work/alone/$file" "$results/whole/$file" || fail "$file differs"
  done
  [[ -s $results/whole/lattice_small.csv ]] || fail "no table"
  left=$(find "$CLIPSCOPE_SCRATCH" -mindepth 1 | wc -l)
  [[ $left -eq 0 ]] || fail "$left files are left in the scratch folder"
}
