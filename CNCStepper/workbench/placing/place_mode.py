# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse on placed parts: press chooses, a drag moves, with Shift it turns; a part never comes to lie on another.

While it is dragged a part follows the pointer, red where it may not lie; let go there, it stays at the last free place
on the way. All else in the view is FreeCAD's.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any

from CNCStepper.errors import JobError
from CNCStepper.nesting.manual_nesting import ManualNest, in_rows, sheet_at
from CNCStepper.nesting.nesting_model import Placement
from CNCStepper.workbench.freehand.drawing_plane import PlaneView
from CNCStepper.workbench.freehand.mode import Mode, say
from CNCStepper.workbench.freehand.stroke import Point
from CNCStepper.workbench.placing.part_nodes import CHOSEN_RGB, FAULT_RGB, LOCKED_RGB, PART_RGB, PartNodes
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.translation import tr


class PlaceMode(Mode):
    """The parts of a nest in a 3D view, until it is left.

    changed: called when a part has been chosen, moved or taken away. say_why: with the reason why a part may not lie
    where it is dragged, "" where it may. faults: parts that do not fit any more, red until they are moved.
    """

    def __init__(
        self,
        view: Any,
        document: Any,
        nest: ManualNest,
        between_mm: float,
        changed: Callable[[], None],
        say_why: Callable[[str], None],
        faults: Iterable[int] = (),
    ):
        import FreeCAD

        super().__init__(view, document)
        self.nest, self._changed, self._say_why = nest, changed, say_why
        self.corners = in_rows(nest.sheets, between_mm)
        self.chosen: int | None = None
        self._nodes = PartNodes(view, nest, self.corners)
        self._sight = PlaneView(view, FreeCAD.Placement())
        self._grip: Point | None = None  # where the pointer took hold, in the document's mm
        self._pixel: Point = (0.0, 0.0)  # where the pointer was seen last while it holds a part
        self._turns = False
        self._wanted: Placement | None = None
        self._faults = set(faults)

    def begin(self) -> None:
        """Show sheets and parts, and take the pointer."""
        self._nodes.show()
        self.refresh()
        super().begin()

    def leave(self) -> None:
        """Take all out of the view, once."""
        if self._begun:
            self._nodes.hide()
        super().leave()

    def hint(self) -> None:
        """Say what the mouse does."""
        say(tr("Drag a part to move it, with Shift to turn it; Delete takes it away"))

    def refresh(self) -> None:
        """Show the parts as they are now."""
        used = {part.placement.sheet for part in self.nest.parts}
        shown = sorted(used | {next((n for n in range(len(self.nest.sheets)) if n not in used), 0)})
        self._nodes.build(shown)
        if self.chosen is not None and self.chosen >= len(self.nest.parts):
            self.chosen = None
        self._colour_all()

    def choose(self, number: int | None) -> None:
        """Mark a part, or none."""
        self.chosen = number
        self._colour_all()
        self._changed()

    def pressed(self, pixel: Point, shift: bool) -> bool:
        """Choose the part under the pointer and take hold of it."""
        point = self._sight.point(pixel)
        found = point and sheet_at(self.nest.sheets, self.corners, *point)
        self.choose(self.nest.part_at(*found) if found else None)
        if self.chosen is None:
            return False
        self._grip, self._turns, self._wanted, self._pixel = point, shift, None, pixel
        return True

    def moved(self, pixel: Point, shift: bool) -> bool:
        """Let the part that is held follow the pointer, and say at once where it may not lie."""
        point = self._sight.point(pixel) if self._grip is not None else None
        if point is None or self._grip is None or self.chosen is None or self.nest.parts[self.chosen].locked:
            return False
        self._pixel = pixel
        self._wanted = self._turned(point) if self._turns else self._shifted(point)
        why = self.nest.problem(self._wanted, self.chosen)
        self._nodes.place(self.chosen, self._wanted)
        self._nodes.colour(self.chosen, FAULT_RGB if why else CHOSEN_RGB)
        self._say_why(translated(why) if why else "")
        return True

    def released(self, pixel: Point) -> bool:
        """Let the part lie where the pointer lets it go, or at the last free place on the way there."""
        if pixel != self._pixel:  # a busy window may hand on no move to here
            self.moved(pixel, self._turns)
        wanted, self._wanted, self._grip = self._wanted, None, None
        if wanted is not None and self.chosen is not None:
            self.put(self.nest.reached(self.chosen, wanted))
        return True

    def put(self, placement: Placement) -> None:
        """Move the chosen part to a place; where it may not lie it stays, and the reason is said."""
        if self.chosen is None:
            return
        self._say_why("")
        try:
            self.nest.move(self.chosen, placement)
            self._faults.discard(self.chosen)
        except JobError as error:
            self._say_why(translated(error.what))
        self._nodes.place(self.chosen, self.nest.parts[self.chosen].placement)
        self._colour_all()
        self._changed()

    def wants(self, key: str) -> bool:
        """Esc gives up a drag, Delete takes the chosen part away; all else is the panel's."""
        return (key == "escape" and self._wanted is not None) or (key == "delete" and self.chosen is not None)

    def key(self, key: str) -> None:
        """Give up a drag, or take the chosen part away."""
        number = self.chosen
        if number is None:
            return
        if key == "escape":
            self._wanted = self._grip = None
            self._nodes.place(number, self.nest.parts[number].placement)
            self._colour_all()
        else:
            self.remove()

    def remove(self) -> None:
        """Take the chosen part away, unless it is locked."""
        if self.chosen is None or self.nest.parts[self.chosen].locked:
            return
        self.nest.remove(self.chosen)
        left = self._faults - {self.chosen}
        self._faults = {number - (number > self.chosen) for number in left}
        self.chosen = None
        self.refresh()
        self._changed()

    def _shifted(self, point: Point) -> Placement:
        """Return where the chosen part is dragged to, on the sheet under the pointer or that of before."""
        assert self._grip is not None and self.chosen is not None
        own = self.nest.parts[self.chosen].placement
        found = sheet_at(self.nest.sheets, self.corners, *point)
        sheet = found[0] if found else own.sheet
        (left, low), (to_left, to_low) = self.corners[own.sheet], self.corners[sheet]
        x_mm, y_mm = (point[axis] - self._grip[axis] for axis in (0, 1))
        return self.nest.moved_by(self.chosen, x_mm + left - to_left, y_mm + low - to_low, sheet)

    def _turned(self, point: Point) -> Placement:
        """Return how the chosen part is turned about the middle of its box by the way from the grip to the pointer."""
        assert self._grip is not None and self.chosen is not None
        left, low = self.corners[self.nest.parts[self.chosen].placement.sheet]
        middle = self.nest.polygon(self.chosen).envelope.centroid
        x_mm, y_mm = middle.x + left, middle.y + low
        before, now = (math.atan2(at[1] - y_mm, at[0] - x_mm) for at in (self._grip, point))
        return self.nest.turned_by(self.chosen, math.degrees(now - before))

    def _colour_all(self) -> None:
        for number, part in enumerate(self.nest.parts):
            usual = LOCKED_RGB if part.locked else PART_RGB
            self._nodes.colour(
                number, FAULT_RGB if number in self._faults else CHOSEN_RGB if number == self.chosen else usual
            )
