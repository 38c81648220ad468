# SPDX-License-Identifier: LGPL-2.1-or-later
"""Builds zips for *Install packages…* on computers without internet: `make installer [PYTHONS="3.11 3.13"]`.

One zip for each Python, build/installer/cncstepper-packages-VERSION-py311.zip, with the pinned wheels of all that
FreeCAD's Python may lack, for 64-bit Linux and Windows, and with pip itself, where a Python has none.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))
from CNCStepper import __version__, dependencies  # noqa: E402

PYTHONS = ("3.11",)  # of the FreeCADs that freecad.org offers
# What pip takes for one system, the newest C library first: pip does not know that a newer one runs older wheels.
PLATFORMS = {
    "Linux": (*(f"manylinux_2_{minor}_x86_64" for minor in range(28, 16, -1)), "manylinux2014_x86_64"),
    "Windows": ("win_amd64",),
}
FOLDER = ROOT / "build" / "installer"


def main(pythons: list[str]) -> int:
    """Build a zip for each of the Pythons."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    for python in pythons or PYTHONS:
        with tempfile.TemporaryDirectory(prefix="wheels-", dir=FOLDER) as folder:
            wheels = Path(folder)
            for system in PLATFORMS:
                download(wheels, python, system)
            path = zip_path(python)
            write_zip(path, wheels)
        print(f"installer: {path.relative_to(ROOT)}, {path.stat().st_size / 1e6:.0f} MB, Python {python}")
    return 0


def zip_path(python: str) -> Path:
    """Return where the zip for a Python is written."""
    return FOLDER / f"cncstepper-packages-{__version__}-py{python.replace('.', '')}.zip"


def download(folder: Path, python: str, system: str) -> None:
    """Put the wheels of all pinned packages for one Python on one system into a folder."""
    command = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--only-binary=:all:"]
    command += [f"--dest={folder}", f"--python-version={python}", f"--requirement={dependencies.PINS}", "pip"]
    command += [f"--platform={platform}" for platform in PLATFORMS[system]]
    if subprocess.run(command).returncode:
        sys.exit(f"installer: the wheels for Python {python} on {system} are not all there: see above")


def write_zip(path: Path, wheels: Path) -> None:
    """Write the zip, whole or not at all; wheels are compressed already."""
    part = path.with_suffix(".part")
    with zipfile.ZipFile(part, "w", zipfile.ZIP_STORED) as archive:
        for wheel in sorted(wheels.glob("*.whl")):
            archive.write(wheel, wheel.name)
    shutil.move(part, path)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
