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

# follow_steps HEADING INCLUDES LIST OPENING: the section of spaces/README.md has three code blocks:
# a header, its #include for the file INCLUDES, and its entry for what begins with OPENING in the
# file LIST. Copies spaces/ to $tree and does there what they show; sets $name and $entry.
follow_steps() {
  local heading=$1 includes=$2 list=$3 opening=$4 block include path
  tree=$work/tree
  mkdir "$tree"
  cp -r "$root/CMakeLists.txt" "$root/spaces" "$tree"

  sed -n "/^## $heading/,/^## /{/^## $heading/!{/^## /!p}}" "$root/spaces/README.md" \
    >"$work/steps.md"
  fenced cpp "$work/steps.md" |
    awk -v RS='\f\n' -v work="$work" '{ printf "%s", $0 > (work "/block" NR) }'
  for block in 1 2 3; do
    [[ -s $work/block$block ]] || die "$heading: code block $block of the three steps is missing"
  done
  [[ ! -e $work/block4 ]] || die "$heading: the three steps show more than three code blocks"

  include=$(<"$work/block2")
  entry=$(<"$work/block3")
  path=$(sed -n 's/^#include "\(.*\)"$/\1/p' <<<"$include")
  [[ -n $path ]] || die "$heading: the second code block is no #include: $include"
  name=$(sed -n 's/.*std::string_view name = "\(.*\)";.*/\1/p' "$work/block1")
  [[ -n $name ]] || die "$heading: the type of the first code block has no name"
  [[ ! -e $tree/$path ]] || die "$heading: the example $path exists already"

  cp "$work/block1" "$tree/$path"
  awk -v include="$include" '
    /^#include "/ && !done { print include; done = 1 }
    { print }
    END { exit !done }' "$root/$includes" >"$tree/$includes" ||
    die "$heading: $includes includes nothing"
  awk -v entry="$entry" -v opening="$opening" '
    { print }
    index($0, opening) { print entry; done = 1 }
    END { exit !done }' "$tree/$list" >"$work/list" ||
    die "$heading: $list has no list that says $opening"
  cp "$work/list" "$tree/$list"
}
