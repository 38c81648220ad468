# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page in FreeCAD's preferences: what is chosen there with real clicks is what the next job begins with."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtCore

from CNCStepper.workbench.document import preferred_values as preferred
from CNCStepper.workbench.document.preferred_values import GROUP
from CNCStepper.workbench.features.base import JOB, proxy_type
from CNCStepper.workbench.first_run import card_setting
from CNCStepper.workbench.preferences.job_preferences import JobPreferences
from CNCStepper.workbench.proving.prove_program import proposed
from window_helpers import screen_places as places
from window_helpers.file_dialogs import choose_file
from window_helpers.hand import Hand
from window_helpers.interface import LONGEST_MS
from window_helpers.processor_speed import slowness

P = "CNCStepper_Preferences"


def box(name: str) -> Any:
    found = [widget for widget in places.all_widgets() if widget.objectName() == f"{P}_{name}"]
    return next((widget for widget in found if widget.isVisible()), None)


@pytest.mark.window("plain", "portuguese")
def test_what_is_preferred_is_what_the_next_job_begins_with(hand: Hand, tmp_path: Path) -> None:
    hand.main(lambda: QtCore.QTimer.singleShot(0, lambda: FreeCADGui.showPreferences("CNCStepper")))
    hand.wait(lambda: box("machine"), 20, "the page")
    hand.settle()
    hand.shot("preferences")
    assert hand.main(lambda: places.narrower_than_their_text(box("folder").parent().parent())) == []

    for name, value in (("machine", "table-b"), ("material", "mdf"), ("units", "inch")):
        combo = hand.main(box, name)
        hand.choose(combo, hand.main(lambda combo=combo, value=value: combo.itemText(combo.findData(value))))
    hand.fill(hand.main(box, "thickness"), "65")
    closed = hand.main(card_setting.was_closed)
    hand.click(hand.main(box, "card"))
    hand.fill(hand.main(box, "folder"), str(tmp_path.parent))
    hand.click(hand.main(box, "browse"))
    choose_file(hand, f"{P}_folder_dialog", tmp_path)
    hand.wait(lambda: box("folder").text() == str(tmp_path), 5, "the folder that was chosen")
    hand.click(hand.main(box, "folder"))
    hand.key("Return")  # OK
    hand.wait(lambda: box("machine") is None, 10, "the dialog to close")
    assert hand.main(card_setting.was_closed) != closed
    try:
        hand.main(FreeCAD.newDocument, "Preferred")
        hand.command("CNCStepper_NewJob")
        job = hand.wait(lambda: next(filter(is_job, FreeCAD.ActiveDocument.Objects), None), 10, "the job")
        assert (job.Material, job.Units, job.Machine) == ("mdf", "inch", "table-b")
        assert hand.main(proposed, job).parent == tmp_path and preferred.thickness_mm() == 65.0
        hand.key("Escape")
    finally:
        hand.main(lambda: (FreeCAD.ParamGet(GROUP).Clear(), card_setting.remember_closed(closed)))
        hand.main(FreeCADGui.Control.closeDialog)
        hand.main(FreeCAD.closeDocument, "Preferred")


def page_times_ms() -> dict[str, float]:
    """Return the processor time that the page takes to be made, to show what is preferred and to keep it."""

    def timed_ms(act: Callable[[], Any]) -> tuple[Any, float]:
        begun_s = time.thread_time()
        made = act()
        return made, 1000 * (time.thread_time() - begun_s) / slow

    slow = slowness()
    page, making_ms = timed_ms(JobPreferences)
    times_ms = {act.__name__: timed_ms(act)[1] for act in (page.loadSettings, page.saveSettings)}
    page.form.deleteLater()
    return {"making": making_ms, **times_ms}


def test_no_call_of_the_page_keeps_the_window(hand: Hand) -> None:
    """FreeCAD makes its whole dialog in one event, so the page's own calls are timed one by one."""
    closed = hand.main(card_setting.was_closed)
    try:
        times_ms = hand.main(page_times_ms)
    finally:
        hand.main(lambda: (FreeCAD.ParamGet(GROUP).Clear(), card_setting.remember_closed(closed)))
    print(times_ms, flush=True)
    assert max(times_ms.values()) < LONGEST_MS, times_ms


def is_job(obj: Any) -> bool:
    return proxy_type(obj) == JOB
