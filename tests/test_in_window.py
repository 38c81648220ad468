# SPDX-License-Identifier: LGPL-2.1-or-later
"""What goes wrong inside FreeCAD's window is seen outside: planted tests that must fail, each in its own window."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PLANTED = {  # the source, the exit status, and what is said
    "passes": ("def test_planted(hand):\n    assert hand.main(int, '7') == 7", 0, ("1 passed",)),
    "fails": (
        "import FreeCAD\ndef test_planted(hand):\n    assert hand.main(int, '7') == 8\n"
        "def test_report(hand):\n    hand.main(FreeCAD.Console.PrintWarning, 'planted warning\\n')",
        1,
        ("1 failed, 1 passed", "1 error", "the report view holds:"),
    ),
    "crashes": ("import os\ndef test_planted(hand):\n    hand.main(os.abort)", 1, ("ended before the tests did",)),
    "hangs": ("import time\ndef test_planted(hand):\n    hand.main(time.sleep, 600)", 1, ("FreeCAD still runs after",)),
    "leaves": (
        "import subprocess\ndef test_planted(hand):\n    subprocess.Popen(['sleep', '600'], start_new_session=True)",
        1,
        ("processes were left behind:",),
    ),
}
LIMIT_S = {"hangs": "5"}  # once the window is ready; others have time to end
READY_S = 600  # so long may a window take that compiles the kernels first


@pytest.mark.freecad
@pytest.mark.slow
@pytest.mark.parametrize("name", PLANTED)
def test_what_happens_in_a_window_is_seen_outside(name: str, tmp_path: Path) -> None:
    source, status, words = PLANTED[name]
    planted = tmp_path / "test_planted.py"
    planted.write_text(source + "\n", "utf-8")
    limits = {"CNCSTEPPER_WINDOW_LIMIT_S": LIMIT_S.get(name, "40"), "CNCSTEPPER_WINDOW_LEAVE_S": "2"}
    script = ROOT / "tests" / "window_helpers" / "start_window.py"
    result = subprocess.run(
        [sys.executable, str(script), "host", str(planted), "-p", "conftest"],
        env={**os.environ, **limits},
        capture_output=True,
        text=True,
        errors="replace",
        timeout=READY_S + 120,
    )
    assert result.returncode == status, result.stdout + result.stderr
    assert all(word in result.stdout + result.stderr for word in words), result.stdout + result.stderr
