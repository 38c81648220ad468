# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a milling job, by its menu entry; test_lathe.py has a lathe's."""

from __future__ import annotations

from pathlib import Path

import FreeCADGui
import pytest
from test_tree import job  # noqa: F401

from CNCStepper.workbench import api
from window_helpers.file_dialogs import report_of
from window_helpers.hand import Hand


def test_a_milling_jobs_report_is_written_by_a_click(
    hand: Hand,
    job: object,  # noqa: F811
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    hand.main(FreeCADGui.Selection.addSelection, job)
    page = report_of(hand, tmp_path / "peça 1.html", monkeypatch)
    for words in ("T1 flat end mill 6 mm", "EllipticalPocket001 · T1 · ", "<!-- X (mm) -->", "<!-- stock -->"):
        assert words in page, words
    lines = hand.main(api.program_text, job).splitlines()
    assert all(line in page for line in (lines[0], lines[-1]))
