#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Run a command inside a FreeCAD's folder: tools/in_root.sh 1.0.0 freecadcmd script.py -M .
#
# The project, its Python packages and the temporary folder are seen there at their own places, through mounts that only this command and
# what it starts can see: removing the folder can never reach the project through them.
set -euo pipefail
project=$(cd "$(dirname "$0")/.." && pwd)
links=$project/.cache/freecad/$1 # of freecad_root.sh
root=$(realpath -m "${CNCSTEPPER_ROOT:-$links}")
python_folder=$(realpath -m "$links-python")
shift
if ! [ -x "$root/usr/bin/freecad" ]; then
    echo "in_root: $root holds no FreeCAD: run 'make matrix', which sets it up" >&2
    exit 1
fi
if [ "$(id -u)" != 0 ]; then
    echo "in_root: only root can enter $root: run this with sudo" >&2
    exit 1
fi
packages=("$python_folder"/lib/python3.*/site-packages)
export CNCSTEPPER_PACKAGES=${CNCSTEPPER_PACKAGES-${packages[0]}} CNCSTEPPER_PYTHON=${CNCSTEPPER_PYTHON-$python_folder/bin/python}
# shellcheck disable=SC2016  # the inner shell fills these in
exec unshare --mount bash -c '
    set -euo pipefail
    root=$1 project=$2 packages=$3
    shift 3
    mount -t proc proc "$root/proc"
    mount --rbind /dev "$root/dev"
    for folder in /tmp "${TMPDIR:-/tmp}" "$project" "$packages"; do
        if ! [ -d "$folder" ]; then continue; fi
        mkdir -p "$root$folder"
        mount --bind "$folder" "$root$folder"
    done
    exec chroot "$root" /usr/bin/env -C "$PWD" "$@"
' in_root "$root" "$project" "$python_folder" "$@"
