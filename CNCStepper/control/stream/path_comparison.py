# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares every reported position with the path: what grbl's link lets pass damaged, `X90` for `X10`, is seen so.

stretches  | done | planned by the controller | in its receive buffer |
                  ^ behind here it cannot be                          ^ nor beyond: the last line sent
                    ○ a report on one of these is right; from then on the machine is not behind it either

Sees whether the work zero changes while a program runs, and not by it: a pendant, another client, a fault.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.program.wire_line import ARCS
from CNCStepper.control.protocol.grbl.connect import ControllerInfo, offsets_of
from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.firmware import LATHE
from CNCStepper.control.protocol.grbl.readiness import CHECK, state_refusal
from CNCStepper.control.protocol.grbl.settings import STEPS_PER_MM
from CNCStepper.control.protocol.grbl.status_reports import Status, Vector
from CNCStepper.control.stream.backlash_side import BacklashTracker
from CNCStepper.control.stream.executed_lines import SEGMENTS, finished_lines, longest_step_mm
from CNCStepper.errors import MachineRefusal, Place, Text
from CNCStepper.gcode.syntax.words import code_pattern, packed_wire
from CNCStepper.state import WORK_SYSTEMS, Start
from CNCStepper.tolerances import REPORTED_OFFSET_MM

if TYPE_CHECKING:
    from CNCStepper.control.stream.planned_path import PlannedPath

# What may change it: work systems (a program's end goes back to G54), G10, G92, lengths and changes of tools, `$`.
_CHANGING = (code_pattern("G", r"(?:10|5[4-9]|92|43|49)(?:\.[0-9]+)?"), code_pattern("M", r"(?:2|30|6)(?:\.0*)?"))
_CHANGES = re.compile("|".join((*_CHANGING, "T[0-9]", r"\$")))


class OffsetWatch:
    """Compares each reported offset (WCO), mm, with the one before.

    lines: of the program that runs. offset_mm: at its begin, None where it was not reported yet.
    """

    def __init__(self, lines: Sequence[str], offset_mm: Vector | None = None):
        self._lines = lines
        self._offset_mm = offset_mm
        self._first = 0  # the first line, from 0, that may not have been read when that was reported

    def take(self, offset_mm: Vector | None, acknowledged: int, sent: int) -> tuple[Vector, Vector] | None:
        """Return the offset before and the present one where no line that is on its way can have changed it."""
        if offset_mm is None:
            return None
        before, first = self._offset_mm, self._first
        self._offset_mm, self._first = offset_mm, max(0, acknowledged - 1)
        if before is None or len(before) != len(offset_mm):
            return None
        changed = any(abs(old - new) > REPORTED_OFFSET_MM for old, new in zip(before, offset_mm, strict=True))
        if not changed or any(_CHANGES.search(packed_wire(self._lines[index])) for index in range(first, sent)):
            return None
        return before, offset_mm


def zero_changed(before_mm: Vector, offset_mm: Vector, place: Place | None) -> MachineRefusal:
    """Return the error for a work zero that changed during a program."""
    return MachineRefusal(
        "zero-changed",
        "the work zero changed while the program ran, and not by the program",
        value=f"{_words(offset_mm)} mm",
        limit=f"{_words(before_mm)} mm",
        advice="look for a pendant or another program that is connected, set the zero again, then send again",
        place=place,
    )


def _words(vector: Vector) -> str:
    return ",".join(f"{value:.3f}" for value in vector)


STEPS = 2.0
ROUNDING_MM = 0.002  # of positions and offsets as they are reported, in inches too
STEP_MM = 0.0125  # where the controller does not report its steps/mm
STANDING = ("Idle", "Run", "Hold")  # in others (door, tool, jog) a controller moves by itself, or a person it
MODES = ["G0", "G1", "G2", "G3", "G17", "G18", "G19", "G20", "G21", "G90", "G91", "G93", "G94", "G98", "G99"]
DRILLS = re.compile(r"G(7[346]|8[1-9])\b")
TURNS_ON = re.compile(code_pattern("M", r"[34](?:\.0*)?"))
DAMAGED = "the machine is not on the program's path: a line was damaged on its way"
RESTARTED = "the machine left the program's path: a line was damaged on its way, or the controller restarted unheard"

Offsets = Mapping[str, Sequence[float] | None]


class PathWatch:
    """Watches one job on one machine; `excursion` is the first report that was off the path, or of the check mode.

    restarted: at that report the controller may have restarted unheard, so that its position is unknown.

    tell(kind, text): called where the path becomes unknown. gaps: follow the lines sent, where there
    is play.
    """

    def __init__(
        self,
        job: SendJob,
        driver: Grbl,
        found: ControllerInfo,
        tell: Callable[[str, str], None],
        gaps: BacklashTracker | None = None,
    ):
        self.excursion: MachineRefusal | None = None
        self.restarted = False
        self._job = job
        self._driver = driver
        self._tell = tell
        self._gaps = gaps
        self._told = False  # that the path is not known
        self._path = self._planned(found)
        self._offsets = OffsetWatch(job.lines, driver.wco_mm)
        axes = (driver.settings.get(STEPS_PER_MM + axis, 1 / STEP_MM) for axis in range(3))
        self._step_mm = longest_step_mm(driver.settings)
        self._near_mm = tuple(STEPS / max(steps, 1.0) + ROUNDING_MM for steps in axes)

    def read_on(self, sent: int) -> None:
        """Read the lines sent by now: a few at a time, while all since the last report would hold the stream up."""
        if self._path:
            self._path.read_on(sent)

    def take(self, status: Status, acknowledged: int, sent: int) -> None:
        """Compare a report; acknowledged: lines that were answered before it. sent: lines sent by now."""
        if status.state == CHECK:
            self.excursion = self.excursion or state_refusal(status)
        if changed := self._offsets.take(self._driver.mm(status.wco), acknowledged, sent):
            self.excursion = self.excursion or zero_changed(*changed, self._place())
        place = self._driver.mm(status.mpos) or self._driver.mpos_mm
        if place is None or self._path is None or self.excursion or status.state not in STANDING:
            return
        self._path.read(sent)
        self._notify_unknown(self._path)
        self._path.drop_planned_before(acknowledged, self._driver.planner_blocks + SEGMENTS)
        if not self._path.drop_to(place[:3], self._near_mm):
            self._leave(place, sent)

    def done(self, acknowledged: int) -> int:
        """Return how many of the acknowledged lines are surely cut, by the last report.

        These are those before the one on which the machine was seen; where the path is not known, those that must have
        left the planner.
        """
        passed = max(self._path.line, 0) if self._path else 0
        if self._path is None or self._path.refused:
            blocks = self._driver.planner_blocks + SEGMENTS
            passed = max(passed, finished_lines(self._job.lines, acknowledged, blocks, self._step_mm))
        return min(passed, acknowledged)

    def restart_from_here(self, found: ControllerInfo, sent: int) -> None:
        """Compare from here on: the machine is at rest, all lines sent are cut, its zero may have changed."""
        self._offsets = OffsetWatch(self._job.lines)
        if self._path and not self._told:
            self._path = self._planned(found, sent)

    @property
    def left_line(self) -> int | None:
        """The line, from 0, at or after which the path was left; None while no report shows that."""
        return max(self._path.line, 0) if self._path and self.excursion else None

    def check(self) -> None:
        """Raise MachineRefusal once a report was off the path."""
        if self.excursion:
            raise self.excursion

    def may_have_restarted(self, sent: int) -> bool:
        """Return whether the controller may have restarted, its greeting being lost or damaged on its way.

        A restart switches the spindle off. So there was none if it still turns, and none of the `sent` lines that may
        have been read since has switched it on.
        """
        status, first = self._driver.status, max(self._path.line, 0) if self._path else 0
        lines = (self._job.lines[index] for index in range(first, sent))
        return status is None or not status.spindle or any(TURNS_ON.search(packed_wire(line)) for line in lines)

    def check_end(self, sent: int) -> None:
        """Raise MachineRefusal unless the machine, idle after the last answer, is at the path's end."""
        place = self._driver.mpos_mm
        if self._path and (place is None or not self._path.ends_at(place[:3], self._near_mm)):
            raise self._leave(place, sent)

    def _planned(self, found: ControllerInfo, first: int = 0) -> PlannedPath | None:
        if found.firmware is LATHE:  # its position is counted from the lines sent: it proves nothing
            return None
        try:
            from CNCStepper.control.stream.planned_path import PlannedPath  # takes long: when a machine is there only
        except ImportError as error:
            self._warn(str(error))
            return None
        start, held = start_of(self._driver, found), held_modes(offsets_of(self._driver, found), found.modes)
        step_mm = [1.0 / found.settings.get(STEPS_PER_MM + axis, math.inf) for axis in range(3)]
        return PlannedPath(self._job.lines, start, held, first, self._gaps, found.firmware.language, step_mm)

    def _notify_unknown(self, path: PlannedPath) -> None:
        if path.refused and not self._told:
            self._told = True
            self._warn(str(path.refused.at(self._job.place(path.lost_at))))

    def _warn(self, why: str) -> None:
        self._tell("warning", Text("positions are not compared with the path any more: {why}", why=why))

    def _leave(self, place: Vector | None, sent: int) -> MachineRefusal:
        self.restarted = self.may_have_restarted(sent)
        self.excursion = self._refusal(place, RESTARTED if self.restarted else DAMAGED)
        return self.excursion

    def _refusal(self, place: Vector | None, what: str) -> MachineRefusal:
        return MachineRefusal(
            "path-left",
            what,
            value=",".join(f"{value:.3f}" for value in place or ()) + " mm",
            limit=f"{STEPS:g} steps",
            advice="look at cable, shielding and grounding; the part may be cut where it should not be",
            place=self._place(),
        )

    def _place(self) -> Place:
        """Return where the machine is in the program, as far as it was seen there."""
        return self._job.place(max(self._path.line, 0) if self._path else 0)


def start_of(driver: Grbl, found: ControllerInfo) -> Start:
    """Return the position and offsets of a machine that was just connected."""
    return start_from(offsets_of(driver, found), found.modes, driver.mpos_mm)


def start_from(offsets_mm: Offsets, modes: str, mpos_mm: Vector | None) -> Start:
    """Return the same by the offsets of `$#` in mm, the words of `$G` and the machine position."""
    offsets = {name: tuple(offset) for name, offset in offsets_mm.items() if offset}
    return Start(
        position_mm=mpos_mm or Start().position_mm,
        work_system=next((word for word in modes.split() if word in WORK_SYSTEMS), "G54"),
        work_offsets_mm={name: offsets[name] for name in WORK_SYSTEMS if name in offsets},
        g92_mm=offsets.get("G92", Start().g92_mm),
        zero_known=True,
        parameters=_homes(offsets),
    )


def held_modes(offsets_mm: Offsets, modes: str) -> list[str]:
    """Return the machine's further state as lines: tool length, coordinate mode, feed, motion mode."""
    length = offsets_mm.get("TLO")
    words = [word for word in modes.split() if word in MODES or (word[0] == "F" and float(word[1:]) > 0)]
    plain, arcs = "".join(word for word in words if word not in ARCS), [word for word in words if word in ARCS]
    end_cycle = ["G80"] if DRILLS.search(modes) else []  # its depth and retract plane are not reported
    return [*([f"G43.1Z{length[-1]}"] if length and length[-1] else []), plain, *arcs, *end_cycle]


def _homes(offsets_mm: Mapping[str, Sequence[float]]) -> dict[int, float]:
    """Return G28 and G30 as the parameters that hold them."""
    first = {"G28": 5161, "G30": 5181}
    return {first[name] + axis: value for name in first for axis, value in enumerate(offsets_mm.get(name, ()))}
