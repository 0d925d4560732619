#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Follows "Add a clipper in three steps" of spaces/README.md to the letter in a copy of spaces/.
# Then builds a program that looks the clipper up and runs it; listed as taking less than it does,
# the clipper does not compile.
# shellcheck source=tests/package/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

list=spaces/clippers.hpp
follow_steps "Add a clipper" $list $list "using AllClippers = TriangleClippers<"

quietly "$CMAKE" -S "$root/tests/package/added" -B "$work/build" -DCLIPSCOPE_TREE="$tree"
quietly "$CMAKE" --build "$work/build"
"$work/build/app" "$name"

text=$(<"$tree/$list")
echo "${text/"$entry"/"${entry/ViewAndClip/ViewOnly}"}" >"$tree/$list"
if "$CMAKE" --build "$work/build" >"$work/log" 2>&1; then
  die "a clipper compiles that takes another space than the list says"
fi
grep -q 'other spaces than the list' "$work/log" || die "it is not the list that fails: $(cat "$work/log")"
