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
    hand.fill(f"{C}thickness", "900")
    hand.wait(lambda: places.visible("CNCStepper_Cut_error"), what="why this thickness cannot be cut")
    assert not hand.main(lambda: places.find(f"{C}ok").isEnabled())
    hand.shot("file-cut-refused")
    hand.fill(f"{C}thickness", "6")
    for choice in ("material", "consumable", "process"):
        choose_another_and_back(hand, f"{C}{choice}")
    for axis, size in (("x", "310"), ("y", "170")):
        hand.fill(f"{C}{axis}", size)
    hand.wait(lambda: f"{row.feed_mm_min:g}" in hand.text(f"{C}feed"), what="the feed")
    hand.shot("file-cut")
    hand.click(f"{C}ok")
    hand.wait(lambda: hand.exists(f"{D}Start"), 240, "the proof")
    result = hand.main(lambda: dock.sending._result)
    assert not result.refused, result.findings
    assert result.report["cut_length_mm"] > 60
    lines = hand.main(lambda: api.program_text(FreeCAD.ActiveDocument.findObjects("App::FeaturePython")[-1]))
    assert "F" not in lines.replace("G", "")
    (job,) = hand.main(lambda: [one for one in FreeCAD.ActiveDocument.Objects if hasattr(one, "StockSize")])
    assert hand.main(lambda: (job.StockSize.x, job.StockSize.y)) == (310, 170)
    with_feed = [line for line in _sent(result.send_file) if f"F{row.feed_mm_min:g}" in line]
    assert len(with_feed) == 1
    hand.shot("file-cut-proven")


def choose_another_and_back(hand: Hand, box: str) -> None:
    """Choose the last of a box's entries, which shows another feed or none, then the one that stood there."""
    texts = hand.main(lambda: [places.find(box).itemText(row) for row in range(places.find(box).count())])
    before, feed = hand.text(box), hand.text(f"{C}feed")
    hand.choose(box, next(text for text in reversed(texts) if text != before or len(texts) == 1))
    hand.wait(lambda: len(texts) == 1 or hand.text(f"{C}feed") != feed, what=f"what {box} changes")
    hand.choose(box, before)
    hand.wait(lambda: hand.text(box) == before)


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
    objects = hand.main(lambda: len(job.Document.Objects))
    choose_file(hand, file)
    assert hand.main(lambda: places.find(f"{C}thickness").value()) == 3.0
    assert not hand.exists(f"{C}x")
    hand.click(f"{C}cancel")
    hand.wait(lambda: not hand.exists(f"{C}ok"), what="the question to go")
    assert hand.exists(f"{D}SendFile") and hand.main(lambda: len(job.Document.Objects)) == objects
    choose_file(hand, file)
    hand.fill(f"{C}thickness", "6")
    hand.click(f"{C}ok")
    hand.wait(lambda: hand.exists(f"{D}Start") or hand.exists(f"{D}Away"), 240, "the proof")
    jobs = hand.main(lambda: [one for one in job.Document.Objects if getattr(one, "Process", "") == "plasma"])
    assert [hand.main(lambda one=one: one.StockSize.z) for one in jobs] == [3.0, 6.0]
    hand.main(dock.sending.away)
