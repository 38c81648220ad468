# SPDX-License-Identifier: LGPL-2.1-or-later
"""Freehand lines are drawn, given up, closed, edited and undone with the mouse, in every navigation style."""

from __future__ import annotations

import math
from typing import Any

import FreeCAD
import FreeCADGui
import pytest

from window_helpers.hand import Hand

STYLES = ("CAD", "Blender", "Gesture", "Inventor", "MayaGesture", "OpenCascade", "OpenSCAD", "Revit", "TinkerCAD")
WAVE = [(300 + 8 * step, 300 + 60 * math.sin(step / 5)) for step in range(30)]


@pytest.fixture
def document(hand: Hand) -> Any:
    """A document seen from above, 100 mm high on the screen."""

    def make() -> Any:
        import pivy.coin  # noqa: F401  the camera's type comes from it

        made = FreeCAD.newDocument("Linha à mão")
        made.UndoMode = 1
        view = FreeCADGui.ActiveDocument.ActiveView
        view.setAnimationEnabled(False)
        view.viewTop()
        view.getCameraNode().height = 100
        return made

    made = hand.main(make)
    hand.settle()
    return made


def lines(hand: Hand, document: Any) -> list[Any]:
    return hand.main(lambda: list(document.Objects))


def status(hand: Hand) -> str:
    return hand.main(lambda: FreeCADGui.getMainWindow().statusBar().currentMessage())


def ends(hand: Hand, line: Any) -> list[Any]:
    """Return where the first and the last vertex of a line appear in the 3D view."""
    points = hand.main(lambda: [tuple(vertex.Point) for vertex in line.Shape.Vertexes])
    return [hand.view_point(*points[0]), hand.view_point(*points[-1])]


def test_press_move_release_draws_one_line_in_one_undo_step(hand: Hand, document: Any) -> None:
    hand.command("CNCStepper_Freehand")
    assert "press the left button" in status(hand)
    hand.press_at(WAVE[0])
    for point in WAVE[1:]:
        hand.move_to(point)
    assert lines(hand, document) == []
    assert "give up" in status(hand)
    hand.shot("freehand-drawing")
    hand.release()
    (line,) = lines(hand, document)
    assert hand.main(lambda: (line.isValid(), line.State, document.UndoCount)) == (True, ["Up-to-date"], 1)
    assert hand.main(lambda: FreeCADGui.Selection.getSelection()) == [line]
    pixel_mm = hand.main(lambda: float(line.Tolerance)) / 1.5
    assert 0 < pixel_mm < 0.5
    assert 3 < hand.main(lambda: line.Kept) < len(WAVE)
    assert f"{hand.main(lambda: line.Kept)} points" in status(hand)
    for place, drawn in zip(ends(hand, line), (WAVE[0], WAVE[-1]), strict=True):
        assert place == pytest.approx(drawn, abs=1.5)
    hand.shot("freehand-drawn")
    hand.key("Escape")
    hand.undo()
    hand.wait(lambda: not document.Objects)


def test_lines_follow_each_other_until_escape_and_the_wheel_zooms(hand: Hand, document: Any) -> None:
    hand.command("CNCStepper_Freehand")
    hand.drag(WAVE)
    before = hand.main(lambda: FreeCADGui.ActiveDocument.ActiveView.getCameraNode().height.getValue())
    hand.move_to((500, 300))
    hand.mouse.down(4)
    hand.mouse.up(4)
    hand.settle()
    assert hand.main(lambda: FreeCADGui.ActiveDocument.ActiveView.getCameraNode().height.getValue()) != before
    hand.drag([(x, y + 100) for x, y in WAVE])
    assert len(lines(hand, document)) == 2
    hand.key("Escape")
    assert status(hand) == ""
    hand.drag([(x, y + 180) for x, y in WAVE])
    assert len(lines(hand, document)) == 2


def test_the_command_pressed_again_ends_drawing(hand: Hand, document: Any) -> None:
    hand.command("CNCStepper_Freehand")
    hand.command("CNCStepper_Freehand")
    hand.drag(WAVE)
    assert lines(hand, document) == []


def test_escape_gives_up_the_line_and_leaves_nothing(hand: Hand, document: Any) -> None:
    hand.command("CNCStepper_Freehand")
    hand.press_at(WAVE[0])
    for point in WAVE[1:]:
        hand.move_to(point)
    hand.key("Escape")
    hand.release()
    assert lines(hand, document) == []
    assert hand.main(lambda: document.UndoCount) == 0
    hand.drag([(300, 300), (300, 300)])  # nor does a click that moves nothing
    assert lines(hand, document) == []
    hand.key("Escape")


def test_shift_goes_straight_and_along_an_axis_that_is_near(hand: Hand, document: Any) -> None:
    hand.command("CNCStepper_Freehand")
    hand.drag([(300, 300), (350, 280), (400, 330), (500, 304)], modifiers=["Shift"])
    hand.drag([(300, 400), (350, 390), (500, 480)], modifiers=["Shift"])
    level, free = lines(hand, document)
    assert hand.main(lambda: [len(line.Points) for line in (level, free)]) == [2, 2]
    first, last = hand.main(lambda: [tuple(point) for point in level.Points])
    assert first[1] == pytest.approx(last[1], abs=1e-9)
    assert ends(hand, free)[1] == pytest.approx((500, 480), abs=1.5)
    hand.key("Escape")


def test_a_release_beside_the_start_closes_the_line(hand: Hand, document: Any) -> None:
    round_trip = [(400 + 80 * math.cos(a / 10), 300 + 80 * math.sin(a / 10)) for a in range(63)]
    hand.command("CNCStepper_Freehand")
    hand.press_at(round_trip[0])
    for point in round_trip[1:]:
        hand.move_to(point)
    assert "Release to close" in status(hand)
    hand.shot("freehand-closing")
    hand.release()
    (line,) = lines(hand, document)
    assert hand.main(lambda: (line.Closed, line.Shape.isClosed(), line.isValid())) == (True, True, True)
    hand.key("Escape")


@pytest.mark.parametrize("style", STYLES)
def test_no_navigation_style_takes_the_stroke(hand: Hand, document: Any, style: str) -> None:
    view = hand.main(lambda: FreeCADGui.ActiveDocument.ActiveView)
    known = hand.main(view.listNavigationTypes)
    name = f"Gui::{style}NavigationStyle"
    if name not in known:
        assert hand.main(lambda: FreeCAD.Version()[0]) == "0"  # the newest styles came with 1.0
        return
    before = hand.main(view.getNavigationType)

    def looks() -> Any:
        camera = view.getCameraNode()
        return camera.position.getValue().getValue(), camera.orientation.getValue().getValue()

    hand.main(view.setNavigationType, name)
    try:
        camera = hand.main(looks)
        hand.command("CNCStepper_Freehand")
        hand.drag(WAVE)
        assert len(lines(hand, document)) == 1
        assert hand.main(looks) == camera
        hand.key("Escape")
    finally:
        hand.main(view.setNavigationType, before)


def test_the_line_lies_at_the_job_s_work_zero_and_on_draft_s_plane(hand: Hand, document: Any) -> None:
    def job() -> None:
        from CNCStepper.workbench import api

        api.new_job(document, work_origin_mm=(0, 0, 12))
        document.recompute()

    hand.main(job)
    hand.command("CNCStepper_Freehand")
    hand.drag(WAVE)
    hand.key("Escape")
    line = lines(hand, document)[-1]
    assert hand.main(lambda: line.Shape.BoundBox.ZMin) == pytest.approx(12)

    def plane(z_mm: float | None) -> None:
        import draftguitools  # noqa: F401  Draft's plane comes with its commands
        import WorkingPlane

        draft = FreeCAD.DraftWorkingPlane = getattr(FreeCAD, "DraftWorkingPlane", None) or WorkingPlane.plane()
        if z_mm is None:
            draft.weak = True
            return
        draft.alignToPointAndAxis(FreeCAD.Vector(0, 0, z_mm), FreeCAD.Vector(0, 0, 1))
        draft.weak = False

    hand.main(plane, 3.0)
    try:
        hand.command("CNCStepper_Freehand")
        hand.drag(WAVE)
        hand.key("Escape")
    finally:
        hand.main(plane, None)
    line = lines(hand, document)[-1]
    assert hand.main(lambda: line.Shape.BoundBox.ZMax) == pytest.approx(3)


BENT = [(-30, 0), (0, 20), (30, 0)]
LEFT_MM = -45  # newer FreeCADs lay the task panel over the right of the view


def test_the_points_are_handles_that_move_come_and_go(hand: Hand, document: Any) -> None:
    def make() -> Any:
        from CNCStepper.workbench import api, freehand

        line = api.add_freehand(document, [(x + LEFT_MM, y) for x, y in BENT], tolerance_mm=0.1)
        document.recompute()
        document.clearUndos()
        freehand.edit(line)
        return line

    def at(x_mm: float, y_mm: float) -> Any:
        return hand.view_point(x_mm + LEFT_MM, y_mm)

    line = hand.main(make)
    hand.settle()
    assert "Drag a point" in status(hand)

    def points() -> list[Any]:
        return hand.main(lambda: [(round(x - LEFT_MM, 1), round(y, 1)) for x, y, _ in line.Points])

    hand.drag([at(0, 20), at(0, 25), at(10, 30)])
    assert points()[1] == pytest.approx((10, 30), abs=0.3)
    assert hand.main(lambda: (len(line.Points), document.UndoCount, line.State)) == (3, 1, ["Up-to-date"])
    middle = (20, 15)  # of the second part
    hand.drag([at(*middle), at(22, 16), at(30, 25)])
    assert len(points()) == 4
    hand.shot("freehand-handles")
    hand.move_to(at(30, 25))
    hand.key("Delete")
    assert len(points()) == 3
    assert lines(hand, document) == [line]
    hand.press_at(at(-30, 0))
    hand.move_to(at(-20, -20))
    hand.key("Escape")
    hand.release()
    assert points()[0] == (-30, 0)
    hand.undo()
    hand.wait(lambda: len(line.Points) == 4)
    hand.key("Escape")
    assert status(hand) == ""
    for _ in range(2):
        hand.undo()
    assert points() == BENT
    assert hand.main(lambda: float(line.Tolerance)) == 0.1


def test_the_panel_shows_the_handles_and_cancel_takes_their_moves_back(hand: Hand, document: Any) -> None:
    def make() -> Any:
        from CNCStepper.workbench import api

        line = api.add_freehand(document, [(x + LEFT_MM, y) for x, y in BENT], tolerance_mm=0.1)
        document.recompute()
        document.clearUndos()
        return line

    line = hand.main(make)
    for button, moved in (("CNCStepper_Panel_cancel", False), ("CNCStepper_Panel_ok", True)):
        hand.tree("Freehand", double=True)
        hand.wait(lambda: FreeCADGui.Control.activeDialog())
        hand.settle()
        hand.drag([hand.view_point(LEFT_MM, 20), hand.view_point(LEFT_MM, 10), hand.view_point(LEFT_MM + 5, -15)])
        assert hand.main(lambda: float(line.Tolerance)) == 0
        hand.shot(f"freehand-panel-{moved}")
        hand.click(button)
        hand.wait(lambda: not FreeCADGui.Control.activeDialog())
        assert hand.main(lambda: line.Points[1].y < 0) is moved
        assert status(hand) == ""
    assert hand.main(lambda: document.UndoCount) == 1
    hand.undo()
    hand.wait(lambda: line.Points[1].y == 20)


def test_a_closed_document_ends_drawing_and_editing(hand: Hand, document: Any) -> None:
    from CNCStepper.workbench import freehand

    hand.command("CNCStepper_Freehand")
    hand.main(FreeCAD.closeDocument, document.Name)
    hand.settle()
    assert not hand.main(freehand.going_on)
