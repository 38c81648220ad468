# SPDX-License-Identifier: LGPL-2.1-or-later
"""A drawing as a window imports it: its chains, what is wrong with them, what was mended, and the state of its file.

file ──► read_imported ──► packed: plain data for JSON ══► unpacked ──► objects in the window's document
         (in a process)    columns as base64
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, astuple, dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from CNCStepper.drawing.drawing import Attributes, Chain, Drawing, Share, Skipped
from CNCStepper.drawing.repair.mend import Change, mended
from CNCStepper.drawing.repair.problems import Problem, RepairLimits, problems_of
from CNCStepper.job.drawings.linked_file import FileState, read_linked
from CNCStepper.job.drawings.packed_curves import Packed, array_of, column_text, packed_curves, unpacked_curves
from CNCStepper.job.shape_forms.drawing_form import DrawingForm

GROUPS = "\x1f"  # between the names of groups: no printable text holds it
MOST_TOLD = 200  # problems, changes and skipped entities that are kept by their places


@dataclass(frozen=True)
class Told:
    """Rows of one kind that a report names, MOST_TOLD at most, and how many there are."""

    count: int
    rows: tuple[Any, ...]

    @classmethod
    def of(cls, rows: Sequence[Any]) -> Told:
        """Return the first rows and the count of all."""
        return cls(len(rows), tuple(rows[:MOST_TOLD]))


@dataclass(frozen=True)
class ImportedDrawing:
    """The chains of a drawing in mm, what is wrong with them, and the file as it was read."""

    chains: tuple[Chain, ...]
    state: FileState
    unit_mm: float
    problems: Told
    changes: Told
    skipped: Told
    warnings: tuple[str, ...]
    kerf_mm: float | None = None  # for which neighbours on a nested sheet share cuts


def read_imported(
    path: Path, form: DrawingForm, limits: RepairLimits, share: Share = lambda share: None
) -> ImportedDrawing:
    """Return a drawing read as its form says; what is wrong is judged by `limits`, whether it is mended or not.

    Raises JobError for a file that cannot be read.
    """
    options = replace(form.options(), near_mm=max(form.options().near_mm, limits.close_mm))
    drawing, state = read_linked(path, options, share)
    changes: tuple[Change, ...] = ()
    if form.mend is not None:
        drawing, changes = mended(drawing, form.mend)
    problems = problems_of(drawing, limits)
    return ImportedDrawing(
        tuple(replace(chain, curve=form.placed(chain.curve)) for chain in drawing.chains),
        state,
        drawing.unit_mm,
        Told.of(problems),
        Told.of(changes),
        Told.of(drawing.skipped),
        _warnings(drawing),
        drawing.kerf_mm,
    )


def _warnings(drawing: Drawing) -> tuple[str, ...]:
    return (*((drawing.damage,) if drawing.damage else ()), *drawing.warnings)


def packed(imported: ImportedDrawing) -> Packed:
    """Return an imported drawing as plain data."""
    chains = imported.chains
    return {
        "curves": packed_curves([chain.curve for chain in chains]),
        "layer": _texts([chain.attributes.layer for chain in chains]),
        "colour": _texts([chain.attributes.colour for chain in chains]),
        "name": _texts([chain.attributes.name for chain in chains]),
        "groups": _texts([GROUPS.join(chain.attributes.groups) for chain in chains]),
        "filled": column_text(np.array([chain.attributes.filled for chain in chains], np.uint8)),
        "state": asdict(imported.state),
        "unit_mm": imported.unit_mm,
        "warnings": list(imported.warnings),
        "kerf_mm": imported.kerf_mm,
        **{name: _rows(getattr(imported, name)) for name in KINDS},
    }


def unpacked(content: Packed) -> ImportedDrawing:
    """Return the drawing of `packed`."""
    filled = array_of(content["filled"], np.uint8).astype(bool).tolist()
    columns = [_texts_of(content[key]) for key in ("layer", "colour", "name", "groups")]
    chains = [
        Chain(curve, Attributes(layer, colour, name, tuple(groups.split(GROUPS)) if groups else (), is_filled))
        for curve, layer, colour, name, groups, is_filled in zip(
            unpacked_curves(content["curves"]), *columns, filled, strict=True
        )
    ]
    told = {name: Told(content[name][0], tuple(kind(*row) for row in content[name][1])) for name, kind in KINDS.items()}
    state, warnings = FileState(**content["state"]), tuple(content["warnings"])
    return ImportedDrawing(
        tuple(chains), state, content["unit_mm"], warnings=warnings, kerf_mm=content["kerf_mm"], **told
    )


KINDS: dict[str, Any] = {"problems": Problem, "changes": Change, "skipped": Skipped}


def _rows(told: Told) -> list[Any]:
    return [told.count, [list(astuple(row)) for row in told.rows]]


def _texts(values: Sequence[str]) -> list[Any]:
    """Return texts as those that differ, and a column of their numbers."""
    numbers: dict[str, int] = {}
    column = [numbers.setdefault(value, len(numbers)) for value in values]
    return [list(numbers), column_text(np.array(column, np.int32))]


def _texts_of(content: list[Any]) -> list[str]:
    different, column = content
    return [different[number] for number in array_of(column, np.int32).tolist()]
