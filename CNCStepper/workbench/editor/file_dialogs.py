# SPDX-License-Identifier: LGPL-2.1-or-later
"""Dialogs for files: open, save, and the question about unsaved text."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from CNCStepper.workbench.document.preferred_values import program_folder
from CNCStepper.workbench.editor.program_source import FileSource
from CNCStepper.workbench.services.messages import choose
from CNCStepper.workbench.services.translation import tr

PATTERNS = "*.nc *.ngc *.gcode *.tap *.cnc *.txt"


def ask_which() -> Path | None:
    """Ask for a program to open; None when the user cancels."""
    from PySide import QtGui

    dialog = _dialog(tr("Open a G-code file"), program_folder(None))
    dialog.setFileMode(QtGui.QFileDialog.FileMode.ExistingFile)
    return _chosen(dialog)


def ask_where_to(source: Any) -> Path | None:
    """Ask where to save a text; None when the user cancels."""
    from PySide import QtGui

    proposed = _proposed(source)
    dialog = _dialog(tr("Save program as…"), proposed.parent)
    dialog.setAcceptMode(QtGui.QFileDialog.AcceptMode.AcceptSave)
    dialog.setFileMode(QtGui.QFileDialog.FileMode.AnyFile)
    dialog.setDefaultSuffix("nc")
    dialog.selectFile(proposed.name)
    return _chosen(dialog)


def in_file(source: Any, path: Path) -> FileSource:
    """Return the source of the same text in a file."""
    return source.at(path) if isinstance(source, FileSource) else FileSource(path)


def ask_to_save(name: str) -> str:
    """Ask what becomes of a text that is not saved: "save", "discard" or "cancel", which Esc means too."""
    answers = {
        "save": (tr("Save"), "Accept"),
        "discard": (tr("Discard"), "Destructive"),
        "cancel": (tr("Cancel"), "Reject"),
    }
    text = tr("{0} has changes that are not saved.").format(name)
    return choose("CNCStepper_Editor_closing", "Question", tr("Edit program"), text, answers, "save")


def ask_to_save_first(name: str) -> bool:
    """Ask whether a text is to be saved, so that what is checked or sent is what the editor shows."""
    answers = {"save": (tr("Save and go on"), "Accept"), "cancel": (tr("Cancel"), "Reject")}
    text = tr("{0} has changes that are not saved. They must be saved before it is checked or sent.").format(name)
    return choose("CNCStepper_Editor_save_first", "Question", name, text, answers, "save") == "save"


def _proposed(source: Any) -> Path:
    if isinstance(source, FileSource):
        return source.path or Path.home() / "program.nc"
    document = source.document if source.alive else None
    folder = program_folder(document)
    name = source.name if source.alive else "program"
    return folder / f"{name.replace('/', '-')}.nc"


def _dialog(title: str, folder: Path) -> Any:
    import FreeCADGui
    from PySide import QtGui

    dialog = QtGui.QFileDialog(FreeCADGui.getMainWindow(), title, str(folder))
    dialog.setObjectName("CNCStepper_Editor_file")
    dialog.setNameFilters([tr("Programs ({0})").format(PATTERNS), tr("All files ({0})").format("*")])
    return dialog


def _chosen(dialog: Any) -> Path | None:
    agreed = getattr(dialog, "exec", dialog.exec_)()
    chosen = dialog.selectedFiles()
    dialog.deleteLater()
    return Path(chosen[0]) if agreed and chosen else None
