# SPDX-License-Identifier: LGPL-2.1-or-later
"""An edited program in the tree: it is below its job, and a double click opens the editor."""

from __future__ import annotations

from functools import partial

from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.viewproviders.base import Entry, ViewProvider


class Program(ViewProvider):
    """The view of an edited program."""

    def edit(self) -> None:
        """Open the editor."""
        from CNCStepper.workbench.editor import open_program

        open_program(self.obj)

    def entries(self) -> list[Entry]:
        """Return what can be done with it."""
        from CNCStepper.workbench.commands.program import Send, Simulate
        from CNCStepper.workbench.proving import prove_program

        why_not = prove_program.why_not_of(self.obj)
        further = [
            Entry(each.text(), each.name, partial(each.take, self.obj), why_not) for each in (Simulate(), Send())
        ]
        return [Entry(tr("Edit program"), "CNCStepper_Program", self.edit), *further]
