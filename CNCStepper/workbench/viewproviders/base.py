# SPDX-License-Identifier: LGPL-2.1-or-later
"""The base of our objects in the tree: icon, badge, double click, context menu."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from CNCStepper.workbench.features.base import problem_of, proxy_type
from CNCStepper.workbench.services.messages import guarded, polled
from CNCStepper.workbench.services.translation import tr


@dataclass(frozen=True)
class Entry:
    """An entry of the context menu; `icon` names a file of ours, `why_not` is "" where it can be chosen."""

    text: str
    icon: str
    act: Callable[[], None]
    why_not: str = ""


class ViewProvider:
    """The proxy of a view object; it keeps nothing, all that is saved is which class it is."""

    BADGED_BY: tuple[str, ...] = ("Problem",)  # the properties whose change may change the icon

    def __init__(self, view: Any):
        self.obj = view.Object
        view.Proxy = self

    def attach(self, view: Any) -> None:
        """Remember whose proxy this is; FreeCAD calls this when an object is opened again."""
        self.obj = view.Object

    @polled
    def getIcon(self) -> Any:
        """Return the icon of the tree."""
        from CNCStepper.workbench.services.icons import icon

        return icon(self.icon_name(), self.badge())

    def icon_name(self) -> str:
        """Return the name of the icon's file."""
        return proxy_type(self.obj)

    def badge(self) -> str:
        """Return what the icon says of the object's state: "Problem", "Inactive" or nothing."""
        return "Problem" if problem_of(self.obj) else ""

    @guarded
    def onDelete(self, view: Any, parts: Any) -> bool:
        """Return whether FreeCAD may delete the object, which it is about to; in a macro that is one step."""
        from CNCStepper.workbench.document import macro_recorder

        macro_recorder.follow_deletion(self.obj.Document)
        return True

    @polled
    def isShow(self) -> bool:
        """Return whether the tree shows it as visible; FreeCAD asks, as most of our objects draw nothing."""
        return bool(self.obj.ViewObject.Visibility)

    @polled
    def updateData(self, obj: Any, name: str) -> None:
        """Draw the icon anew when what it says has changed; FreeCAD calls this at every change of a property."""
        if name in self.BADGED_BY:
            obj.ViewObject.signalChangeIcon()

    @guarded
    def doubleClicked(self, view: Any) -> bool:
        """Open the object's panel."""
        self.edit()
        return True

    def edit(self) -> None:
        """Open the object's panel; its changes are one undo step."""
        from CNCStepper.workbench.panels import edit

        edit(self.obj)

    def entries(self) -> list[Entry]:
        """Return the entries of the context menu, from top to bottom."""
        return [Entry(tr("Edit"), proxy_type(self.obj), self.edit)]

    @guarded
    def setupContextMenu(self, view: Any, menu: Any) -> bool:
        """Put our entries at the top of the context menu of the tree; FreeCAD's own stay."""
        before = menu.actions()[0] if menu.actions() else None
        menu.setToolTipsVisible(True)
        for entry in self.entries():
            menu.insertAction(before, _action(entry, menu))
        return False

    def dumps(self) -> None:
        """Keep nothing (FreeCAD from 0.21 on)."""

    def loads(self, state: Any) -> None:
        """Restore nothing (FreeCAD from 0.21 on)."""

    def __getstate__(self) -> None:
        """Keep nothing (FreeCAD before 0.21)."""

    def __setstate__(self, state: Any) -> None:
        """Restore nothing (FreeCAD before 0.21)."""


def _action(entry: Entry, menu: Any) -> Any:
    from PySide import QtGui

    from CNCStepper.workbench.services.icons import icon

    action = QtGui.QAction(icon(entry.icon), entry.text, menu)
    action.setEnabled(not entry.why_not)
    action.setToolTip(entry.why_not or entry.text)
    action.triggered.connect(guarded(entry.act))
    return action
