# SPDX-License-Identifier: LGPL-2.1-or-later
"""A torch's G-code file without F, sent from the dock: material, thickness and consumable asked, the feed shown."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtGui

from CNCStepper.job.proof_folder import SEND
from CNCStepper.machine.cut_charts import cut_data_for
from CNCStepper.workbench import api
from CNCStepper.workbench.dock.model.port_choices import VIRTUAL
from window_helpers import screen_places as places
from window_helpers.hand import Hand

D, C = "CNCStepper_Dock_", "CNCStepper_Cut_"
PROGRAM = "G21 G90\nG0 X20 Y20\nM3 S1\nG4 P{0}\nG1 X60\nY50\nM5\nG0 X0 Y0\nM2\n"


@pytest.fixture
def dock(hand: Hand) -> Iterator[Any]:
    """The dock's panel for the torch table; closed afterwards with all documents."""
    hand.command("CNCStepper_Controller")
    hand.wait(lambda: FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, "CNCStepper_Dock"))
    shown = hand.main(FreeCADGui.getMainWindow().findChild, QtGui.QDockWidget, "CNCStepper_Dock")
    panel = hand.main(shown.widget)
    hand.main(panel.connection.look, VIRTUAL)
    before = hand.main(lambda: panel.connection.profile)
    hand.main(panel.connection.machine.setCurrentText, "torch-table")
    yield panel
    hand.main(panel.sending.away)
    hand.main(panel.connection.machine.setCurrentText, before)
    hand.main(shown.close)
    hand.main(lambda: [FreeCAD.closeDocument(name) for name in FreeCAD.listDocuments()])


def choose_file(hand: Hand, file: Path) -> None:
    hand.click(f"{D}SendFile")
    hand.wait(lambda: hand.exists("CNCStepper_Editor_file"), 10, "the question which file")
    for _ in range(3):  # the list that completes names may take the folder, and show it
        hand.fill("fileNameEdit", str(file))
        hand.key("Return")
        if not hand.exists("CNCStepper_Editor_file"):
            break
    hand.wait(lambda: hand.exists(f"{C}ok"), 10, "how it is cut")


@pytest.mark.window("plain", "portuguese")
def test_a_file_without_a_job_is_cut_with_the_charts_feed(hand: Hand, dock: Any, tmp_path: Path) -> None:
    row = cut_data_for("plasma", "mild-steel", 6.0)
    file = tmp_path / "peça.nc"
    file.write_text(PROGRAM.format(row.pierce_delay_s), "utf-8")
    choose_file(hand, file)
    hand.main(lambda: places.find(f"{C}thickness").setValue(900.0))
    hand.wait(lambda: places.visible("CNCStepper_Cut_error"), what="why this thickness cannot be cut")
    assert not hand.main(lambda: places.find(f"{C}ok").isEnabled())
    hand.shot("file-cut-refused")
    hand.main(lambda: places.find(f"{C}thickness").setValue(6.0))
    hand.wait(lambda: f"{row.feed_mm_min:g}" in hand.text(f"{C}feed"), what="the feed")
    hand.shot("file-cut")
    hand.click(f"{C}ok")
    hand.wait(lambda: hand.exists(f"{D}Start"), 240, "the proof")
    result = hand.main(lambda: dock.sending._result)
    assert not result.refused, result.findings
    assert result.report["cut_length_mm"] > 60
    lines = hand.main(lambda: api.program_text(FreeCAD.ActiveDocument.findObjects("App::FeaturePython")[-1]))
    assert "F" not in lines.replace("G", "")
    with_feed = [line for line in _sent(result.send_file) if f"F{row.feed_mm_min:g}" in line]
    assert len(with_feed) == 1
    hand.shot("file-cut-proven")


def _sent(certificate: Path) -> list[str]:
    from CNCStepper.control.program.certificate import Certificate

    assert certificate.name == SEND
    return list(Certificate.read(certificate).lines)


def test_a_jobs_own_values_are_offered_and_others_make_a_job_of_their_own(
    hand: Hand, dock: Any, tmp_path: Path
) -> None:
    file = tmp_path / "part.nc"
    file.write_text(PROGRAM.format(0.5), "utf-8")
    values = {"machine": "torch-table", "process": "plasma", "material": "mild-steel", "stock_size_mm": (200, 150, 3)}
    job = hand.main(lambda: api.new_job(FreeCAD.newDocument("Cut"), stock_form="sheet", **values))
    hand.main(lambda: (api.chart_tool(job), job.Document.recompute()))
    choose_file(hand, file)
    assert hand.main(lambda: places.find(f"{C}thickness").value()) == 3.0
    assert not hand.exists(f"{C}x")
    hand.main(lambda: places.find(f"{C}thickness").setValue(6.0))
    hand.click(f"{C}ok")
    hand.wait(lambda: hand.exists(f"{D}Start") or hand.exists(f"{D}Away"), 240, "the proof")
    jobs = hand.main(lambda: [one for one in job.Document.Objects if getattr(one, "Process", "") == "plasma"])
    assert [hand.main(lambda one=one: one.StockSize.z) for one in jobs] == [3.0, 6.0]
    hand.main(dock.sending.away)
