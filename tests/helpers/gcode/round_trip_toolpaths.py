# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random tables that a dialect can express: on the grid of its last digit, the ends of arcs exactly on their circle."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace
from math import hypot
from random import Random

from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.dialects.codes import AXES
from CNCStepper.state import Start, State
from CNCStepper.toolpath import ARC_CCW, ARC_CW, PLANE_AXES, TableBuilder, Toolpath
from CNCStepper.units import MM_PER_INCH


@dataclass
class Drawn:
    """A random table; units: of its grid. counts: what it holds, by name."""

    path: Toolpath
    units: str
    counts: Counter[str]


class _Drawer:
    """Draws one table; points are in counts of the text's last digit."""

    def __init__(self, dialect: Dialect, seed: int):
        assert dialect.writing is not None
        self.random = Random(f"{dialect.name} {seed}")  # a text seeds the same on every machine
        self.dialect, self.writing = dialect, dialect.writing
        self.units = self.random.choice(sorted(dialect.writing.units))
        self.decimals = dialect.writing.decimals[self.units]
        self.size = self.random.choice([200, 5_000, 90_000])
        self.axes = [axis for axis in range(3) if AXES[axis] in dialect.letters]
        self.counts: Counter[str] = Counter({self.units: 1})
        self.at = [self.random.randint(-self.size, self.size) for _ in range(3)]
        self.state = State(units=self.units)
        self.table = TableBuilder(Start(), self.state)
        self.arc_planes = [plane for plane in range(3) if self._has_plane(plane)] if "G2" in dialect.codes else []

    def drawn(self) -> Drawn:
        self.table.rapid(self._mm(self.at))
        for _ in range(self.random.randint(8, 30)):
            self.random.choice([self._line, self._line, self._arc, self._arc, self._happening])()
        self._line()  # what happens last happens before a row
        return Drawn(self.table.toolpath(), self.units, self.counts)

    def _has_plane(self, plane: int) -> bool:
        return (plane == 0 and not self.dialect.is_lathe) or ("G17", "G18", "G19")[plane] in self.dialect.codes

    def _mm(self, point: list[int]) -> tuple[float, ...]:
        """Return a point as the reader works it out."""
        scale = MM_PER_INCH if self.units == "inch" else 1.0
        values = [float(f"{count / 10**self.decimals:.{self.decimals}f}") * scale for count in point]
        return tuple(value if axis in self.axes else 0.0 for axis, value in enumerate(values))

    def _feed(self) -> float:
        text = self.random.choice([1.5, 100.0, 250.5, 1234.5])
        return text * self.dialect.feed_unit_mm_min * (MM_PER_INCH if self.units == "inch" else 1.0)

    def _line(self) -> None:
        moved = self.random.sample(self.axes, self.random.randint(1, len(self.axes)))
        for axis in moved:
            self.at[axis] += self.random.choice([-1, 1]) * self.random.randint(0 if len(moved) > 1 else 1, self.size)
        if self.random.random() < 0.3:
            self.counts["rapid"] += 1
            self.table.rapid(self._mm(self.at))
        else:
            self.counts["line"] += 1
            self.table.feed(self._mm(self.at), self._feed())

    def _arc(self) -> None:
        if not self.arc_planes:
            self._line()
            return
        plane = self.random.choice(self.arc_planes)
        first, second, normal = PLANE_AXES[plane]
        x, y = self._spoke()
        turned = ((x, -y), (-x, y), (-x, -y), (y, x), (-y, x), (y, -x), (-y, -x))
        ends = [(u, v) for u, v in turned if hypot(u - x, v - y) > 0.4 * hypot(x, y)]  # flat arcs would become lines
        is_full = self.writing.full_circles and self.random.random() < 0.2
        u, v = (x, y) if is_full else self.random.choice(ends)
        centre = list(self.at)
        centre[first], centre[second] = self.at[first] - x, self.at[second] - y
        self.at[first], self.at[second] = centre[first] + u, centre[second] + v
        if self.writing.helices and self.random.random() < 0.4:
            self.at[normal] += self.random.randint(1, self.size)
            self.counts["helix"] += 1
        kind = self.random.choice([ARC_CW, ARC_CCW])
        turns = self.random.choice([1, 1, 2, 3]) if "P" in self.dialect.codes["G2"].takes else 1
        self.counts["turns"] += turns > 1
        self.counts["full circle"] += is_full
        self.counts[f"arc {plane}"] += 1
        self.table.arc(kind, self._mm(self.at), self._mm(centre), self._feed(), plane, turns)

    def _spoke(self) -> tuple[int, int]:
        """Return from the centre to the begin of an arc, long enough that its arc is none that becomes a line."""
        x = self.random.randint(120, max(self.size, 121)) * self.random.choice([-1, 1])
        y = self.random.randint(120, max(self.size, 121)) * self.random.choice([-1, 1])
        return (x, 0) if self.random.random() < 0.2 else (x, y)

    def _happening(self) -> None:
        may = [self._comment] if self.writing.comment else []
        codes = self.dialect.codes
        may += [self._spindle, self._coolant] if "M3" in codes and "M8" in codes else []
        may += [self._dwell] if "G4" in codes else []
        may += [self._pause] if "M0" in codes else []
        may += [self._system] if len(self.writing.work_systems) > 1 else []
        may += [self._tool] if "M6" in codes and "m6" in self.writing.tool_change else []
        if may:
            self.random.choice(may)()

    def _set(self, name: str, **fields) -> None:
        self.counts[name] += 1
        self.state = replace(self.state, **fields)
        self.table.set_state(self.state)
        self._line()

    def _spindle(self) -> None:
        turns = self.random.choice(["off", "cw", "ccw"])
        self._set("spindle", spindle=turns, spindle_rpm=0.0 if turns == "off" else self.random.choice([800.0, 9000.5]))

    def _coolant(self) -> None:
        self._set("coolant", mist=self.random.random() < 0.5, flood=self.random.random() < 0.5)

    def _system(self) -> None:
        self._set("work system", work_system=self.random.choice(self.writing.work_systems))

    def _tool(self) -> None:
        tool = self.random.choice([1, 2, 3])
        self._set("tool", tool=tool)

    def _dwell(self) -> None:
        self.counts["dwell"] += 1
        self.table.event("dwell", self.random.choice([0.25, 1.0, 12.5]))

    def _pause(self) -> None:
        self.counts["pause"] += 1
        self.table.event("pause", text=self.random.choice(["", "turn the part"]))

    def _comment(self) -> None:
        self.counts["comment"] += 1
        self.table.event("comment", text="a note")


def drawn_path(dialect: Dialect, seed: int) -> Drawn:
    """Return a random table that the dialect can express as it is."""
    return _Drawer(dialect, seed).drawn()
