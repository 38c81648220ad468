# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mini-lathe's acceptance parts from the window: checked and simulated, sent from the dock, made step by step."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
from test_dock import D, own_sessions, says  # noqa: F401

from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.machine.profile import load_machine
from CNCStepper.workbench import api
from CNCStepper.workbench.features.base import problem_of
from CNCStepper.workbench.proving.proof_process import ProofRun
from window_helpers import screen_places as places
from window_helpers.docks import opened_dock
from window_helpers.hand import Hand

INDEX = Path(__file__).parents[2] / "examples" / "machines" / "mini-lathe-index.toml"
RPM, STEPS_PER_MM = 1000.0, 80.0
# What sends is the same process under each FreeCAD: all five parts are cut beside the oldest alone.
START = {"start_by": "given", "start_x_mm": 5.3, "start_z_mm": 5.0}
THREAD = {"length_mm": 2.0, "first_depth_mm": 0.5, "pull_out_mm": 1.0, "spring_passes": 0}
WORKED = ["automatic mode", "M02: the program has ended"]  # all that the virtual lathe has to tell
PARTS: dict[str, tuple[tuple[str, ...], dict[str, Any], dict[str, Any]]] = {  # profile, of the job, of the thread
    "cylinder": (("8; 0", "8; -2"), {}, {}),
    "incremental cylinder": (("8; 0", "8; -2"), {"distance": "incremental"}, {}),
    "cone": (("6; 0", "8; -2"), {}, {}),
    "threaded cylinder": (("7.9; 0", "7.9; -4"), {}, {"thread": "M8x1"}),
    "threaded cone": (("7.6; 0", "7.85; -4"), {}, {"thread": "M7.7x1", "taper_deg": 1.789910608}),
}


@pytest.fixture
def machine(tmp_path: Path) -> str:
    """The mini-lathe with an encoder, whose feeds may be as fast as its rapids: a part takes seconds."""
    path = tmp_path / "mini-lathe-fast.toml"
    text = INDEX.read_text("utf-8")
    assert "pull_in_ms = 5.67 " in text
    path.write_text(text.replace("pull_in_ms = 5.67 ", "pull_in_ms = 0.54 "), "utf-8")
    return str(path)


def new_job(name: str, machine: str) -> Any:
    points, values, thread = PARTS[name]
    document = FreeCAD.newDocument("Acceptance")
    job = api.new_lathe_job(document, machine=machine, stock_diameter_mm=8.6, stock_length_mm=20.0,
                            stock_face_mm=0.1, x_is="radius", **START, **values)  # fmt: skip
    cutter = {"insert": "CNMG 120408", "shank_mm": 20.0, "feed_mm_rev": 0.6, "spindle_rpm": 2 * RPM}
    insert = api.add_tool(job, **cutter)
    profile = api.add_profile(document, points)
    api.add_operation(job, "turn_rough", profile, tool=insert, stock_to_leave_mm=0.2)
    api.add_operation(job, "turn_finish", profile, tool=insert)
    if thread:
        tip = api.add_tool(job, kind="threading", insert="", tip_angle_deg=60.0, shank_mm=20.0, spindle_rpm=RPM)
        api.add_operation(job, "turn_thread", profile, tool=tip, **THREAD, **thread)
    job.Label = name
    document.recompute()
    assert [problem_of(each) for each in (*job.Operations, job)] == [""] * (len(job.Operations) + 1)
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(job)
    return job


@pytest.fixture
def panel(hand: Hand) -> Iterator[Any]:
    """The dock's panel, with the profile that it had at the end."""

    def at_end(panel: Any) -> None:
        if panel.live.box.isChecked():
            panel.live.box.click()

    with opened_dock(hand, at_end) as panel:
        yield panel
    ProofRun._last = None


def step(hand: Hand, title: str, seconds: float = 60.0) -> None:
    hand.wait(lambda: hand.exists(f"{D}FlowTitle") and title in hand.text(f"{D}FlowTitle"), seconds, title)


def simulated(hand: Hand) -> None:
    hand.command("CNCStepper_Simulate")
    end = "CNCStepper_Simulation_end"
    hand.wait(lambda: hand.exists(end) and hand.find(end).isEnabled(), 60, "the simulation")
    hand.button("Close")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 10)


def sent(hand: Hand, job: Any, twin: Any, machine: str) -> None:
    """Send the program that the job shows to a lathe that was just switched on."""
    hand.command("CNCStepper_Send")
    hand.wait(lambda: hand.exists(f"{D}FlowTitle"), 20, "the steps")
    hand.wait(lambda: "Connect" in hand.text(f"{D}FlowTitle") or "Warnings" in hand.text(f"{D}FlowTitle"), 60)
    if "Warnings" in hand.text(f"{D}FlowTitle"):
        hand.click(f"{D}Start")
        step(hand, "Connect")
    assert hand.text(f"{D}Machine") == Path(machine).name
    hand.fill(f"{D}Port", twin.address)
    hand.click(f"{D}Start")
    step(hand, "Work zero")
    hand.click(f"{D}ZeroAll")
    hand.wait(lambda: hand.find(f"{D}Start").isEnabled(), 20, "Start")
    hand.click(f"{D}Start")
    if hand.main(lambda: places.find(f"{D}Live").isChecked()):
        hand.wait(lambda: "lathe is not shown" in FreeCADGui.getMainWindow().statusBar().currentMessage(), 20, "a note")
    step(hand, "Done")
    hand.click(f"{D}Cancel")
    hand.click(f"{D}Connect")
    says(hand, "Not connected")


def check_steps(text: str, twin: Any, machine: str) -> None:
    """The lathe has made as many steps of each axis as the program's own text has, and stands at its end."""
    ends = interpret(text, None, load_machine(machine).language()).table().end[:, [0, 2]]
    places = np.vstack([np.zeros(2), np.rint(ends * STEPS_PER_MM)])
    rows = [line.split(",")[1:] for line in twin.trace.read_text().splitlines()[1:]]
    made = np.rint(np.array(rows, float) * STEPS_PER_MM)
    assert np.abs(np.diff(made, axis=0)).sum(axis=0).tolist() == np.abs(np.diff(places, axis=0)).sum(axis=0).tolist()
    assert made[-1].tolist() == places[-1].tolist()
    assert [line.partition(": ")[2] for line in twin.told] == WORKED  # no record was refused and no byte lost


@pytest.mark.parametrize("name", PARTS if FreeCAD.Version()[1] == "20" else ["threaded cylinder"])
def test_an_acceptance_part_from_the_job_to_the_last_step(
    hand: Hand,
    panel: Any,
    twins: Any,
    machine: str,
    name: str,
) -> None:
    job = hand.main(new_job, name, machine, limit_s=60)
    simulated(hand)
    if name == "cone":
        show_the_cut(hand)
    for part in range(1, hand.main(lambda: job.ProgramParts) + 1):
        twin = twins("lathe", "--thread-start", "--spindle-rpm", f"{RPM:g}")
        hand.main(show_part, job, part)
        sent(hand, job, twin, machine)
        twin.end()
        check_steps(hand.main(api.program_text, job), twin, machine)
    hand.shot(f"lathe-sent-{name}")


def show_the_cut(hand: Hand) -> None:
    """Tick the box, which the panel's fixture clears."""
    hand.main(lambda: places.scroll_to(places.find(f"{D}Live")))
    hand.click(f"{D}Live")


def show_part(job: Any, part: int) -> None:
    if job.ProgramPart != part:
        job.ProgramPart = part
        job.Document.recompute()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(job)
