# SPDX-License-Identifier: LGPL-2.1-or-later
"""The planned times of operations for panels: asked of the cut process when nobody types, kept with its answers."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from contextlib import suppress
from typing import Any

from PySide import QtCore

from CNCStepper.errors import CNCStepperError
from CNCStepper.job import request_digest
from CNCStepper.job.deferred_fitting import Unfitted, only_looking
from CNCStepper.workbench.calculation import result_cache
from CNCStepper.workbench.calculation.cut_process import CutRequest, process
from CNCStepper.workbench.services import jit_guard
from CNCStepper.workbench.services.messages import guarded

PAUSE_MS = 300  # without a change, before the process is asked


class PlannedTimes(QtCore.QObject):
    """The times of the operations that `operations` returns; `changed` is sent when one is known or known no more.

    While the kernels are being compiled nothing is known.
    """

    changed = QtCore.Signal()

    def __init__(self, operations: Callable[[], Iterable[Any]], parent: Any):
        super().__init__(parent)
        self._operations, self._times_s = operations, dict[str, float]()
        self._gone = gone = [False]
        self._timer = QtCore.QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(PAUSE_MS)
        self._timer.timeout.connect(guarded(self._ask))
        self.destroyed.connect(lambda: gone.__setitem__(0, True))

    def time_s(self, operation: Any) -> float:
        """Return the planned time of an operation's own moves, 0 where it is not known."""
        return self._times_s.get(operation.Name, 0.0)

    def look(self) -> None:
        """Show the times that are known now, and ask for the others when there is a pause."""
        self._timer.start()

    def stop(self) -> None:
        """Ask nothing any more: the objects may be gone before the panel is."""
        self._gone[0] = True
        self._timer.stop()
        process().forget(self)

    def _ask(self) -> None:
        """Take what is known, and ask for the rest."""
        if self._gone[0] or jit_guard.compiling_elsewhere:
            return
        found, unknown = {}, {}
        for name, question in self._questions():
            key = request_digest.key_of(question)
            answer = result_cache.known(key)
            if isinstance(answer, result_cache.Planned):
                found[name] = answer.time_s
            elif result_cache.may_ask(key) and not process().unavailable:
                unknown[key] = question
        if found != self._times_s:
            self._times_s = found
            self.changed.emit()
        if unknown:
            process().ask(self, CutRequest(unknown, lambda words: None, guarded(self._ask), can_wait=True))

    def _questions(self) -> Iterable[tuple[str, dict[str, Any]]]:
        """Yield the name of each operation that can be cut, and what the process is asked for its time."""
        with only_looking():
            for operation in self._operations():
                with suppress(CNCStepperError, Unfitted):  # what cannot be cut has no time; its panel says why
                    if (question := operation.Proxy.question(operation)) is not None:
                        yield operation.Name, {"time_of": question}
