#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Stands for the explorer's tests in a build without it.
echo "The explorer is not built: emscripten, node or its packages are missing; experiments/run explorer sets them up."
[ -n "${CLIPSCOPE_REQUIRE_EXPLORER:-}" ] && exit 1
exit 77
