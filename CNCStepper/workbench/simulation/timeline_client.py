# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asks a process of its own (`workers/simulation_timeline.py`) for the proven part at any moment, without waiting.

player ──► want(time) ──► one question at a time, the newest ──► tiles: faces that changed ──► scene
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from PySide import QtCore

from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.request_queue import RequestQueue

if TYPE_CHECKING:
    import numpy as np

    from CNCStepper.workbench.proving.proof_process import ProofResult

WORKER = "CNCStepper.workers.simulation_timeline"

Tiles = dict[int, tuple["np.ndarray", "np.ndarray"]]  # corners and colours of the faces of tiles, by number


class TimelineClient(QtCore.QObject):
    """The part of a proven program by time. An answer is taken back with `go_on`, and only then the next one is asked.

    tiles: sent with the Tiles that changed since they were sent last, the first time all. pulse: with the time and
    the motors' steps, both None where none follows. mesh: with the time and the path of an STL file. failed: with an
    error; the next question starts the process again, unless it has not answered a single one.
    """

    tiles = QtCore.Signal(object)
    pulse = QtCore.Signal(object, object)
    mesh = QtCore.Signal(float, str)
    failed = QtCore.Signal(object)

    def __init__(self, result: ProofResult, parent: Any = None):
        super().__init__(parent)
        self._result = result  # keeps its folder
        self._wanted: list[dict[str, Any]] = []
        self._asked = self._answered = self._given_up = False
        what, advice = "the simulation's process has ended", "move the slider to start it again"
        lost = CNCStepperError("timeline-lost", what, advice=advice)
        self._questions = RequestQueue(WORKER, lost, result.folder.name, parent=self)
        self._questions.answered.connect(guarded(self._on_message))
        self._questions.failed.connect(guarded(self._fail))

    @property
    def waiting(self) -> bool:
        """Whether an answer is still to come."""
        return self._asked or bool(self._wanted)

    def want(self, time_s: float) -> None:
        """Ask for the part at a moment; a moment that waits to be asked for is forgotten."""
        self._wanted = [question for question in self._wanted if "at" not in question]
        self._want({"at": time_s})

    def want_pulse(self, time_s: float, sense: int) -> None:
        """Ask for the first pulse after a moment (1) or the last before it (-1)."""
        self._want({"pulse": time_s, "sense": sense})

    def want_mesh(self, time_s: float) -> None:
        """Ask for the part at a moment as a mesh."""
        self._want({"mesh": time_s})

    def go_on(self) -> None:
        """Ask the next question: what was told has been used."""
        self._asked = False
        self._ask()

    def end(self) -> None:
        """End the process; nothing is told any more."""
        self._questions.end()
        self._wanted.clear()
        self._asked = self._answered = False

    def _want(self, question: dict[str, Any]) -> None:
        if self._given_up:
            return
        self._wanted.append(question)
        self._ask()

    def _ask(self) -> None:
        if self._wanted and not self._asked:
            self._asked = True
            self._questions.ask(self._wanted.pop(0))

    def _on_message(self, answer: dict[str, Any]) -> None:
        self._answered = True
        if "tiles" in answer:
            self.tiles.emit(dict(self._read(answer["tiles"])))
        elif "mesh" in answer:
            self.mesh.emit(answer["at"], str(self._result.send_file.with_name(answer["mesh"])))
        else:
            self.pulse.emit(answer["pulse"], answer["steps"])

    def _read(self, counts: list[list[int]]) -> Iterator[tuple[int, tuple[np.ndarray, np.ndarray]]]:
        """Yield the faces of tiles, so many each; nothing is computed."""
        import numpy as np

        from CNCStepper.job.proof_folder import TILES

        data = self._result.send_file.with_name(TILES).read_bytes()
        total = sum(count for _, count in counts)
        corners = np.frombuffer(data, np.float32, 12 * total).reshape(total, 4, 3)
        rgba = np.frombuffer(data, np.uint32, 4 * total, corners.nbytes).reshape(total, 4)
        first = 0
        for number, count in counts:
            yield number, (corners[first : first + count], rgba[first : first + count])
            first += count

    def _fail(self, error: CNCStepperError) -> None:
        self._given_up = not self._answered
        self.end()
        self.failed.emit(error)
