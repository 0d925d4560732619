#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs the clippers alone, hides CGAL meanwhile, and builds and runs a project that uses them.
# shellcheck source=tests/package/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

prefix=$work/prefix
quietly "$CMAKE" -S "$root" -B "$work/library" -DCLIPSCOPE_PROGRAM=OFF \
  -DCMAKE_DISABLE_FIND_PACKAGE_CGAL=ON -DCMAKE_INSTALL_PREFIX="$prefix"
quietly "$CMAKE" --build "$work/library"
quietly "$CMAKE" --install "$work/library"

[[ -f $prefix/include/clipscope/spaces/clippers.hpp ]] || die "the headers were not installed"
[[ -n $(find "$prefix" -name LICENSE) ]] || die "the licence was not installed"

quietly "$CMAKE" -S "$root/tests/package/consumer" -B "$work/consumer" \
  -DCMAKE_PREFIX_PATH="$prefix"
quietly "$CMAKE" --build "$work/consumer"
"$work/consumer/app"
