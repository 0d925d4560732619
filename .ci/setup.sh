# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
#
# The steps that experiments/run, tests/run and .ci/run share: packages, configure, build.
# Sourced, never run. It finds the source tree by its own place, so it works from any directory.
#
# CLIPSCOPE_PRESET chooses the CMake preset (default: release); it builds in build/<preset>.

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
preset=${CLIPSCOPE_PRESET:-release}
build_dir=$root/build/$preset

packages=(
  g++ cmake ninja-build git ca-certificates
  libcgal-dev libgmp-dev libmpfr-dev          # exact arithmetic, polyhedra
  libglm-dev libqd-dev                        # vectors, double-double
  libhwy-dev                                  # SIMD
  libopenimageio-dev fonts-dejavu-core        # pictures and the text in them
  libcairo2-dev                               # vector graphics
  openimageio-tools libopencv-core-dev        # OpenImageIO's CMake package names files of these
  libwebp-dev                                 # pictures within a page
  libepoxy-dev libegl1 libgl1-mesa-dri        # OpenGL without a window, and drivers in software
  libboost-dev                                # search trees
  libcli11-dev nlohmann-json3-dev libfmt-dev  # command line, output
  libtbb-dev                                  # threads
  libsqlitecpp-dev libsqlite3-dev             # results store
  gnuplot-nox                                 # plots
  catch2 libbenchmark-dev                     # tests, timing
  python3                                     # an example of a program as a clipper
  dpkg-dev                                    # what packages depend on
)
python_packages=(python3-dev python3-numpy python3-venv pybind11-dev) # of the Python package
# shellcheck disable=SC2034  # for the scripts
explorer_packages=(emscripten) # of the explorer, beside node and npm (set_up_npm)
# shellcheck disable=SC2034  # for the scripts
sanitize_packages=(clang-14 libclang-rt-14-dev) # of the preset `sanitize`

# One line per step, with the seconds since the start.
say() {
  printf '[%4d s] %s\n' "$SECONDS" "$*"
}

fail() {
  printf '[%4d s] %s\n' "$SECONDS" "$*" >&2
  exit 1
}

# Prints the packages among the arguments that are not installed.
missing_packages() {
  local package status
  for package in "$@"; do
    # shellcheck disable=SC2016  # the braces are dpkg-query's
    status=$(LC_ALL=C dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null) || true
    grep -qx installed <<<"$status" || printf '%s\n' "$package"
  done
}

# Installs those of the packages given that are missing; no network when none is.
install_packages() {
  local missing log as_root=()
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    say "packages: not a Debian system, so nothing is installed; the build needs what Debian calls: $*"
    return
  fi
  mapfile -t missing < <(missing_packages "$@")
  if [[ ${#missing[@]} -eq 0 ]]; then
    say "packages: all $# are installed"
    return
  fi
  if [[ $(id -u) -ne 0 ]]; then
    if ! command -v sudo >/dev/null || { ! sudo -n true 2>/dev/null && [[ ! -t 0 ]]; }; then
      fail "packages: these are missing, and installing them needs root or sudo: ${missing[*]}
         As root, run: apt-get update && apt-get install --no-install-recommends ${missing[*]}"
    fi
    as_root=(sudo)
  fi
  mkdir -p "$root/build"
  log=$root/build/packages.log
  say "packages: installing ${#missing[@]} that are missing: ${missing[*]} (log: $log)"
  {
    "${as_root[@]}" apt-get -o DPkg::Lock::Timeout=300 update &&
      "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 \
        install --yes --no-install-recommends "${missing[@]}"
  } >"$log" 2>&1 </dev/null || {
    tail -n 20 "$log" >&2
    fail "packages: apt-get failed (the end of $log is above)"
  }
  say "packages: installed"
}

# Node and its packages for the explorer. Whoever has node from elsewhere has npm with it, and Debian's
# would not go together with that.
set_up_npm() {
  local folder=$root/experiments/explorer log=$root/build/npm.log node_packages=()
  command -v node >/dev/null || node_packages+=(nodejs)
  command -v npm >/dev/null || node_packages+=(npm)
  [[ ${#node_packages[@]} -eq 0 ]] || install_packages "${node_packages[@]}"
  if [[ $folder/node_modules/.package-lock.json -nt $folder/package-lock.json ]]; then
    say "npm: the packages of package-lock.json are there"
    return
  fi
  mkdir -p "$root/build"
  say "npm: ci in experiments/explorer (log: $log)"
  npm ci --prefix "$folder" --no-audit --no-fund >"$log" 2>&1 </dev/null || {
    tail -n 20 "$log" >&2
    fail "npm: failed (the end of $log is above)"
  }
}

# How many compilers may run at once: one per core and per 2 GB of memory, since sources that use
# CGAL take that much.
build_jobs() {
  local cores gigabytes
  cores=$(nproc)
  gigabytes=$(awk '/^MemAvailable:/ { print int($2 / 1e6) }' /proc/meminfo 2>/dev/null) || true
  local by_memory=$((${gigabytes:-4} / 2))
  local jobs=$((by_memory < cores ? by_memory : cores))
  echo $((jobs > 0 ? jobs : 1))
}

# Configures the preset unless that was done for this tree and these presets already. Ninja itself
# configures again when a CMakeLists.txt changes.
configure() {
  local log=$root/build/$preset-configure.log fresh=()
  mkdir -p "$root/build"
  if [[ -f $build_dir/build.ninja && $build_dir/build.ninja -nt $root/CMakePresets.json ]] &&
    grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build_dir/CMakeCache.txt"; then
    say "configure: $preset is configured in build/$preset"
    return
  fi
  if [[ -f $build_dir/CMakeCache.txt ]]; then
    fresh=(--fresh)
  fi
  say "configure: preset $preset in build/$preset"
  (cd "$root" && cmake "${fresh[@]}" --preset "$preset") >"$log" 2>&1 || {
    tail -n 40 "$log" >&2
    fail "configure: failed (log: $log)"
  }
}

# Reads ninja's lines: on a terminal each status line replaces the last; elsewhere one is printed
# every 20 seconds.
show_progress() {
  local line code last=$SECONDS status=''
  while true; do
    code=0
    IFS= read -r -t 5 line || code=$?
    if [[ $code -eq 0 ]]; then
      [[ $line =~ ^\[[0-9]+/[0-9]+\] ]] || continue
      status=$line
      if [[ -t 1 ]]; then
        printf '\r\033[K%.*s' "$((${COLUMNS:-80} - 1))" "$status"
      fi
    elif [[ $code -le 128 ]]; then
      break
    fi
    if [[ ! -t 1 && -n $status && $((SECONDS - last)) -ge 20 ]]; then
      say "build: $status"
      last=$SECONDS
    fi
  done
  if [[ -t 1 && -n $status ]]; then
    printf '\r\033[K'
  fi
}

# build TARGET…: builds what changed of the targets.
build() {
  local log=$root/build/$preset-build.log jobs started=$SECONDS
  jobs=$(build_jobs)
  say "build: $*, $jobs at a time (log: $log)"
  if ! NINJA_STATUS='[%f/%t] ' cmake --build "$build_dir" --parallel "$jobs" --target "$@" \
    2>&1 </dev/null | tee "$log" | show_progress; then
    if grep -q '^FAILED: ' "$log"; then
      awk '/^FAILED: / { found = 1 } found && n++ < 60' "$log" >&2
    else
      tail -n 60 "$log" >&2
    fi
    fail "build: failed (log: $log)"
  fi
  if grep -q '^ninja: no work to do' "$log"; then
    say "build: nothing to do, all is up to date"
  else
    say "build: done in $((SECONDS - started)) s"
  fi
}

# set_up TARGET…: from whatever is there to a build of the targets. Two runs at once take turns.
set_up() {
  install_packages "${packages[@]}"
  mkdir -p "$root/build"
  exec 9>"$root/build/.lock"
  flock --nonblock 9 || {
    say "build: waiting for another run in this tree"
    flock 9
  }
  configure
  build "$@"
  exec 9>&-
}

# configure_again_without TARGET: a build that was configured before the target's packages were there
# looks for them again.
configure_again_without() {
  if [[ -f $build_dir/build.ninja ]] && ! grep -q "$1" "$build_dir/build.ninja"; then
    cmake "$build_dir" >/dev/null
  fi
}

# set_up_with_python: the program and the Python package.
set_up_with_python() {
  install_packages "${python_packages[@]}"
  configure_again_without clipscope_python_all
  set_up clipscope clipscope_plugin_host clipscope_python_all
}
