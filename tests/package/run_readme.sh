#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Runs the `sh` blocks of README.md and of the command reference, each document in an empty folder,
# with the program given on the PATH. A line that starts with ./ is a script of the source tree: it must
# exist, be executable and parse, and is not run here.
# shellcheck source=tests/package/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

PATH=$(dirname -- "$3"):$PATH
export PATH

# run_document FILE LEAST: fails unless at least so many blocks and scripts were tried.
run_document() {
  local document=$1 least=$2 folder commands=0 block script
  folder=$work/${document//\//_}
  mkdir -p "$folder/blocks" "$folder/run"
  fenced sh "$root/$document" |
    awk -v RS='\f\n' -v folder="$folder" '{ printf "%s", $0 > sprintf("%s/blocks/%02d", folder, NR) }'
  cd "$folder/run"
  for block in "$folder"/blocks/*; do
    while read -r script _; do
      [[ -x $root/$script ]] || die "$document shows $script, which is not an executable file"
      bash -n "$root/$script"
      commands=$((commands + 1))
    done < <(grep '^\./' "$block" || true)
    sed -i '/^\.\//d; /^git clone /d; /^cd /d' "$block"
    grep -q '[^[:space:]]' "$block" || continue
    echo "--- $(<"$block")"
    bash -euo pipefail "$block" >"$work/log" 2>&1 || {
      cat "$work/log" >&2
      die "this block of $document failed: $(<"$block")"
    }
    commands=$((commands + 1))
  done
  [[ $commands -ge $least ]] || die "$document shows $commands commands; it should show more"
}

run_document README.md 3
run_document experiments/commands/README.md 20
