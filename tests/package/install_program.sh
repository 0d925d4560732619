#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs the program of a build, the third argument, and has it draw a picture with the module that was
# installed beside it; without the module it says what is missing, and does all else.
# shellcheck source=tests/package/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

prefix=$work/prefix
quietly "$CMAKE" --install "$3" --prefix "$prefix" --component program
program=$prefix/bin/clipscope
module=$(find "$prefix" -name 'clipscope_openimageio.*')
[[ -n $module ]] || die "the module that draws was not installed"

draw=("$program" render --scene corridor --clipper homogeneous/sutherland_hodgman --size "64,36")
quietly "${draw[@]}" --out "$work/corridor.png"
[[ $(head -c 4 "$work/corridor.png") == $'\x89PNG' ]] || die "there is no picture"

# The host of plug-ins is installed where the module is.
clipped=$(echo '0 0 0 1  2 0 0 1  0 1 0 1' |
  "$program" clip --space clip --plugin "$(find "$prefix" -name clipscope_own_plugin.so)")
[[ $clipped == *$'\n'*,1,0,0,1* ]] || die "the installed plug-in clips otherwise: $clipped"

echo "not a module" >"$module"
"$program" list clippers >/dev/null
if "${draw[@]}" --out "$work/none.png" 2>"$work/errors"; then
  die "a picture was drawn without the module"
fi
grep -q OpenImageIO "$work/errors" || die "the error does not name what is missing: $(cat "$work/errors")"
