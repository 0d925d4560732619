#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Runs the `sh` blocks of README.md in an empty folder with the program given on the PATH. A line
# that starts with ./ is a script of the source tree: it must exist, be executable and parse, and is
# not run here.
# shellcheck source=tests/package/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

PATH=$(dirname -- "$3"):$PATH
export PATH

mkdir "$work/blocks" "$work/run"
fenced sh "$root/README.md" |
  awk -v RS='\f\n' -v work="$work" '{ printf "%s", $0 > sprintf("%s/blocks/%02d", work, NR) }'
cd "$work/run"
commands=0
for block in "$work"/blocks/*; do
  while read -r script _; do
    [[ -x $root/$script ]] || die "README.md shows $script, which is not an executable file"
    bash -n "$root/$script"
    commands=$((commands + 1))
  done < <(grep '^\./' "$block" || true)
  sed -i '/^\.\//d; /^git clone /d; /^cd /d' "$block"
  grep -q '[^[:space:]]' "$block" || continue
  echo "--- $(<"$block")"
  bash -euo pipefail "$block" >"$work/log" 2>&1 || {
    cat "$work/log" >&2
    die "this block of README.md failed: $(<"$block")"
  }
  commands=$((commands + 1))
done
[[ $commands -ge 3 ]] || die "README.md shows $commands commands; it should show more"
