# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Program: a program that a person has edited, or a G-code file's, kept in the document.

No recompute writes over it.
"""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Any

from CNCStepper.errors import JobError
from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.document.undo_observer import follow
from CNCStepper.workbench.features.base import LINK, TEXT, Feature, Property, edit, is_job, proxy_type
from CNCStepper.workbench.services.translation import later

PROGRAM = later("Program")
ARRANGEMENT = "CNCStepper_Arrangement"


class Program(Feature):
    """The proxy of an edited program; it is checked, simulated and sent with its job's machine and stock."""

    Type = "CNCStepper_Program"
    PROPERTIES = (
        Property("job", "Job", LINK, PROGRAM, later("Job"),
                 later("The job with the machine, stock, tools and clamps for the program")),
        Property("program", "Program", "App::PropertyFileIncluded", PROGRAM, later("Program"),
                 later("The program, kept in this document"), output=True),
        Property("made_from", "MadeFrom", TEXT, PROGRAM, later("Made from"),
                 later("The fingerprint of the job's program from which this one was edited"), "", output=True),
        Property("file", "File", TEXT, PROGRAM, later("File"),
                 later("The G-code file that it is, which has nothing to do with the operations of its job"), "",
                 output=True),
        Property("note", "Note", TEXT, PROGRAM, later("Note"),
                 later("Changes of the job's own program since then"), "", output=True),
    )  # fmt: skip

    def add_properties(self, obj: Any) -> None:
        """Add what `obj` lacks, and see that it follows every undo."""
        super().add_properties(obj)
        follow()

    def onChanged(self, obj: Any, name: str) -> None:
        """Let arrangements of this program say that it has changed; FreeCAD calls this at every change."""
        if name == "Program" and "Restore" not in obj.State:
            for each in obj.InList:
                if proxy_type(each) == ARRANGEMENT:
                    each.Proxy.execute(each)

    def make(self, obj: Any) -> None:
        """Say whether the job's own program is still the one that was edited; the text stays as it is."""
        if not is_job(obj.Job):
            raise JobError("job-missing", "the edited program has no job", advice="choose its job")
        changed = obj.MadeFrom and obj.MadeFrom != fingerprint(program_file.load(obj.Job))
        obj.Note = "the job's own program has changed since this one was edited" if changed else ""


def fingerprint(text: str) -> str:
    """Return what names a program's text."""
    return hashlib.sha256(text.encode("utf-8")).hexdigest()


def is_of_a_file(obj: Any) -> bool:
    """Return whether a program was read from a file, so that it is none of its job's operations."""
    return proxy_type(obj) == Program.Type and bool(obj.File)


def job_behind(obj: Any) -> Any:
    """Return the job whose machine, stock and tools a program is for: an edited program's, else the object itself."""
    return obj.Job if proxy_type(obj) == Program.Type else obj


def program_of_file(job: Any, path: Path) -> Any:
    """Return the program with the text of a G-code file, for the machine, stock, tools and clamps of a job.

    One that was read from the same file before takes its text. Raises JobError for a file that cannot be read.
    """
    return program_of_text(job, path.name, str(path), program_file.read(path)[0])


def program_of_text(job: Any, label: str, name: str, text: str) -> Any:
    """Return the program with a text that has nothing to do with the operations of its job, as a file's has.

    name: by which it is found again; the one of that name takes the text.
    """
    obj = next((obj for obj in job.InList if is_of_a_file(obj) and obj.File == name), None)
    if obj is None:
        obj = job.Document.addObject("App::FeaturePython", Program.Type)
        Program(obj)
        edit(obj, job=job)
    obj.Label, obj.File = label, name
    program_file.store(obj, text)
    job.Message = job.Message  # an output: nothing is out of date by that, but FreeCAD's tree looks at the job again
    return obj
