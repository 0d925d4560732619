#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Follows "Add a batch method in three steps" of spaces/README.md to the letter in a copy of
# spaces/. Then builds a program that looks the method up and clips by it.
# shellcheck source=tests/package/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

follow_steps "Add a batch method" spaces/batch/methods.hpp spaces/batch/batch.hpp \
  "using AllMethods = TypeList<"

# One instruction set without optimisation shows that the method is there, and compiles fast.
quietly "$CMAKE" -S "$root/tests/package/added_method" -B "$work/build" -DCLIPSCOPE_TREE="$tree" \
  -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="-O0 -DHWY_COMPILE_ONLY_STATIC"
quietly "$CMAKE" --build "$work/build"
"$work/build/app" "$name"
