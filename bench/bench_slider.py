# SPDX-License-Identifier: LGPL-2.1-or-later
"""Milliseconds from a move of the simulation's slider to the material of that moment in the scene, for the demo part.

Python starts FreeCAD with this file, and FreeCAD measures, without a window: what drawing the scene then takes is
the graphics card's. The answers come from the process that a simulation's panel starts.
"""

from __future__ import annotations

import os
import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from bench_panel import engraving, pocket
from in_freecad import is_measuring, run

MOVES = 100
LIMIT_S = 300.0


def until(done: Callable[[], Any]) -> None:
    """Let Qt's events run until something is so."""
    from PySide import QtCore

    end_s = time.monotonic() + LIMIT_S
    while not done():
        if time.monotonic() > end_s:
            raise TimeoutError
        QtCore.QCoreApplication.processEvents(QtCore.QEventLoop.ProcessEventsFlag.WaitForMoreEvents, 5)


def proven(job: Any) -> Any:
    """Return the proof of a job."""
    from CNCStepper.workbench.proving.proof_process import ProofRun

    answers: list[Any] = []
    run = ProofRun(job)
    run.finished.connect(answers.append)
    run.failed.connect(answers.append)
    run.start()
    until(lambda: answers)
    return answers[0]


def processor_ms(material: Any) -> float:
    """Return the processor time of this process and of the one that it asks, which Linux tells."""
    pid = material.moments._process.processId()
    ticks = Path(f"/proc/{pid}/stat").read_text("ascii").rpartition(")")[2].split()[11:13]
    return 1000 * (time.process_time() + sum(map(int, ticks)) / os.sysconf("SC_CLK_TCK"))


class View:
    """What a scene wants of a 3D view."""

    def __init__(self) -> None:
        from pivy import coin

        self._graph = coin.SoSeparator()

    def getSceneGraph(self) -> Any:
        """Return the root of what is shown."""
        return self._graph


def measure(result: Any) -> str:
    """Return what jumps to any moment and drags by a five hundredth of the program take."""
    import numpy as np
    from PySide import QtCore

    from CNCStepper.workbench.simulation.player import Player
    from CNCStepper.workbench.simulation.scene import Scene
    from CNCStepper.workbench.simulation.stock_update import Material

    player, scene = Player(result.moves), Scene(View(), result.part, result.work_origin_mm)
    list(scene.load_part())
    list(scene.load_result(result))
    material = Material(player, scene, result)
    until(lambda: not material.waiting)
    player.seek(player.moves.duration_s / 2)
    until(lambda: not material.waiting)
    shown, texts = QtCore.QEventLoop(), []
    material.shown.connect(shown.quit)
    jumps = np.random.default_rng(5).uniform(0, 0.99, MOVES)
    for name, shares in (("jumps", jumps), ("drags", 0.3 + np.arange(MOVES) / 500)):
        times_ms, worked_ms = [], processor_ms(material)
        for share in shares:
            begun = time.perf_counter()
            player.seek(float(share) * player.moves.duration_s)
            shown.exec_()
            times_ms.append((time.perf_counter() - begun) * 1000)
        worked_ms = (processor_ms(material) - worked_ms) / MOVES
        times = f"median {statistics.median(times_ms):.1f}, worst {max(times_ms):.1f} ms"
        texts.append(f"{name} {times}, processor {worked_ms:.1f} ms")
    material.end()
    return "; ".join(texts)


def inside() -> None:
    """Measure, in FreeCAD."""
    import FreeCAD
    from PySide import QtCore

    application = QtCore.QCoreApplication.instance() or QtCore.QCoreApplication([])
    for make in (pocket, engraving):
        document = FreeCAD.newDocument()
        _, job = make(document)
        document.recompute()
        print(f"slider: the demo's {make.__name__}: {measure(proven(job))}", file=sys.stderr)
    application.processEvents()


if __name__ == "__main__" or is_measuring("slider"):
    run(__file__, "slider", inside)
