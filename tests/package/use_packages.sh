#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Uses what the Debian packages put below the folder that is the third argument, found by whatever the
# environment says: the program with a plug-in built by the installed header, a project by CMake and by
# pkg-config, the Python package if it is there. The second argument is a tree that has tests/package/.
# shellcheck source=tests/package/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"
usr=$3

[[ $(command -v clipscope) == "$usr/bin/clipscope" ]] || die "the program is $(command -v clipscope)"
quietly clipscope list clippers
grep -q barycentric/correctly_rounded "$work/log" || die "the program does not list its clippers"

# The examples' bug is found, by the host of plug-ins; ours keeps its promises.
quietly "${CC:-cc}" -shared -fPIC -I "$usr/include/clipscope/spaces/plugin" -o "$work/divide_first.so" \
  "$usr/share/doc/clipscope/examples/c/divide_first.c"
code=0
clipscope verify --plugin "$work/divide_first.so" --space clip --triangles 200 >"$work/log" 2>&1 || code=$?
[[ $code -eq 1 ]] || die "verify ended with $code, where the example's bug is 1: $(<"$work/log")"
quietly clipscope verify --plugin "$usr/lib/clipscope/clipscope_own_plugin.so" --space clip --triangles 200
quietly clipscope render --scene corridor --clipper homogeneous/sutherland_hodgman --size 64,36 \
  --out "$work/corridor.png"

# Another project, by CMake and by pkg-config.
for project in consumer batch_consumer; do
  quietly "$CMAKE" -S "$root/tests/package/$project" -B "$work/$project"
  grep -q "clipscope_DIR:PATH=$usr/" "$work/$project/CMakeCache.txt" || die "CMake found another clipscope"
  quietly "$CMAKE" --build "$work/$project"
  quietly "$work/$project/app"
done
for name in clipscope clipscope-batch; do
  project=$(if [[ $name == *-batch ]]; then echo batch_consumer; else echo consumer; fi)
  read -ra flags <<<"$(pkg-config --cflags --libs "$name")"
  [[ " ${flags[*]} " == *"/clipscope "* ]] || die "pkg-config has no folder of headers: ${flags[*]}"
  quietly "$CXX" -std=c++20 "$root/tests/package/$project/main.cpp" "${flags[@]}" -o "$work/$name"
  quietly "$work/$name"
done

[[ -e $usr/lib/python3/dist-packages/clipscope ]] || exit 0
/usr/bin/python3 -B - "$usr" >"$work/log" 2>&1 <<'END' || die "Python: $(<"$work/log")"
import sys
import clipscope
import clipscope.exact
assert clipscope.__file__.startswith(sys.argv[1]), clipscope.__file__
inside = [[[0, 0, 0, 1], [0.5, 0, 0, 1], [0, 0.5, 0, 1]]]
assert clipscope.clip(inside, space="clip")[0].tolist() == inside[0]
assert clipscope.exact.program() == sys.argv[1] + "/bin/clipscope", clipscope.exact.program()
verdict = clipscope.exact.verify(lambda triangle: triangle, triangles=20)
assert verdict.judged > 0 and not verdict.kept and verdict.error is None, verdict
END
