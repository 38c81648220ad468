# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where an edited text comes from, and where it goes when it is saved: a file, a job, or an edited program.

A job makes its program anew whenever something changes, so that an edit of it is kept beside it, as an object of its
own in the same document.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import JobError, Place, Text
from CNCStepper.gcode.syntax.text_format import FileForm
from CNCStepper.workbench.document import program_file, targets, undo_steps
from CNCStepper.workbench.editor.reader_client import Language
from CNCStepper.workbench.features.base import is_job
from CNCStepper.workbench.features.program import job_behind
from CNCStepper.workbench.services.translation import tr


class FileSource:
    """A G-code file; `path` is None for a text that was never saved. It belongs to no document and no object."""

    obj = document = None
    document_name = ""
    alive = True

    def __init__(self, path: Path | None):
        self.path = path
        self._form = FileForm()

    @property
    def key(self) -> str:
        """What two windows of the same text have in common."""
        return str(self.path or id(self))

    @property
    def name(self) -> str:
        """What the text is called."""
        return self.path.name if self.path else tr("New program")

    @property
    def origin_mm(self) -> tuple[float, float, float]:
        """Where its work zero lies in a document."""
        return (0.0, 0.0, 0.0)

    def text(self) -> str:
        """Return the text, each line with its end; raises JobError for a file that cannot be read."""
        if self.path is None:
            return ""
        text, self._form = program_file.read(self.path)
        return text

    def language(self, machine: Any) -> Language:
        """Return the dialect and settings of its job."""
        return Language(machine.language(), str(self.path or ""), machine)

    def save(self, text: str) -> FileSource:
        """Write the text into the file, whole or not at all; returns the source of what is saved now."""
        assert self.path is not None
        try:
            write_whole(self.path, self._form.bytes_of(text))
        except OSError as error:
            what = Text("the program cannot be written: {error}", error=error.strerror or error)
            advice = "choose a folder that exists and that you may write to"
            raise JobError("program-unwritable", what, advice=advice, place=Place(str(self.path))) from error
        return self

    def at(self, path: Path) -> FileSource:
        """Return the same text in another file."""
        other = FileSource(path)
        other._form = self._form
        return other


class ObjectSource:
    """The program of a job or an edited program in a document."""

    def __init__(self, obj: Any):
        self.obj = obj
        self.document = obj.Document
        self.document_name, self._name = obj.Document.Name, obj.Name
        self._label, self._origin_mm = obj.Label, (0.0, 0.0, 0.0)

    @property
    def key(self) -> str:
        """What two windows of the same text have in common."""
        return f"{self.document_name}#{self._name}"

    @property
    def name(self) -> str:
        """What the text is called, also when the object is gone."""
        if self.alive:
            self._label = self.obj.Label
        return str(self._label)

    @property
    def path(self) -> Path | None:
        """The file that is proposed."""
        return None

    @property
    def alive(self) -> bool:
        """Whether the object is still in its document, and that open: another one may have its name meanwhile."""
        import FreeCAD

        document = FreeCAD.listDocuments().get(self.document_name)
        return document is not None and document is self.document and document.getObject(self._name) is not None

    @property
    def origin_mm(self) -> tuple[float, float, float]:
        """Where its work zero lies in the document; where it lay, when the object or its job is gone."""
        job = job_behind(self.obj) if self.alive else None
        if job is not None:
            self._origin_mm = job.Proxy.origin_mm(job)
        return self._origin_mm

    def text(self) -> str:
        """Return the text, each line with its end."""
        return program_file.ended(program_file.load(self.obj))

    def language(self, machine: Any) -> Language:
        """Return how it is read: as its job says."""
        from CNCStepper.workbench.document.core_job import language_of, machine_of, proven_with

        own = machine_of(job_behind(self.obj))
        start = proven_with(self.obj).started(None, own) if own.tool_length == "table" else None
        return Language(language_of(self.obj), "", own, start)

    def save(self, text: str) -> ObjectSource:
        """Keep the text in the document, in one undo step; returns the source of what is kept.

        The first time that is a new object. Raises JobError where the object or its document is gone, or a task panel
        is open: that is an undo step of its own, and its Cancel gives the document back.
        """
        if not self.alive:
            what = "the object of this program is no longer there"
            raise JobError("object-gone", what, advice="save it as a file")
        if targets.why_no_panel():
            raise JobError("panel-open", "a task panel is open", advice="close it with OK or Cancel, and save again")
        undo_steps.begin(self.document, tr("Edit {0}").format(self.obj.Label))
        try:
            kept = self._kept(text)
        except Exception:
            self.document.abortTransaction()
            raise
        self.document.commitTransaction()
        return kept

    def _kept(self, text: str) -> ObjectSource:
        from CNCStepper.workbench import api

        if is_job(self.obj):
            made = api.edit_program(self.obj, text)
            made.Label = tr("{0} (edited)").format(self.obj.Label)
            made.recompute()
            return ObjectSource(made)
        program_file.store(self.obj, text)
        self.obj.recompute()
        self.obj.purgeTouched()
        return self
