#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs the headers and the batch clippers of a build, the third argument, and builds and runs a
# project that uses them.
# shellcheck source=tests/package/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

prefix=$work/prefix
for component in spaces batch; do
  quietly "$CMAKE" --install "$3" --prefix "$prefix" --component "$component"
done
quietly "$CMAKE" -S "$root/tests/package/batch_consumer" -B "$work/consumer" \
  -DCMAKE_PREFIX_PATH="$prefix"
quietly "$CMAKE" --build "$work/consumer"
"$work/consumer/app"
