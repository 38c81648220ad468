# SPDX-License-Identifier: LGPL-2.1-or-later
"""A nest's sheets: a process searches, fills and writes beside the window, then each sheet's drawing is read.

The drawings of the sheets lie side by side in the document, in the order of the sheets.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.document.sheet_drawings import SheetWork, make_now
from CNCStepper.workbench.features.base import proxy_type
from CNCStepper.workbench.features.drawings.drawing import Drawing, path_of
from CNCStepper.workbench.features.drawings.nest import asked_of

SHEET = re.compile(r"sheet-(\d+)\.dxf")
BETWEEN_SHEETS_MM = 50.0


class Nesting(SheetWork):
    """One question about a nest; what writes files ends with their drawings. answer: of the process."""

    def __init__(
        self,
        obj: Any,
        verb: str,
        done: Callable[[], None],
        failed: Callable[[CNCStepperError], None],
        share: Callable[[float], None] = lambda share: None,
        **more: Any,
    ):
        """more: what else is asked, as the parts that are placed (`job/nesting/nest_question.py`)."""
        super().__init__(obj, done, failed, share)
        self.answer: dict[str, Any] = {}
        self._verb, self._more = verb, more

    def asked(self) -> dict[str, Any]:
        """Return what the process is asked; raises CNCStepperError for a part or a value that is no good."""
        return {"nest": asked_of(self.obj, self._verb, **self._more)}

    def stop(self) -> None:
        """Let the search end with the best so far."""
        from CNCStepper.workbench.calculation.drawing_process import process

        process().stop(self)

    def take(self, answer: dict[str, Any]) -> None:
        """Keep what was written, and read the sheets; all else is only told."""
        self.answer = answer
        if answer["written"]:
            super().take(answer)
        else:
            self.finish()

    def finish(self) -> None:
        """Lay the drawings side by side, and tell that all is there."""
        if self.answer["written"]:
            lay_out(self.obj, self.answer)
        super().finish()


def lay_out(obj: Any, answer: dict[str, Any]) -> None:
    """Lay the drawings of the sheets side by side."""
    import FreeCAD

    from CNCStepper.job.nesting.nest_data import unpacked_order
    from CNCStepper.nesting.manual_nesting import in_rows

    _, sheets, _ = unpacked_order(answer["order"])
    corners = in_rows(sheets, BETWEEN_SHEETS_MM)
    for drawing in obj.Group:
        found = SHEET.fullmatch(path_of(drawing).name) if proxy_type(drawing) == Drawing.Type else None
        if found:
            base = FreeCAD.Vector(*corners[int(found[1])], 0.0)
            for each in drawing.Group:
                if each.Placement.Base != base:
                    each.Placement = FreeCAD.Placement(base, FreeCAD.Rotation())


def nest_now(obj: Any, verb: str, **more: Any) -> None:
    """Search or write at once and read the drawings, for scripts; raises CNCStepperError, and then changes nothing."""
    from CNCStepper.job.nesting.nest_question import answer_of

    lay_out(obj, make_now(obj, lambda: answer_of(asked_of(obj, verb, **more))))
    obj.Proxy.execute(obj)
