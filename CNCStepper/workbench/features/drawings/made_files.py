# SPDX-License-Identifier: LGPL-2.1-or-later
"""The base of objects whose files a process makes on demand, and which tell when something has changed since.

sources, values ──► key_of ──► compared with MadeOf ──► is_stale: Problem says what to do; the files stay
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from CNCStepper.errors import JobError
from CNCStepper.workbench.features.base import HIDDEN, STALE, Feature

NAME_ONE = "give a whole path, or save the document"


class MadeFiles(Feature):
    """The proxy of an object that has a property MadeOf: the key of its sources and values when its files were made."""

    HIDDEN_NAMES: tuple[str, ...] = ("MadeOf", "Report")  # what only the object itself reads
    CHANGED: tuple[str, str] = ("", "")  # what is said of a change since, and the advice

    def add_properties(self, obj: Any) -> None:
        """Add what `obj` lacks; what only the object itself reads is not shown."""
        super().add_properties(obj)
        for name in self.HIDDEN_NAMES:
            obj.setEditorMode(name, HIDDEN)

    def key_of(self, obj: Any) -> str:
        """Return a text that is the same for the same sources and values."""
        raise NotImplementedError

    def make(self, obj: Any) -> None:
        """Say what has changed since the files were made; they stay as they are."""
        if obj.MadeOf and is_stale(obj):
            what, advice = self.CHANGED
            raise JobError(STALE, what, advice=advice)


class SheetGroup(MadeFiles):
    """The proxy of a group of the drawings of sheets."""

    OF_WINDOW: tuple[str, ...] = ()  # keys of which the core is not asked, or apart

    def given(self, found: dict[str, Any]) -> dict[str, Any]:
        """Return the figures among an object's values, of which the core is asked."""
        return {key: value for key, value in found.items() if key not in self.OF_WINDOW}

    def keep(self, obj: Any, answer: dict[str, Any], made_of: str) -> None:
        """Keep the process's answer, made of the sources and values that `made_of` holds."""
        raise NotImplementedError


def is_stale(obj: Any) -> bool:
    """Return whether the files are not those of the sources and values, as they never are before the first time."""
    return bool(obj.MadeOf != obj.Proxy.key_of(obj))


def folder_of(obj: Any) -> Path:
    """Return the folder of the files; raises JobError where neither the object nor the document names one."""
    folder = written_to(obj, obj.Folder, obj.Name)
    if folder is None:
        raise JobError("sheets-folder", "there is no folder for the drawings", value=obj.Folder, advice=NAME_ONE)
    return folder


def written_to(obj: Any, named: str, own: str) -> Path | None:
    """Return the path that is named, for "" `own` in a folder beside the document, None where neither is known.

    A relative path begins where the document lies: nobody sees where FreeCAD was started.
    """
    path = Path(os.path.expanduser(named))
    if named and path.is_absolute():
        return path
    if not obj.Document.FileName:
        return None
    document = Path(obj.Document.FileName)
    return document.parent / path if named else document.with_suffix("") / own
