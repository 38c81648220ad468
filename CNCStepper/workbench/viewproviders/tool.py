# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a tool looks in the tree: its icon, and a name that says what it is until a person gives one."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.features.base import PROBLEM, proxy_type
from CNCStepper.workbench.services.messages import polled
from CNCStepper.workbench.viewproviders.base import ViewProvider


class NamedTool(ViewProvider):
    """The view of a tool. NAMED_BY: the properties of which its name is made."""

    NAMED_BY: tuple[str, ...] = ()

    @polled
    def updateData(self, obj: Any, name: str) -> None:
        """Draw icon and name anew when what they say has changed; FreeCAD calls this at every change of a property."""
        super().updateData(obj, name)
        if name in self.NAMED_BY and PROBLEM.name in obj.PropertiesList and "Restore" not in obj.State:
            self.name()

    def name(self) -> None:
        """Name the tool by what it is, unless a person has named it."""
        from CNCStepper.workbench.panels.tools.tool_words import has_own_name, tree_words

        words = tree_words(self.obj)
        is_so = self.obj.Label.removeprefix(words).isdigit() or self.obj.Label == words  # digits: the name was taken
        if not is_so and not has_own_name(self.obj):
            self.obj.Label = words


class Tool(NamedTool):
    """The view of a cutter, with the icon of its shape."""

    BADGED_BY = ("Problem", "ToolShape")
    NAMED_BY = ("Number", "ToolShape", "Diameter", "TipAngle", "Label")

    def icon_name(self) -> str:
        """Return the name of its shape's icon."""
        return f"{proxy_type(self.obj)}_{self.obj.ToolShape}"


class TurningTool(NamedTool):
    """The view of a lathe's tool."""

    NAMED_BY = ("Number", "Kind", "Insert", "Width", "Diameter", "TipAngle", "NoseRadius", "Label")
