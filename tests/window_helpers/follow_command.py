# SPDX-License-Identifier: LGPL-2.1-or-later
"""Follows the command that the workbench prints for missing packages: `follow_command.py 0.20.2|1.0.0|1.1.3|host`.

From an empty home, with a copy of the project that has no packages beside it: FreeCAD's window opens the workbench and
prints the command; a shell runs it, as it stands; FreeCAD starts again, makes a job and connects to the virtual
controller. Nothing else may be found: neither .venv nor the packages for tests.

The other FreeCADs have no pip in their folder. Their `python3.14 -m pip` is this checkout's, which is told for which
Python it installs, and that it cannot write that Python's byte code.
"""

from __future__ import annotations

import json
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import uuid
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tests"))
from window_helpers import start_window  # noqa: E402

SCRIPT = Path(__file__).with_name("empty_home.py")
PARTS = ("CNCStepper", "resources", "Init.py", "InitGui.py", "package.xml", "LICENSE", "pyproject.toml")
START_S, INSTALL_S = 240.0, 600.0
FOREIGN_PIP = """#!/bin/sh
test "$1 $2 $3" = "-m pip install" || exit 2
shift 3
exec "{python}" -m pip install --no-compile --python-version {version} {platforms} "$@"
"""


def main(version: str) -> int:
    """Return 0 when the printed command is all that it takes."""
    with tempfile.TemporaryDirectory(prefix="cncstepper-empty-", dir="/tmp", ignore_cleanup_errors=True) as folder:
        work = Path(folder)
        project = copy_project(work / "project")
        with start_window.screen() as display:
            asked = step(version, "ask", display, work, project)
            print(asked["command"], flush=True)
            install(asked["command"], work)
            done = step(version, "work", display, work, project)
    print(done, flush=True)
    return int(not (done.get("program", 0) > 0 and done.get("phase")))


def copy_project(folder: Path) -> Path:
    """Return a copy of what FreeCAD reads of the project, without .venv."""
    folder.mkdir()
    for name in PARTS:
        copy = shutil.copytree if (ROOT / name).is_dir() else shutil.copy2
        copy(ROOT / name, folder / name)
    return folder


def step(version: str, name: str, display: str, work: Path, project: Path) -> dict[str, Any]:
    """Return what FreeCAD's window answers in one step; raises RuntimeError with what went wrong."""
    answer, home, mark = work / f"{name}.json", work / "home", uuid.uuid4().hex
    start_window.make_home(home, autoload="NoneWorkbench")
    environment = {
        "CNCSTEPPER_STEP": name,
        "CNCSTEPPER_ANSWER": str(answer),
        "CNCSTEPPER_PACKAGES": "",
        "CNCSTEPPER_PYTHON": "",
        "PATH": "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin",
        "PYTHONPATH": "",
        "PYTHONNOUSERSITE": "1",
        "NUMBA_DISABLE_JIT": "1",  # compiling takes minutes, and is not what is judged
    }
    freecad = start_window.start(version, display, home, SCRIPT, environment, mark, project)
    try:
        freecad.wait(START_S)
    finally:
        start_window.end_all(mark)
    result = json.loads(answer.read_text("utf-8")) if answer.exists() else {"error": f"no answer to '{name}'"}
    if "error" in result:
        raise RuntimeError(result["error"])
    return dict(result)


def install(command: str, work: Path) -> None:
    """Run the printed command in a shell, as it stands."""
    (python,) = re.findall(r"^\S+", command)
    programs = work / "bin"
    programs.mkdir()
    if not runs(python):
        stand_in(programs / python, python.removeprefix("python"))
    path = f"{programs}{os.pathsep}{os.environ['PATH']}"
    subprocess.run(command, shell=True, check=True, timeout=INSTALL_S, env={**os.environ, "PATH": path})


def runs(python: str) -> bool:
    """Return whether a Python of that name is there and runs: a version manager's may only say that it does not."""
    found = shutil.which(python)
    return found is not None and subprocess.run([found, "-c", ""], capture_output=True).returncode == 0


def stand_in(program: Path, version: str) -> None:
    """Write a program that is a Python of another FreeCAD's folder, as far as pip goes."""
    kinds = ("manylinux_2_28", "manylinux_2_17", "manylinux2014")
    platforms = " ".join(f"--platform {kind}_{platform.machine()}" for kind in kinds)
    platforms += " --implementation cp --only-binary=:all:"
    python = ROOT / ".venv" / "bin" / "python"
    program.write_text(FOREIGN_PIP.format(python=python, version=version, platforms=platforms), "utf-8")
    program.chmod(0o755)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
