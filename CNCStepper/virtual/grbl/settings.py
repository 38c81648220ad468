# SPDX-License-Identifier: LGPL-2.1-or-later
"""The `$` settings: made from a machine profile, listed, changed one by one, and turned back into a profile.

The board's EEPROM: settings, work systems, start-up lines, build text.

The virtual board's memory lives as long as its process; a soft reset leaves it alone, as it should.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from CNCStepper.machine.profile import AXIS_NAMES, Axis, Machine
from CNCStepper.virtual.grbl.alarms_and_errors import refused
from CNCStepper.virtual.grbl.firmware import GRBL, Firmware
from CNCStepper.virtual.grbl.gcode.block import FIRST_SYSTEM
from CNCStepper.virtual.grbl.gcode.words import f32

STEPS, RATE, ACCELERATION, TRAVEL = 100, 110, 120, 130
PULSE, IDLE_DELAY_MS, REPORT, DEVIATION, ARC_TOLERANCE, INCHES = 0, 1, 10, 11, 12, 13
SOFT_LIMITS, HARD_LIMITS, HOMING, HOMING_SIDES = 20, 21, 22, 23
HOMING_FEED, HOMING_SEEK, DEBOUNCE_MS, PULL_OFF = 24, 25, 26, 27
MAX_RPM, MIN_RPM, LASER = 30, 31, 32

BYTES = (PULSE, IDLE_DELAY_MS, 2, 3, REPORT, HOMING_SIDES, DEBOUNCE_MS)
SWITCHES = (4, 5, 6, INCHES, SOFT_LIMITS, HARD_LIMITS, HOMING, LASER)
WHOLE = (*BYTES, *SWITCHES, MAX_RPM, MIN_RPM)  # printed without decimals
ALWAYS_ON_MS = 255
REPORTS_MPOS, REPORTS_BUFFER = 1, 2  # bits of $10


def defaults(machine: Machine, homing: bool) -> dict[int, float]:
    """Return the settings that a board on this machine would hold.

    $10=3 (machine position and buffer state) so that a sender sees all there is. Homing, and with it
    the lock at power-up, is off unless asked for: a newcomer's first program runs at once.
    """
    sides = sum(1 << number for number, axis in enumerate(machine.axes) if axis.homing == "min")
    planner, spindle = machine.planner, machine.spindle
    values: dict[int, float] = {PULSE: 10, IDLE_DELAY_MS: 25, 2: 0, 3: 0, 4: 0, 5: 0, 6: 0}
    values |= {REPORT: REPORTS_MPOS | REPORTS_BUFFER}
    values |= {DEVIATION: planner.junction_deviation_mm, ARC_TOLERANCE: planner.arc_tolerance_mm, INCHES: 0}
    values |= {SOFT_LIMITS: 0, HARD_LIMITS: 0, HOMING: int(homing), HOMING_SIDES: sides}
    values |= {HOMING_FEED: 25, HOMING_SEEK: 500, DEBOUNCE_MS: 250, PULL_OFF: 1}
    values |= {MAX_RPM: spindle.max_rpm, MIN_RPM: spindle.min_rpm, LASER: int(spindle.laser)}
    for number, axis in enumerate(machine.axes):
        values[STEPS + number] = axis.steps_per_mm
        values[RATE + number] = axis.max_rate_mm_min
        values[ACCELERATION + number] = axis.acceleration_mm_s2
        values[TRAVEL + number] = axis.travel_max_mm - axis.travel_min_mm
    return {number: f32(value) for number, value in sorted(values.items())}


@dataclass
class Settings:
    """The settings of one board; `machine` is the profile that `$RST=$` goes back to."""

    machine: Machine
    homing: bool = False
    firmware: Firmware = GRBL
    values: dict[int, float] = field(init=False)

    def __post_init__(self) -> None:
        self.restore()

    def restore(self) -> None:
        """Go back to the profile's settings."""
        self.values = defaults(self.machine, self.homing)

    def __getitem__(self, number: int) -> float:
        return self.values[number]

    def on(self, number: int) -> bool:
        """Return whether a yes-or-no setting is on."""
        return bool(self.values[number])

    def reports(self, bit: int) -> bool:
        """Return whether $10 asks for a field of the status report."""
        return bool(int(self.values[REPORT]) & bit)

    def store(self, number: int, value: float) -> None:
        """Store `$number=value`; raises MachineRefusal and changes nothing where it is not allowed.

        A rate, acceleration or resolution of 0 is refused with error 4; the firmware takes it and then hangs.
        """
        if value < 0:
            raise refused(4)
        if number not in self.values:
            raise refused(3)
        whole = int(value) & 0xFF
        if number == PULSE and whole < self.firmware.shortest_pulse_us:
            raise refused(6)
        if number == SOFT_LIMITS and whole and not self.on(HOMING):
            raise refused(10)
        if value == 0 and (STEPS <= number < TRAVEL or number in (DEVIATION, ARC_TOLERANCE)):
            raise refused(4)
        self.values[number] = float(whole) if number in BYTES else float(bool(whole)) if number in SWITCHES else value
        if number == HOMING and not whole:
            self.values[SOFT_LIMITS] = 0.0

    def lines(self, shown: frozenset[int] = frozenset()) -> list[str]:
        """Return what `$$` prints, a line a setting; `shown`: only these numbers."""
        return [
            f"${number}={value:.0f}" if number in WHOLE else f"${number}={value:.3f}"
            for number, value in self.values.items()
            if not shown or number in shown
        ]

    def outside_travel(self, target_mm: list[float]) -> bool:
        """Return whether a target lies outside the machine's space, which for grbl is always 0 and below."""
        return any(not -self.values[TRAVEL + axis] <= value <= 0 for axis, value in enumerate(target_mm))

    def profile(self) -> Machine:
        """Return the machine as its settings now describe it."""
        axes = {name: self._axis(number) for number, name in enumerate(AXIS_NAMES)}
        planner = self.machine.planner.model_copy(
            update={"junction_deviation_mm": self[DEVIATION], "arc_tolerance_mm": self[ARC_TOLERANCE]}
        )
        return self.machine.model_copy(update={"axis": axes, "planner": planner})

    def _axis(self, number: int) -> Axis:
        return self.machine.axes[number].model_copy(
            update={
                "steps_per_mm": self[STEPS + number],
                "max_rate_mm_min": self[RATE + number],
                "acceleration_mm_s2": self[ACCELERATION + number],
            }
        )


def no_places(firmware: Firmware = GRBL) -> dict[int, list[float]]:
    """Return the places of a board on which nothing was stored."""
    systems = range(FIRST_SYSTEM, FIRST_SYSTEM + firmware.systems)
    return {place: [0.0, 0.0, 0.0] for place in (*systems, 28, 30)}


@dataclass
class Eeprom:
    """The board's EEPROM; `places` are G54 to G59 (G59.1 is 60), G28 and G30 by number, mm in machine coordinates."""

    settings: Settings
    firmware: Firmware = GRBL
    places: dict[int, list[float]] = field(default_factory=dict)
    startup_lines: list[str] = field(default_factory=lambda: ["", ""])
    build_text: str = ""

    def __post_init__(self) -> None:
        self.clear_places()

    def clear_places(self) -> None:
        """Forget every stored position (`$RST=#`)."""
        self.places = no_places(self.firmware)

    def clear_all(self) -> None:
        """Forget everything but what the machine profile says (`$RST=*`)."""
        self.settings.restore()
        self.clear_places()
        self.startup_lines = ["", ""]
        self.build_text = ""
