# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool's power: followed line by line, switched off at a pause, and restored after it.

    M3S1000 | G1 ... | M5 |  the job pauses, jogs, the return     | M3S1000 | G1 ...

A beam, a torch or a jet would go on cutting where it stands, and along each jog: grbl switches a laser off in a hold,
but here it is idle. A spindle turns on at an M0, as it does on the controller; for a new tool (M6) it is stopped.

In a hold (!) the controller leaves a torch burning and a wire hot: the override that stops the spindle takes their
power, at once or after as long as the process allows. To go on they pierce or heat up again: `~` alone does not wait.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import Any

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.program.wire_line import dwell_s, is_dwell
from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.settings import LASER_MODE
from CNCStepper.gcode.syntax.words import code_pattern, packed_wire
from CNCStepper.machine.processes import PROCESSES

OFF = "M5"
_M = re.compile(code_pattern("M", r"(\d+)(?:\.0*)?"))
_S = re.compile(r"S[\d.]+")
SPINDLE_STOP = b"\x9e"  # it switches, so it is sent once a hold
SWITCHED_ON = "SC"  # in `A:` of the status
_POWER = {"3": "M3", "4": "M4", "5": "", "2": "", "30": ""}  # outputs that are on after each of these


class ToolPower:
    """The power of one controller's tool.

    cuts_standing: it cuts without turning. spin_up_s: how long it takes once it is on; one that pierces, as long
    as the program waits behind its last M3. modes: of `$G`. stand_s: how long it may stand with power in a hold.
    """

    def __init__(self, cuts_standing: bool = False, spin_up_s: float = 0.0, modes: str = "", stand_s: float = math.inf):
        self.is_taken = False  # although the program has it on
        self.is_stopped = False  # in the hold that lasts
        self._stand_s = stand_s
        self._held_s: float | None = None  # when the hold was first seen
        self._is_fresh = False  # nothing was switched or waited for since M3
        self._cuts_standing = cuts_standing
        self._spin_up_s = spin_up_s
        self._on = self._speed = ""
        for word in modes.split():
            self.follow(word)

    def follow(self, text: str) -> None:
        """Note the outputs that a sent line leaves on."""
        plain = packed_wire(text)
        self._note_wait(plain)
        for number in _M.findall(plain):
            self._on = _POWER.get(number, self._on)
        self._speed = next(iter(_S.findall(plain)), self._speed)

    def _note_wait(self, plain: str) -> None:
        """Note how long the program waits for a tool that pierces."""
        if is_dwell(plain) and self._is_fresh and self._cuts_standing and math.isfinite(self._stand_s):
            self._spin_up_s = dwell_s(plain)
        self._is_fresh = any(_POWER.get(number) for number in _M.findall(plain))

    def hold(self, driver: Grbl) -> None:
        """Switch the power off in a hold after the permitted time at rest."""
        status = driver.status
        if status is None or status.state != "Hold":
            self._held_s, self.is_stopped = None, False
            return
        if status.substate not in (0, None):  # it still moves, and cuts
            return
        now_s = driver.clock()
        self._held_s = now_s if self._held_s is None else self._held_s
        is_on = any(letter in (driver.outputs or "") for letter in SWITCHED_ON)
        if is_on and not self.is_stopped and now_s - self._held_s >= self._stand_s:
            driver.realtime(SPINDLE_STOP)
            self.is_stopped = True

    def stand(self, driver: Grbl) -> None:
        """Take its power from a tool that would cut on, as soon as the lines before are cut."""
        if self._cuts_standing:
            self.take(driver)

    def take(self, driver: Grbl) -> None:
        """Switch the tool off, where the program has it on and the controller has room for the line."""
        if self._on and not self.is_taken and driver.fits(OFF):
            driver.send(OFF)
            self.is_taken = True

    def give_back(self, driver: Grbl, text: str) -> None:
        """Switch on again what was taken, unless the line that comes next switches itself."""
        if not self.is_taken:
            return
        self.is_taken = False
        if not any(number in _POWER for number in _M.findall(packed_wire(text))):
            driver.send(self._on + self._speed)
            if self._spin_up_s:
                driver.send(f"G4P{self._spin_up_s:g}")


def power_of(job: SendJob, driver: Grbl, modes: str) -> ToolPower:
    """Return that of a job's machine: a laser by the controller's $32 or its profile, a torch or a jet by the latter.

    A profile can also require outputs that are off during the return. A laser's power needs no time.
    """
    profile: Mapping[str, Any] = job.retrace.get("machine") or {}
    spindle = profile.get("spindle") or {}
    is_laser = driver.settings.get(LASER_MODE) == 1 or bool(spindle.get("laser"))
    is_off_back = (profile.get("retreat") or {}).get("outputs") == "off"
    processes = [PROCESSES[name] for name in profile.get("processes") or ("milling",)]
    is_torch = all(process.power in ("contour", "always", "none") for process in processes)
    stand_s = min(process.stand_s for process in processes) if is_torch and not is_laser else math.inf
    spin_up_s = 0.0 if is_laser else spindle.get("spin_up_s", 0.0)
    return ToolPower(is_laser or is_off_back or math.isfinite(stand_s), spin_up_s, modes, stand_s)
