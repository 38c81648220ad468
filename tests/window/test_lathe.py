# SPDX-License-Identifier: LGPL-2.1-or-later
"""A lathe's job by mouse and keyboard: bar, profile by points, roughing and finishing; every panel has its picture."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtGui
from test_simulation_view import click_finding

from CNCStepper.workbench import api, panels
from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.document.turning import turning_defaults
from CNCStepper.workbench.features.base import problem_of, proxy_type
from CNCStepper.workbench.features.turning.turning_operation import TURNING_OPERATIONS
from CNCStepper.workbench.services.view_fit import look_at_lathe, show_all
from helpers.freecad.half_profiles import POINTS, edges, shaft, sketch
from window_helpers import screen_places as places
from window_helpers.file_dialogs import report_of
from window_helpers.hand import Hand
from window_helpers.task_panels import PANEL, accept, begin

SMALL_SCREEN = (1280, 690)  # pixels: 1280 × 720 with the window's frame


def the(kind: str) -> Any:
    (found,) = [obj for obj in FreeCAD.ActiveDocument.Objects if proxy_type(obj) == f"CNCStepper_{kind}"]
    return found


def rows(hand: Hand, *lines: str) -> None:
    """Type the rows of a profile in place of those that are there."""
    hand.click(f"{PANEL}points")
    hand.key("Ctrl+A")
    for number, line in enumerate(lines):
        if number:
            hand.key("Return")
        hand.type(line)


def text_of_core(job: Any) -> str:
    from CNCStepper.job.turning.make_turning import make_turning
    from CNCStepper.workbench.document.turning.core_turning_job import lathe_of, turning_job_of

    return make_turning(turning_job_of(job), lathe_of(job), job.Label)[0].program


def test_a_shaft_by_mouse_and_keyboard(hand: Hand, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    hand.main(FreeCAD.newDocument, "Shaft")
    begin(hand, "CNCStepper_NewLatheJob")
    hand.fill(f"{PANEL}stock_diameter_mm", "40")
    hand.fill(f"{PANEL}stock_length_mm", "90")
    hand.wait(lambda: the("LatheJob").Length.Value == 90, 10, "the bar")
    hand.shot("lathe-1-job")
    accept(hand)
    assert hand.main(lambda: the("TurningTool").Label) == "T1 CNMG 120408"
    begin(hand, "CNCStepper_TurningProfile")
    rows(hand, "24; 0", "24; -30; fillet 2", "36; -40", "36; -50")
    hand.wait(lambda: len(the("TurningProfile").Points) == 4, 10, "the rows")
    hand.key("Return")
    hand.type("36 -55")
    hand.wait(lambda: "no row" in note("points"), 10, "the refusal")
    hand.type("; -60")
    hand.wait(lambda: "nothing of a corner" in note("points") or "no row" in note("points"), 10, "the refusal")
    hand.shot("lathe-2-profile")
    for _ in range(len("36 -55; -60") + 1):
        hand.key("BackSpace")
    accept(hand)
    begin(hand, "CNCStepper_TurnRough", "Profile")
    assert hand.main(colours, hand.find(f"{PANEL}picture")) > 3
    hand.fill(f"{PANEL}ap_mm", "1,25")
    hand.wait(lambda: the("TurnRough").Ap.Value == 1.25, 60, "the depth")
    hand.fill(f"{PANEL}feed_mm_rev", "20")
    hand.wait(lambda: "at most" in note("feed_mm_rev"), 60, "the refusal")
    hand.fill(f"{PANEL}feed_mm_rev", "0.25")
    hand.shot("lathe-3-roughing")
    accept(hand)
    begin(hand, "CNCStepper_TurnFinish")
    accept(hand)
    job = hand.main(the, "LatheJob")
    assert hand.main(lambda: [problem_of(each) for each in (*job.Operations, job)]) == ["", "", ""]
    assert hand.main(lambda: api.program_text(job)) == hand.main(text_of_core, job)
    assert hand.main(lambda: the("TurnFinish").Drawings[0][0].Label) == "Profile"
    hand.shot("lathe-4-tree")
    every_other_command(hand, job)
    report_is_written(hand, tmp_path / "shaft.html", monkeypatch)
    hand.undo()
    hand.wait(lambda: len(job.Operations) == 1, 10, "the finishing to be gone")


def every_other_command(hand: Hand, job: Any) -> None:
    """Each adds its operation with a panel, a picture and a tool of its kind; Cancel takes it away again."""
    for cycle, kind in turning_defaults.KIND_OF_TOOL.items():
        if cycle in ("turn_rough", "turn_finish"):
            continue
        begin(hand, TURNING_OPERATIONS[cycle].Type)
        added = hand.main(lambda: job.Operations[-1])
        assert hand.main(lambda added=added: (added.Proxy.CYCLE, added.Tool.Kind)) == (cycle, kind)
        assert hand.main(colours, hand.find(f"{PANEL}picture")) > 3
        hand.click(f"{PANEL}cancel")
        hand.wait(lambda: len(job.Operations) == 2 and not FreeCADGui.Control.activeDialog(), 20, "the cancel")


def report_is_written(hand: Hand, file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Report… of the menu writes operations with tool and time, the half section with the bar, and the program."""
    page = report_of(hand, file, monkeypatch)
    for words in ("Ø 40 × 91 mm", "T1 CNMG 120408", "Roughing · T1 · ", "<!-- Z (mm) -->", "<!-- stock -->", "M02"):
        assert words in page, words


def colours(widget: Any) -> int:
    """How many colours lie on the middle line of a widget."""
    image = widget.grab().toImage()
    return len({image.pixel(x, image.height() // 2) for x in range(image.width())})


def note(key: str) -> str:
    labels = FreeCADGui.getMainWindow().findChildren(QtGui.QLabel, f"{PANEL}{key}_error")
    return str(labels[0].text()) if labels else ""


def new_shaft() -> Any:
    """Make a lathe's job and its profile by points, as a sketch, a solid and single edges."""
    document = FreeCAD.newDocument("Drawn")
    job = api.new_lathe_job(document, stock_diameter_mm=40)
    api.add_tool(job)
    api.add_profile(document, POINTS).Label = "Profile"
    api.add_profile(document, ("0; 0", *POINTS)).Label = "Section"  # that of a solid begins at the axis
    for draw in (sketch, shaft, edges):
        draw(document).ViewObject.LineWidth = 5
    document.recompute()
    look_at_lathe()
    show_all()
    return job


def only_shown(label: str) -> None:
    for obj in FreeCAD.ActiveDocument.Objects:
        if hasattr(obj, "Shape"):
            obj.ViewObject.Visibility = obj.Label == label


def show_beside_the_tasks() -> None:
    """Show all at half its size where FreeCAD covers the right part of the view with its tasks (1.1)."""
    if FreeCADGui.getMainWindow().findChild(QtGui.QTabWidget, "OverlayRight") is not None:
        camera = FreeCADGui.ActiveDocument.ActiveView.getCameraNode()
        camera.height = 2.0 * camera.height.getValue()


def begin_at_edges(hand: Hand, command: str) -> None:
    """Select the edges of the lines in the view, one after the other with Ctrl, and press a command's button."""
    hand.main(only_shown, "Lines")
    hand.main(show_beside_the_tasks)
    hand.main(FreeCADGui.Selection.clearSelection)
    for number, (x, z) in enumerate(((12, -10), (15, -20), (18, -30)), start=1):
        hand.click_view(hand.view_point(x, 0, z), modifiers=("Ctrl",) if number > 1 else ())
        hand.wait(lambda number=number: edges_selected() == number, 10, f"{number} edges to be selected")
    hand.command(command)
    hand.wait(lambda: hand.exists(f"{PANEL}ok"), 20, f"the panel of {command}")


def edges_selected() -> int:
    return sum(len(each.SubElementNames) for each in FreeCADGui.Selection.getSelectionEx())


def test_roughing_follows_a_sketch_a_solid_and_edges_that_are_selected(hand: Hand) -> None:
    job, texts = hand.main(new_shaft, limit_s=60), {}
    for label in ("Profile", "Sketch", "Section", "Shaft", "Lines"):
        if label == "Lines":
            begin_at_edges(hand, "CNCStepper_TurnRough")
        else:
            begin(hand, "CNCStepper_TurnRough", label)
        drawn, subs = hand.main(lambda: job.Operations[0].Drawings[0])
        assert (drawn.Label, [each for each in subs if each]) == (
            label, ["Edge1", "Edge2", "Edge3"] if label == "Lines" else []
        )  # fmt: skip
        accept(hand)
        hand.wait(lambda: not problem_of(job.Operations[0]) and api.program_text(job), 20, "the program")
        texts[label] = hand.main(lambda: api.program_text(job))
        hand.shot(f"lathe-drawn-{label}")
        hand.undo()
        hand.wait(lambda: not job.Operations, 10, "the roughing to be gone")
    assert texts["Profile"] == texts["Sketch"] == texts["Lines"]
    assert texts["Section"] == texts["Shaft"]


def test_a_collision_with_the_chuck_is_named_and_shown(hand: Hand) -> None:
    job = hand.main(new_shaft, limit_s=60)
    begin(hand, "CNCStepper_TurnRough", "Profile")
    accept(hand)

    def lengthen() -> None:
        text = api.program_text(job)
        farthest = max(re.findall(r"Z([\d.]+)", text), key=float)  # the mini-lathe's Z rises towards the chuck
        program_file.store(job, text.replace(f"Z{farthest}", f"Z{float(farthest) + 100:.4f}", 1))
        for obj in job.Document.Objects:
            obj.purgeTouched()

    hand.main(lengthen)
    hand.main(FreeCADGui.Selection.clearSelection)
    hand.tree(job.Label)
    hand.command("CNCStepper_Simulate")
    end = "CNCStepper_Simulation_end"
    hand.wait(lambda: hand.exists(end) and hand.find(end).isEnabled(), 180, "the simulation")
    rows = hand.find("CNCStepper_Findings_list")
    said = hand.main(lambda: [rows.item(k).text() for k in range(rows.count())])
    (collision,) = [text for text in said if "runs into the chuck" in text]
    line = int(re.findall(r"line (\d+)", collision)[0])
    assert hand.main(lambda: places.find("CNCStepper_Simulation_program").currentIndex().row()) != line - 1
    click_finding(hand, collision)
    hand.wait(lambda: places.find("CNCStepper_Simulation_program").currentIndex().row() == line - 1, 10, "the line")
    hand.shot("lathe-collision")
    hand.button("Close")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 10)


def every_operation() -> Any:
    document = FreeCAD.newDocument("Panels")
    job = api.new_lathe_job(document)
    api.add_tool(job)
    profile = api.add_profile(document, ("20; 0", "20; -30"))
    for cycle, kind in TURNING_OPERATIONS.items():
        api.add_operation(job, cycle, profile if kind.FOLLOWS else None)
    document.recompute()
    return job


@pytest.fixture(params=["English", "pt-BR"])
def language(request: Any, hand: Hand) -> Iterator[str]:
    """The window in that language; afterwards it is in English again."""
    hand.main(FreeCADGui.setLocale, request.param)
    yield request.param
    hand.main(FreeCADGui.setLocale, "English")


@pytest.fixture
def small_window(hand: Hand) -> Iterator[None]:
    """FreeCAD's window as large as a small screen; afterwards it fills the screen again."""

    def shrink() -> None:
        FreeCADGui.getMainWindow().showNormal()
        FreeCADGui.getMainWindow().resize(*SMALL_SCREEN)

    hand.main(shrink)
    hand.wait(lambda: FreeCADGui.getMainWindow().width() <= SMALL_SCREEN[0], 10, "the small window")
    yield
    hand.main(lambda: FreeCADGui.getMainWindow().showMaximized())
    hand.wait(lambda: FreeCADGui.getMainWindow().width() > SMALL_SCREEN[0], 10, "the large window")


def is_cut_off() -> bool:
    """Return whether the open panel is wider than its place, so that a person has to scroll sideways."""
    around = places.widgets_around(places.find(f"{PANEL}ok"))
    areas = [each for each in around if isinstance(each, QtGui.QScrollArea)]  # none in FreeCAD 1.1
    return bool(areas) and areas[0].horizontalScrollBar().maximum() > 0


@pytest.mark.usefixtures("small_window")
def test_every_panel_of_the_lathe_on_a_small_screen(hand: Hand, language: str) -> None:
    job = hand.main(every_operation)
    for obj in (job, *hand.main(lambda: [job.Tools[0], *job.Operations, *job.Operations[1].OutList[1:2]])):
        hand.main(panels.edit, obj)
        hand.wait(lambda: hand.exists(f"{PANEL}ok"), 20, "the panel")
        hand.shot(f"lathe-{language}-{hand.main(proxy_type, obj)}", FreeCADGui.getMainWindow())
        assert not hand.main(is_cut_off), hand.main(proxy_type, obj)
        if hand.exists(f"{PANEL}tool"):
            assert hand.main(lambda: places.find(f"{PANEL}tool").toolTip()).startswith("T1 CNMG 120408\n")
            shown = hand.main(lambda: places.find(f"{PANEL}tool").shown_text())
            assert shown == "T1 CNMG 120408" or (shown.startswith("T1 C") and shown.endswith("…"))
        hand.click(f"{PANEL}cancel")
        hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 20, "the panel to close")
