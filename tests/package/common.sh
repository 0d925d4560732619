# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash disable=SC2034
#
# What the scripts of this folder share. Sourced with the script's own arguments.
set -euo pipefail

work=$1
root=$2
: "${CMAKE:=cmake}" "${CXX:=c++}"
rm -rf "$work"
mkdir -p "$work"

die() {
  printf 'error: %s\n' "$*" >&2
  exit 1
}

# quietly COMMAND…: its output is shown only if it fails.
quietly() {
  "$@" >"$work/log" 2>&1 || {
    cat "$work/log" >&2
    die "failed: $*"
  }
}

# fenced LANGUAGE FILE: prints the code blocks of that language, each followed by a line with a lone
# form feed.
fenced() {
  awk -v fence="\`\`\`$1" '
    !inside && $1 == fence { inside = 1; indent = match($0, /[^ ]/) - 1; next }
    inside && $1 == "```" { inside = 0; print "\f"; next }
    inside { print substr($0, indent + 1) }' "$2"
}
