# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a window asks about programs on the work surface, and the answer, both plain data.

    {"verb": "place", "programs": [{"name": "a.nc", "text": "...", "count": 2}, {"file": PATH, "count": 1}],
     "parts": [[0, program, x, y, deg, locked], ...], "size_mm": [600, 400], "gap_mm": 5, "radius_mm": 1.5,
     "turn": true, "dialect": "grbl", "machine": {...}, "file": PATH}

    show        the outlines alone
    place       the copies that are not locked are placed
    fill        more of the program "item" where there is room
    write       the one checked program of just these copies, as `cncstepper arrange` writes it

The answer is that of a nest (`job/nesting/nest_question.py`), with the programs in place of parts.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from threading import Event
from typing import Any

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import JobError
from CNCStepper.gcode.syntax.text_format import decoded
from CNCStepper.input_file import read_input
from CNCStepper.job.editing.arrangement import (
    SEARCH_S,
    Program,
    arranged_and_checked,
    copies_at,
    items_of,
    nested,
    program_of,
    work_surface,
)
from CNCStepper.job.nesting.nest_data import FILL, SEARCH, WRITE, packed_items, parts_of, rows_of
from CNCStepper.job.nesting.nest_question import with_locked
from CNCStepper.machine.profile import Machine
from CNCStepper.nesting.manual_nesting import ManualNest, PlacedPart, filled
from CNCStepper.nesting.nesting_model import Budget, Placement, Spacing
from CNCStepper.simulation.finding import Finding

MOST_BYTES = 256_000_000
QUARTERS_DEG = (0.0, 90.0, 180.0, 270.0)


def answer_of(
    asked: dict[str, Any], share: Callable[[float], None] = lambda share: None, stopped: Event | None = None
) -> dict[str, Any]:
    """Do what is asked; stopped: ends a search with the best so far. Raises CNCStepperError."""
    programs = [_program(each, asked) for each in asked["programs"]]
    sheet, spacing = work_surface(tuple(asked["size_mm"])), Spacing(asked["gap_mm"])
    items = items_of(programs, None)
    parts = parts_of(asked["parts"])
    budget = Budget(SEARCH_S, progress=share, stopped=stopped or Event())
    if asked["verb"] == SEARCH:
        locked = [part.placement for part in parts if part.locked]
        turned = items_of(programs, QUARTERS_DEG if asked["turn"] else (0.0,))
        wanted = with_locked(turned, [program.count for program in programs], locked)
        found = nested(wanted, sheet, asked["gap_mm"], budget)
        parts = [PlacedPart(place, place in locked) for place in sorted(found)]
    elif asked["verb"] == FILL:
        manual = ManualNest(items, [sheet], Spacing(asked["gap_mm"]), parts)
        parts += [PlacedPart(place) for place in filled(manual, asked["item"], 0, budget)]
    written = asked["verb"] == WRITE
    if written:
        _write(programs, [part.placement for part in parts], asked)
    faults = ManualNest(items, [sheet], spacing, parts).overlapping()
    told = {"order": packed_items(items, [sheet], spacing), "parts": rows_of(parts)}
    return {**told, "faults": faults, "written": written}


def _program(told: dict[str, Any], asked: dict[str, Any]) -> Program:
    """Return a program by its text, or by its file."""
    text = told.get("text")
    name = told["file"] if text is None else told["name"]
    if text is None:
        text = decoded(read_input(Path(told["file"]), MOST_BYTES))[0]
    return program_of(name, text, told["count"], asked["dialect"], asked["radius_mm"])


def _write(programs: Sequence[Program], places: Sequence[Placement], asked: dict[str, Any]) -> None:
    """Write the whole program; raises JobError where a check forbids it."""
    machine = Machine.model_validate(asked["machine"]) if asked["machine"] else None
    copies = copies_at(programs, places)
    text, errors = arranged_and_checked(programs, copies, asked["dialect"], asked["file"], machine)
    if errors:
        raise _refusal(errors[0])
    path = Path(asked["file"])
    path.parent.mkdir(parents=True, exist_ok=True)
    write_whole(path, text.encode("utf-8"))


def _refusal(finding: Finding) -> JobError:
    return JobError("arrange-refused", finding.text, advice=finding.advice or "place the copies elsewhere")
