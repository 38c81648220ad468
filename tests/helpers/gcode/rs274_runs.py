# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of LinuxCNC's own stand-alone interpreter, the judge of ours."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

NUMBER = re.compile(r"-?\d+\.\d+")


def run_rs274(
    home: Path, *arguments: str, folder_of_program: Path | None = None, timeout_s: float = 60
) -> subprocess.CompletedProcess[str]:
    """Run `rs274 -g ARGUMENTS` in a folder, `home` where none is given: there it looks for subroutines.

    rs274 keeps its tool table in HOME, mapped to memory: two runs that share it kill each other.
    """
    return subprocess.run(
        ["rs274", "-g", *arguments],
        cwd=folder_of_program or home,
        env={**os.environ, "HOME": str(home)},
        capture_output=True,
        encoding="latin-1",
        timeout=timeout_s,
    )


def rs274_calls(text: str, folder: Path) -> tuple[list[str], bool]:
    """Return what rs274 prints for a program, and whether it accepted it."""
    (folder / "program.ngc").write_bytes(text.encode("latin-1"))
    run = run_rs274(folder, "program.ngc")
    return [line.rstrip() for line in run.stdout.splitlines() if line.strip()], run.returncode == 0


def same_call(ours: str, theirs: str) -> bool:
    """Whether two printed calls are the same, their numbers to the 4th decimal."""
    mine, real = NUMBER.findall(ours), NUMBER.findall(theirs)
    if NUMBER.sub("#", ours.rstrip()) != NUMBER.sub("#", theirs.rstrip()) or len(mine) != len(real):
        return False
    return all(abs(float(a) - float(b)) < 1.01e-4 for a, b in zip(mine, real, strict=True))
