# SPDX-License-Identifier: LGPL-2.1-or-later
"""File dialogs, answered with a path."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide import QtGui

from CNCStepper.workbench.report import job_report
from window_helpers import screen_places as places
from window_helpers.hand import Hand


def choose_file(hand: Hand, dialog: str, path: Path, kind: str = "") -> None:
    """Answer the file dialog with this objectName, and wait until it is gone; kind: of file, where it is chosen."""
    hand.wait(lambda: places.visible(dialog), 20, f"{dialog} to ask")
    if kind:
        hand.choose(hand.main(lambda: places.find(dialog).findChild(QtGui.QComboBox, "fileTypeCombo")), kind)
    line = hand.main(lambda: places.find(dialog).findChild(QtGui.QLineEdit, "fileNameEdit"))
    hand.main(line.setText, str(path))
    hand.click(line)
    hand.key("Return")
    hand.wait(lambda: not places.visible(dialog), 10, f"{dialog} to close")


def report_of(hand: Hand, file: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """Let Report… of the menu write the selected job's page to an HTML file, which no reader opens; return its text."""
    shown: list[str] = []
    monkeypatch.setattr(job_report, "show", shown.append)
    hand.menu("CNCStepper", "Report…")
    choose_file(hand, "CNCStepper_Report_file", file)
    hand.wait(lambda: shown == [str(file)], 180, "the report")
    return file.read_text("utf-8")
