# SPDX-License-Identifier: LGPL-2.1-or-later
"""A question to the process that reads drawings, for an object of the document, which may be gone when it answers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from CNCStepper.errors import CNCStepperError


class DrawingWork:
    """One work beside the window; the transaction is the caller's.

    done: called when the object has what was made. failed: with the error. share: with what is done, 0 to 1.
    """

    def __init__(
        self,
        obj: Any,
        done: Callable[[], None],
        failed: Callable[[CNCStepperError], None],
        share: Callable[[float], None] = lambda share: None,
    ):
        self.obj = obj
        self._done, self._failed, self._share = done, failed, share
        self._place = obj.Document.Name, obj.Name
        self._ended = False

    def question(self) -> dict[str, Any]:
        """Return what the process is asked; raises CNCStepperError for a bad value."""
        raise NotImplementedError

    def take(self, answer: dict[str, Any]) -> None:
        """Give the object what the process has made."""
        raise NotImplementedError

    def begin(self) -> None:
        """Ask the process; raises CNCStepperError for a bad value."""
        from CNCStepper.workbench.calculation.drawing_process import DrawingRequest, process

        process().ask(self, DrawingRequest(self.question(), self._take, self.refuse, self._share))

    def end(self) -> None:
        """Make nothing any more."""
        from CNCStepper.workbench.calculation.drawing_process import process

        process().forget(self)
        self.close()

    @property
    def goes_on(self) -> bool:
        """Whether the work is not ended, and its object still in its document."""
        import FreeCAD

        document, name = self._place
        documents = FreeCAD.listDocuments()
        return not self._ended and document in documents and documents[document].getObject(name) is not None

    def finish(self) -> None:
        """Tell that the object has what was made."""
        self.close()
        self._done()

    def refuse(self, error: CNCStepperError) -> None:
        """Tell why it could not be made."""
        if self.goes_on:
            self.close()
            self._failed(error)

    def close(self) -> None:
        """Take no answer any more."""
        self._ended = True

    def _take(self, answer: dict[str, Any]) -> None:
        if self.goes_on:
            self.take(answer)
