# SPDX-License-Identifier: LGPL-2.1-or-later
"""One proof at a time, for a caller that needs the newest result only: its begin and its end."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Protocol

from CNCStepper.workbench.services.messages import guarded

if TYPE_CHECKING:
    from CNCStepper.recovery.restart.restart_proof_folder import RestartPlace
    from CNCStepper.state import Start


class Sender(Protocol):
    """Begins to send a job object or an edited program, or its restart at a place, and returns at once."""

    def __call__(self, job: Any, place: RestartPlace | None = None) -> None: ...


def _unknown() -> Start | None:
    return None


start_here: Callable[[], Start | None] = _unknown
"""Returns the start state of the machine that this window is connected to; the dock fills this when it is loaded."""


class LatestProof:
    """The proof that runs, or none; the next that begins takes its place.

    proved: called with the ProofResult. failed: with the CNCStepperError. progress: with the sentence of each stage.
    """

    def __init__(self, proved: Callable[[Any], None], failed: Callable[[Any], None], progress: Callable[[str], None]):
        self._proved, self._failed, self._progress = proved, failed, progress
        self._run: Any = None

    @property
    def running(self) -> bool:
        """Whether an answer is still to come."""
        return self._run is not None

    def begin(self, program: Any, begins: Start | None, place: RestartPlace | None, parent: Any = None) -> None:
        """Prove a program from a start state, or its restart at a place; see `ProofRun`."""
        from CNCStepper.workbench.proving.proof_process import ProofRun

        self.give_up()
        self._run = ProofRun(program, parent, begins, place)
        self._run.finished.connect(guarded(lambda result: self._answer(self._proved, result)))
        self._run.failed.connect(guarded(lambda error: self._answer(self._failed, error)))
        self._run.progress.connect(guarded(self._progress))
        self._run.start()

    def give_up(self) -> None:
        """End the running proof; no further signals are sent."""
        if self._run is not None:
            self._run.cancel()
            self._let_go()

    def _answer(self, tell: Callable[[Any], None], answer: Any) -> None:
        self._let_go()
        tell(answer)

    def _let_go(self) -> None:
        self._run.deleteLater()
        self._run = None
