# SPDX-License-Identifier: LGPL-2.1-or-later
"""Operations by mouse and keyboard: a pocket with an island, a grid of holes, a contour with tabs; every panel."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import Draft
import FreeCAD
import FreeCADGui
import Part
import pytest
from FreeCAD import Vector
from PySide import QtCore, QtGui

from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench import api, panels
from CNCStepper.workbench.features.base import problem_of, proxy_type
from CNCStepper.workbench.features.catalogue import OPERATIONS
from CNCStepper.workbench.panels.tools.tool_words import tool_words
from CNCStepper.workbench.proving.proof_process import ProofRun
from window_helpers import screen_places as places
from window_helpers.hand import Hand
from window_helpers.task_panels import PANEL, accept, begin

RIGHT = QtCore.Qt.ArrowType.RightArrow  # of a group that is folded
PORTUGUESE = "pt-BR"
DRAWN = {"pocket": "Hollow", "contour": "Outline", "engrave": "Hollow"}
MILLED = [cycle for cycle, kind in OPERATIONS.items() if "milling" in kind.BY]
CHOSEN = {"contour": {"tabs_by": "count", "lead_in_kind": "arc", "lead_out_kind": "line"}, "drill": {"style": "G83"}}


def polygon(*corners: tuple[float, float]) -> list[Any]:
    return [Part.LineSegment(Vector(*a, 0), Vector(*b, 0)) for a, b in pairwise((*corners, corners[0]))]


def sketch(document: Any, label: str, *lines: Any) -> Any:
    made = document.addObject("Sketcher::SketchObject", "Sketch")
    made.Label = label
    for line in lines:
        made.addGeometry(line, False)
    return made


def draw() -> None:
    """Make a document with the outline of a plate and, within, that of a pocket with an island."""
    document = FreeCAD.newDocument("Plate")
    document.UndoMode = 1
    sketch(document, "Outline", *polygon((-40, -30), (40, -30), (40, 30), (-40, 30)))
    island = Part.Circle(Vector(5, 0, 0), Vector(0, 0, 1), 6)
    sketch(document, "Hollow", *polygon((-15, -20), (30, -20), (30, 20), (-15, 15)), island)
    document.recompute()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.SendMsgToActiveView("ViewFit")


def the(kind: str) -> Any:
    (found,) = [obj for obj in FreeCAD.ActiveDocument.Objects if proxy_type(obj) == f"CNCStepper_{kind}"]
    return found


def unfold(name: str = "") -> None:
    """Open the group with this name in the open panel, or all."""
    window = FreeCADGui.getMainWindow()
    for head in window.findChildren(QtGui.QToolButton):
        ours = head.objectName().startswith(f"{PANEL}group_{name}")
        if ours and head.isVisible() and head.arrowType() == RIGHT:
            head.click()


def test_a_plate_by_mouse_and_keyboard(hand: Hand) -> None:
    hand.main(compile_kernels, limit_s=300)
    hand.main(draw)
    make_job(hand)
    make_pocket(hand)
    drill_a_grid(hand)
    cut_it_out(hand)
    check(hand)


def compile_kernels() -> None:
    """Cut each kind once: on a computer where that has never been done it takes a while."""
    every_panel()
    FreeCAD.closeDocument("Plate")


def make_job(hand: Hand) -> None:
    begin(hand, "CNCStepper_NewJob", "Outline")
    hand.click(f"{PANEL}tools_add")
    hand.choose(f"{PANEL}shape", "drill")
    hand.fill(f"{PANEL}diameter_mm", "3")
    hand.fill(f"{PANEL}feed_mm_min", "120")
    hand.fill(f"{PANEL}plunge_mm_min", "120")
    hand.wait(lambda: the("Job").Tools[1].Diameter.Value == 3, 10, "the drill")
    hand.shot("cycles-1-job")
    accept(hand)


def choose_tool(hand: Hand, number: int) -> None:
    hand.choose(f"{PANEL}tool", hand.main(lambda: tool_words(the("Job").Tools[number - 1])))


def make_pocket(hand: Hand) -> None:
    begin(hand, "CNCStepper_Pocket", "Hollow")
    choose_tool(hand, 1)
    hand.fill(f"{PANEL}depth_mm", "4")
    hand.choose(f"{PANEL}pattern", "zigzag")
    hand.wait(lambda: places.visible(f"{PANEL}angle_deg"), 5, "the zigzag's angle")
    hand.choose(f"{PANEL}pattern", "along the walls")
    hand.wait(lambda: not places.visible(f"{PANEL}angle_deg"), 5, "the angle to go")
    hand.fill(f"{PANEL}stepover_mm", "7")
    hand.wait(lambda: "larger than the tool" in hand_note("stepover_mm"), 5, "the refusal")
    hand.fill(f"{PANEL}stepover_mm", "2,4")
    hand.shot("cycles-2-pocket")
    accept(hand)
    pocket = hand.main(the, "Pocket")
    held = hand.main(lambda: (pocket.Depth.Value, pocket.Pattern, pocket.Stepover.Value, pocket.Drawings[0][0].Label))
    assert held == (4, "offset", 2.4, "Hollow")
    assert hand.main(lambda: pocket.Levels) == 3


def hand_note(key: str) -> str:
    label = FreeCADGui.getMainWindow().findChild(QtGui.QLabel, f"{PANEL}{key}_error")
    return label.text() if label is not None and label.isVisible() else ""


def drill_a_grid(hand: Hand) -> None:
    begin(hand, "CNCStepper_Drill")
    choose_tool(hand, 2)
    hand.choose(f"{PANEL}pattern_kind", "grid")
    hand.wait(lambda: places.visible(f"{PANEL}pattern_columns"), 5, "the grid's fields")
    assert not hand.exists(f"{PANEL}pattern_radius_mm")
    for key, text in {"origin_mm_x": "-34", "origin_mm_y": "-24", "spacing_mm_x": "68", "spacing_mm_y": "24"}.items():
        hand.fill(f"{PANEL}pattern_{key}", text)
    hand.fill(f"{PANEL}pattern_columns", "2")
    hand.fill(f"{PANEL}pattern_rows", "3")
    hand.fill(f"{PANEL}depth_mm", "6")
    hand.choose(f"{PANEL}style", "G83 pecks, all out")
    hand.wait(lambda: places.visible(f"{PANEL}peck_mm"), 5, "the peck")
    hand.fill(f"{PANEL}peck_mm", "1,5")
    hand.wait(lambda: the("Drill").Holes == 6, 5, "six holes")
    hand.shot("cycles-3-drill")
    accept(hand)


def cut_it_out(hand: Hand) -> None:
    begin(hand, "CNCStepper_Contour", "Outline")
    choose_tool(hand, 1)
    hand.fill(f"{PANEL}stepdown_mm", "4")
    hand.click(f"{PANEL}group_tabs")
    hand.choose(f"{PANEL}tabs_by", "count")
    hand.fill(f"{PANEL}tabs_count", "4")
    hand.fill(f"{PANEL}tabs_height_mm", "2")
    hand.click(f"{PANEL}group_leads")
    hand.click(f"{PANEL}lead_in_kind")
    hand.key("End")  # the last of the list that has opened
    hand.key("Return")
    hand.wait(lambda: the("Contour").LeadInKind == "arc", 5, "the arc")
    hand.fill(f"{PANEL}lead_in_radius_mm", "2")
    hand.wait(lambda: the("Contour").TabsMade == 4, 10, "four tabs")
    hand.shot("cycles-4-contour")
    accept(hand)


def check(hand: Hand) -> None:
    """The program holds all three, and the product's own proof finds nothing in it."""
    job = hand.main(the, "Job")
    text = hand.main(api.program_text, job)
    assert [name for name in ("pocket", "drill", "contour") if f"{name})" in text] == ["pocket", "drill", "contour"]
    assert [tool for tool in ("T1", "T2") if tool in text] == ["T1", "T2"]
    hand.main(lambda: FreeCADGui.ActiveDocument.ActiveView.viewIsometric())
    hand.main(FreeCADGui.SendMsgToActiveView, "ViewFit")
    hand.shot("cycles-5-program")

    told: list[Any] = []

    def prove() -> Any:
        run = ProofRun(job, FreeCADGui.getMainWindow())
        run.finished.connect(told.append)
        run.failed.connect(told.append)
        run.start()
        return run

    run = hand.main(prove)
    hand.wait(lambda: told, 240, "the proof")
    assert not isinstance(told[0], CNCStepperError), told[0].sentence
    assert run is not None and not told[0].refused
    seen = {finding.text.partition(" into ")[0] for finding in told[0].findings if finding.severity != "info"}
    assert seen <= {"the tool does not reach"}  # the corners of the pocket, which are sharper than the tool


def solid_and_points() -> None:
    """Make a plate with a hole in it, three Draft points, and a job."""
    import Draft

    document = FreeCAD.newDocument("Plate")
    plate = document.addObject("Part::Feature", "Solid")
    plate.Shape = Part.makeBox(60, 40, 10).cut(Part.makeCylinder(5, 10, Vector(30, 20, 0)))
    for x in (10, 20, 30):
        Draft.make_point(x, 5, 0)
    api.add_tool(api.new_job(document, work_origin_mm=(0, 0, 10)))
    document.recompute()


def select(*parts: tuple[str, str]) -> None:
    FreeCADGui.Selection.clearSelection()
    for name, element in parts:
        FreeCADGui.Selection.addSelection(FreeCAD.ActiveDocument.Name, name, element)


def face_above() -> str:
    faces = FreeCAD.ActiveDocument.getObject("Solid").Shape.Faces
    return next(f"Face{n}" for n, face in enumerate(faces, start=1) if face.BoundBox.ZMin > 9)


def press(hand: Hand, command: str) -> None:
    hand.wait(lambda: FreeCADGui.Command.get(command).getAction()[0].isEnabled(), 10, f"{command} to be enabled")
    hand.command(command)
    hand.wait(lambda: hand.exists(f"{PANEL}ok"), 60, f"the panel of {command}")


def test_a_selected_face_and_selected_points(hand: Hand) -> None:
    hand.main(compile_kernels, limit_s=300)
    hand.main(solid_and_points)
    face = hand.main(face_above)
    hand.main(select, ("Solid", face))
    press(hand, "CNCStepper_Pocket")
    assert hand.main(listed) == {f"Solid: {face}": True}
    hand.shot("cycles-6-picked")
    accept(hand)
    assert hand.main(lambda: (the("Pocket").Drawings[0][0].Name, problem_of(the("Pocket")))) == ("Solid", "")
    hand.main(select, *((name, "") for name in ("Point", "Point001", "Point002")))
    press(hand, "CNCStepper_Drill")
    hand.wait(lambda: the("Drill").Holes == 3, 10, "three holes")
    assert hand.main(listed) == {"Point": True, "Point001": True, "Point002": True}
    hand.shot("cycles-7-points")
    accept(hand)


def listed() -> dict[str, bool]:
    """Return the drawings that the open panel lists, and whether they are followed."""
    drawings = FreeCADGui.getMainWindow().findChild(QtGui.QListWidget, f"{PANEL}drawings")
    items = [drawings.item(row) for row in range(drawings.count())]
    return {item.text(): item.checkState() == QtCore.Qt.CheckState.Checked for item in items}


def rectangle_circle_and_line() -> Any:
    document = FreeCAD.newDocument("Sign")
    job = api.new_job(document, stock_size_mm=(100, 80, 10))
    api.add_tool(job)
    Draft.make_rectangle(60, 40)
    Draft.make_circle(8, FreeCAD.Placement(Vector(30, 20, 0), FreeCAD.Rotation()))
    Draft.make_wire([Vector(70, 0, 0), Vector(80, 0, 0)])
    document.recompute()
    return job


def test_a_rectangle_and_a_circle_selected_together(hand: Hand) -> None:
    job = hand.main(rectangle_circle_and_line)
    hand.main(select, ("Circle", ""), ("Line", ""), ("Rectangle", ""))
    press(hand, "CNCStepper_Pocket")
    assert hand.main(listed) == {"Rectangle": True, "Circle": True}
    said = hand.text(f"{PANEL}drawings_unused")
    assert said.startswith("Not used: ") and "'Line' is open" in said
    hand.shot("drawings-1-pocket")
    row = hand.main(lambda: area_mm2(job))
    assert row == pytest.approx(60 * 40 - math.pi * 64, abs=1)
    hand.click(f"{PANEL}drawings", at=hand.main(check_box, "Circle"))
    hand.wait(lambda: len(job.Operations[0].Drawings) == 1, 10, "the circle to be let go")
    assert hand.main(listed) == {"Rectangle": True, "Circle": False}
    assert hand.main(lambda: area_mm2(job)) == pytest.approx(60 * 40, abs=1)
    hand.main(select, ("Circle", ""))
    hand.click(f"{PANEL}drawings_add")
    hand.wait(lambda: len(job.Operations[0].Drawings) == 2, 10, "the circle to be taken again")
    accept(hand)
    hand.main(lambda: (job.Document.removeObject("Circle"), job.Document.recompute()))
    hand.main(panels.edit, hand.main(lambda: job.Operations[0]))
    hand.wait(lambda: hand.exists(f"{PANEL}ok"), 60, "the panel")
    assert hand.main(listed) == {"Rectangle": True, "Circle (deleted)": True}
    hand.shot("drawings-2-deleted")
    hand.click(f"{PANEL}drawings", at=hand.main(check_box, "Circle (deleted)"))
    hand.wait(lambda: problem_of(job.Operations[0]) == "", 10, "the pocket to go on without it")
    accept(hand)


def area_mm2(job: Any) -> float:
    from CNCStepper.job.make import make_program
    from CNCStepper.workbench.document.core_job import machine_of

    removals = make_program(api.job_model(job), machine_of(job)).removals
    return float(sum(removal.region.area for removal in removals))


def check_box(text: str) -> tuple[int, int]:
    """Return where the check box of a listed drawing lies in the list."""
    drawings = FreeCADGui.getMainWindow().findChild(QtGui.QListWidget, f"{PANEL}drawings")
    (item,) = drawings.findItems(text, QtCore.Qt.MatchFlag.MatchExactly)
    place = drawings.visualItemRect(item)
    return place.left() + 10, place.center().y() + drawings.frameWidth()


def every_panel() -> Any:
    """Return a job with one operation of each kind that is milled, those that need a drawing with one."""
    draw()
    job = api.new_job(FreeCAD.ActiveDocument, stock_size_mm=(100, 80, 10))
    api.add_tool(job)
    for cycle in MILLED:
        drawn = FreeCAD.ActiveDocument.getObjectsByLabel(DRAWN[cycle]) if cycle in DRAWN else [None]
        api.add_operation(job, cycle, drawn[0], **CHOSEN.get(cycle, {}))
    FreeCAD.ActiveDocument.recompute()
    return job


@pytest.fixture
def portuguese(hand: Hand) -> Iterator[None]:
    hand.main(FreeCADGui.setLocale, PORTUGUESE)
    hand.settle()
    yield
    hand.main(FreeCADGui.setLocale, "English")
    hand.settle()


def cut_off() -> list[str]:
    """Return the visible parts of the open panel that are too narrow for what they show."""
    window = FreeCADGui.getMainWindow()
    areas = [area for area in window.findChildren(QtGui.QScrollArea) if area.isVisible()]
    wide = [str(area) for area in areas if area.widget() and area.widget().width() > area.viewport().width()]
    labels = [label for label in window.findChildren(QtGui.QLabel) if label.isVisible() and not label.wordWrap()]
    ours = [label for label in labels if any(area.isAncestorOf(label) for area in areas)]
    return wide + [label.text() for label in ours if label.width() < label.minimumSizeHint().width()]


def test_every_panel_is_seen_whole_in_portuguese(hand: Hand, portuguese: None) -> None:
    job = hand.main(every_panel)
    for operation in hand.main(lambda: list(job.Operations)):
        name = hand.main(proxy_type, operation).removeprefix("CNCStepper_")
        hand.main(panels.edit, operation)
        hand.wait(lambda: FreeCADGui.Control.activeDialog(), 10, f"the panel of {name}")
        hand.main(unfold)
        hand.settle()
        hand.shot(f"panel-pt-{name}")
        assert hand.main(cut_off) == [], name
        hand.main(FreeCADGui.Control.closeDialog)
        hand.settle()
    assert hand.main(lambda: [problem_of(obj) for obj in job.Operations]) == [""] * len(MILLED)
