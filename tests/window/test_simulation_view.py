# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check and simulate, with a real mouse: the proof, the player, the program's lines, the findings, and no trace."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
from PySide import QtCore

from CNCStepper.workbench import api
from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.proving import standby
from CNCStepper.workbench.proving.proof_process import ProofRun
from CNCStepper.workbench.services.findings_list import sentence
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.simulation import open_simulation
from CNCStepper.workbench.simulation.scene import AT_MOMENT, FINISHED
from CNCStepper.workbench.simulation.task import SimulationTask
from CNCStepper.workbench.simulation.view_menu import ENTRIES
from window_helpers import screen_places as places
from window_helpers.hand import Hand

PROVEN_S = 180  # where nothing is compiled yet and the processors are busy
AT_ONCE_MS = 50
SIMULATIONS = int(os.environ.get("CNCSTEPPER_SIMULATIONS", "15"))  # of which memory must not grow
PART_S = 0.5  # of processor, from the click to the part in its process


def new_document(drawing_mm: tuple[float, float, float] = (50, 35, 0)) -> Any:
    """A plate with an elliptical pocket and an engraved line, away from the document's origin."""
    import Draft

    document = FreeCAD.newDocument("Peça")
    plate = document.addObject("Part::Box", "Plate")
    plate.Length, plate.Width, plate.Height = 100, 70, 20
    plate.Placement.Base.z = -20
    job = api.new_job(document, machine="table-a", stock_size_mm=(100, 70, 20), work_origin_mm=drawing_mm)
    cutter = api.add_tool(job, diameter_mm=6, feed_mm_min=800, plunge_mm_min=200, spindle_rpm=10000)
    api.add_elliptical_pocket(
        job, tool=cutter, centre_mm=(10, 0), radius_x_mm=30, radius_y_mm=22, depth_mm=8, stepdown_mm=2
    )
    ball = api.add_tool(job, shape="ball", diameter_mm=3, feed_mm_min=600, plunge_mm_min=200, spindle_rpm=12000)
    points = [(5 + 4 * np.sin(k / 3), 10 + 2 * k, 0) for k in range(26)]
    wave = Draft.make_bspline([FreeCAD.Vector(*point) for point in points])
    document.recompute()
    api.add_engrave(job, wave, tool=ball, depth_mm=1)
    document.recompute()
    return job


@pytest.fixture
def job(hand: Hand) -> Iterator[Any]:
    ProofRun._last = None
    job = hand.main(new_document)
    hand.main(FreeCADGui.SendMsgToActiveView, "ViewFit")
    yield job
    ProofRun._last = None


def no_restart(job: Any, line: int) -> None:
    raise AssertionError(f"nobody restarts {job.Label} at {line}")


def opened(hand: Hand, job: Any) -> SimulationTask:
    """Open the simulation and wait until all of it is shown."""
    task = hand.main(open_simulation, job, no_restart)
    hand.wait(lambda: task._result is not None and not task._loader.isActive(), PROVEN_S)
    return task


def scenes() -> int:
    graph = FreeCADGui.ActiveDocument.ActiveView.getSceneGraph()
    return sum(graph.getChild(k).getName() == "CNCStepper_Simulation" for k in range(graph.getNumChildren()))


def click_line(hand: Hand, task: SimulationTask, number: int) -> None:
    """Scroll the program to a line and click it."""
    program = task.form.program
    index = hand.main(lambda: program.model().index(number - 1, 0))
    hand.main(program.scrollTo, index)
    hand.settle()
    middle = hand.main(lambda: program.visualRect(index).center())
    hand.click(hand.main(program.viewport), at=(40, middle.y()))


def click_finding(hand: Hand, text: str) -> None:
    rows = hand.find("CNCStepper_Findings_list")

    def middle() -> tuple[int, int]:
        row = next(rows.item(k) for k in range(rows.count()) if rows.item(k).text() == text)
        rows.scrollToItem(row)
        place = rows.visualItemRect(row).center()
        return place.x(), place.y()

    hand.click(hand.main(rows.viewport), at=hand.main(middle))


def tip(task: SimulationTask) -> np.ndarray:
    """Where the tool's tip is drawn, in the document."""
    work = np.array(task._scene._tool_place.translation.getValue().getValue())
    return work + np.array(task._job.WorkOrigin)


def ready(hand: Hand, task: SimulationTask) -> None:
    """Wait until the scene shows the moment at which the player stands."""
    hand.wait(lambda: not task._material.waiting, PROVEN_S)


def go_to(hand: Hand, task: SimulationTask, share: float) -> None:
    """Drag the slider to a share of the program's time and wait for the picture."""
    slider = hand.find("CNCStepper_Simulation_time")
    hand.main(lambda: slider.setValue(round(share * slider.maximum())))
    ready(hand, task)


def drawn_tiles(task: SimulationTask) -> dict[int, np.ndarray]:
    """The corners of the faces of every tile that the 3D view holds, float32[n, 4, 3]."""
    tiles = {}
    for number, tile in task._scene._tiles.items():
        pieces = [tile.getChild(k).vertexProperty.getValue().vertex for k in range(tile.getNumChildren())]
        points = [point.getValue() for piece in pieces for point in piece.getValues(0)]
        tiles[number] = np.array(points, np.float32).reshape(-1, 4, 3)
    return tiles


def volume_mm3(tiles: dict[int, np.ndarray]) -> float:
    """The volume within faces, which are drawn a trifle larger than they are."""
    from CNCStepper.simulation.views.coloured_faces import (
        LAP_MM,  # not above: a window without packages reads this file too
    )

    corners = np.concatenate(list(tiles.values())).astype(float)
    corners -= LAP_MM * np.sign(corners - corners.mean(axis=1, keepdims=True))
    area = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]) / 2
    return float((corners.mean(axis=1) * area).sum() / 3)


def shows_a_moment(task: SimulationTask) -> bool:
    return bool(task._scene._part.whichChild.getValue() == AT_MOMENT)


def processor_s(pid: int) -> float:
    """The processor time that a process has taken."""
    used = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[11:13]
    return sum(map(int, used)) / os.sysconf("SC_CLK_TCK")


def waiting_proof(hand: Hand) -> tuple[int, float]:
    """Wait until a process has loaded what the next proof needs; its number and the processor time of that."""
    hand.wait(lambda: standby._standby is not None and standby._standby.is_ready, PROVEN_S)
    pid = standby._standby.pid
    assert pid is not None
    return pid, processor_s(pid)


def opened_up_to_the_part(hand: Hand, job: Any) -> tuple[SimulationTask, int]:
    """Open the simulation, halt its proof when the part is handed out, and wait until that is shown; the process."""
    processes: list[int] = []

    def halt(*_: Any) -> None:
        print(f"the part came {time.monotonic() - begun_s:.2f} s after the click")
        processes.append(int(task._run._process.pid))
        os.kill(processes[0], signal.SIGSTOP)

    def open_and_listen() -> SimulationTask:
        task = open_simulation(job, no_restart)
        task._run.part.connect(halt)
        return task

    begun_s = time.monotonic()
    task = hand.main(open_and_listen)
    hand.wait(lambda: processes and not task._loader.isActive(), PROVEN_S)
    print(f"the part is in the view {time.monotonic() - begun_s:.2f} s after the click")
    return task, processes[0]


def camera_set() -> list[str]:
    """What is set of the camera; near and far follow from what there is to see when it is next drawn."""
    lines = FreeCADGui.ActiveDocument.ActiveView.getCamera().splitlines()
    return [line for line in lines if line.split()[:1] not in (["nearDistance"], ["farDistance"])]


def finished_faces(task: SimulationTask) -> int:
    """How many pieces of the finished part the scene holds."""
    group = task._scene._part.getChild(FINISHED)
    return sum(group.getChild(k).getTypeId().getName() == "IndexedFaceSet" for k in range(group.getNumChildren()))


def process_of(task: SimulationTask) -> int:
    return int(task._material.moments._questions._process.pid)


def runs(pid: int) -> bool:
    return Path(f"/proc/{pid}").exists()


@pytest.mark.window("plain", "scaled")
def test_it_plays_steps_and_follows_the_program(hand: Hand, job: Any) -> None:
    task = opened(hand, job)
    hand.shot("simulation-begin")
    assert hand.main(scenes) == 1
    hand.click("CNCStepper_Simulation_play")
    hand.wait(lambda: task._player.time_s > 20, 20)
    hand.shot("simulation-plays")
    hand.click("CNCStepper_Simulation_play")
    stood_s = task._player.time_s
    hand.click("CNCStepper_Simulation_forward")
    line = task._player.line
    assert task._player.time_s > stood_s and not task._player.playing
    hand.click("CNCStepper_Simulation_back")
    assert task._player.line < line
    ready(hand, task)
    marked = hand.main(lambda: task.form.program.currentIndex().row() + 1)
    assert marked == task._player.line
    hand.shot("simulation-stepped")
    for name, value in (("time", lambda: task._player.time_s), ("speed", lambda: task._player.speed)):
        slider, before = hand.find(f"CNCStepper_Simulation_{name}"), hand.main(value)
        hand.click(slider, at=hand.main(lambda slider=slider: (slider.width() - 4, slider.height() // 2)))
        hand.wait(lambda value=value, before=before: value() > before, 5, f"the {name} to rise")
    assert not hand.text("CNCStepper_Simulation_speed_text").startswith("1 ")


@pytest.mark.window("plain", "portuguese")
def test_the_menu_chooses_from_where_the_part_is_seen_and_how_near(hand: Hand, job: Any) -> None:
    opened(hand, job)
    view = FreeCADGui.ActiveDocument.ActiveView
    path = hand.find("CNCStepper_Simulation_path")
    for name, seen in (("xy", (0, 0, -1)), ("zy", (-1, 0, 0)), ("depth", (0, 0, -1)), ("isometric", (-1, 1, -1))):
        choose_view(hand, name)
        along = np.array(hand.main(view.getViewDirection))
        assert along == pytest.approx(np.array(seen) / np.linalg.norm(seen), abs=1e-3), name
        assert hand.main(path.isChecked) == (name != "depth")
        hand.shot(f"simulation-{name}")
    for is_on in (False, True):
        hand.click(path)
        hand.wait(lambda is_on=is_on: path.isChecked() == is_on, 5, "the path's box")
    whole_mm = hand.main(seen_mm)
    choose_view(hand, "nearer")
    assert hand.main(seen_mm) < whole_mm
    choose_view(hand, "farther")
    choose_view(hand, "farther")
    assert hand.main(seen_mm) > whole_mm
    choose_view(hand, "whole")
    assert hand.main(seen_mm) == pytest.approx(whole_mm, rel=1e-3)
    choose_view(hand, "frame")
    hand.drag([hand.view_point(-10, -10), hand.view_point(10, 10)])
    hand.wait(lambda: seen_mm() < whole_mm / 2, 5, "the frame that was dragged")


def choose_view(hand: Hand, name: str) -> None:
    """Choose an entry of the view's menu."""
    text = tr(next(text for group in ENTRIES for entry, text in group if entry == name))
    hand._click_place(hand._place(places.of_widget, "CNCStepper_Simulation_view", None))
    hand.wait(lambda: places.popup_entry(text), 5, text)
    hand._click_place(hand.main(places.popup_entry, text))
    hand.settle()


def seen_mm() -> float:
    """The height that the 3D view shows."""
    camera = FreeCADGui.ActiveDocument.ActiveView.getCameraNode()
    return float(camera.height.getValue())


def test_material_vanishes_while_it_plays_and_comes_back_the_same(hand: Hand, job: Any) -> None:
    task = opened(hand, job)
    assert task._player.at_end and not hand.main(shows_a_moment, task)
    ready(hand, task)
    shares = (0.0, 0.1, 0.3, 0.5, 0.7, 0.9)
    there = []
    for share in shares:
        go_to(hand, task, share)
        there.append(hand.main(drawn_tiles, task))
    assert hand.main(shows_a_moment, task)
    volumes = [volume_mm3(tiles) for tiles in there]
    print(volumes)
    assert volumes[0] == pytest.approx(100 * 70 * 20, rel=1e-4) and (np.diff(volumes) < -100).all()
    for share, before in zip(shares[-2::-1], there[-2::-1], strict=True):
        go_to(hand, task, share)
        if share == 0.5:
            hand.shot("simulation-half-cut")
        now = hand.main(drawn_tiles, task)
        assert {k: faces.tobytes() for k, faces in now.items()} == {k: faces.tobytes() for k, faces in before.items()}
    pictures: list[int] = []
    hand.main(task._material.shown.connect, lambda: pictures.append(1))
    hand.click("CNCStepper_Simulation_play")
    hand.wait(lambda: len(pictures) > 20 and volume_mm3(drawn_tiles(task)) < volumes[0] - 10, 60)
    hand.click("CNCStepper_Simulation_play")
    ready(hand, task)
    assert volume_mm3(hand.main(drawn_tiles, task)) < volumes[0] - 10
    hand.click("CNCStepper_Simulation_end")
    assert task._player.at_end and not hand.main(shows_a_moment, task)


def test_one_step_is_a_line_a_move_or_a_pulse(hand: Hand, job: Any) -> None:
    task = opened(hand, job)
    go_to(hand, task, 0.2)
    player, moves = task._player, task._result.moves
    steps = hand.find("CNCStepper_Simulation_step_by")
    begun_s = player.time_s
    hand.choose(steps, hand.main(steps.itemText, 1))
    hand.click("CNCStepper_Simulation_forward")
    assert player.time_s == moves.ends_s[np.searchsorted(moves.ends_s, begun_s)]
    hand.choose(steps, hand.main(steps.itemText, 2))
    stood = [player.time_s]
    for _ in range(3):
        hand.click("CNCStepper_Simulation_forward")
        hand.wait(lambda: player.time_s > stood[-1], 20)
        ready(hand, task)
        stood.append(player.time_s)
    assert 0 < np.diff(stood[1:]).max() < 0.1 and len(player.steps) == 3
    assert str(player.steps[0]) in hand.text("CNCStepper_Simulation_motors")
    hand.shot("simulation-pulse")
    hand.click("CNCStepper_Simulation_back")
    hand.wait(lambda: player.time_s < stood[-1], 20)
    assert player.time_s == stood[-2]


def test_the_part_is_kept_as_a_mesh(hand: Hand, job: Any) -> None:
    task = opened(hand, job)
    go_to(hand, task, 0.4)
    left_mm3 = volume_mm3(hand.main(drawn_tiles, task))
    document = job.Document
    undos = hand.main(lambda: document.UndoCount)
    hand.click("CNCStepper_Simulation_keep")
    hand.wait(lambda: document.getObject("CutPart") is not None, 60)
    hand.settle()
    part = document.CutPart
    assert hand.main(lambda: part.Mesh.Volume) == pytest.approx(left_mm3, rel=2e-3)
    assert hand.main(lambda: part.Mesh.isSolid())
    assert part.Placement.Base == job.WorkOrigin and job.Label in part.Label
    assert hand.main(lambda: part.Mesh.BoundBox.ZMax) == pytest.approx(0, abs=1e-3)
    assert not hand.main(lambda: part.ViewObject.Visibility)
    hand.button("Close")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 5)
    assert hand.main(lambda: part.ViewObject.Visibility)
    hand.main(lambda: setattr(document.Plate.ViewObject, "Visibility", False))
    hand.shot("simulation-mesh")
    assert hand.main(lambda: document.UndoCount) == undos + 1
    hand.main(document.undo)
    assert document.getObject("CutPart") is None


def test_a_click_on_a_line_moves_the_tool_there(hand: Hand, job: Any) -> None:
    task = opened(hand, job)
    lines = api.program_text(job).splitlines()
    number = next(k for k, line in enumerate(lines, 1) if line.startswith(("G2", "G3")) and k > 25)
    click_line(hand, task, number)
    assert task._player.line == number
    row = task._player.row
    end = task._result.moves.end[row] + np.array(job.WorkOrigin)
    assert hand.main(tip, task) == pytest.approx(end, abs=1e-4)


def test_findings_lead_to_their_place(hand: Hand, job: Any) -> None:
    def break_program() -> None:
        text = api.program_text(job)
        program_file.store(job, text.replace("Z-6", "Z-30", 1))
        for obj in job.Document.Objects:
            obj.purgeTouched()

    hand.main(break_program)
    task = opened(hand, job)
    worst = next(finding for finding in task._result.findings if finding.place.line and finding.place_mm)
    title = hand.main(lambda: [w.text() for w in task.form.findChildren(type(task.form._message))])
    assert any("must not be sent" in text for text in title)
    click_finding(hand, sentence(worst))
    assert task._player.line == worst.place.line
    place = np.array(hand.main(lambda: task._scene._marker_place.translation.getValue().getValue()))
    assert place == pytest.approx(worst.place_mm, abs=1e-3)
    hand.shot("simulation-findings")


def test_it_leaves_nothing_behind(hand: Hand, job: Any) -> None:
    document = job.Document
    before = {obj.Name: hand.main(lambda obj=obj: obj.ViewObject.Visibility) for obj in document.Objects}
    camera = hand.main(camera_set)
    for _ in range(2):
        opened(hand, job)
        assert not hand.main(lambda: document.Plate.ViewObject.Visibility)
        hand.button("Close")
        hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 5)
        assert hand.main(scenes) == 0
    assert {obj.Name: hand.main(lambda obj=obj: obj.ViewObject.Visibility) for obj in document.Objects} == before
    assert hand.main(camera_set) == camera


class Simulations:
    """Opens and closes the simulation by a timer: what pytest's thread holds would be kept until its test ends."""

    def __init__(self, job: Any, times: int):
        self.left, self._job, self._task = times, job, None
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._next)
        self._timer.start(20)

    def _next(self) -> None:
        if self._task is None and self.left:
            self._task = open_simulation(self._job, no_restart)
        elif self._task is None:
            self._timer.stop()
        elif self._task._result is not None and not self._task._loader.isActive():
            FreeCADGui.Control.closeDialog()
            self._task = None
            self.left -= 1


def test_memory_stays_flat_over_simulations(hand: Hand, job: Any) -> None:
    def simulate(times: int) -> None:
        running = hand.main(Simulations, job, times)
        hand.wait(lambda: not running.left, PROVEN_S + 10 * times, "all simulations")
        hand.settle()

    simulate(5)
    before_mb = hand.memory_mb()
    simulate(SIMULATIONS)
    grown_mb = hand.memory_mb() - before_mb
    print(f"{SIMULATIONS} simulations leave {grown_mb:.1f} MB")
    assert grown_mb < 10


def test_the_part_is_in_the_view_before_the_answer(hand: Hand, job: Any) -> None:
    waited, loaded_s = waiting_proof(hand)
    task, process = opened_up_to_the_part(hand, job)
    used_s = processor_s(process) - loaded_s
    print(f"the process that waited has taken {used_s:.2f} s of processor for the part, {loaded_s:.2f} before")
    assert process == waited and used_s < PART_S
    scene = task._scene
    assert task._result is None and hand.main(scenes) == 1 and hand.main(finished_faces, task) > 0
    assert not hand.main(lambda: job.Document.Plate.ViewObject.Visibility)
    assert hand.exists("CNCStepper_Simulation_busy")
    assert hand.text("CNCStepper_Simulation_message")
    hand.shot("simulation-part-first")
    pieces = hand.main(finished_faces, task)
    os.kill(process, signal.SIGCONT)
    hand.wait(lambda: task._result is not None and not task._loader.isActive(), PROVEN_S)
    assert task._scene is scene and hand.main(scenes) == 1 and hand.main(finished_faces, task) == pieces
    hand.shot("simulation-part-and-all")


@pytest.mark.parametrize("end", ["lost", "closed", "deleted"])
def test_a_part_without_an_answer_leaves_the_view(hand: Hand, job: Any, end: str) -> None:
    camera = hand.main(camera_set)
    task, process = opened_up_to_the_part(hand, job)
    assert hand.main(scenes) == 1
    if end == "lost":
        os.kill(process, signal.SIGKILL)
        hand.wait(lambda: "without an answer" in task.form._message.text(), 20)
        hand.shot("simulation-part-lost")
    elif end == "closed":
        hand.button("Close")
        hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 5)
    else:
        hand.main(lambda: job.Document.removeObject(job.Name))
        hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 5)
    hand.wait(lambda: not runs(process), 5)
    assert hand.main(scenes) == 0 and task._scene is None and task._run is None
    assert hand.main(camera_set) == camera


def test_closing_it_ends_the_process(hand: Hand, job: Any) -> None:
    task = hand.main(open_simulation, job, no_restart)
    hand.wait(lambda: task._run is not None and task._run._process is not None, 20)
    process = task._run._process
    hand.shot("simulation-proves")
    hand.button("Close")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 5)
    assert task._run is None and process is not None
    again = hand.main(open_simulation, job, no_restart)
    hand.wait(lambda: again._run is not None and again._run._process is not None, 20)
    hand.main(FreeCAD.closeDocument, job.Document.Name)
    hand.wait(lambda: not FreeCADGui.Control.activeDialog() and again._run is None, 5)


def test_the_process_behind_the_material_goes_with_the_panel_and_is_started_again(hand: Hand, job: Any) -> None:
    task = opened(hand, job)
    go_to(hand, task, 0.5)
    first = process_of(task)
    os.kill(first, signal.SIGKILL)
    hand.wait(lambda: task._material.moments._questions._process is None, 20)
    assert "ended" in hand.text("CNCStepper_Simulation_message") and not hand.main(shows_a_moment, task)
    hand.shot("simulation-lost")
    go_to(hand, task, 0.6)
    second = process_of(task)
    assert hand.main(shows_a_moment, task) and second != first
    hand.button("Close")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 5)
    hand.wait(lambda: not runs(second), 5)
    again = opened(hand, job)  # the proof is the one before
    go_to(hand, again, 0.5)
    third = process_of(again)
    assert hand.main(shows_a_moment, again)
    hand.main(FreeCAD.closeDocument, job.Document.Name)
    hand.wait(lambda: not runs(third), 5)


def test_an_edit_meanwhile_is_said_and_simulated_again(hand: Hand, job: Any) -> None:
    task = opened(hand, job)

    def deeper() -> None:
        api.edit(job.Operations[0], depth_mm=10)
        job.Document.recompute()

    hand.main(deeper)
    assert "changed" in hand.text("CNCStepper_Simulation_message")
    hand.shot("simulation-changed")
    first = task._result
    hand.click("CNCStepper_Simulation_again")
    hand.wait(lambda: task._result not in (None, first) and not task._loader.isActive(), PROVEN_S)
    assert task._result.part.heights_mm.min() == pytest.approx(-10)
    assert hand.main(scenes) == 1


def test_no_call_takes_long_while_a_long_program_is_proven_and_played(hand: Hand, job: Any) -> None:
    lines = ["G21 G90 G17 G94 G54", "T1", "G0 Z10", "M3 S10000", "G4 P3", "G0 X-30 Y-20", "G1 Z-1 F200"]
    angle = np.linspace(0, 200 * np.pi, 100_000)
    radius = np.linspace(28, 2, len(angle))
    places = np.column_stack([radius * np.cos(angle), 0.7 * radius * np.sin(angle)])
    lines += [f"G1 X{x:.3f} Y{y:.3f} F2000" for x, y in places]
    text = "\n".join([*lines, "G0 Z10", "M5", "M2", ""])

    def store() -> None:
        program_file.store(job, text)
        for obj in job.Document.Objects:
            obj.purgeTouched()

    hand.main(store)
    with hand.watchdog() as watch:
        task = hand.main(open_simulation, job, no_restart)
        hand.wait(lambda: task._result is not None and not task._loader.isActive(), 120)
        hand.click("CNCStepper_Simulation_play")
        time.sleep(3)
        hand.click("CNCStepper_Simulation_play")
        for share in (0.9, 0.1, 0.5):
            go_to(hand, task, share)
    print(watch)
    hand.shot("simulation-100000-lines")
    assert len(task._result.program_lines) > 100_000
    assert watch.max_cpu_ms < AT_ONCE_MS, watch
