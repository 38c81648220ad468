# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that installs packages into a folder, all or none: `python -m CNCStepper.workers.package_installer`.

    pip ──► FOLDER.part-PID/new ──► FOLDER: each entry in place of its older one, which goes to FOLDER.part-PID/old

It needs nothing but Python and pip. Arguments: `installation_arguments`. Standard output and error are pip's own, and
the exit status is pip's; a line that begins with "ERROR: " says what stopped this module itself.
"""

from __future__ import annotations

import argparse
import os
import re
import runpy
import shutil
import sys
import zipfile
from collections.abc import Sequence
from pathlib import Path

from CNCStepper.dependencies import PINS

NO_PIP = "No module named pip"
NO_WHEELS = "no wheels in"
NOT_IMPORTED = {"bin", "share", "include", "etc"}  # programs and manual pages, which FreeCAD has no use for
PIP_OPTIONS = (
    "install",
    "--no-input",
    "--disable-pip-version-check",
    "--progress-bar=off",
    "--no-warn-script-location",
    "--no-compile",
    "--retries=2",
    "--only-binary=:all:",
)


def installation_arguments(
    target: Path, requirements: Sequence[str], source: Path | None = None, proxy: str = ""
) -> list[str]:
    """Return the arguments for this module.

    source: a folder or zip with wheels, in place of Python's package index. proxy: "http://host:port", "": pip's own.
    """
    from_files = [f"--source={source}"] if source else []
    through = [f"--proxy={proxy}"] if proxy else []
    return [*from_files, *through, str(target), *requirements]


def main(arguments: Sequence[str]) -> int:
    """Install; return the exit status, 0 when all packages are in the folder."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--source", type=Path)
    parser.add_argument("--proxy", default="")
    parser.add_argument("target", type=Path)
    parser.add_argument("requirements", nargs="+")
    options = parser.parse_args(arguments)
    sys.stdout.reconfigure(line_buffering=True)  # type: ignore[union-attr]  # the window shows each line as it comes
    try:
        return install(options.target, options.requirements, options.source, options.proxy)
    except (OSError, zipfile.BadZipFile) as error:
        print(f"ERROR: {error}", file=sys.stderr)
        return 1


def install(target: Path, requirements: Sequence[str], source: Path | None, proxy: str = "") -> int:
    """Install into `target`; return pip's exit status. Raises OSError when a file cannot be written."""
    part = part_folder(target, os.getpid())
    part.mkdir(parents=True)
    try:
        wheels = wheel_folder(source, part) if source else None
        status = run_pip(pip_arguments(part / "new", requirements, wheels, proxy), wheels)
        if status == 0:
            target.mkdir(parents=True, exist_ok=True)
            move_into(target, part / "new", part / "old")
        return status
    finally:
        shutil.rmtree(part, ignore_errors=True)


def part_folder(target: Path, pid: int) -> Path:
    """Return where the process `pid` keeps what is not whole yet: beside `target`, so that moving is renaming."""
    return target.with_name(f"{target.name}.part-{pid}")


def wheel_folder(source: Path, part: Path) -> Path:
    """Return a folder with the wheels of a folder or zip. Raises OSError when there are none."""
    if source.is_dir():
        folder = source
    else:
        folder = part / "wheels"
        folder.mkdir()
        with zipfile.ZipFile(source) as archive:
            for entry in archive.infolist():
                if entry.filename.endswith(".whl"):
                    entry.filename = Path(entry.filename).name  # never outside of the folder
                    archive.extract(entry, folder)
    if not any(folder.glob("*.whl")):
        raise FileNotFoundError(f"{NO_WHEELS} {source}")
    return folder


def pip_arguments(target: Path, requirements: Sequence[str], wheels: Path | None, proxy: str = "") -> list[str]:
    """Return the arguments for pip: the pinned versions, as wheels only, for nobody has a compiler."""
    places = ["--no-index", f"--find-links={wheels}"] if wheels else []
    through = [f"--proxy={proxy}"] if proxy else []
    return [*PIP_OPTIONS, *places, *through, f"--constraint={PINS}", f"--target={target}", *requirements]


def run_pip(arguments: Sequence[str], wheels: Path | None) -> int:
    """Run this Python's pip, else the one among the wheels, in this process: who ends this one ends pip."""
    os.environ |= {"PIP_USER": "0", "PIP_REQUIRE_VIRTUALENV": "0"}  # a person's own settings, which forbid a folder
    sys.path.extend(str(wheel) for wheel in wheels.glob("pip-*.whl")) if wheels else None
    sys.argv = ["pip", *arguments]
    try:
        runpy.run_module("pip", run_name="__main__", alter_sys=True)
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else int(end.code is not None)
    except ImportError as error:
        print(f"ERROR: {error}", file=sys.stderr)
        return 1
    return 0


def move_into(target: Path, new: Path, old: Path) -> None:
    """Move the entries of `new` into `target`, older ones into `old`; all back when one cannot be moved (OSError)."""
    old.mkdir()
    moved: list[tuple[Path, Path]] = []
    try:
        for entry in sorted(new.iterdir()):
            if entry.name in NOT_IMPORTED:
                continue
            for older in older_entries(target, entry.name):
                moved.append((older, older.rename(old / older.name)))
            moved.append((entry, entry.rename(target / entry.name)))
    except OSError:
        for before, after in reversed(moved):
            after.rename(before)
        raise


def older_entries(target: Path, name: str) -> list[Path]:
    """Return what an entry takes the place of: that of its name, and the metadata of the package's other versions."""
    found = re.fullmatch(r"(?P<package>.+)-[^-]+\.dist-info", name)
    versions = target.glob("*.dist-info") if found else []
    of_package = [path for path in versions if found and path.name.startswith(f"{found['package']}-")]
    return of_package if found else [path for path in (target / name,) if path.exists()]


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
