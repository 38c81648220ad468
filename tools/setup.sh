#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Set up what the Makefile's targets need; a second run costs a few milliseconds.
#
#   tools/setup.sh python   only .venv: the package, numba, and the tools for tests
#   tools/setup.sh translations   .venv, and Qt's lrelease, which compiles the catalogues of translations
#   tools/setup.sh all      .venv, and the programs of the system: FreeCAD, LinuxCNC's rs274, locale sources, and for the
#                           tests in FreeCAD's window a screen that nobody sees (Xvfb), a window manager, software OpenGL
#                           and CadQuery in an environment of its own, which all checkouts share in the user's cache folder;
#                           Sphinx for the manual's HTML
#   tools/setup.sh matrix   all that, and debootstrap for the other FreeCADs
#   tools/setup.sh manual   .venv, Sphinx and WeasyPrint in an environment of their own, .cache/manual-env, and for the PDF Pango
#
# On Debian and its family as root, missing system packages are installed; otherwise they are named.
# .venv uses the system's Python, which is FreeCAD's own on Linux: its compiled packages load in FreeCAD too.
set -euo pipefail
cd "$(dirname "$0")/.."

stamp=.venv/setup-done
locale_sources=/usr/share/i18n/locales/pt_BR

say() { printf 'setup: %s\n' "$*" >&2; }
fail() { say "$*"; exit 1; }
has() { command -v "$1" >/dev/null 2>&1; }

# One set-up at a time in this folder (where flock is missing, as on macOS, start only one yourself).
lock() {
    mkdir -p .cache
    exec 9>.cache/setup.lock
    if has flock; then flock 9; fi
}

find_python() {
    local candidate
    for candidate in "${CNCSTEPPER_PYTHON:-}" /usr/bin/python3 python3 python; do
        if [ -n "$candidate" ] && "$candidate" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null; then
            echo "$candidate"
            return
        fi
    done
}

missing_packages() {
    if [ -z "$(find_python)" ]; then echo python3; fi
    if ! [ -e "$stamp" ] && ! /usr/bin/python3 -c 'import ensurepip' 2>/dev/null; then echo python3-venv; fi
    if [ "$1" = translations ] && ! has lrelease && ! [ -x /usr/lib/qt5/bin/lrelease ]; then echo qttools5-dev-tools; fi
    if [ "$1" = manual ] && ! compgen -G '/usr/lib/*/libpangoft2-1.0.so.0' >/dev/null; then echo libpangoft2-1.0-0; fi
    if [ "$1" = manual ] && ! compgen -G '/usr/lib/*/libharfbuzz-subset.so.0' >/dev/null; then echo libharfbuzz-subset0; fi
    if [ "$1" != all ] && [ "$1" != matrix ]; then return; fi
    if ! has freecadcmd && ! has FreeCADCmd; then echo freecad; fi
    if ! has rs274; then echo linuxcnc-uspace; fi
    if ! [ -e "$locale_sources" ]; then echo locales; fi
    if ! has Xvfb; then echo xvfb; fi
    if ! has openbox; then echo openbox; fi
    if ! compgen -G '/usr/lib/*/dri/swrast_dri.so' >/dev/null; then echo libgl1-mesa-dri; fi
    if [ "$1" = matrix ] && ! has debootstrap && ! [ -x /usr/sbin/debootstrap ]; then echo debootstrap; fi
}

install_packages() {
    if [ "$(id -u)" != 0 ]; then
        fail "missing system packages: $*. Get them with:" \
            "sudo apt-get update && sudo apt-get install -y --no-install-recommends $*"
    fi
    say "installing system packages: $*"
    export DEBIAN_FRONTEND=noninteractive
    apt-get update -qq || say "apt-get update failed; trying with the lists that are there"
    apt-get install -y -qq -o DPkg::Lock::Timeout=300 --no-install-recommends "$@" >&2 ||
        fail "apt-get could not install: $*. Install them yourself and run make again"
}

# Outside the Debian family nothing is installed: say how to get it, and stop only where nothing would work.
name_missing() {
    local package
    for package in "$@"; do
        case "$package" in
        python3 | python3-venv) fail "Python 3.11 or newer with venv is missing: get it from https://www.python.org/downloads/ or your system's packages" ;;
        freecad) say "FreeCAD is missing: get it from https://www.freecad.org/downloads.php (macOS: brew install --cask freecad) and put its freecadcmd on PATH" ;;
        qttools5-dev-tools) fail "Qt's lrelease is missing: get it with your system's tools for Qt developers" ;;
        linuxcnc-uspace) say "LinuxCNC's rs274 is missing: get it from https://linuxcnc.org/downloads/ (there is none for macOS and Windows; run the comparison with it on Linux)" ;;
        xvfb | openbox) say "$package is missing: get it from your system's packages (the tests in FreeCAD's window run under X only)" ;;
        libgl1-mesa-dri) ;; # other systems name it differently, or need none
        libpangoft2-1.0-0 | libharfbuzz-subset0) say "Pango is missing: the manual's PDF needs it (macOS: brew install pango)" ;;
        debootstrap) say "debootstrap is missing: get it from your system's packages ('make matrix' runs on Linux only)" ;;
        locales) ;; # other systems bring pt_BR.UTF-8 with them or as glibc-locale-source
        esac
    done
    case " $* " in
    *" freecad "*) fail "demo and test need FreeCAD; 'make quick' works without it" ;;
    esac
}

system_packages() {
    local packages
    packages=$(missing_packages "$1")
    if [ -z "$packages" ]; then return; fi
    # shellcheck disable=SC2086  # names of packages hold no spaces
    if has apt-get; then install_packages $packages; else name_missing $packages; fi
}

# What .venv was made for: it is made anew when Python or the folder's place differ, refreshed when pyproject or the versions do.
wanted_place() { "$1" -c 'import os, sys; print("place", sys.version.split()[0], ascii(os.getcwd()))'; }
wanted_content() { echo "content $(cat pyproject.toml CNCStepper/constraints.txt | cksum)"; }

make_venv() {
    local python=$1 place content
    if [ -L .venv ]; then return; fi  # that of another checkout, whose own set-up keeps it: here it would be emptied
    place=$(wanted_place "$python")
    content=$(wanted_content)
    if [ -e "$stamp" ] && [ "$(cat "$stamp")" = "$place"$'\n'"$content" ]; then return; fi
    if ! [ -e "$stamp" ] || [ "$(head -n 1 "$stamp")" != "$place" ]; then
        say "making .venv with $python"
        "$python" -m venv --clear .venv ||
            fail "$python cannot make a virtual environment: install its venv module (Debian: apt-get install python3-venv)"
    fi
    rm -f "$stamp"
    say "installing the Python packages into .venv (the first time takes a minute or two)"
    # Python compiles what is used at its first import: that is a part of what comes.
    PIP_DISABLE_PIP_VERSION_CHECK=1 .venv/bin/python -m pip install --quiet --no-compile \
        --constraint CNCStepper/constraints.txt --editable '.[fast,dev]' >&2 ||
        fail "pip could not install the packages that pyproject.toml names: check the network and run make again"
    make_locale
    printf '%s\n%s\n' "$place" "$content" >"$stamp.part"
    mv "$stamp.part" "$stamp"
}

# A locale with a decimal comma for the tests, whatever the machine has: LOCPATH=.venv/locale LC_ALL=pt_BR.UTF-8
make_locale() {
    if ! has localedef || ! [ -e "$locale_sources" ]; then return; fi
    mkdir -p .venv/locale
    localedef --no-archive -i pt_BR -f UTF-8 .venv/locale/pt_BR.UTF-8 >&2 ||
        fail "localedef could not make pt_BR.UTF-8"
}

# CadQuery for the tests of solids: 1.2 GB, 40 s, once for all checkouts. Without the packages that its windows take.
make_cadquery() {
    local python=$1 folder wanted
    folder=${CNCSTEPPER_CADQUERIES:-${XDG_CACHE_HOME:-$HOME/.cache}/cncstepper-cadquery}
    wanted=$("$python" -c 'import sys, tomllib
extras = tomllib.load(open("pyproject.toml", "rb"))["project"]["optional-dependencies"]
print(sys.version.split()[0], *extras["solids"], sep="\n")')
    if [ -e "$folder/setup-done" ] && [ "$(cat "$folder/setup-done")" = "$wanted" ]; then return; fi
    say "installing CadQuery into $folder (the first time takes a minute)"
    mkdir -p "$(dirname "$folder")"
    "$python" -m venv --clear "$folder"
    tail -n +2 <<<"$wanted" >"$folder/requirements.txt"
    PIP_DISABLE_PIP_VERSION_CHECK=1 "$folder/bin/python" -m pip install --quiet --no-deps --no-compile \
        -r "$folder/requirements.txt" >&2 || fail "pip could not install CadQuery: check the network and run make again"
    printf '%s\n' "$wanted" >"$folder/setup-done"
}

# Sphinx for `make manual`, with the versions of docs/manual/requirements.txt: 150 MB, half a minute.
make_manual() {
    local folder=.cache/manual-env wanted
    wanted="$(wanted_place "$1") $(cksum <docs/manual/requirements.txt)"
    if [ -e "$folder/setup-done" ] && [ "$(cat "$folder/setup-done")" = "$wanted" ]; then return; fi
    say "installing Sphinx into $folder (the first time takes half a minute)"
    "$1" -m venv --clear "$folder"
    PIP_DISABLE_PIP_VERSION_CHECK=1 "$folder/bin/python" -m pip install --quiet -r docs/manual/requirements.txt >&2 ||
        fail "pip could not install Sphinx: check the network and run make again"
    printf '%s\n' "$wanted" >"$folder/setup-done"
}

case "$(uname -s)" in
MINGW* | MSYS* | CYGWIN*)
    fail "on Windows run: py -m venv .venv, then .venv\\Scripts\\pip install -e .[fast,dev], then .venv\\Scripts\\cncstepper --help"
    ;;
esac
lock
system_packages "${1:-all}"
make_venv "$(find_python)"
case "${1:-all}" in
all | matrix)
    make_cadquery "$(find_python)"
    make_manual "$(find_python)"
    ;;
manual) make_manual "$(find_python)" ;;
esac
