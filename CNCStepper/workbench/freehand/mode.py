# SPDX-License-Identifier: LGPL-2.1-or-later
"""The base of drawing and editing: both begin, show their state, and restore the view."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from CNCStepper.workbench.freehand.stroke import Point


class Mode:
    """A mouse mode in `view` until it is left; it observes its document."""

    def __init__(self, view: Any, document: Any):
        from CNCStepper.workbench.freehand.mouse_events import Pointer
        from CNCStepper.workbench.freehand.preview_wire import Wire

        self.view = view
        self.document = document
        self._document_name = document.Name
        self.pointer = Pointer(view, self)
        self.wire = Wire(view)
        self.on_left: Callable[[], None] = lambda: None
        self._begun = False

    def begin(self) -> None:
        """Take the pointer and show the wire."""
        import FreeCAD

        self._begun = True
        self.pointer.take()
        self.wire.show()
        FreeCAD.addDocumentObserver(self)
        self.hint()

    def leave(self) -> None:
        """End it, once; the document is not touched."""
        import FreeCAD

        if not self._begun:
            return
        self._begun = False
        FreeCAD.removeDocumentObserver(self)
        self.pointer.give_back()
        self.wire.hide()
        say("")
        self.on_left()

    def hint(self) -> None:
        """Say in the status bar what the user may do now."""

    def pressed(self, pixel: Point, shift: bool) -> bool:
        """The left button went down at a pixel; return whether that was meant for this mode. So do the next two."""
        raise NotImplementedError

    def moved(self, pixel: Point, shift: bool) -> bool:
        """The pointer moved, with the button that `pressed` took, or with none."""
        raise NotImplementedError

    def released(self, pixel: Point) -> bool:
        """The button that `pressed` took went up."""
        raise NotImplementedError

    def wants(self, key: str) -> bool:
        """Return whether "escape", "enter" or "delete" would do something now."""
        raise NotImplementedError

    def key(self, key: str) -> None:
        """Do what a wanted key means."""
        raise NotImplementedError

    def slotDeletedDocument(self, document: Any) -> None:
        """Leave with the document; FreeCAD calls this."""
        if document.Name == self._document_name:
            self.leave()


def say(text: str) -> None:
    """Show a sentence in the status bar until the next one."""
    import FreeCADGui

    FreeCADGui.getMainWindow().statusBar().showMessage(text)
