# SPDX-License-Identifier: LGPL-2.1-or-later
"""A test file that calls a kernel when it is imported is not collected."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
SOURCE = """import numpy as np
from CNCStepper.gcode.interpreter.flow.o_word_kernel import needs_interpreter
{call}
def test_planted():
    pass
"""
CALL = "needs_interpreter(np.zeros(1, np.uint8))"


@pytest.mark.slow
@pytest.mark.parametrize("call, status", [(CALL, 2), (f"def _called(): {CALL}", 0)])
def test_a_kernel_called_at_import_fails_the_run(call: str, status: int, tmp_path: Path) -> None:
    planted = tmp_path / "test_planted.py"
    planted.write_text(SOURCE.format(call=call), "utf-8")
    options = ("--collect-only", "-p", "no:cacheprovider", "-p", "unit.conftest", "-c", ROOT / "pyproject.toml")
    run = subprocess.run(
        [sys.executable, "-m", "pytest", *options, planted], cwd=ROOT, capture_output=True, encoding="utf-8"
    )
    assert run.returncode == status, run.stdout + run.stderr
    assert ("test_planted.py calls a kernel when it is imported" in run.stdout) == bool(status), run.stdout
