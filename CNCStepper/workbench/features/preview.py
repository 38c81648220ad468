# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Preview: FreeCAD's own Path object, which shows a job's program text.

It is only looked at: nothing ever reads the program back from it.
"""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench import packages
from CNCStepper.workbench.calculation import result_cache
from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.features.base import LINK, Feature, Property
from CNCStepper.workbench.services.translation import later


class Preview(Feature):
    """The proxy of a preview; it depends on its job and is placed at the job's work zero."""

    Type = "CNCStepper_Preview"
    PROPERTIES = (
        Property("job", "Job", LINK, later("Preview"), later("Job"), later("The job whose program is shown")),
    )

    was_read: tuple[str, Any] | None = None  # a program's text and its path, until that is shown

    def read(self, obj: Any) -> bool:
        """Read the program's moves from the cut process for the next `make`; return whether it was unread."""
        text = program_file.load(obj.Job) if obj.Job is not None else ""
        moves = result_cache.path_of(text) if text else None
        if moves is None or (self.was_read is not None and self.was_read[0] == text):
            return False
        self.was_read = text, _path(moves)
        return True

    def make(self, obj: Any) -> None:
        """Read the program text and show it."""
        text = program_file.load(obj.Job) if obj.Job is not None else ""
        if not text:
            self.clear(obj)
            return
        packages.require()
        read, self.was_read = self.was_read, None
        if read is None or read[0] != text:
            read = text, _path(result_cache.path_of(text) or path_text(obj.Job, text))
        obj.Path = read[1]
        placement = obj.Placement
        placement.Base = obj.Job.Proxy.origin_mm(obj.Job)
        obj.Placement = placement

    def clear(self, obj: Any) -> None:
        """Show nothing."""
        import Path

        obj.Path = Path.Path()


def _path(moves: str) -> Any:
    import Path

    return Path.Path(moves)


def path_text(job: Any, text: str) -> str:
    """Return the moves of a job's program as FreeCAD's Path reads them."""
    from CNCStepper.job.path_commands import commands, gcode

    return gcode(commands(job.Proxy.read_back(job, text)))
