# SPDX-License-Identifier: LGPL-2.1-or-later
"""Starts headless FreeCAD with a benchmark's own file, and shows what that prints there."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
import traceback
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def is_measuring(name: str) -> bool:
    """Tell whether this is FreeCAD, which runs the benchmark of that name; there its file is no __main__."""
    return os.environ.get("CNCSTEPPER_BENCH") == name


def run(file: str, name: str, inside: Callable[[], None]) -> None:
    """Call `inside` when FreeCAD runs the benchmark's file, else start FreeCAD with it.

    What `inside` writes to the error stream in lines that begin with `name` and a colon is printed.
    """
    if is_measuring(name):
        _end_after(inside)
    with tempfile.TemporaryDirectory() as home:
        command = [str(shutil.which("freecadcmd")), file, "-M", str(ROOT)]
        environment = {
            **os.environ,
            "FREECAD_USER_HOME": home,
            "CNCSTEPPER_BENCH": name,
            "PYTHONPATH": str(ROOT / "bench"),
        }
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    print("\n".join(line for line in done.stderr.splitlines() if line.startswith(f"{name}:")))
    if done.returncode:
        sys.exit(done.stderr)


def _end_after(inside: Callable[[], None]) -> None:
    """Measure and leave by os._exit: FreeCAD would go on to its prompt."""
    try:
        inside()
    except BaseException:
        traceback.print_exc()
        os._exit(1)
    os._exit(0)
