# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whoever follows the command that the workbench prints for missing packages can work: from an empty home."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]


@pytest.mark.freecad
@pytest.mark.matrix
@pytest.mark.slow
def test_the_printed_command_is_all_that_it_takes() -> None:
    result = subprocess.run(
        [sys.executable, str(ROOT / "tests" / "window_helpers" / "follow_command.py"), "host"],
        capture_output=True,
        text=True,
        errors="replace",
        timeout=1200,
    )
    assert result.returncode == 0, result.stdout + result.stderr
