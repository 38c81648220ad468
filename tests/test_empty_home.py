# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whoever presses *Install packages…* can work, without another start of FreeCAD: from an empty home."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]


@pytest.mark.freecad
@pytest.mark.matrix
@pytest.mark.slow
def test_the_button_is_all_that_it_takes() -> None:
    result = subprocess.run(
        [sys.executable, str(ROOT / "tests" / "window_helpers" / "install_and_work.py"), "host"],
        capture_output=True,
        text=True,
        errors="replace",
        timeout=1200,
    )
    assert result.returncode == 0, result.stdout + result.stderr
