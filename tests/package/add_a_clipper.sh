#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Follows "Add a clipper in three steps" of spaces/README.md to the letter in a copy of spaces/:
# its code blocks are, in this order, the header, the #include and the entry of the list. The header
# goes where the #include says. Then builds a program that looks the clipper up and runs it; listed as
# taking less than it does, the clipper does not compile.
# shellcheck source=tests/package/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

tree=$work/tree
mkdir "$tree"
cp -r "$root/CMakeLists.txt" "$root/spaces" "$tree"

sed -n '/^## Add a clipper/,/^## /{/^## Add/!{/^## /!p}}' "$root/spaces/README.md" >"$work/steps.md"
fenced cpp "$work/steps.md" | awk -v RS='\f\n' -v work="$work" '{ printf "%s", $0 > (work "/block" NR) }'
for block in 1 2 3; do
  [[ -s $work/block$block ]] || die "spaces/README.md: code block $block of the three steps is missing"
done
[[ ! -e $work/block4 ]] || die "spaces/README.md: the three steps show more than three code blocks"

include=$(<"$work/block2")
entry=$(<"$work/block3")
path=$(sed -n 's/^#include "\(.*\)"$/\1/p' <<<"$include")
[[ -n $path ]] || die "spaces/README.md: the second code block is no #include: $include"
name=$(sed -n 's/.*std::string_view name = "\(.*\)";.*/\1/p' "$work/block1")
[[ -n $name ]] || die "spaces/README.md: the clipper of the first code block has no name"
[[ ! -e $tree/$path ]] || die "spaces/README.md: the example $path exists already"

cp "$work/block1" "$tree/$path"
list=$tree/spaces/clippers.hpp
awk -v include="$include" -v entry="$entry" '
  /^#include "/ && !done { print include; done = 1 }
  { if (sub(/using AllClippers = TriangleClippers</, "&\n" entry "\n")) listed = 1; print }
  END { exit !(done && listed) }' "$root/spaces/clippers.hpp" >"$list" ||
  die "spaces/clippers.hpp has no #include or no list where spaces/README.md says"

quietly "$CMAKE" -S "$root/tests/package/added" -B "$work/build" -DCLIPSCOPE_TREE="$tree"
quietly "$CMAKE" --build "$work/build"
"$work/build/app" "$name"

text=$(<"$list")
echo "${text/"$entry"/"${entry/ViewAndClip/ViewOnly}"}" >"$list"
if "$CMAKE" --build "$work/build" >"$work/log" 2>&1; then
  die "a clipper compiles that takes another space than the list says"
fi
grep -q 'other spaces than the list' "$work/log" || die "it is not the list that fails: $(cat "$work/log")"
