# SPDX-License-Identifier: LGPL-2.1-or-later
"""A solid's file to the files of a stack: sections, pieces, drawings, and the sheets on which they are nested."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from CNCStepper.drawing.solids.stl import MOST_BYTES, read_triangles
from CNCStepper.errors import Place, Text, placed
from CNCStepper.input_file import read_input
from CNCStepper.job.nesting.nest_files import write_nest
from CNCStepper.job.nesting.order_file import Order
from CNCStepper.job.slicing.sections import Sections, mesh_sections, solid_sections
from CNCStepper.job.slicing.slice_files import nest_order, write_stack
from CNCStepper.job.slicing.slice_form import SliceForm
from CNCStepper.job.slicing.solid_slices import stack_of
from CNCStepper.nesting.nest import nest
from CNCStepper.nesting.nesting_model import Budget, Layout

SOLIDS = (".step", ".stp", ".brep", ".brp", ".fcstd")  # which OCCT reads, and whose unit is known
PARTS = ("front", "middle", "back")  # names of the runs of sheets, from the lowest


@dataclass(frozen=True)
class Nested:
    """The pieces of a stack on sheets of material, and the files of that."""

    order: Order
    layout: Layout
    files: tuple[Path, ...]

    @property
    def unplaced(self) -> list[str]:
        """The pieces that no sheet takes, each with the reason."""
        return [
            Text("{name}: {why}", name=self.order.items[each.item].name, why=each.why) for each in self.layout.unplaced
        ]


def sections_of(solid: Path, axis: str, thickness_mm: float, scale: float = 1.0) -> Sections:
    """Return the sections of a file; scale: mm of an STL's unit. Raises JobError for one that cannot be sliced."""
    if solid.suffix.casefold() in SOLIDS:
        return solid_sections(solid, axis, thickness_mm)
    with placed(Place(str(solid))):
        return mesh_sections(
            read_triangles(read_input(solid, MOST_BYTES), Place(str(solid))) * scale, axis, thickness_mm
        )


def nest_stack(order: Order, time_s: float, folder: Path, share: Callable[[float], None]) -> Nested:
    """Nest the order of `nest_order` within a time and write the files of that."""
    layout = nest(order.items, order.sheets, order.spacing, Budget(time_s, progress=share))
    return Nested(order, layout, tuple(write_nest(order, layout, folder)))


def answer_of(asked: dict[str, Any], share: Callable[[float], None] = lambda share: None) -> dict[str, Any]:
    """Slice and nest as a window asks for it; return as plain data what was made.

    sheets: the drawings of the sheets of material. slices: the sheets of the stack. unplaced, notes: sentences.
    """
    form, folder = SliceForm.model_validate(asked["form"]), Path(asked["folder"])
    stack = stack_of(sections_of(Path(asked["solid"]), form.axis, form.thickness_mm), PARTS, form.hole_mm)
    write_stack(stack, folder, asked["title"])
    order = nest_order(stack, (form.sheet_x_mm, form.sheet_y_mm), form.gap_mm, form.margin_mm)
    nested = nest_stack(order, form.time_s, folder, share)
    return {
        "sheets": [str(path) for path in nested.files if path.name.startswith("sheet-")],
        "slices": len(stack.slices),
        "pieces": len(nested.layout.placements),
        "volume_share": stack.volume_mm3 / stack.solid_volume_mm3 - 1.0,
        "unplaced": nested.unplaced,
        "notes": list(stack.notes),
    }
