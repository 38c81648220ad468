# SPDX-License-Identifier: LGPL-2.1-or-later
"""Starts the tests of tests/freecad inside headless FreeCAD, once more under a locale with a decimal comma."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
LOCALES = ROOT / ".venv" / "locale"


def freecadcmd() -> str:
    found = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    assert found, "FreeCAD's freecadcmd is not on PATH: run 'make setup'"
    return found


def run_inside(home: Path, *pytest_arguments: str, **environment: str) -> subprocess.CompletedProcess[str]:
    """Run tests/freecad/run.py in FreeCAD with a user folder of its own; options stand after the script (0.20)."""
    return subprocess.run(
        [freecadcmd(), str(ROOT / "tests" / "freecad" / "run.py"), "-M", str(ROOT)],
        env={
            **os.environ,
            "LC_ALL": "C.UTF-8",
            "FREECAD_USER_HOME": str(home),
            "CNCSTEPPER_PYTEST": "\n".join(pytest_arguments),
            **environment,
        },
        capture_output=True,
        text=True,
        timeout=300,
    )


def passed(output: str) -> int:
    counts = re.findall(r"^=*\s*(\d+) passed(?:, \d+ warnings?)? in", output, re.MULTILINE)
    return int(counts[-1]) if counts else 0


@pytest.mark.freecad
@pytest.mark.matrix
@pytest.mark.parametrize("locale", ["C.UTF-8", "pt_BR.UTF-8"])
def test_the_workbench_inside_freecad(locale: str, tmp_path: Path) -> None:
    environment = {"LC_ALL": locale} | ({} if locale.startswith("C.") else {"LOCPATH": str(LOCALES)})
    result = run_inside(tmp_path, **environment)
    assert result.returncode == 0, result.stdout + result.stderr
    assert passed(result.stdout) > 10, result.stdout


@pytest.mark.freecad
def test_a_failure_inside_freecad_is_seen_outside(tmp_path: Path) -> None:
    planted = tmp_path / "test_planted.py"
    planted.write_text("import FreeCAD\ndef test_planted():\n    assert FreeCAD.Version()[0] == 'none'\n")
    result = run_inside(tmp_path / "home", str(planted))
    assert result.returncode == 1, result.stdout
    assert "test_planted" in result.stdout
