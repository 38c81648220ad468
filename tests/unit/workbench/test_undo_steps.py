# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every transaction is opened in one place, so that macros miss none."""

from __future__ import annotations

from helpers.imports import ROOT

ROOM = ROOT / "CNCStepper" / "workbench"


def test_only_undo_steps_opens_transactions_and_a_macro_that_runs() -> None:
    openers = {
        path.relative_to(ROOM).as_posix()
        for path in ROOM.rglob("*.py")
        if ".openTransaction(" in path.read_text("utf-8")
    }
    assert openers == {"document/undo_steps.py", "macro.py"}
