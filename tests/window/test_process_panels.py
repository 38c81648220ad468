# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panels of jobs by torch, laser and wire: what they show, values of the chart and a person's own, commands."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import Draft
import FreeCAD
import FreeCADGui
import pytest
from FreeCAD import Vector
from test_cycle_panels import cut_off
from test_every_choice import but, work_through
from test_typing import hidden_view

from CNCStepper.workbench import api, panels
from CNCStepper.workbench.features.base import problem_of
from CNCStepper.workbench.panels.fields import CheckField, ChoiceField, NumberField
from window_helpers import screen_places as places
from window_helpers.file_dialogs import choose_file
from window_helpers.hand import Hand

P = "CNCStepper_Panel_"
CHARTS = Path(api.__file__).parents[1] / "machine" / "charts"
PORTUGUESE = "pt-BR"
JOBS = {
    "plasma": {"machine": "torch-table", "material": "mild-steel", "stock_size_mm": (200, 150, 3)},
    "laser": {"machine": "laser-table", "material": "plywood", "stock_size_mm": (200, 150, 3)},
    "hot-wire": {"machine": "wire-table", "material": "eps", "stock_size_mm": (200, 150, 20)},
}
SHOWN = {
    "plasma": {
        "cut_height_mm",
        "pierce_height_mm",
        "pierce_delay_s",
        "amperes",
        "feed_mm_min",
        "kerf_mm",
        "consumable",
    },
    "laser": {"pierce_delay_s", "power_percent", "feed_mm_min", "kerf_mm", "consumable"},
    "hot-wire": {"pierce_delay_s", "power_percent", "feed_mm_min", "kerf_mm", "consumable"},
}
OF_SOME = {*SHOWN["plasma"], *SHOWN["laser"], "preheat_s", "coolant", "clearance_mm", "retract_mm"}


@pytest.fixture
def document(hand: Hand) -> Iterator[Any]:
    """A document with a rectangle to cut out."""

    def make() -> Any:
        made = FreeCAD.newDocument("Sheet")
        made.UndoMode = 1
        Draft.make_rectangle(100, 60, FreeCAD.Placement(Vector(-50, -30, 0), FreeCAD.Rotation()))
        made.recompute()
        return made

    yield hand.main(make)
    hand.main(FreeCADGui.Control.closeDialog)
    hand.main(FreeCAD.closeDocument, "Sheet")


def make_job(document: Any, process: str, cycle: str = "") -> Any:
    job = api.new_job(document, process=process, stock_form="sheet", **JOBS[process])
    api.add_operation(job, cycle or ("wire_cut" if process == "hot-wire" else "sheet_cut"), document.Objects[0])
    document.recompute()
    return job


def open_panel(hand: Hand, obj: Any, key: str) -> None:
    hand.main(panels.edit, obj)
    hand.wait(lambda: places.visible(P + key), what="the panel")
    hand.settle()


def seen(hand: Hand) -> set[str]:
    """Return those fields that some jobs do not have and that are not hidden now; a folded group counts as seen."""

    def shown() -> set[str]:
        fields = FreeCADGui.getMainWindow().findChildren(panels_editor())[0].form.fields
        return {key for key in OF_SOME if not fields[key].widget.isHidden()}

    return set(hand.main(shown))


def unfold() -> None:
    for box in FreeCADGui.getMainWindow().findChildren(panels_editor())[0].form.boxes.values():
        box.fold(False)


def panels_editor() -> type:
    from CNCStepper.workbench.panels.object_form import Editor

    return Editor


@pytest.mark.window("plain", "portuguese")
@pytest.mark.parametrize("process", JOBS)
def test_a_job_shows_only_what_its_process_has(hand: Hand, document: Any, process: str) -> None:
    job = hand.main(make_job, document, process)
    assert [hand.main(problem_of, obj) for obj in (*job.Operations, job)] == ["", ""]
    open_panel(hand, job, "machine")
    hand.shot(f"job-{process}")
    hand.main(lambda: places.scroll_to(places.find(P + "cut_feed_mm_min")))
    hand.shot(f"job-{process}-chart")
    hand.main(lambda: places.scroll_to(places.find("CNCStepper_Panel_tools")))
    hand.shot(f"job-{process}-tools")
    assert hand.main(cut_off) == []
    heights = {"clearance_mm", "retract_mm"} if process == "plasma" else set()
    assert seen(hand) == SHOWN[process] | heights


@pytest.mark.window("plain", "portuguese")
@pytest.mark.parametrize("process", JOBS)
def test_the_panel_of_an_operation(hand: Hand, document: Any, process: str) -> None:
    job = hand.main(make_job, document, process)
    open_panel(hand, job.Operations[0], "tool")
    hand.shot(f"operation-{process}")
    hand.main(unfold)
    hand.shot(f"operation-{process}-all")
    assert hand.main(cut_off) == []
    assert hand.main(problem_of, job.Operations[0]) == ""


def test_what_a_laser_marks_is_checked_and_taken_from_the_selection(hand: Hand, document: Any) -> None:
    job = hand.main(make_job, document, "laser")
    lines = hand.main(two_lines, document)
    operation = job.Operations[0]
    open_panel(hand, operation, "tool")
    marks, field = P + "mark_drawings", lambda: [drawing for drawing, _ in operation.MarkDrawings]
    hand.main(unfold)
    hand.settle()
    hand.main(lambda: places.scroll_to(places.find(marks)))
    hand.settle()
    hand.click(hand.main(lambda: places.find(marks).viewport()), at=hand.main(mark_of, marks, lines[0].Label))
    hand.wait(lambda: field() == [lines[0]], 20, "the checked line")
    for button, expected in (("add", lines), ("take", lines[1:])):
        hand.main(FreeCADGui.Selection.clearSelection)
        hand.main(FreeCADGui.Selection.addSelection, lines[1])
        hand.click(f"{marks}_{button}")
        hand.wait(lambda expected=expected: field() == expected, 20, button)
    hand.wait(lambda: "Touched" not in job.State and not problem_of(operation), 20, "the program")
    hand.click(P + "ok")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 20, "the panel to close")
    with hidden_view(hand):
        mine = ("mark_power", "mark_feed_mm_min", "dynamic_power", "power_ramp_by")
        work_through(hand, operation, but(operation, *mine), (CheckField, ChoiceField, NumberField))
        tool = hand.main(api.chart_tool, job)
        work_through(hand, tool, but(tool, "from_chart"), (CheckField,))


def test_a_chart_of_the_shop_and_its_consumables_are_chosen(hand: Hand, document: Any, tmp_path: Path) -> None:
    chart = tmp_path / "tabela da oficina.toml"
    chart.write_text((CHARTS / "plasma.toml").read_text("utf-8").replace("3850.0", "3777.0"), "utf-8")
    job = hand.main(make_job, document, "plasma")
    open_panel(hand, job, "chart")
    hand.main(lambda: places.scroll_to(places.find(P + "chart")))
    hand.choose(P + "chart", "A chart's file…")
    choose_file(hand, P + "chart_file", chart)
    hand.wait(lambda: "Touched" not in job.State and "F3777" in api.program_text(job), 20, "the shop's feed")
    for number in (2, 0):
        hand.main(lambda: places.scroll_to(places.find(P + "consumable")))
        hand.choose(P + "consumable", hand.main(lambda number=number: places.find(P + "consumable").itemText(number)))
        hand.wait(lambda number=number: bool(job.Consumable) is bool(number) and "Touched" not in job.State, 20)
    assert hand.main(problem_of, job) == ""


def two_lines(document: Any) -> list[Any]:
    made = [Draft.make_line(Vector(-40, y, 0), Vector(40, y, 0)) for y in (-10, 10)]
    document.recompute()
    return made


def mark_of(name: str, label: str) -> tuple[int, int]:
    """Return the place of the mark before an entry of a list."""
    entries = places.find(name)
    rows = [row for row in range(entries.count()) if entries.item(row).text() == label]
    rect = entries.visualItemRect(entries.item(rows[0]))
    return rect.left() + 10, rect.center().y()


def test_a_typed_value_wins_and_the_button_takes_the_charts_again(hand: Hand, document: Any) -> None:
    job = hand.main(make_job, document, "plasma")
    before = hand.main(api.program_text, job)
    open_panel(hand, job, "cut_feed_mm_min")
    hand.main(lambda: places.scroll_to(places.find(P + "cut_feed_mm_min")))
    hand.settle()
    hand.fill(P + "cut_feed_mm_min", "1234")
    hand.wait(lambda: "Touched" not in job.State and "F1234" in api.program_text(job), 20, "the feed in the program")
    hand.shot("job-own-feed")
    hand.click(P + "cut_feed_mm_min_reset")
    hand.wait(lambda: float(job.CutFeed) == 0 and "Touched" not in job.State, 20, "the chart's feed")
    assert hand.main(api.program_text, job) == before
    hand.wait(lambda: not places.visible(P + "cut_feed_mm_min_reset"), what="the button to go")
    for key in sorted(SHOWN["plasma"] - {"feed_mm_min", "consumable"}):
        field, reset = f"{P}cut_{key}", f"{P}cut_{key}_reset"
        of_chart = hand.text(field)
        hand.fill(field, "2.5")
        hand.wait(lambda reset=reset: places.visible(reset), 20, reset)
        hand.click(reset)
        hand.wait(lambda reset=reset: not places.visible(reset), 20, f"{reset} to go")
        hand.wait(lambda field=field, of_chart=of_chart: hand.text(field) == of_chart, 20, of_chart)


def test_a_machine_brings_a_process_and_a_material(hand: Hand, document: Any) -> None:
    job = hand.main(lambda: api.new_job(document, stock_size_mm=(200, 150, 3)))
    open_panel(hand, job, "machine")
    hand.choose(P + "machine", "Torch table (torch-table)")
    hand.wait(lambda: job.Process == "plasma", 20, "the process of the machine")
    assert hand.main(lambda: job.Material) != ""
    hand.wait(lambda: places.visible(P + "cut_feed_mm_min"), what="the chart's values")
    hand.choose(P + "process", "Oxyfuel")
    hand.wait(lambda: job.Process == "oxyfuel", 20, "the other process")
    hand.shot("job-oxyfuel")


def test_commands_are_those_of_the_process(hand: Hand, document: Any) -> None:
    def state(name: str) -> tuple[bool, str]:
        action = FreeCADGui.Command.get(f"CNCStepper_{name}").getAction()[0]
        return action.isEnabled(), action.toolTip()

    job = hand.main(make_job, document, "plasma")
    hand.main(lambda: (FreeCADGui.Selection.clearSelection(), FreeCADGui.Selection.addSelection(document.Objects[0])))
    hand.wait(lambda: state("SheetCut")[0] and not state("Pocket")[0], what="the commands of plasma")
    assert "Plasma" in hand.main(state, "Pocket")[1] and "Milling" in hand.main(state, "Pocket")[1]
    assert not hand.main(state, "WireCut")[0]
    hand.main(lambda: (api.edit(job, process="hot-wire", **JOBS["hot-wire"]), document.recompute()))
    hand.main(lambda: (FreeCADGui.Selection.clearSelection(), FreeCADGui.Selection.addSelection(document.Objects[0])))
    hand.wait(lambda: state("WireCut")[0] and not state("SheetCut")[0], what="the commands of a hot wire")
