# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Arrangement: programs of jobs and files, placed on the work surface, as one checked program.

programs, counts, places ──► process ──► file ──► a CNCStepper_Program with the machine of the job
  └── looked at when the object is made: Problem says when the program is not that of the others and the places
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from CNCStepper.errors import JobError
from CNCStepper.workbench import packages
from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.document.machine_of_job import file_stamp, machine_of
from CNCStepper.workbench.features.base import (
    BOOL,
    CONTAINERS,
    DISTANCE,
    INTEGER,
    JOB,
    LINK,
    TEXT,
    Property,
    proxy_type,
    values,
)
from CNCStepper.workbench.features.drawings.made_files import NAME_ONE, MadeFiles, written_to
from CNCStepper.workbench.features.program import Program, fingerprint, program_of_file
from CNCStepper.workbench.services.translation import later

PROGRAMS, SURFACE, MADE = later("Programs"), later("Work surface"), later("What was made")
FIGURES = ("sheet_x_mm", "sheet_y_mm", "gap_mm", "tool_mm", "turn")


class Arrangement(MadeFiles):
    """The proxy of an arrangement."""

    Type = "CNCStepper_Arrangement"
    PROPERTIES = (
        Property("programs", "Programs", CONTAINERS, PROGRAMS, later("Programs"),
                 later("Jobs and programs of the document"), ()),
        Property("files", "Files", TEXT, PROGRAMS, later("Files"), later("G-code files"), "[]"),
        Property("counts", "Counts", TEXT, PROGRAMS, later("Counts"), later("How many of each are wanted"), "[]"),
        Property("job", "Job", LINK, PROGRAMS, later("Job"), later("Its machine runs and checks the whole program")),
        Property("sheet_x_mm", "SizeX", DISTANCE, SURFACE, later("Length X"), later("Of the work surface"), 600.0),
        Property("sheet_y_mm", "SizeY", DISTANCE, SURFACE, later("Width Y"), later("Of the work surface"), 400.0),
        Property("gap_mm", "Gap", DISTANCE, SURFACE, later("Gap"), later("Between the cuts of two copies"), 5.0),
        Property("tool_mm", "Diameter", DISTANCE, SURFACE, later("Tool diameter"),
                 later("By half of it all cuts are wider than their paths"), 0.0),
        Property("turn", "Turn", BOOL, SURFACE, later("Quarter turns"),
                 later("Copies that are placed by the search may be turned"), False),
        Property("file", "File", TEXT, SURFACE, later("File"),
                 later("Where the program is written; empty: beside the document"), ""),
        Property("placed", "Placed", INTEGER, MADE, later("Placed"), later("Copies on the work surface"), 0,
                 output=True),
        Property("placements", "Placements", TEXT, MADE, later("Placements"), later("Where the copies lie"), "[]",
                 output=True),
        Property("made_of", "MadeOf", TEXT, MADE, later("Made of"), later("The programs and their places"), "",
                 output=True),
    )  # fmt: skip

    HIDDEN_NAMES = ("Files", "Counts", "Placements", "MadeOf")
    CHANGED = ("a program or a value has changed since they were arranged", "arrange them again")

    def key_of(self, obj: Any) -> str:
        """Return a text that is the same for the same programs, places and values."""
        told = [
            list(file_stamp(str(each))) if isinstance(each, Path) else fingerprint(program_file.load(each))
            for each in sources(obj)
        ]
        found = values(obj)
        machine = getattr(obj.Job, "Machine", "")
        places = json.loads(obj.Placements)
        return json.dumps([told, counts_of(obj), [found[key] for key in FIGURES], machine, places], sort_keys=True)


def sources(obj: Any) -> list[Any]:
    """Return what is arranged: objects of the document, then paths of files."""
    return [*obj.Programs, *(Path(name) for name in json.loads(obj.Files))]


def set_sources(obj: Any, found: Sequence[Any], counts: Sequence[int]) -> None:
    """Let these be arranged, each so often; objects come before files."""
    pairs = sorted(zip(found, counts, strict=True), key=lambda pair: isinstance(pair[0], Path))
    objects = [each for each, _ in pairs if not isinstance(each, Path)]
    if list(obj.Programs) != objects:
        obj.Programs = objects
    obj.Files = json.dumps([str(each) for each, _ in pairs if isinstance(each, Path)])
    obj.Counts = json.dumps([count for _, count in pairs])


def counts_of(obj: Any) -> list[int]:
    """Return how many of each are wanted."""
    found = sources(obj)
    return ([int(count) for count in json.loads(obj.Counts)] + [1] * len(found))[: len(found)]


def name_of(source: Any) -> str:
    """Return how a program is called."""
    return source.name if isinstance(source, Path) else str(source.Label)


def is_source(obj: Any) -> bool:
    """Return whether an object has a program of its own."""
    return proxy_type(obj) in (JOB, Program.Type) and bool(obj.Program)


def file_of(obj: Any) -> Path:
    """Return where the program is written; raises JobError where neither the object nor the document says so."""
    file = written_to(obj, obj.File, f"{obj.Name}.nc")
    if file is None:
        raise JobError("arrange-file", "there is no file for the program", value=obj.File, advice=NAME_ONE)
    return file


def asked_of(obj: Any, verb: str, **more: Any) -> dict[str, Any]:
    """Return what the process is asked (`job/editing/arrange_question.py`); raises CNCStepperError."""
    packages.require()
    from CNCStepper.job.editing.arrange_form import ArrangeForm
    from CNCStepper.machine.profile import validated

    if not sources(obj):
        raise JobError("arrange-none", "there is no program to arrange", advice="add jobs, programs or files")
    if proxy_type(obj.Job) != JOB:
        raise JobError("job-missing", "the arrangement has no job", advice="choose the job whose machine runs it")
    machine, found = machine_of(obj.Job), values(obj)
    validated(ArrangeForm, {key: found[key] for key in FIGURES}, obj.Label)
    return {
        "verb": verb,
        "programs": [_told(each, count) for each, count in zip(sources(obj), counts_of(obj), strict=True)],
        "parts": json.loads(obj.Placements),
        "size_mm": [found["sheet_x_mm"], found["sheet_y_mm"]],
        "gap_mm": found["gap_mm"],
        "radius_mm": found["tool_mm"] / 2.0,
        "turn": found["turn"],
        "dialect": machine.language(),
        "machine": machine.model_dump(mode="json"),
        "file": str(file_of(obj)),
        **more,
    }


def _told(source: Any, count: int) -> dict[str, Any]:
    if isinstance(source, Path):
        return {"file": str(source), "count": count}
    label = str(source.Label)
    return {"name": label if Path(label).suffix else f"{label}.nc", "text": program_file.load(source), "count": count}


def take_answer(obj: Any, answer: dict[str, Any]) -> None:
    """Keep where the copies lie, and load the program that was written for the machine of the job."""
    obj.Placed, obj.Placements = len(answer["parts"]), json.dumps(answer["parts"])
    program_of_file(obj.Job, file_of(obj))
    obj.MadeOf = obj.Proxy.key_of(obj)
