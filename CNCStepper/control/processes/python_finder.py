# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds a real Python for a process of our own: inside FreeCAD `sys.executable` is FreeCAD itself.

What runs there is named by `command` and told by `environment`: where it lacks some of ours it sees, behind its own
packages, those that this process sees (`control/processes/bootstrap.py`).
"""

from __future__ import annotations

import functools
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import Future
from pathlib import Path

import CNCStepper
from CNCStepper.control.processes.background_thread import in_background
from CNCStepper.control.processes.bootstrap import BEHIND, python_version
from CNCStepper.dependencies import pip_names
from CNCStepper.errors import MissingPackage, Text

VARIABLE = "CNCSTEPPER_PYTHON"
OLDEST = (3, 11)
CHECK_LIMIT_S = 20.0
# as imported, links and all: numba's cache goes by that path
PACKAGE_ROOT = Path(CNCStepper.__file__).absolute().parents[1]
SENDER = ("serial",)
PROOF = ("numpy", "shapely", "pydantic", "platformdirs")
# It prints its own path: later starts bypass a launcher such as Windows' `py`.
CHECK = (
    "import sys\n"
    f"assert sys.version_info >= {OLDEST}, 'Python ' + sys.version.split()[0] + ' is too old'\n"
    "import CNCStepper.control.processes.bootstrap as started\n"
    "version, *needs = sys.argv[1:]\n"
    "assert version in ('', started.python_version()), 'it is not Python ' + version\n"
    "started.see_packages(*needs)\n"
    "for name in needs:\n"
    "    __import__(name)\n"
    "sys.stdout.buffer.write(sys.executable.encode('utf-8'))"
)


@functools.cache
def find_python(needs: tuple[str, ...] = SENDER, version: str = "") -> str:
    """Return the path of a Python that can import all of `needs`; the first search takes up to seconds.

    version: which it must be, as "3.11"; "": any.
    Raises MissingPackage that names every Python tried and what it lacks.
    """
    tried: dict[str, str] = {}
    for candidate in candidates():
        if candidate not in tried:
            path, lack = checked(candidate, needs, version)
            if path:
                return path
            tried[candidate] = lack
    packages = " ".join(pip_names(needs))
    raise MissingPackage(
        "python-missing",
        f"no Python has {packages}: " + "; ".join(f"{name}: {lack}" for name, lack in tried.items()),
        advice=Text(
            "install them in one (python -m pip install {packages}), or set {variable} to a Python that has them",
            packages=packages,
            variable=VARIABLE,
        ),
    )


def find_python_in_background(needs: tuple[str, ...] = SENDER, version: str = "") -> Future[str]:
    """Return at once what will be the answer of `find_python`, or its refusal: ask its `done()` from a timer."""
    return in_background(lambda: find_python(needs, version))


def command(python: str, module: str, *arguments: str) -> list[str]:
    """Return the arguments that start a module of this package in that Python; `environment` has its variables."""
    return [python, "-P", "-X", "utf8", "-m", "CNCStepper.control.processes.bootstrap", module, *arguments]


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


def checked(candidate: str, needs: tuple[str, ...] = SENDER, version: str = "") -> tuple[str, str]:
    """Return (path, "") of a Python that can import all of `needs`, or ("", what it lacks)."""
    try:
        answer = subprocess.run(
            [candidate, "-P", "-c", CHECK, version, *needs],
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
    """Return the variables for a Python of its own: our package is found, an embedding program's home is not.

    What this process imports from is named too, for a Python of the same version.
    """
    variables = dict(os.environ)
    variables.pop("PYTHONHOME", None)
    variables["PYTHONPATH"] = os.pathsep.join(filter(None, [str(PACKAGE_ROOT), os.environ.get("PYTHONPATH")]))
    variables[BEHIND] = os.pathsep.join([python_version(), *filter(None, sys.path)])
    return variables


def _there(path: Path) -> Iterator[str]:
    if path.is_file():
        yield str(path)
