# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the preview of a program behaves: it belongs to its job, whose panel it opens."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.viewproviders.base import ViewProvider


class Preview(ViewProvider):
    """The view of a preview; FreeCAD's own Path view draws it."""

    def edit(self) -> None:
        """Open the panel of the job."""
        from CNCStepper.workbench.panels import edit

        if self.obj.Job is not None:
            edit(self.obj.Job)

    def canDelete(self, obj: Any) -> bool:
        """Let the job be deleted without a question: it takes the preview with it."""
        return True
