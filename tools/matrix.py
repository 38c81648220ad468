# SPDX-License-Identifier: LGPL-2.1-or-later
"""`make matrix`: the tests inside FreeCAD 0.20.2, 1.0.0 and 1.1.3, without and with a window; run by .venv's Python.

What is asked for on the command line (versions) is all that runs. It goes on to the end whatever fails; then a table
says what did, and the exit status is 0 only when all of it passed. The system's FreeCAD is used where it is the
version that is asked for; the others are set up once for all checkouts of a user (freecad_root.sh).
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
VERSIONS = ("0.20.2", "1.0.0", "1.1.3")  # from old to new: each opens the documents of those before it
KINDS = ("plain", "scaled", "portuguese", "bare", "timed")
EMPTY_HOME = "empty home"
HEADLESS_LIMIT_S = 900


@dataclass
class Row:
    """What became of one version: the answer to FreeCAD.Version(), then verdict and seconds of each run."""

    version: str
    told: str = ""
    results: dict[str, tuple[bool, float]] = field(default_factory=dict)

    @property
    def good(self) -> bool:
        """Whether all of it passed."""
        return bool(self.told) and bool(self.results) and all(passed for passed, _ in self.results.values())


def main(versions: list[str]) -> int:
    """Set all up, run all, print the table; return 0 when all is well."""
    unknown = sorted(set(versions) - set(VERSIONS))
    if unknown:
        sys.exit(f"matrix: only {', '.join(VERSIONS)} are known, not {', '.join(unknown)}")
    chosen = [version for version in VERSIONS if version in versions or not versions]
    at_system = system_version()
    with ThreadPoolExecutor() as pool:
        ready = dict(
            zip(chosen, pool.map(lambda version: version == at_system or set_up(version), chosen), strict=True)
        )
    rows = []
    with tempfile.TemporaryDirectory(prefix="cncstepper-documents-", dir="/tmp") as folder:
        for version in chosen:
            row = Row(version)
            rows.append(row)
            if ready[version]:
                run_all(row, "host" if version == at_system else version, Path(folder), chosen)
    print_table(rows)
    return 0 if all(row.good for row in rows) else 1


def set_up(version: str) -> bool:
    """Make one FreeCAD's folder, when it is not there yet."""
    return subprocess.run([str(ROOT / "tools" / "freecad_root.sh"), version]).returncode == 0


def freecadcmd(where: str, script: str, environment: dict[str, str]) -> list[str]:
    """Return the command that runs a script in headless FreeCAD, in its folder or in the system."""
    variables = [f"{name}={value}" for name, value in environment.items()]
    inside = [] if where == "host" else [str(ROOT / "tools" / "in_root.sh"), where]
    program = (shutil.which("freecadcmd") or "FreeCADCmd") if where == "host" else "freecadcmd"
    return [*inside, "/usr/bin/env", "LC_ALL=C.UTF-8", *variables, program, str(ROOT / script), "-M", str(ROOT)]


def told_version(where: str) -> str:
    """Return what FreeCAD.Version() says inside, for example "1.0.0 ['1', '0', '0', …]"; "" when it does not start."""
    with tempfile.TemporaryDirectory(dir="/tmp") as home:
        command = freecadcmd(where, "tools/print_version.py", {"FREECAD_USER_HOME": home})
        output = subprocess.run(command, capture_output=True, text=True, cwd=ROOT).stdout
    found = [line for line in output.splitlines() if line.startswith("FreeCAD.Version() ")]
    return found[0].removeprefix("FreeCAD.Version() ") if found else ""


def system_version() -> str:
    """Return the version of the system's FreeCAD, "" when there is none."""
    return told_version("host").partition(" ")[0] if shutil.which("freecadcmd") or shutil.which("FreeCADCmd") else ""


def run_all(row: Row, where: str, folder: Path, chosen: list[str]) -> None:
    """Run the tests of one version, headless first: that compiles the kernels, which the window then finds."""
    row.told = told_version(where)
    heading(f"FreeCAD {row.version}: FreeCAD.Version() says {row.told or 'nothing'}")
    older = chosen[: chosen.index(row.version)]
    timed(row, "headless", lambda: headless(where, documents(folder / "headless", older)))
    timed(row, EMPTY_HOME, lambda: followed(where))
    for kind in KINDS:
        timed(row, kind, lambda kind=kind: window(where, kind, documents(folder / "window", older)))


def followed(where: str) -> bool:
    """Follow the command that the workbench prints for missing packages, from an empty home."""
    command = [str(ROOT / ".venv" / "bin" / "python"), str(ROOT / "tests" / "window" / "follow_command.py"), where]
    return subprocess.run(command, cwd=ROOT).returncode == 0


def documents(folder: Path, older: list[str]) -> dict[str, str]:
    """Return the variables for tests/freecad/whole_document.py."""
    folder.mkdir(exist_ok=True)
    return {"CNCSTEPPER_DOCUMENTS": str(folder), "CNCSTEPPER_OLDER": " ".join(older)}


def timed(row: Row, name: str, run: Callable[[], bool]) -> None:
    """Put verdict and seconds of one run into the row."""
    heading(f"FreeCAD {row.version}: {name}")
    begun = time.monotonic()
    passed = run()
    row.results[name] = (passed, time.monotonic() - begun)


def headless(where: str, environment: dict[str, str]) -> bool:
    """Run tests/freecad inside headless FreeCAD."""
    with tempfile.TemporaryDirectory(dir="/tmp") as home:
        command = freecadcmd(where, "tests/freecad/run.py", {"FREECAD_USER_HOME": home, **environment})
        try:
            return subprocess.run(command, cwd=ROOT, timeout=HEADLESS_LIMIT_S).returncode == 0
        except subprocess.TimeoutExpired:
            print(f"matrix: FreeCAD did not end within {HEADLESS_LIMIT_S} s", file=sys.stderr, flush=True)
            return False


def window(where: str, kind: str, environment: dict[str, str]) -> bool:
    """Run tests/window inside FreeCAD's window."""
    command = [str(ROOT / "tools" / "window.sh"), where, kind]
    return subprocess.run(command, cwd=ROOT, env={**os.environ, **environment}).returncode == 0


def heading(text: str) -> None:
    """Print what begins now."""
    print(f"\n===== {text} =====", flush=True)


def print_table(rows: list[Row]) -> None:
    """Print what passed and what failed."""
    heading("result")
    names = ("headless", EMPTY_HOME, *KINDS)
    print("FreeCAD".ljust(10) + "".join(name.rjust(16) for name in names))
    for row in rows:
        cells = [row.results.get(name) for name in names]
        words = [f"{'passed' if cell[0] else 'FAILED'} {cell[1]:5.0f} s" if cell else "NOT SET UP" for cell in cells]
        print(row.version.ljust(10) + "".join(word.rjust(16) for word in words))
        print(f"{'':10}FreeCAD.Version() {row.told or 'told nothing'}")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
