# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pause between two lines of a job: the machine is idle, can be jogged, and its zero can be set.

grbl refuses jogs and delays G10 while it is held, as at an M0. So the sender sends no M0: it waits until all lines
before it are cut, and continues at a resume command. The lines that follow were proven from the tool's position at the
pause. After a jog the tool first returns there (`control/stream/return_after_jog.py`), in work coordinates, because a
new zero moves the program with it. An axis with backlash that was moved returns to the side of its gap that it had
(`backlash_side.py`).

At its M6 grblHAL waits in the state Tool. It takes jogs and a new zero there after 0xA3; a cycle start ends the state.

A sender whose tool was retracted along the cut pauses too: a reset has discarded its lines, so the machine is idle. Its
client resumes from there, and returns the tool to the cut after jogs.

"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from CNCStepper.control.operator import zero_and_unlock
from CNCStepper.control.operator.jog import MAY_JOG, Jogger, JogMove, check_in_time
from CNCStepper.control.protocol.grbl.driver import RESUME, Answered, Grbl
from CNCStepper.control.protocol.grbl.firmware import TOOL
from CNCStepper.control.protocol.grbl.status_reports import Vector
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.control.session.command import Command
from CNCStepper.control.stream.backlash_side import UP, BacklashTracker
from CNCStepper.control.stream.return_after_jog import THERE_MM, Axes, over
from CNCStepper.errors import CNCStepperError, MachineRefusal, Text

TOOL_ENDS_S = 0.5  # from a cycle start until the status reports it
AT_REST = ("Idle", TOOL)


@dataclass(frozen=True)
class JogTarget:
    """A straight jog to a work position; an axis that is None stays."""

    place_mm: Axes
    feed_mm_min: float

    def line(self) -> str:
        """Return the jog command of grbl 1.1."""
        words = zip("XYZ", self.place_mm, strict=True)
        return f"$J=G90G21{''.join(f'{axis}{mm:.4f}' for axis, mm in words if mm is not None)}F{self.feed_mm_min:.1f}"


def way_back(here_mm: Vector, there_mm: Vector) -> list[JogTarget]:
    """Return the jogs from one work position to another: up, over, down; none where it is that place."""
    return [JogTarget(place_mm, feed_mm_min) for place_mm, feed_mm_min in over(here_mm, there_mm)]


class Pause:
    """Operator actions at one pause of a job, until it is left.

    tell, refuse: hear what happens, as of a `JobRun`. commands: those that `do` takes. is_off_path: the machine may
    have left the program's path, or its work zero be another one.
    """

    commands = ("resume", "hold", "jog", "jog_on", "jog_cancel", "set_zero")

    def __init__(
        self, timing: Timing, tell: Callable[[str, str], None], refuse: Callable[[Command, CNCStepperError], None]
    ):
        self.is_off_path = False
        self._zero_set = False  # at this stand or one before
        self._timing = timing
        self._tell = tell
        self._refuse = refuse
        self._driver: Grbl | None = None
        self._jogger: Jogger | None = None
        self._index = -1  # of the line that is waited before
        self._place_mm: Vector | None = None
        self._gaps: BacklashTracker | None = None
        self._loose: set[int] = set()  # the axes that were moved here
        self._resume_asked = False
        self._going_back = False
        self._at_tool = False  # which the controller waits for
        self._started = False  # that wait was to end
        self._leads_on = True
        self._changed_s = 0.0  # an earlier report shows an earlier state

    def begin(self, driver: Grbl, index: int, gaps: BacklashTracker | None = None, leads_on: bool = True) -> None:
        """Pause before the job's line `index`; a pause that was only disturbed keeps its place.

        gaps: of the motors, where the job's lines take up play. leads_on: whether the job goes on from here; else only
        a client can lead it on, from the zero that was cut from.
        """
        self._leads_on, self._gaps = leads_on, gaps
        if index != self._index:
            self._index, self._place_mm, self._loose = index, driver.wpos_mm, set()
        self._driver, self._resume_asked, self._going_back = driver, False, False
        self._at_tool, self._started = driver.status is not None and driver.status.state == TOOL, False
        self._jogger = Jogger(driver, self._give_up, self._tell, (*MAY_JOG, TOOL))

    def end(self) -> None:
        """Leave the pause: the machine is on the path."""
        self._index, self._jogger, self.is_off_path = -1, None, False

    def check_way_back(self) -> None:
        """Raise MachineRefusal where the machine jogs, or where the cut had another zero."""
        if self._zero_set:
            what = "the work zero was set at a pause, so that the retract along the cut is unknown"
            raise MachineRefusal("retreat-zero", what, advice="go on, or stop the job")
        if self._jogger and self._jogger.active:
            raise _busy("the machine jogs")

    def turn(self) -> float:
        """Send due jogs; return the time until the next call is due."""
        if self._jogger is None:
            return float("inf")
        self._jogger.turn()
        return self._jogger.wait_s

    def answered(self, answer: Answered) -> None:
        """Take the answer to a line that is none of the job's; raises MachineRefusal for one that was no jog."""
        if self._driver and self._jogger:
            self._changed_s = self._driver.clock()
            self._jogger.answered(answer)
        elif answer.error:
            raise _power_refused(answer)

    def do(self, command: Command) -> None:
        """Carry out one of `commands`; raises MachineRefusal when it cannot be done now."""
        assert self._driver and self._jogger
        check_in_time(command, self._driver.clock())
        if command.name in ("hold", "jog_cancel"):
            self._cancel(self._driver, self._jogger)
        elif not self._leads_on and command.name == "set_zero":
            raise _zero_kept()
        elif self._resume_asked:
            raise _busy("the job is about to resume")
        elif command.name == "jog":
            self._jogger.step(self._leaving(command.values))
        elif command.name == "jog_on":
            values = dict(command.values)
            self._jogger.keep(values.pop("press"), self._leaving(values))
        elif self._jogger.active:
            raise _busy("the machine jogs")
        elif command.name == "set_zero":
            self._set_zero(self._driver, **command.values)
        else:
            self._resume_asked = True

    def is_left(self, driver: Grbl) -> bool:
        """Return to the place after a resume; return whether the machine is there, so that the job resumes."""
        seen = driver.status
        if seen is None or driver.status_asked_s <= self._changed_s:
            return False
        self._resume_asked |= self._at_tool and seen.state == "Idle"  # started at the machine
        if not self._resume_asked or seen.state not in AT_REST or (self._jogger and self._jogger.active):
            return False
        ways = self._ways(driver)
        if not ways and seen.state == TOOL:
            self._end_tool_change(driver)
            return False
        if not ways:
            self._resume_asked = False
        elif self._going_back:
            self._give_up(_not_there())
        else:
            self._go_back(driver, ways)
        return not ways

    # --- inside --------------------------------------------------------------------------------

    def _leaving(self, values: Mapping[str, float]) -> JogMove:
        """Return a jog, noting that it leads off the path."""
        way = JogMove(**values)
        self.is_off_path = True
        self._loose |= {axis for axis, far_mm in enumerate((way.x_mm, way.y_mm, way.z_mm)) if far_mm}
        return way

    def _ways(self, driver: Grbl) -> list[JogTarget]:
        here_mm, there_mm = driver.wpos_mm, self._place_mm
        if here_mm is None or there_mm is None:
            return []
        if self._gaps and not self._going_back:
            return self._ways_to_side(driver, self._gaps, here_mm[:3], there_mm[:3])
        return way_back(here_mm, there_mm)

    def _ways_to_side(self, driver: Grbl, gaps: BacklashTracker, here_mm: Vector, there_mm: Vector) -> list[JogTarget]:
        """Return the jogs to the place by which each axis that was moved is on the side of its gap on which it was."""
        pairs = zip(here_mm, there_mm, strict=True)
        self._loose |= {axis for axis, (here, there) in enumerate(pairs) if abs(here - there) > THERE_MM}
        if not self._loose or driver.mpos_mm is None:
            return []
        if self._loose - {UP}:
            self._loose.add(UP)  # the tool goes up first
        work_zero_mm = driver.mpos_mm[UP] - here_mm[UP]
        return [
            JogTarget(place_mm, speed)
            for place_mm, speed in gaps.way_back(here_mm, there_mm, self._loose, work_zero_mm)
        ]

    def _go_back(self, driver: Grbl, ways: list[JogTarget]) -> None:
        assert self._jogger
        self._tell("message", "back to where the program paused: up, over, down")
        self._going_back, self._changed_s = True, driver.clock()
        self._jogger.follow(ways)

    def _end_tool_change(self, driver: Grbl) -> None:
        """Start the cycle, and give up where that was in vain."""
        if self._started:
            self._give_up(_tool_awaited())
        else:
            driver.realtime(RESUME)
            self._changed_s = driver.clock() + TOOL_ENDS_S
        self._started = not self._started

    def _set_zero(self, driver: Grbl, axes: str) -> None:
        self.is_off_path = self._zero_set = True
        system = zero_and_unlock.set_zero(driver, axes, self._timing)
        self._changed_s = driver.clock()
        self._tell("message", Text("zero of {axes} set in {system}", axes=axes.upper(), system=system))

    def _cancel(self, driver: Grbl, jogger: Jogger) -> None:
        self._resume_asked = self._going_back = False
        self._at_tool &= not self._started
        self._changed_s = driver.clock()
        if jogger.active or (driver.status and driver.status.state == "Jog"):
            jogger.cancel()

    def _give_up(self, error: MachineRefusal) -> None:
        command = Command("resume" if self._resume_asked else "jog")
        self._resume_asked = self._going_back = False
        self._refuse(command, error)


def _busy(what: str) -> MachineRefusal:
    return MachineRefusal("machine-busy", what, advice="wait until it is at rest, or hold it")


def _zero_kept() -> MachineRefusal:
    what = "the work zero cannot be set here: the cut behind used another one"
    return MachineRefusal("retreat-zero", what, advice="go on, or stop the job")


def _not_there() -> MachineRefusal:
    advice = "resume again, or set the zero so that the move to it is within the travel"
    return MachineRefusal("not-there", "the machine is not where the program paused", advice=advice)


def _tool_awaited() -> MachineRefusal:
    advice = "resume again; if $341 is not 0, finish the controller's own tool change first"
    return MachineRefusal("tool-change", "the controller still waits for its new tool", advice=advice)


def _power_refused(answer: Answered) -> MachineRefusal:
    what = Text("the controller refused '{sent}' (error:{error})", sent=answer.sent.text, error=answer.error)
    return MachineRefusal("power-refused", what, advice="look that the tool is off, and start the job again")
