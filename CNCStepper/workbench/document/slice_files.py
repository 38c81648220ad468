# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sheets of a stack: a process slices and nests beside the window, then each sheet's drawing is read."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.document.sheet_drawings import SheetWork, make_now
from CNCStepper.workbench.features.drawings.slices import asked_of

TEMPORARY = "cncstepper-slices-"  # how folders begin that hold the solid for the process


class Slicing(SheetWork):
    """One slicing of a solid beside the window."""

    def __init__(
        self,
        obj: Any,
        done: Callable[[], None],
        failed: Callable[[CNCStepperError], None],
        share: Callable[[float], None] = lambda share: None,
    ):
        super().__init__(obj, done, failed, share)
        self._temporary = tempfile.TemporaryDirectory(prefix=TEMPORARY)

    def asked(self) -> dict[str, Any]:
        """Return what the process is asked; raises JobError where there is no solid, no folder, or a bad value."""
        return {"slices": asked_of(self.obj, Path(self._temporary.name))}

    def close(self) -> None:
        """Take no answer any more, and take the solid away."""
        super().close()
        self._temporary.cleanup()


def slice_now(obj: Any) -> None:
    """Slice and nest at once and read the drawings, for scripts; raises CNCStepperError, and then changes nothing."""
    from CNCStepper.job.slicing.make_slices import answer_of

    with tempfile.TemporaryDirectory(prefix=TEMPORARY) as folder:
        make_now(obj, lambda: answer_of(asked_of(obj, Path(folder))))
    obj.Proxy.execute(obj)
