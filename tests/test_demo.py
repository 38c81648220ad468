# SPDX-License-Identifier: LGPL-2.1-or-later
"""The demo from a folder with a space and non-ASCII letters, under a locale with a decimal comma."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]


def copied(folder: Path) -> Path:
    """Copy the project's own files into `folder`; .venv is linked, for it takes minutes to make."""
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT,
        check=True,
        capture_output=True,
    )
    for name in filter(None, listed.stdout.decode("utf-8").split("\0")):
        if (ROOT / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, folder / name)
    (folder / ".venv").symlink_to(ROOT / ".venv")
    return folder


@pytest.mark.slow
@pytest.mark.freecad
def test_the_demo_cuts_the_part(tmp_path: Path) -> None:
    folder = copied(tmp_path / "peça nº 1")
    comma = {"LC_ALL": "pt_BR.UTF-8", "LOCPATH": str(ROOT / ".venv" / "locale"), "PYTHONPATH": str(folder)}
    demo = subprocess.run(
        [str(folder / ".venv" / "bin" / "python"), "examples/demo.py"],
        cwd=folder,
        env=os.environ | comma | {"FREECAD_USER_HOME": str(tmp_path / "home")},
        capture_output=True,
        encoding="utf-8",
        timeout=300,
    )
    assert demo.returncode == 0, demo.stdout + demo.stderr
    assert "The part is right" in demo.stdout
    out = folder / "build" / "demo"
    report = json.loads((out / "report.json").read_text("utf-8"))
    assert report["gouge_mm"] <= 0.01 and report["left_over_mm"] <= 0.01
    assert (out / "part.png").stat().st_size > 50_000
    assert (out / "demo.FCStd").stat().st_size > 10_000
    assert_linuxcnc_traces_the_same(out / "program.nc")


def assert_linuxcnc_traces_the_same(program: Path) -> None:
    """Compare every canonical call of LinuxCNC's own interpreter with ours."""
    theirs = subprocess.run(["rs274", "-g", str(program)], check=True, capture_output=True, encoding="utf-8")
    ours = subprocess.run(
        [sys.executable, "-m", "CNCStepper.cli", "trace", str(program)],
        check=True,
        capture_output=True,
        encoding="utf-8",
    )
    expected = [line.removeprefix("executing").strip() for line in theirs.stdout.splitlines()]
    got = [line.strip() for line in ours.stdout.splitlines()]
    assert sum("ARC_FEED" in line or "STRAIGHT_FEED" in line for line in got) > 800
    assert got == [line for line in expected if line]
