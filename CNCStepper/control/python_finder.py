# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds a real Python for the sender's process: inside FreeCAD `sys.executable` is FreeCAD itself."""

from __future__ import annotations

import functools
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

from CNCStepper.errors import MissingPackage

VARIABLE = "CNCSTEPPER_PYTHON"
OLDEST = (3, 11)
CHECK_LIMIT_S = 20.0
PACKAGE_ROOT = Path(__file__).resolve().parents[2]
# It prints its own path: a launcher such as Windows' `py` is left out of what is started later.
CHECK = (
    "import sys\n"
    f"assert sys.version_info >= {OLDEST}, 'Python ' + sys.version.split()[0] + ' is too old'\n"
    "import serial, CNCStepper\n"
    "sys.stdout.buffer.write(sys.executable.encode('utf-8'))"
)


@functools.cache
def find_python() -> str:
    """Return the path of a Python that can run the sender; it is looked for once.

    Raises MissingPackage that names every Python tried and what it lacks.
    """
    tried: dict[str, str] = {}
    for candidate in candidates():
        if candidate not in tried:
            path, lack = checked(candidate)
            if path:
                return path
            tried[candidate] = lack
    raise MissingPackage(
        "python-missing",
        "no Python can run the sender: " + "; ".join(f"{name}: {lack}" for name, lack in tried.items()),
        advice=f"install pyserial there (python -m pip install pyserial), or set {VARIABLE} to a Python that has it",
    )


def candidates() -> Iterator[str]:
    """Yield paths that may be a Python, best first; one that was asked for is the only one."""
    if asked := os.environ.get(VARIABLE):
        yield asked
        return
    if Path(sys.executable or "").stem.lower().startswith("python"):
        yield sys.executable
    folder, name = ("Scripts", "python.exe") if os.name == "nt" else ("bin", "python")
    yield from _there(PACKAGE_ROOT / ".venv" / folder / name)
    base = getattr(sys, "_base_executable", "") or ""
    if Path(base).stem.lower().startswith("python"):
        yield base
    yield from filter(None, map(shutil.which, ("python3", "python", "py")))
    yield from _there(Path(sys.executable or ".").with_name(name))  # beside FreeCAD's own program
    yield from _there(Path(sys.prefix) / "bin" / "python3")


def checked(candidate: str) -> tuple[str, str]:
    """Return (path, "") of a Python that can run the sender, or ("", what it lacks)."""
    try:
        answer = subprocess.run(
            [candidate, "-P", "-c", CHECK],
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=CHECK_LIMIT_S,
            env=environment(),
        )
    except (OSError, ValueError, subprocess.TimeoutExpired) as error:
        return "", str(error)
    if answer.returncode:
        return "", (answer.stderr.decode("utf-8", "replace").strip().splitlines() or ["it ended with an error"])[-1]
    return answer.stdout.decode("utf-8"), ""


def environment() -> dict[str, str]:
    """Return the variables for a Python of its own: our package is found, an embedding program's home is not."""
    variables = dict(os.environ)
    variables.pop("PYTHONHOME", None)
    variables["PYTHONPATH"] = os.pathsep.join(filter(None, [str(PACKAGE_ROOT), os.environ.get("PYTHONPATH")]))
    return variables


def _there(path: Path) -> Iterator[str]:
    if path.is_file():
        yield str(path)
