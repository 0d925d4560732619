#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The interface of plug-ins compiles alone, without a warning, as C99 and as C++20; a plug-in in C exports one
# function by it.
# shellcheck source=tests/package/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

header=$root/spaces/plugin/clipscope_plugin.h
warnings=(-Wall -Wextra -Wpedantic -Werror)
quietly "${CC:-cc}" -std=c99 "${warnings[@]}" -fsyntax-only -x c "$header"
quietly "$CXX" -std=c++20 "${warnings[@]}" -fsyntax-only -x c++ -include "$header" /dev/null

cat >"$work/mine.c" <<'END'
#include "clipscope_plugin.h"

static int32_t clip(const clipscope_task* task, clipscope_answer* answer) {
  for (size_t i = 0; i < task->count; ++i) answer->ends[i] = 0;
  return CLIPSCOPE_DONE;
}

static const clipscope_plugin plugin = {
    sizeof(clipscope_plugin), CLIPSCOPE_PLUGIN_ABI, "mine", "draws nothing", NULL,
    CLIPSCOPE_FLOAT | CLIPSCOPE_CLIP_SPACE | CLIPSCOPE_TRIANGLES | CLIPSCOPE_DEPTH_ZERO_TO_ONE, 0, clip};

const clipscope_plugin* clipscope_plugin_entry(uint32_t abi_version) {
  return abi_version == CLIPSCOPE_PLUGIN_ABI ? &plugin : NULL;
}
END
quietly "${CC:-cc}" -std=c99 "${warnings[@]}" -shared -fPIC -fvisibility=hidden -I "${header%/*}" \
  -o "$work/mine.so" "$work/mine.c"
exported=$(nm --dynamic --defined-only "$work/mine.so" | awk '{ print $3 }')
[[ $exported == clipscope_plugin_entry ]] || die "a plug-in exports '$exported'"
