# SPDX-License-Identifier: LGPL-2.1-or-later
"""The buttons below a simulation's findings on a small screen, with a real mouse: pressed, proven again, undone."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import FreeCAD
import Part
import pytest
from test_cycle_panels import cut_off
from test_lathe import small_window  # noqa: F401
from test_simulation_view import PROVEN_S, opened

from CNCStepper.workbench import api
from CNCStepper.workbench.proving.proof_process import ProofRun
from window_helpers import screen_places as places
from window_helpers.hand import Hand

BUTTON = "CNCStepper_Panel_remedy_"
AT = {"radius_x_mm": 10, "radius_y_mm": 8, "stepdown_mm": 2, "depth_mm": 4}
TOOL = {"diameter_mm": 6, "feed_mm_min": 800, "plunge_mm_min": 200, "spindle_rpm": 10000, "flutes": 2}


def circle(document: Any, radius_mm: float, x_mm: float = 0.0) -> Any:
    drawing = document.addObject("Part::Feature", "Round")
    drawing.Shape = Part.Wire(Part.makeCircle(radius_mm, FreeCAD.Vector(x_mm, 0, 0)))
    return drawing


def new_job(**values: Any) -> Any:
    document = FreeCAD.newDocument("Remedies")
    document.UndoMode = 1
    return api.new_job(document, machine="table-a", stock_size_mm=(60, 50, 12), **values)


def of_tools() -> Any:
    """A job whose tools are wrong in five ways, with a coolant that the machine lacks."""
    job = new_job(coolant="mist")
    for x_mm, wrong in (
        (-15, {"spindle_rpm": 30000}),
        (0, {"feed_mm_min": 6000}),
        (5, {"chip_load_max_mm": 0.03}),
        (15, {"flute_length_mm": 4.0}),
    ):
        tool = api.add_tool(job, **{**TOOL, **wrong})
        deep = {"depth_mm": 9, "stepdown_mm": 4.5} if "flute_length_mm" in wrong else {}
        api.add_elliptical_pocket(job, tool=tool, centre_mm=(x_mm, 0), **{**AT, **deep})
    job.Document.recompute()
    return job


def of_feeds() -> Any:
    job = new_job(material="plywood")
    tool = api.add_tool(job, **{**TOOL, "spindle_rpm": 24000, "feed_mm_min": 5000})
    api.add_elliptical_pocket(job, tool=tool, **{**AT, "depth_mm": 14})
    job.Document.recompute()
    return job


def of_pieces() -> Any:
    """An outline, behind it a hole in the piece that it has set free."""
    job = new_job()
    tool = api.add_tool(job, **TOOL)
    outline = circle(job.Document, 18)
    api.add_operation(job, "contour", outline, tool=tool, side="outside", depth_mm=12, stepdown_mm=3)
    api.add_operation(job, "circular_pocket", tool=tool, radius_mm=8, depth_mm=6, stepdown_mm=3, stepover_mm=2)
    job.Document.recompute()
    return job


def of_stock() -> Any:
    job = new_job()
    round_ = circle(job.Document, 27)
    api.add_operation(job, "pocket", round_, tool=api.add_tool(job, **TOOL), depth_mm=2, stepdown_mm=2, stepover_mm=3)
    job.Document.recompute()
    return job


def of_clamp() -> Any:
    job = new_job()
    bar = job.Document.addObject("Part::Box", "Bar")
    bar.Length, bar.Width, bar.Height = 6, 80, 15
    bar.Placement.Base = FreeCAD.Vector(-3, -40, 0)
    tool = api.add_tool(job, **TOOL)
    for x_mm in (-20, 20):
        where = {"centre_mm": (x_mm, 0), "radius_mm": 6}
        api.add_operation(job, "circular_pocket", tool=tool, depth_mm=2, stepdown_mm=2, stepover_mm=2, **where)
    api.edit(job, clamps=[bar])
    job.Document.recompute()
    return job


JOBS = {
    "tools": (of_tools, ("spindle-speed", "coolant", "flute-length", "feed-above-rate", "chip-load")),
    "feeds": (of_feeds, ("below-stock", "feeds")),
    "pieces": (of_pieces, ("piece-loose", "not-exact")),
    "stock": (of_stock, ("beside-stock",)),
    "clamp": (of_clamp, ("clamp",)),
}


@pytest.fixture(autouse=True)
def unproven() -> Iterator[None]:
    ProofRun._last = None
    yield
    ProofRun._last = None


def found(result: Any) -> set[tuple[str, str]]:
    return {(each.code, each.severity) for each in result.findings if each.severity != "info"}


@pytest.mark.usefixtures("small_window")
@pytest.mark.window("plain", "portuguese")
@pytest.mark.parametrize("name", JOBS)
def test_buttons_mend_findings_one_after_the_other(hand: Hand, name: str) -> None:
    make, codes = JOBS[name]
    job = hand.main(make)
    task = opened(hand, job)
    first, steps = task._result, job.Document.UndoCount
    hand.shot(f"remedies-{name}")
    for code in codes:
        before = task._result
        hand.wait(lambda code=code: hand.exists(BUTTON + code), 10, f"the button of {code}")
        hand.settle()
        press(hand, task, code)
        hand.wait(
            lambda before=before: task._result not in (None, before) and not task._loader.isActive(), PROVEN_S, code
        )
        assert code not in {each for each, _ in found(task._result)}
        assert found(task._result) <= found(before) | {("shank", "warning"), ("not-exact", "warning")}
    assert job.Document.UndoCount == steps + len(codes)
    for _ in codes:
        hand.main(job.Document.undo)
    hand.wait(lambda: hand.exists("CNCStepper_Simulation_again"), 10, "the offer to simulate again")
    hand.click("CNCStepper_Simulation_again")
    last = task._result
    hand.wait(lambda: task._result not in (None, last) and not task._loader.isActive(), PROVEN_S, "the first proof")
    assert found(task._result) == found(first)


def press(hand: Hand, task: Any, code: str) -> None:
    """Bring a button of the list into view, see that its text is whole, and click it."""
    rows = hand.find("CNCStepper_Findings_list")

    def show() -> None:
        row = next(
            rows.item(k)
            for k in range(rows.count())
            if (bar := rows.itemWidget(rows.item(k))) and bar.findChild(type(task.form._again), BUTTON + code)
        )
        rows.scrollToItem(row)

    hand.main(show)
    hand.main(lambda: places.scroll_to(places.find(BUTTON + code)))
    hand.settle()
    hand.shot(f"remedy-{code}")
    hand.wait(lambda: cut_off() == [], 5, "a panel of which nothing is cut off")
    assert hand.main(lambda: places.cut_texts(rows)) == []
    assert hand.main(is_within, places.find(BUTTON + code), rows.viewport())
    assert "\nmm" not in hand.text(BUTTON + code)
    hand.click(BUTTON + code)


def is_within(button: Any, viewport: Any) -> bool:
    """Return whether the list shows a button from its left to its right edge."""
    left = button.mapTo(viewport, button.rect().topLeft()).x()
    return bool(left >= 0 and left + button.width() <= viewport.width())
