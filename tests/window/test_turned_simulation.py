# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check and simulate for a lathe, with a real mouse: the part cut open at any moment, its diameter at a Z, no trace."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import numpy as np
import pytest
from PySide import QtGui
from test_simulation_view import AT_ONCE_MS, no_restart, scenes

from CNCStepper.workbench.document.job_files import open_job
from CNCStepper.workbench.proving.proof_process import ProofRun
from CNCStepper.workbench.services.number_format import length_text
from CNCStepper.workbench.simulation import open_simulation
from CNCStepper.workbench.simulation.turned_task import TurnedSimulationTask
from window_helpers.hand import Hand

JOBS = Path(__file__).parents[2] / "examples" / "jobs"
PROVEN_S = 180  # where nothing is compiled yet and the processors are busy


def new_document() -> Any:
    document = FreeCAD.newDocument("Torno")
    job, _ = open_job(document, JOBS / "lathe-thread.toml")
    document.recompute()
    return job


@pytest.fixture
def job(hand: Hand) -> Iterator[Any]:
    ProofRun._last = None
    job = hand.main(new_document, limit_s=PROVEN_S)
    yield job
    ProofRun._last = None
    hand.main(FreeCADGui.Control.closeDialog)
    hand.main(FreeCAD.closeDocument, job.Document.Name)


def ready(hand: Hand, task: TurnedSimulationTask) -> None:
    hand.wait(lambda: not task._material.waiting and not task._material._wanted, PROVEN_S)


def opened(hand: Hand, job: Any) -> TurnedSimulationTask:
    task = hand.main(open_simulation, job, no_restart)
    hand.wait(lambda: task._material is not None and not task._loader.isActive(), PROVEN_S)
    ready(hand, task)
    return task


def longest_ms(task: TurnedSimulationTask, shares: list[float], hand: Hand) -> float:
    """How long the window takes at most to draw a moment."""
    took, change = [], task._scene.change

    def timed(groups: Any) -> None:
        begun_s = time.perf_counter()
        change(groups)
        took.append(1e3 * (time.perf_counter() - begun_s))

    task._scene.change = timed  # type: ignore[method-assign]
    for share in shares:
        go_to(hand, task, share)
    return max(took)


def points(task: TurnedSimulationTask) -> np.ndarray:
    """The points of the part that is drawn."""
    found = []
    for name, node in task._scene._drawn.items():
        if name.startswith(("raw", "cut")):
            strips = node.getChild(node.getNumChildren() - 1)
            found.append(np.array(strips.vertexProperty.getValue().vertex.getValues()))
    return np.concatenate(found)


def cut_off() -> list[int]:
    """By how many pixels the panel is wider than what FreeCAD shows of it."""
    areas = FreeCADGui.getMainWindow().findChildren(QtGui.QScrollArea)
    shown = [
        area for area in areas if area.isVisible() and area.findChild(QtGui.QWidget, "CNCStepper_Simulation_panel")
    ]
    assert shown
    return [wide for area in shown if (wide := area.widget().width() - area.viewport().width()) > 0]


def go_to(hand: Hand, task: TurnedSimulationTask, share: float) -> None:
    hand.main(task._player.seek, share * task._player.moves.duration_s)
    ready(hand, task)


@pytest.mark.window("plain", "portuguese")
def test_a_turned_part_is_seen_at_any_moment_and_measured(hand: Hand, job: Any) -> None:
    task = opened(hand, job)
    assert hand.main(scenes) == 1
    hand.shot("turned-end")
    assert hand.main(cut_off) == []
    finished = hand.main(points, task)
    assert (finished[:, 0] > 1e-6).any() and not ((finished[:, 0] > 0.1) & (finished[:, 1] > 0.1)).any()
    go_to(hand, task, 0.0)
    raw = hand.main(points, task)
    radius_mm = np.hypot(*raw[:, :2].T).max()
    assert radius_mm == pytest.approx(float(job.Diameter) / 2, abs=1e-3)
    go_to(hand, task, 0.5)
    hand.shot("turned-half")
    profile = np.array(task._result.report["profile"])
    z_mm = float((profile[:-1, 0] + profile[1:, 0])[-1] / 2)
    hand.click("CNCStepper_Simulation_end")
    hand.main(hand.find("CNCStepper_Simulation_z").setValue, round(z_mm, 3))
    ready(hand, task)
    wanted_mm = float(np.interp(round(z_mm, 3), *profile.T))
    assert hand.main(length_text, wanted_mm) in hand.text("CNCStepper_Simulation_reading")
    hand.main(hand.find("CNCStepper_Simulation_opening").setCurrentIndex, 1)
    ready(hand, task)
    assert hand.main(points, task)[:, 1].max() < 1e-3
    hand.shot("turned-open")


@pytest.mark.window("plain")
def test_a_turned_part_is_played_stepped_and_clicked(hand: Hand, job: Any) -> None:
    task = opened(hand, job)
    longest = longest_ms(task, [0.1, 0.3, 0.5, 0.7, 0.9], hand)
    print(f"a moment is drawn in {longest:.1f} ms at most")
    assert longest < AT_ONCE_MS
    hand.click("CNCStepper_Simulation_start")
    hand.click("CNCStepper_Simulation_play")
    hand.wait(lambda: task._player.time_s > 2, 30)
    hand.click("CNCStepper_Simulation_play")
    ready(hand, task)
    hand.click("CNCStepper_Simulation_start")
    steps = hand.find("CNCStepper_Simulation_step_by")
    hand.choose(steps, hand.main(steps.itemText, 2))
    ends_s = list(task._player.operations_s)
    for end_s in ends_s:
        hand.click("CNCStepper_Simulation_forward")
        assert task._player.time_s == pytest.approx(end_s)
    hand.click("CNCStepper_Simulation_back")
    assert task._player.time_s == pytest.approx([0.0, *ends_s][-2])
    ready(hand, task)
    hand.shot("turned-operation")
    for z_mm in (-90.0, -120.0):  # beside FreeCAD 1.1's panel, which lies over the view; a pixel is 0.5 mm
        hand.click_view(hand.view_point(4, 0, z_mm))
        assert hand.main(hand.find("CNCStepper_Simulation_z").value) == pytest.approx(z_mm, abs=1.5)
    opening = hand.find("CNCStepper_Simulation_opening")
    other = hand.main(lambda: (opening.currentIndex() + 1) % opening.count())
    hand.choose(opening, hand.main(opening.itemText, other))
    assert hand.main(opening.currentIndex) == other
    hand.fill("CNCStepper_Simulation_z", "-50")
    hand.wait(lambda: "⌀" in hand.text("CNCStepper_Simulation_reading"), 10, "the diameter there")
    ready(hand, task)
    hand.shot("turned-clicked")
    hand.main(task.reject)
    assert hand.main(scenes) == 0
