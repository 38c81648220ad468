# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sign by real clicks, which are counted: a text, a pocket with a hole, a contour with tabs; drawn here, and read.

The virtual grbl writes down where its tool was. From that the part is cut once more, by another way of reckoning than
the product's, and compared with the part that was proven.
"""

from __future__ import annotations

import shutil
from collections.abc import Collection, Iterator
from pathlib import Path
from typing import Any

import FreeCADGui
import numpy as np
import pytest
from PySide import QtGui
from test_road import DOCK, PLAYER, ours, own_sessions  # noqa: F401

from CNCStepper.workbench.features.base import problem_of
from CNCStepper.workbench.services.choice_labels import words_of
from CNCStepper.workbench.services.translation import tr
from window_helpers.docks import opened_dock
from window_helpers.file_dialogs import choose_file
from window_helpers.hand import Hand
from window_helpers.task_panels import PANEL, accept

SIGN = Path(__file__).parents[2] / "examples" / "drawings" / "sign.svg"
CLICKS = 60  # at most, for a sign
SPEED = 60  # of the virtual machine's clock
RADIUS_MM, STOCK_MM, TABS = 1.5, 4.0, 4
STEP_MM = 0.0125  # of X and Y; that of Z is smaller
PLACES = 4  # of the tool in a cell's width: of those that are nearer the deepest counts
BOTH = pytest.mark.window("plain", "portuguese")


def the(kind: str) -> Any:
    (found,) = ours(kind)
    return found


@pytest.fixture
def dock(hand: Hand) -> Iterator[Any]:
    """The dock's panel, which no click has to open: Send does."""
    with opened_dock(hand, lambda panel: None) as panel:
        yield panel


@pytest.fixture
def counted(hand: Hand, dock: Any) -> Iterator[None]:
    """Counts the clicks of a test from an empty window on."""
    clicks, typed = hand.clicks, hand.typed
    yield
    print(f"a sign: {hand.clicks - clicks} clicks, {hand.typed - typed} typed values", flush=True)
    assert hand.clicks - clicks <= CLICKS


def panel_of(hand: Hand, command: str, key: str = "ok") -> None:
    """Press a command's button and wait for its panel."""
    hand.command(command)
    hand.wait(lambda: hand.exists(f"{PANEL}{key}"), 40, f"the panel of {command}")


def shape(hand: Hand, title: str, **values: str) -> Any:
    """Draw a shape of the library, by its picture and its dimensions."""
    before = len(hand.main(ours, "Shape"))
    panel_of(hand, "CNCStepper_Shapes", "shapes")
    hand.item(f"{PANEL}shapes", hand.main(tr, title), double=True)
    hand.wait(lambda: len(ours("Shape")) > before and hand.exists(f"{PANEL}ok"), 20, title)
    for key, text in values.items():
        hand.fill(f"{PANEL}{key}", text)
    accept(hand)
    return hand.main(ours, "Shape")[-1]


def text(hand: Hand, words: str) -> Any:
    """Write a text about the zero."""
    panel_of(hand, "CNCStepper_Text")
    hand.click(f"{PANEL}text")
    hand.key("Ctrl+A")
    hand.type(words)
    hand.choose(f"{PANEL}align", hand.main(words_of, "center"))
    hand.wait(lambda: (the("Text").Text, the("Text").Align) == (words, "center"), 20, "the text")
    accept(hand)
    return hand.main(the, "Text")


def new_job(hand: Hand, outline: Any) -> Any:
    """Make a job whose stock reaches around the outline, with a thin tool."""
    hand.tree(hand.main(lambda: outline.Label))
    panel_of(hand, "CNCStepper_NewJob")
    hand.fill(f"{PANEL}stock_size_mm_z", f"{STOCK_MM:g}")
    hand.fill(f"{PANEL}diameter_mm", f"{2 * RADIUS_MM:g}")
    job = hand.main(the, "Job")
    hand.wait(lambda: (job.StockSize.z, job.Tools[0].Diameter.Value) == (STOCK_MM, 2 * RADIUS_MM), 20, "stock and tool")
    accept(hand)
    return job


def operation(hand: Hand, command: str, drawings: list[Any], **values: str) -> None:
    """Select drawings, press a command's button, give values, and take what is made."""
    for number, drawing in enumerate(drawings):
        hand.tree(hand.main(lambda drawing=drawing: drawing.Label), modifiers=("Ctrl",) if number else ())
    hand.wait(lambda: FreeCADGui.Selection.getSelection() == drawings, 5, "these drawings alone to be selected")
    panel_of(hand, command)
    for key, words in values.items():
        hand.fill(f"{PANEL}{key}", words)
    accept(hand)


def contour_with_tabs(hand: Hand, outline: Any) -> None:
    """Cut the outline free but for its tabs."""
    hand.tree(hand.main(lambda: outline.Label))
    panel_of(hand, "CNCStepper_Contour")
    hand.click(f"{PANEL}group_tabs")
    hand.choose(f"{PANEL}tabs_by", hand.main(words_of, "count"))
    hand.wait(lambda: hand.exists(f"{PANEL}tabs_count"), 20, "the number of tabs")
    hand.fill(f"{PANEL}tabs_count", str(TABS))
    hand.wait(lambda: the("Contour").TabsMade == TABS, 20, "the tabs")
    accept(hand)


def simulated(hand: Hand) -> None:
    """Check and simulate, look, and close."""
    hand.command("CNCStepper_Simulate")
    hand.wait(lambda: hand.exists(f"{PLAYER}play") and hand.find(f"{PLAYER}play").isEnabled(), 180, "the simulation")
    hand.click(f"{PANEL}close")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 10, "the simulation to close")


def at(hand: Hand, dock: Any, *steps: str) -> None:
    """Wait for a step of the sending."""
    hand.wait(lambda: dock.sending.flow.step in steps, 120, f"one of the steps {steps}")


def cut(hand: Hand, dock: Any, job: Any, twin: Any) -> Any:
    """Send the job to the virtual grbl until it is done; return the proof."""
    hand.tree(hand.main(lambda: job.Label))
    hand.command("CNCStepper_Send")
    at(hand, dock, "connect", "warned")
    if hand.main(lambda: dock.sending.flow.step) == "warned":
        hand.click(f"{DOCK}Start")
        at(hand, dock, "connect")
    result = hand.main(lambda: dock.sending._result)
    hand.fill(f"{DOCK}Port", twin.address)
    hand.click(f"{DOCK}Start")
    at(hand, dock, "zero")
    hand.click(f"{DOCK}ZeroAll")
    hand.wait(lambda: hand.find(f"{DOCK}Start").isEnabled(), 10, "Start")
    hand.click(f"{DOCK}Start")
    hand.wait(lambda: dock.sending.flow.step == "ended" or is_paused(dock), 240, "the end, or another tool")
    if hand.main(is_paused, dock):
        hand.click(f"{DOCK}Resume")
        at(hand, dock, "ended")
    assert hand.main(lambda: dock.sending.flow.outcome) == "done"
    hand.click(f"{DOCK}Cancel")
    hand.click(f"{DOCK}Connect")
    hand.wait(lambda: dock.link.moment.phase == "off", 20, "the end of the connection")
    return result


def is_paused(dock: Any) -> bool:
    return bool(dock.link.status is not None and dock.link.status.phase == "paused")


def cut_by(twin: Any, part: Any, radii_mm: tuple[float, ...]) -> np.ndarray:
    """Return the heights, mm, to which the way that the machine has gone cuts the cells of a part's stock.

    radii_mm: of the tools; the second is put in where the machine has rested the longest.
    """
    rows = twin.trace.read_text("ascii").partition("\n")[2].replace("\n", ",").rstrip(",")
    table = np.fromstring(rows, sep=",").reshape(-1, 4)
    tips, change = table[1:, 1:] - table[0, 1:], int(np.argmax(np.diff(table[1:, 0]))) + 1
    heights = np.full(part.heights_mm.shape, part.high_mm[2])
    parts = np.split(tips, [change]) if len(radii_mm) > 1 else [tips]
    for way, radius_mm in zip(parts, radii_mm, strict=True):
        mill(heights, way[way[:, 2] < 0], part, radius_mm)
    return heights


def mill(heights: np.ndarray, tips: np.ndarray, part: Any, radius_mm: float) -> None:
    """Lower the cells of a part that a flat tool covers at the places of its tip."""
    cells = np.round((tips[:, :2] - [part.x_mm[0], part.y_mm[0]]) / (part.x_mm[1] - part.x_mm[0]) * PLACES)
    deepest = np.lexsort((tips[:, 2], *cells.T))
    _, first = np.unique(cells[deepest], axis=0, return_index=True)
    for x, y, z in tips[deepest[first]]:
        columns = slice(*np.searchsorted(part.x_mm, (x - radius_mm, x + radius_mm)))
        lines = slice(*np.searchsorted(part.y_mm, (y - radius_mm, y + radius_mm)))
        away = np.hypot(part.x_mm[columns] - x, part.y_mm[lines, None] - y)
        patch = heights[lines, columns]
        np.minimum(patch, z, out=patch, where=away < radius_mm)


def around(heights: np.ndarray, extreme: Any) -> np.ndarray:
    """Return the lowest or highest of each cell and its eight neighbours: walls fall between cells."""
    wide = np.pad(heights, 1, mode="edge")
    rows, columns = heights.shape
    shifted = [wide[row : row + rows, column : column + columns] for row in range(3) for column in range(3)]
    return np.asarray(extreme.reduce(shifted))


def check(
    hand: Hand, job: Any, result: Any, twin: Any, radii_mm: tuple[float, ...], *, allowed: Collection[str] = ()
) -> None:
    """The program is proven without a warning of other codes, and the machine has cut what was proven."""
    assert hand.main(lambda: [problem_of(each) for each in (*job.Operations, job)]) == [""] * 4
    assert not result.refused
    told = [each for each in result.findings if each.severity != "info" and each.code not in allowed]
    assert not told, told
    twin.end()
    made, proven = cut_by(twin, result.part, radii_mm), result.part.heights_mm
    assert (made >= around(proven, np.minimum) - STEP_MM).all() and (made <= around(proven, np.maximum) + STEP_MM).all()
    levels = {round(float(level), 1) for level in np.unique(made)}
    assert {0.0, round(float(result.part.low_mm[2]), 1)} < levels
    assert len(levels) >= 5  # text, pocket and tabs between top and bottom


@BOTH
def test_a_sign_is_drawn_and_cut(hand: Hand, counted: None, dock: Any, twins: Any) -> None:
    words = text(hand, "CNC")  # first: FreeCAD 1.1 shows no gallery of shapes where no document is open
    plate = shape(hand, "Circle", diameter_mm="64")
    groove = shape(hand, "Ring", outer_diameter_mm="54", inner_diameter_mm="40")
    job = new_job(hand, plate)
    operation(hand, "CNCStepper_Engrave", [words])
    operation(hand, "CNCStepper_Pocket", [groove], depth_mm="2")
    contour_with_tabs(hand, plate)
    hand.shot("sign-drawn")
    simulated(hand)
    twin = twins("grbl", "--speed", str(SPEED))
    check(hand, job, cut(hand, dock, job, twin), twin, (RADIUS_MM,))
    hand.shot("sign-cut")


@BOTH
def test_a_sign_is_read_and_cut(hand: Hand, counted: None, dock: Any, twins: Any, tmp_path: Path) -> None:
    hand.command("CNCStepper_ImportDrawing")
    choose_file(hand, "CNCStepper_Import_drawing", Path(shutil.copy(SIGN, tmp_path / "placa.svg")))
    hand.wait(lambda: hand.exists(f"{PANEL}ok") and ours("Drawing") and len(the("Drawing").Group) == 5, 40, "contours")
    accept(hand)
    job = job_of_template(hand)
    hand.shot("sign-read")
    simulated(hand)
    twin = twins("grbl", "--speed", str(SPEED))
    result = cut(hand, dock, job, twin)
    check(hand, job, result, twin, (1.5, 3.0), allowed={"not-exact"})  # corners that are sharper than the tool
    hand.shot("sign-read-cut")


def job_of_template(hand: Hand) -> Any:
    """Make a job of the drawing by the rules of the template for signs."""
    panel_of(hand, "CNCStepper_Template", "rules")
    hand.choose(f"{PANEL}template", hand.main(lambda: tr("{0} (example)").format("sign")))
    hand.wait(lambda: untaken() == "0", 60, "the contours of each rule")
    accept(hand)
    job = hand.main(the, "Job")
    hand.wait(lambda: not problem_of(job) and "Touched" not in job.State, 60, "the program")
    return job


def untaken() -> str:
    """Return how many contours no rule of the template takes."""
    tree = FreeCADGui.getMainWindow().findChild(QtGui.QTreeWidget, f"{PANEL}rules")
    return str(tree.topLevelItem(tree.topLevelItemCount() - 1).text(1))
