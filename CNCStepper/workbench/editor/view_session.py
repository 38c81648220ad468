# SPDX-License-Identifier: LGPL-2.1-or-later
"""The editor's part of the 3D view: made when there is something to show, and gone when the editor is."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.workbench.editor.path_scene import EditorScene
from CNCStepper.workbench.editor.view_picking import Clicks


class EditorStage:
    """Shows a program's way in a document's 3D view, or in the active one's for a file; `picked` gets each click."""

    def __init__(self, picked: Callable[[dict[str, Any]], None]):
        self._picked = picked
        self._scene: EditorScene | None = None
        self._clicks: Clicks | None = None
        self._view: Any = None

    @property
    def shown(self) -> bool:
        """Whether there is a view that shows it."""
        return self._scene is not None

    def show(self, source: Any, path: Path) -> None:
        """Show the lines of a file, in the view of a source's document."""
        from CNCStepper.job.editing.path_segments import read_lines

        view = _view_of(source)
        if view is not self._view or (self._scene and self._scene.origin_mm != source.origin_mm):
            self.clear()
        if view is None:
            return
        if self._scene is None:
            self._view = view
            self._scene = EditorScene(view, source.origin_mm)
            self._clicks = Clicks(view, source.origin_mm, self._picked)
        self._scene.show_path(*read_lines(path))

    def show_line(self, way: list[list[list[float]]]) -> None:
        """Show the way of one line."""
        if self._scene is not None:
            self._scene.show_line(way)

    def clear(self) -> None:
        """Take all out of the view."""
        if self._clicks is not None:
            self._clicks.end()
        if self._scene is not None:
            self._scene.remove()
        self._clicks = self._scene = self._view = None


def _view_of(source: Any) -> Any:
    import FreeCAD

    from CNCStepper.workbench.simulation.view_session import view_of

    document = source.document if source.alive else None
    document = document or FreeCAD.ActiveDocument
    return view_of(document) if document is not None else None
