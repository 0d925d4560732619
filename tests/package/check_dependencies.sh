#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Every header of spaces/ compiles alone, without a warning, and the files it reads belong to spaces/,
# to GLM or to the standard library (whatever <bits/stdc++.h> and the C headers of GLM read). Bodies
# that a source of spaces/ compiles once per instruction set (*-inl.hpp) are no headers, and those of
# spaces/python/ are not for others.
# shellcheck source=tests/package/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

cd "$root"
flags=(-std=c++20 -DGLM_FORCE_XYZW_ONLY -I. -Wall -Wextra -Wpedantic -Werror -fsyntax-only)

# The files that compiling a header alone reads, one per line; those of this tree are relative.
files_read() {
  quietly "$CXX" "${flags[@]}" -MD -MF "$work/read" -x c++ -include "$1" /dev/null
  sed 's|\\$||' "$work/read" | tr -s ' ' '\n' | sed -e '/^$/d' -e '/:$/d' -e 's|^\./||' | sort -u
}

files_read bits/stdc++.h >"$work/allowed"
[[ -s $work/allowed ]] || die "could not list the files of the standard library"

status=0
while IFS= read -r header; do
  files_read "$header" >"$work/files"
  foreign=$(comm -23 "$work/files" "$work/allowed" | grep -v -e '^spaces/' -e '/glm/' || true)
  if [[ -n $foreign ]]; then
    printf '%s reaches:\n%s\n' "$header" "$foreign" >&2
    status=1
  fi
done < <(find spaces -name '*.hpp' -not -name '*-inl.hpp' -not -path 'spaces/python/*' | sort)
exit $status
