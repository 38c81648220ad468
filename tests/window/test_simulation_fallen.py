# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces of a sheet in the simulation: each is drawn as fallen from the moment at which nothing holds it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import Draft
import FreeCAD
import FreeCADGui
import pytest
from FreeCAD import Vector
from test_simulation_view import go_to, opened, ready

from CNCStepper.workbench import api
from CNCStepper.workbench.proving.proof_process import ProofRun
from CNCStepper.workbench.simulation.task import SimulationTask
from window_helpers.hand import Hand


def new_document() -> Any:
    """A plate with two holes, to be cut out of sheet by plasma."""
    document = FreeCAD.newDocument("Chapa")
    Draft.make_rectangle(80, 50, FreeCAD.Placement(Vector(-40, -25, 0), FreeCAD.Rotation()))
    for x in (-20, 15):
        Draft.make_circle(9, FreeCAD.Placement(Vector(x, 0, 0), FreeCAD.Rotation()))
    drawings = list(document.Objects)
    document.recompute()
    job = api.new_job(document, process="plasma", machine="torch-table", material="mild-steel", stock_form="sheet",
                      stock_size_mm=(140, 100, 3))  # fmt: skip
    api.add_operation(job, "sheet_cut", drawings=drawings)
    document.recompute()
    return job


@pytest.fixture
def job(hand: Hand) -> Iterator[Any]:
    ProofRun._last = None
    job = hand.main(new_document)
    hand.main(FreeCADGui.SendMsgToActiveView, "ViewFit")
    yield job
    ProofRun._last = None
    hand.main(FreeCADGui.Control.closeDialog)
    hand.main(FreeCAD.closeDocument, job.Document.Name)


def shown(task: SimulationTask) -> list[bool]:
    """Which pieces are drawn as fallen, the first that comes free first."""
    group = task._scene._fallen_pieces
    switches = [group.getChild(k) for k in range(group.getNumChildren())][-len(task._result.fallen) :]
    return [switch.whichChild.getValue() == 0 for switch in switches]


@pytest.mark.window("plain", "scaled")
def test_pieces_fall_while_the_slider_goes_on_and_come_back(hand: Hand, job: Any) -> None:
    task = opened(hand, job)
    falls_s = [piece["falls_at_s"] for piece in task._result.report["pieces"]]
    assert len(falls_s) == 3 and hand.main(shown, task) == [True] * 3
    hand.shot("simulation-fallen-end")
    whole_s = task._player.moves.duration_s
    for share in (0.0, 0.3, 0.6, 0.9, 0.6, 0.3, 0.0):
        go_to(hand, task, share)
        assert hand.main(shown, task) == [falls <= task._player.time_s for falls in falls_s]
        hand.shot(f"simulation-fallen-{share:g}")
    hand.main(task._player.seek, (falls_s[0] + falls_s[1]) / 2)
    ready(hand, task)
    assert hand.main(shown, task) == [True, False, False] and falls_s[-1] < whole_s
    hand.shot("simulation-fallen-first")
