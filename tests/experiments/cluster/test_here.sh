#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Usage: test_here.sh SPREAD PROGRAM. Shards on this machine, one of which is killed.
set -euo pipefail
# shellcheck source=tests/experiments/cluster/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"
trap 'rm -rf "$work"' EXIT
spread=$1
set_sweep "$2"

"$spread" here "$results" 5 "${mishaps[@]}" >"$work/log" 2>&1 || {
  cat "$work/log" >&2
  fail "spread here"
}
check_same_table

# What is there is not done again, and a command that fails always ends with an error.
before=$(stat -c %Y "$results/shards/0/results.sqlite")
"$spread" here "$results" 5 "${mishaps[@]}" >/dev/null 2>&1
[[ $(stat -c %Y "$results/shards/0/results.sqlite") == "$before" ]] || fail "done again"
if CLIPSCOPE_TRIES=2 "$spread" here "$work/none" 2 false >"$work/log" 2>&1; then
  fail "shards that fail are no error"
fi
grep -q 'these shards failed 2 times: 0 1' "$work/log" || fail "the failed shards are not named"
