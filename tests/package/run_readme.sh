#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Runs the `sh` blocks of README.md, of the command reference, of the walk through plug-ins and of
# experiments/cluster/, each document in a folder that has nothing but experiments/ and spaces/, with
# the program given on the PATH. A line that starts with ./ is a script of the source tree: it must
# exist, be executable and parse, and is not run here. A line that ends in "# exit code N" must end
# with that. What a `text` block shows right after a block must be among what that block printed,
# line by line; "..." is any text. Commands with rustc are left out where there is none.
# shellcheck source=tests/package/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

PATH=$(dirname -- "$3"):$PATH
export PATH

has_rust=
if rustc --version >/dev/null 2>&1; then has_rust=yes; fi

# split_blocks DOCUMENT FOLDER: each `sh` block as NN.sh, the `text` block right after it as NN.text.
split_blocks() {
  awk -v folder="$2" '
    !inside && $1 == "```sh" { inside = 1; file = sprintf("%s/%02d.sh", folder, ++n); next }
    !inside && $1 == "```text" && follows { inside = 1; file = sprintf("%s/%02d.text", folder, n); next }
    inside && $1 == "```" { follows = file ~ /sh$/; inside = 0; next }
    inside { print > file; next }
    /[^[:space:]]/ { follows = 0 }' "$1"
}

# check_printed DOCUMENT TEXT: fails unless all lines of the text block were printed.
check_printed() {
  local document=$1 text=$2 line
  [[ -e $text ]] || return 0
  while IFS= read -r line; do
    line=$(sed -E 's/[][\\.*^$+?(){}|]/\\&/g; s/\\\.\\\.\\\./.*/g' <<<"$line")
    grep -qE "^$line\$" "$work/log" && continue
    cat "$work/log" >&2
    die "$document shows a line that was not printed: $line"
  done <"$text"
}

# run_document FILE LEAST: fails unless at least so many blocks and scripts were tried.
run_document() {
  local document=$1 least=$2 folder commands=0 block script
  folder=$work/${document//\//_}
  mkdir -p "$folder/blocks" "$folder/run"
  split_blocks "$root/$document" "$folder/blocks"
  cd "$folder/run"
  ln -s "$root/experiments" "$root/spaces" .
  for block in "$folder"/blocks/*.sh; do
    while read -r script _; do
      [[ -x $root/$script ]] || die "$document shows $script, which is not an executable file"
      bash -n "$root/$script"
      commands=$((commands + 1))
    done < <(grep '^\./' "$block" || true)
    # shellcheck disable=SC2016  # what the block runs
    sed -i -E '/^\.\//d; /^git clone /d; /^cd /d
      s/^(.*[^ ]) +# exit code ([0-9]+)$/code=0; { \1; } || code=$?; [ $code = \2 ]/' "$block"
    [[ $has_rust ]] || sed -i '/^rustc /,/[^\\]$/d; /eight_vertices/d' "$block"
    grep -q '[^[:space:]]' "$block" || continue
    echo "--- $(<"$block")"
    bash -euo pipefail "$block" >"$work/log" 2>&1 || {
      cat "$work/log" >&2
      die "this block of $document failed: $(<"$block")"
    }
    check_printed "$document" "${block%.sh}.text"
    commands=$((commands + 1))
  done
  [[ $commands -ge $least ]] || die "$document shows $commands commands; it should show more"
}

run_document README.md 3
run_document experiments/commands/README.md 20
run_document experiments/plugins/README.md 6
run_document experiments/cluster/README.md 1
