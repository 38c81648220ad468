#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Set up a FreeCAD in a folder of its own, with the Python packages that we need beside it:
#
#   tools/freecad_root.sh 1.0.0
#
# All checkouts of a user share them: they lie in CNCSTEPPER_FREECADS, unless that is set in cncstepper-freecad in the
# user's cache folder, and links in .cache/freecad say which of them this checkout uses. It is not in the kernels' cache
# folder, whose oldest entries are removed. Names hold what a folder was made by (the recipe, or the list of packages):
# two checkouts that want different ones never remove each other's. What no checkout has asked for in KEPT_DAYS goes.
#
# The folder holds a small Debian. It appears under its name only when FreeCAD in it has told its version: what an
# interrupted set-up leaves is removed and made again. One set-up runs at a time; the others wait for it. Nothing is
# mounted outside private mount namespaces. The packages come from the Debian archive of the machine's own apt sources
# (tools/apt_archive.py), or from CNCSTEPPER_DEBIAN_MIRROR where that is set: a snapshot of the archive keeps old
# versions of FreeCAD.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
project=$(dirname "$here")
version=$1
recipe=1 # raised when make_debian, prepare_apt or install_freecad come to make another folder
shared=$(realpath -m "${CNCSTEPPER_FREECADS:-${XDG_CACHE_HOME:-$HOME/.cache}/cncstepper-freecad}")
links=$project/.cache/freecad
root=$shared/$version-$recipe
KEPT_DAYS=60
mirror=${CNCSTEPPER_DEBIAN_MIRROR:-}
log=$root.log

say() { printf 'freecad %s: %s\n' "$version" "$*" >&2; }
fail() {
    say "set-up FAILED: $*"
    if [ -s "$log" ]; then
        say "the last lines of $log:"
        tail -n 15 "$log" >&2
    fi
    exit 1
}

case $version in
0.20.2) suite=bookworm python=3.11 ;;
1.0.0) suite=trixie python=3.13 ;;
1.1.3) suite=forky python=3.14 ;;
*) fail "only 0.20.2, 1.0.0 and 1.1.3 are known here" ;;
esac

check_rights() {
    if [ "$(id -u)" != 0 ]; then fail "only root can make and enter $root: run 'sudo make matrix'"; fi
    unshare --mount true 2>>"$log" || fail "this machine permits no mount namespaces ('unshare --mount' fails)"
    local tool
    for tool in debootstrap flock realpath; do
        command -v "$tool" >/dev/null || fail "$tool is missing: apt-get install debootstrap util-linux coreutils"
    done
}

find_mirror() {
    if [ -n "$mirror" ]; then return; fi
    mirror=$("$project/.venv/bin/python" "$here/apt_archive.py" "$suite" 2>>"$log") ||
        fail "no Debian archive of this machine serves $suite: name one in CNCSTEPPER_DEBIAN_MIRROR"
}

remove() { rm -rf --one-file-system "$@"; }

# debootstrap stumbles over spaces in a path: it sees the folder under a plain one. Where it does not know the suite, it
# takes the script that all newer ones share.
make_debian() {
    local scripts=/usr/share/debootstrap/scripts script plain
    script=$scripts/$suite
    if ! [ -e "$script" ]; then script=$scripts/sid; fi
    say "making Debian's $suite (about a minute)"
    mkdir -p "$1"
    plain=$(mktemp -d /tmp/cncstepper-debian-XXXXXX)
    unshare --mount bash -c '
        mount --bind "$1" "$2"
        debootstrap --variant=minbase --include=ca-certificates "$3" "$2" "$4" "$5"
    ' debian "$1" "$plain" "$suite" "$mirror" "$script" >>"$log" 2>&1 || {
        rmdir "$plain"
        fail "debootstrap could not make $suite from $mirror: check the network and run it again"
    }
    rmdir "$plain"
}

# Services that packages bring must not start here; the machine's own ways through a proxy are the folder's too. Nobody
# reads manuals here, and Python writes byte code of what it loads: a third of the installation's time would go there.
prepare_apt() {
    printf '#!/bin/sh\nexit 101\n' >"$1/usr/sbin/policy-rc.d"
    chmod +x "$1/usr/sbin/policy-rc.d"
    cp --dereference /etc/resolv.conf "$1/etc/resolv.conf"
    local file
    for file in /etc/apt/apt.conf.d/*proxy*; do
        if [ -e "$file" ]; then cp "$file" "$1/etc/apt/apt.conf.d/"; fi
    done
    # A testing suite's Release file may have expired on a mirror; nothing is fetched that its signature does not cover.
    printf '%s\n' 'Acquire::Check-Valid-Until "false";' 'APT::Install-Recommends "false";' \
        'DPkg::Options "--force-unsafe-io";' >"$1/etc/apt/apt.conf.d/90cncstepper"
    printf 'path-exclude=/usr/share/%s/*\n' doc info locale man >"$1/etc/dpkg/dpkg.cfg.d/90cncstepper"
    chroot "$1" dpkg-divert --quiet --local --rename --add /usr/bin/py3compile >>"$log" 2>&1
    ln -s /bin/true "$1/usr/bin/py3compile"
}

install_freecad() {
    say "installing FreeCAD (about a minute)"
    unshare --mount bash -c '
        set -e
        mount -t proc proc "$1/proc"
        chroot "$1" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
            ${http_proxy:+http_proxy="$http_proxy"} sh -c "apt-get update && apt-get install -y freecad libgl1-mesa-dri && apt-get clean"
    ' install "$1" >>"$log" 2>&1 || fail "apt-get in the folder could not install freecad from $mirror"
}

check_version() {
    local told
    told=$(CNCSTEPPER_ROOT=$1 "$here/in_root.sh" "$version" env LC_ALL=C.UTF-8 \
        FREECAD_USER_HOME=/root freecadcmd "$here/print_version.py" 2>>"$log" | sed -n 's/^FreeCAD.Version() //p')
    case $told in
    "$version "*) say "FreeCAD.Version() says $told" ;;
    "") fail "FreeCAD in it does not start" ;;
    *) fail "$mirror has FreeCAD $told in $suite now: name a snapshot of the archive that has $version in" \
        "CNCSTEPPER_DEBIAN_MIRROR" ;;
    esac
}

make_root() {
    if [ -e "$root/set-up-done" ] && [ -e "$root/usr/bin/freecad" ]; then return; fi
    remove "$root" "$root.part"
    : >"$log"
    find_mirror
    make_debian "$root.part"
    prepare_apt "$root.part"
    install_freecad "$root.part"
    check_version "$root.part"
    touch "$root.part/set-up-done"
    mv "$root.part" "$root"
}

# The project's own list of packages, without what only checks style and types.
wanted_packages() {
    "$project/.venv/bin/python" - "$project/pyproject.toml" <<'PYTHON'
import sys, tomllib
from pathlib import Path
project = tomllib.loads(Path(sys.argv[1]).read_text("utf-8"))["project"]
extras = project["optional-dependencies"]
print("\n".join(project["dependencies"] + extras["fast"] + extras["inside"]))
PYTHON
}

# pip would compile them for its own Python, which is another.
make_packages() {
    local wanted platform platforms=()
    wanted=$(wanted_packages) || fail "pyproject.toml cannot be read: run 'make setup' first"
    python_folder=$root-python-$(cksum <<<"$wanted" | tr -d ' ')
    if [ "$(cat "$python_folder/done" 2>/dev/null)" = "$wanted" ]; then return; fi
    remove "$python_folder" "$python_folder.part"
    say "fetching the Python packages for Python $python"
    mkdir -p "$python_folder.part/lib/python$python/site-packages" "$python_folder.part/bin"
    ln -s "/usr/bin/python$python" "$python_folder.part/bin/python"
    printf 'home = /usr/bin\ninclude-system-site-packages = false\nversion = %s\n' "$python" >"$python_folder.part/pyvenv.cfg"
    for platform in manylinux_2_28 manylinux_2_17 manylinux2014; do
        platforms+=(--platform "${platform}_$(uname -m)")
    done
    printf '%s\n' "$wanted" >"$python_folder.part/requirements.txt"
    "$project/.venv/bin/python" -m pip install --quiet --no-compile --disable-pip-version-check \
        --target "$python_folder.part/lib/python$python/site-packages" --python-version "$python" --implementation cp \
        "${platforms[@]}" --only-binary=:all: --requirement "$python_folder.part/requirements.txt" >>"$log" 2>&1 ||
        fail "pip could not fetch the packages for Python $python: check the network and run it again"
    printf '%s\n' "$wanted" >"$python_folder.part/done"
    mv "$python_folder.part" "$python_folder"
}

# A checkout from before the folders were shared has one of its own under the link's name.
link() {
    if [ -d "$links/$2" ] && ! [ -L "$links/$2" ]; then remove "${links:?}/$2"; fi
    ln -sfn "$1" "$links/$2"
    touch "$1/last-used"
}

remove_unused() {
    local stamp
    find "$shared" -mindepth 2 -maxdepth 2 -path "$shared/$version-*" -name last-used -mtime "+$KEPT_DAYS" -print0 |
        while IFS= read -r -d '' stamp; do remove "$(dirname "$stamp")"; done
}

mkdir -p "$shared" "$links"
check_rights
exec 9>"$root.lock"
flock 9
make_root
make_packages
link "$root" "$version"
link "$python_folder" "$version-python"
remove_unused
