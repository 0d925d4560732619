#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs the Python package of a build, the third argument, in both ways: by `cmake --install`, and by pip
# as a wheel that pyproject.toml's backend makes of it. Each is imported from where it was installed. The
# fourth argument is the Python.
# shellcheck source=tests/package/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"
build=$3 python=$4

# try FOLDER: the package there clips, and knows its cases.
try() {
  (cd "$work" && PYTHONPATH=$1 "$python" -B - "$1") <<'END'
import sys
import clipscope
import clipscope.exact
assert clipscope.__file__.startswith(sys.argv[1]), clipscope.__file__
inside = [[[0, 0, 0, 1], [0.5, 0, 0, 1], [0, 0.5, 0, 1]]]
assert clipscope.clip(inside, space="clip")[0].tolist() == inside[0]
assert len(clipscope.exact.catalogue()) > 300
END
}

quietly "$CMAKE" --install "$build" --component python --prefix "$work/prefix"
try "$(dirname "$(dirname "$(find "$work/prefix" -path '*clipscope/__init__.py')")")"

quietly "$python" -m venv --system-site-packages "$work/env"
quietly "$work/env/bin/pip" install "$root" --no-build-isolation --no-deps --no-index \
  --config-settings "build-dir=$build"
try "$("$work/env/bin/python" -c 'import sysconfig; print(sysconfig.get_path("platlib"))')"
"$work/env/bin/pip" uninstall --yes clipscope >"$work/log" 2>&1
[[ -z $(find "$work/env" -path '*clipscope/*.py') ]] || die "files are left after pip uninstall"
