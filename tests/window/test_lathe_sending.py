# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mini-lathe's acceptance parts from the window: checked and simulated, sent from the dock, made step by step.

What is cut is shown in the 3D view meanwhile: the material as it goes, and the tool where the lathe reports it.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
import shapely
from test_dock import LONGEST_MS, D, own_sessions, says  # noqa: F401

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
AUTOMATIC = {"start_by": "automatic"}
START_XZ_MM = {"given": (5.3, 5.0), "automatic": (4.3 + 5.0, 0.1 + 5.0)}  # X as radius; clear of bar and raw end
AWAY_MM = 0.02  # of the tool from the proof's path, of a step of 0.0125 mm in X and in Z
SAME_SHARE = 0.005  # of a volume; a drawn outline may be 0.005 mm from the true one
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


def new_job(name: str, machine: str, start: dict[str, Any] = START, feed_mm_rev: float = 0.6) -> Any:
    points, values, thread = PARTS[name]
    document = FreeCAD.newDocument("Acceptance")
    job = api.new_lathe_job(document, machine=machine, stock_diameter_mm=8.6, stock_length_mm=20.0,
                            stock_face_mm=0.1, x_is="radius", **start, **values)  # fmt: skip
    cutter = {"insert": "CNMG 120408", "shank_mm": 20.0, "feed_mm_rev": feed_mm_rev, "spindle_rpm": 2 * RPM}
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


def connected(hand: Hand, twin: Any, machine: str) -> None:
    """Begin to send the selected job, up to the question for the zero, to a lathe that was just switched on."""
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


def begun(hand: Hand) -> None:
    """Set the zero where the tool is, and begin to cut."""
    hand.click(f"{D}ZeroAll")
    hand.wait(lambda: hand.find(f"{D}Start").isEnabled(), 20, "Start")
    hand.click(f"{D}Start")


def left(hand: Hand) -> None:
    """Close what has ended, and disconnect."""
    hand.click(f"{D}Cancel")
    hand.click(f"{D}Connect")
    says(hand, "Not connected")


def sent(hand: Hand, twin: Any, machine: str) -> None:
    """Send the program that the selected job shows."""
    connected(hand, twin, machine)
    begun(hand)
    step(hand, "Done")
    left(hand)


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
    for part in range(1, hand.main(lambda: job.ProgramParts) + 1):
        twin = twins("lathe", "--thread-start", "--spindle-rpm", f"{RPM:g}")
        hand.main(show_part, job, part)
        sent(hand, twin, machine)
        twin.end()
        check_steps(hand.main(api.program_text, job), twin, machine)
    hand.shot(f"lathe-sent-{name}")


def show_part(job: Any, part: int) -> None:
    if job.ProgramPart != part:
        job.ProgramPart = part
        job.Document.recompute()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(job)


class Seen:
    """All that a cut under way shows: the section faces of each part, and the reports with the place of the tool."""

    def __init__(self, shown: Any):
        self.faces: list[np.ndarray] = []
        self.places: list[tuple[Any, Any]] = []
        self._change, self._follow = shown._scene.change, shown.follow
        self._shown = shown
        shown._scene.change, shown.follow = self._changed, self._followed

    def _changed(self, groups: Any) -> None:
        self._change(groups)
        self.faces.append(groups["section"][0])

    def _followed(self, status: Any) -> None:
        self._follow(status)
        scene = self._shown._scene
        if scene._tool.whichChild.getValue() == 0:  # it comes with the first part
            self.places.append((status.wpos_mm, scene._tool_place.translation.getValue().getValue()))

    @property
    def volumes(self) -> np.ndarray:
        """The volume of each part, mm³: what its two half sections sweep, half a turn each."""
        corners = [faces.reshape(-1, 3, 3).astype(float) for faces in self.faces]
        areas = [np.linalg.norm(np.cross(c[:, 1] - c[:, 0], c[:, 2] - c[:, 0]), axis=1) / 2 for c in corners]
        radii = [np.hypot(c[:, :, 0], c[:, :, 1]).mean(axis=1) for c in corners]
        return np.pi * np.array([area @ radius for area, radius in zip(areas, radii, strict=True)])


def proven_volume(result: Any) -> float:
    """The volume of a solid part as it was proven, mm³."""
    (ring,) = result.rings
    section = shapely.Polygon(ring)
    return float(2 * np.pi * section.centroid.y * section.area)


def jogged_aside(hand: Hand, panel: Any) -> None:
    """Jog away from where the lathe was switched on, which its positions count from."""
    hand.click(f"{D}Step2")
    hand.click(f"{D}JogXPlus")
    hand.wait(lambda: panel.link.status.mpos_mm[0] > 0.9, 20, "the jog")
    says(hand, "Idle")


@pytest.mark.parametrize("start", [AUTOMATIC, START], ids=["automatic", "given"])
def test_the_cut_is_in_the_view_while_the_lathe_makes_it(
    hand: Hand, panel: Any, twins: Any, machine: str, start: dict[str, Any]
) -> None:
    hand.main(new_job, "cone", machine, {**start, "chuck_diameter_mm": 20.0}, 0.1, limit_s=60)
    connected(hand, twins("lathe", "--spindle-rpm", f"{RPM:g}"), machine)
    jogged_aside(hand, panel)
    hand.main(lambda: places.scroll_to(places.find(f"{D}Live")))
    hand.click(f"{D}Live")
    with hand.watchdog() as dog:
        begun(hand)
        hand.wait(lambda: panel.live.shown is not None, 30, "the cut")
        shown, seen = panel.live.shown, hand.main(Seen, panel.live.shown)
        hand.wait(lambda: shown.time_s > shown.result.moves.duration_s / 2 and seen.faces, 60, "half of the cut")
    hand.main(shown._stage.look_from_the_side)
    hand.shot(f"lathe-live-{start['start_by']}")
    step(hand, "Done")
    hand.wait(lambda: not shown._material.waiting and not shown._material._wanted, 20, "the finished part")
    hand.shot(f"lathe-live-end-{start['start_by']}")
    print(f"while the cut is shown: {dog}; {len(seen.faces)} parts, {len(seen.places)} places")
    assert dog.max_cpu_ms < LONGEST_MS, dog
    volumes = seen.volumes
    assert (np.diff(volumes) < 1e-3 * volumes[0]).all() and volumes[0] > 1.01 * volumes[-1] and len(volumes) > 5
    assert volumes[-1] == pytest.approx(proven_volume(shown.result), rel=SAME_SHARE)
    check_places(seen, shown.result.moves, *START_XZ_MM[start["start_by"]])
    left(hand)
    hand.wait(lambda: panel.live.shown is None, 5, "an empty view")


def check_places(seen: Seen, moves: Any, start_x_mm: float, start_z_mm: float) -> None:
    """The tool was shown where it was reported, counted from the start, and on the proven path."""
    work_mm, shown_mm = (np.array(column, float) for column in zip(*seen.places, strict=True))
    wanted_mm = np.column_stack([start_x_mm + work_mm[:, 0], work_mm[:, 1], start_z_mm - work_mm[:, 2]])
    assert shown_mm == pytest.approx(wanted_mm, abs=1e-3) and len(shown_mm) > 10
    path = shapely.LineString(np.vstack([moves.begin[:1], moves.end])[:, [0, 2]])
    away_mm = shapely.distance(path, shapely.points(shown_mm[:, [0, 2]]))
    print(f"the tool is {away_mm.max():.4f} mm from the path at most")
    assert away_mm.max() < AWAY_MM
