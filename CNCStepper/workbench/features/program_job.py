# SPDX-License-Identifier: LGPL-2.1-or-later
"""The base of all jobs: a machine, tools and operations in order, and the program that they make."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.errors import JobError
from CNCStepper.state import WORK_SYSTEMS
from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.document.operation_order import active_operations
from CNCStepper.workbench.document.undo_observer import follow
from CNCStepper.workbench.features.base import (
    ENUMERATION,
    HIDDEN,
    INTEGER,
    TEXT,
    Feature,
    Property,
    proxy_type,
    require_parts,
)
from CNCStepper.workbench.services.translation import later

MACHINE, STOCK, PROGRAM, JOB_GROUP = later("Machine"), later("Stock"), later("Program"), later("Job")
LINKS = "App::PropertyLinkList"
PROFILE_TEXT = later("A shipped profile's name, or a profile's file")
PROGRAM_FORM = (
    Property("dialect", "Dialect", TEXT, PROGRAM, later("Dialect"),
             later("The program's dialect; empty: the machine's own"), ""),
    Property("units", "Units", ENUMERATION, PROGRAM, later("Units"), later("Of the written program"),
             "mm", choices=("mm", "inch")),
    Property("work_offset", "WorkOffset", ENUMERATION, PROGRAM, later("Work offset"),
             later("The work coordinate system"), "G54", choices=WORK_SYSTEMS),
    Property("coolant", "Coolant", ENUMERATION, PROGRAM, later("Coolant"),
             later("Outputs that are on while cutting"), "none", choices=("none", "mist", "flood")),
)  # fmt: skip
PROGRAM_PARTS = (
    Property("part", "ProgramPart", INTEGER, PROGRAM, later("Program number"),
             later("The program that is shown, checked and sent, if the machine needs one for each tool"), 1),
    Property("parts", "ProgramParts", INTEGER, PROGRAM, later("Programs"),
             later("How many there are: one, or one a tool in turn"), 0, output=True),
)  # fmt: skip
CONTENTS = (
    Property("operations", "Operations", LINKS, JOB_GROUP, later("Operations"),
             later("The operations, in their order"), ()),
    Property("tools", "Tools", LINKS, JOB_GROUP, later("Tools"),
             later("The tools that operations may choose from"), ()),
)  # fmt: skip
MADE = (
    Property("program", "Program", "App::PropertyFileIncluded", JOB_GROUP, later("Program"),
             later("The program, kept in this document"), output=True),
    Property("message", "Message", TEXT, JOB_GROUP, later("Message"), later("Why there is no program"), "",
             output=True),
)  # fmt: skip


def machine_property(default: str) -> Property:
    """Return the property that names a job's machine; default: that of a new job."""
    return Property("machine", "Machine", TEXT, MACHINE, later("Profile"), PROFILE_TEXT, default)


class ProgramJob(Feature):
    """The proxy of a job; `Operations` are cut in their order. TOOL: the type of its tools."""

    TOOL = ""
    around: Any = None  # of a new job until its panel opens: its `workbench/templates/around.py`

    def add_properties(self, obj: Any) -> None:
        """Add what `obj` lacks, and see that its program follows every undo."""
        super().add_properties(obj)
        follow()

    def take_around(self) -> Any:
        """Return what a new job's stock is made round, once; None for a job that is not new."""
        around, self.around = self.around, None
        return around

    def question(self, obj: Any) -> dict[str, Any] | None:
        """Return what the cut process is asked for the programs; None while there are no operations."""
        self.check(obj)
        return self.program_question(obj) if active_operations(obj) else None

    def make(self, obj: Any) -> None:
        """Make the program from all active operations."""
        self.check(obj)
        self.make_surroundings(obj)
        require_parts(active_operations(obj))
        if not active_operations(obj):
            self.invalidate(obj, "the job has no operations")
            return
        texts = [text for _, text in self.programs(obj)]
        obj.ProgramParts = len(texts)
        obj.setEditorMode("ProgramPart", 0 if len(texts) > 1 else HIDDEN)
        program_file.store(obj, texts[part_of(obj, len(texts)) - 1])
        obj.Message = ""

    def make_surroundings(self, obj: Any) -> None:
        """Make what stands beside the stock, before the program; raises JobError."""

    def invalidate(self, obj: Any, why: str) -> None:
        """Remove the program and its picture, so that an outdated one is never cut."""
        program_file.store(obj, "")
        obj.Message = why
        for preview in obj.InList:
            if proxy_type(preview) == "CNCStepper_Preview":
                preview.Proxy.clear(preview)

    def origin_mm(self, obj: Any) -> tuple[float, float, float]:
        """Return where the zero of its table of moves lies in the document."""
        return tuple(obj.WorkOrigin)  # type: ignore[return-value]

    def program_question(self, obj: Any) -> dict[str, Any]:
        """Return what the cut process is asked for the programs; raises what the core raises."""
        raise NotImplementedError

    def programs(self, obj: Any) -> list[tuple[str, str]]:
        """Return the names and texts of the programs: one without a name, or several; raises what the core raises."""
        raise NotImplementedError

    def proof_question(self, obj: Any, program: Any) -> Callable[[Path, str], None]:
        """Return what writes the request for a proof into a folder, with the program's text; the document is read now.

        program: the job itself, an edited program or a G-code file's. Raises what the core raises.
        """
        raise NotImplementedError

    def read_back(self, obj: Any, text: str) -> Any:
        """Return the table of moves of a program's text, as it lies in the document; raises ProgramError."""
        raise NotImplementedError


def part_of(obj: Any, parts: int) -> int:
    """Return which of its programs a job object holds, from 1; raises JobError for one that there is not."""
    if parts == 1:
        return 1
    if not 1 <= obj.ProgramPart <= parts:
        raise JobError(
            "part-missing",
            "there is no such part of the program",
            value=f"{obj.ProgramPart}",
            limit=f"1 to {parts}",
            advice="choose one of them",
        )
    return int(obj.ProgramPart)
