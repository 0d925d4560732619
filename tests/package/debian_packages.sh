#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the Debian packages of a build, the third argument, by the fourth, CPack, and uses them
# (use_packages.sh): unpacked anywhere, where no file of the build may stand in for a packaged one, and, as root,
# installed by dpkg in a copy of this system that is thrown away and has neither build nor source tree.
# shellcheck source=tests/package/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"
build=$3 cpack=$4
if ! command -v dpkg-shlibdeps >/dev/null; then
  echo "warning: nothing was tried: packages are made by dpkg-dev, which is not installed" >&2
  exit
fi

quietly "$cpack" --config "$build/CPackConfig.cmake" -B "$work/made"
packages=("$work"/made/*.deb)

# depends NAME DEPENDENCY…: the package NAME was made, and it asks for these.
depends() {
  local name=$1 file dependency
  file=$(printf '%s\n' "${packages[@]}" | grep "/${name}_") || die "there is no package $name: ${packages[*]}"
  for dependency in "${@:2}"; do
    dpkg-deb --field "$file" Depends | tr ',' '\n' | grep -qE "^ *$dependency( |\$)" ||
      die "$name does not depend on $dependency, but on $(dpkg-deb --field "$file" Depends)"
  done
  dpkg-deb --fsys-tarfile "$file" | tar -xO "./usr/share/doc/$name/copyright" >"$work/copyright"
  grep -q 'common-licenses/GPL-3' "$work/copyright" || die "$name does not say that it is under the GPL"
  grep -q 'Permission is hereby granted, free of charge' "$work/copyright" || die "$name lacks the MIT licence"
}
# What its modules and hosts link is found, too.
depends clipscope libc6 libgmp10 'libopenimageio[0-9.]*(t64)?' libepoxy0
depends libclipscope-dev libglm-dev libhwy-dev
if grep -q clipscope_python_all "$build/build.ninja"; then depends python3-clipscope python3 python3-numpy 'libhwy1(t64)?'; fi

# What was unpacked elsewhere finds its own.
moved=$work/moved/usr
for file in "${packages[@]}"; do dpkg-deb --extract "$file" "$work/moved"; done
use_moved() {
  CMAKE_PREFIX_PATH=$moved PKG_CONFIG_PATH=$(dirname "$(find "$moved" -name clipscope.pc)") PATH=$moved/bin:$PATH \
    PYTHONPATH=$moved/lib/python3/dist-packages bash "$root/tests/package/use_packages.sh" \
    "$work/use_moved" "$root" "$moved"
}
quietly use_moved
for file in clipscope_plugin_host clipscope_openimageio.so; do
  echo "not a program" >"$moved/lib/clipscope/$file"
done
use_moved >"$work/log" 2>&1 && die "the packages work without their own files, by those of the build"
grep -q clipscope_plugin_host "$work/log" || die "it is not the host that is missed: $(<"$work/log")"

# in_copy FOLDER COMMAND…: as root of a copy of this system that is thrown away; it has neither build nor source
# tree, but FOLDER as /mnt.
in_copy() {
  local folder=$1
  shift
  # shellcheck disable=SC2016  # the inner shell's own
  unshare --mount bash -euc '
    disk=$1 folder=$2
    mount -t tmpfs tmpfs "$disk"
    mkdir "$disk/upper" "$disk/work" "$disk/system"
    mount -t overlay overlay -o "lowerdir=/,upperdir=$disk/upper,workdir=$disk/work" "$disk/system"
    mount --rbind /proc "$disk/system/proc"
    mount --rbind /dev "$disk/system/dev"
    for hidden in "$3" "$4"; do
      mkdir -p "$disk/system$hidden"
      mount -t tmpfs tmpfs "$disk/system$hidden"
    done
    mkdir -p "$disk/system/mnt"
    mount --bind "$folder" "$disk/system/mnt"
    shift 4
    exec chroot "$disk/system" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 "$@"
  ' in_copy "$work/disk" "$folder" "$root" "$build" "$@"
}

mkdir "$work/disk" "$work/given"
if ! in_copy "$work/given" true >"$work/log" 2>&1; then
  echo "warning: not installed by dpkg, for no copy of this system could be made: $(tail -n 1 "$work/log")" >&2
  exit
fi
cp "${packages[@]}" "$work/given"
mkdir -p "$work/given/tree/tests"
cp -r "$root/tests/package" "$work/given/tree/tests"
cat >"$work/given/install.sh" <<'END'
set -euo pipefail
export DEBIAN_FRONTEND=noninteractive
dpkg --install /mnt/*.deb
bash /mnt/tree/tests/package/use_packages.sh /tmp/use_packages /mnt/tree /usr
[[ -z $(dpkg --verify clipscope libclipscope-dev) ]] || { echo "not what was packed" >&2; exit 1; }
mapfile -t names < <(for file in /mnt/*.deb; do dpkg-deb --field "$file" Package; done)
dpkg --purge "${names[@]}"
left=$(find /usr/bin /usr/lib /usr/include /usr/share -path '*clipscope*' -print -quit)
[[ -z $left ]] || { echo "left behind: $left" >&2; exit 1; }
END
quietly in_copy "$work/given" bash /mnt/install.sh
