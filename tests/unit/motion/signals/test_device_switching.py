# SPDX-License-Identifier: LGPL-2.1-or-later
"""When devices are switched: a laser's beam burns in feeds alone, also where no controller puts it out."""

from __future__ import annotations

from dataclasses import replace

import pytest

from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.machine.backlash import Backlash
from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.planner.backlash_moves import motor_moves
from CNCStepper.motion.planner.buffers import TICKS_PER_S
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.signals.device_switching import Changes
from CNCStepper.motion.signals.pulse_stream import pulse_stream
from CNCStepper.state import Start
from CNCStepper.toolpath import RAPID

MACHINE = load_machine("table-a")
LIMITS = Limits.of(MACHINE)
SQUARE = "G0 X1 Y1\n{beam} S500\nG1 X5 F600\nY5\nG0 X1\nG1 Y1\nS900\nX5\nG0 X0 Y0\nM5\nM2\n"


def read(text: str):
    return interpret("G21 G90 G17 G94\n" + text, Start.at_zero(), "linuxcnc", "job.ngc")


def burning(path, laser: bool = True) -> list[tuple[str, bool]]:
    """Return for each row of a path its kind, and whether the beam is on in it; at the end it must be off."""
    changes = Changes(path.states, path.events, laser)
    made = [change for chunk in path.chunks for change in changes.of(chunk)] + changes.last()
    table, on, told = path.table(), False, []
    for row in range(len(table) + 1):
        for change in made:
            if change.row == table.first + row:
                assert change.device == "spindle_cw"
                on = change.on
        if row < len(table):
            told.append(("rapid" if table.kind[row] == RAPID else "feed", on))
    assert not on
    return told


@pytest.mark.parametrize("beam", ["M3", "M4"])
def test_a_laser_burns_in_feeds_and_in_no_rapid(beam: str) -> None:
    told = burning(read(SQUARE.format(beam=beam)))
    assert len(told) == 7 and all(on == (kind == "feed") for kind, on in told)


def test_a_spindle_goes_on_turning_in_rapids() -> None:
    assert [on for _, on in burning(read(SQUARE.format(beam="M3")), laser=False)] == [False, *[True] * 6]


@pytest.mark.parametrize("rows", [1, 2, 3])
def test_it_is_so_over_chunks_of_any_size(rows: int) -> None:
    path = read(SQUARE.format(beam="M3"))
    table = path.table()
    columns = ("kind", "end", "centre", "plane", "turns", "feed", "state", "line")
    pieces = [
        replace(table, first=table.first + k, **{name: getattr(table, name)[k : k + rows] for name in columns})
        for k in range(0, len(table), rows)
    ]
    assert burning(replace(path, chunks=pieces)) == burning(path)


def test_the_beam_is_off_while_play_is_taken_up() -> None:
    """Where the axis turns back in the cut the tool stands still, until its motor has crossed the gap."""
    first = MACHINE.axes[0].model_copy(update={"backlash_mm": 0.1, "homing": "min"})
    spindle = MACHINE.spindle.model_copy(update={"laser": True})
    machine = MACHINE.model_copy(update={"axis": MACHINE.axis | {"x": first}, "spindle": spindle})
    motors = motor_moves(read("M3 S500\nG1 X5 F600\nX1\nM5\nM2\n"), Backlash.of(machine))
    assert burning(motors) == [("feed", True), ("rapid", False), ("feed", True)]


def test_m4_is_dark_while_the_machine_dwells_and_m3_is_not() -> None:
    text = "{beam} S500\nG1 X1 F600\nG4 P2\nX2\nM5\nM2\n"

    def on_s(beam: str) -> float:
        stream = pulse_stream(read(text.format(beam=beam)), replace(LIMITS, laser=True))
        switches = [switch for chunk in stream for switch in chunk.switches]
        begun = [switch.tick for switch in switches if switch.on]
        ended = [switch.tick for switch in switches if not switch.on]
        return (sum(ended) - sum(begun)) / TICKS_PER_S

    assert on_s("M3") - on_s("M4") == pytest.approx(2, abs=0.01)


def test_the_switches_of_a_laser_are_in_its_pulses() -> None:
    stream = pulse_stream(read(SQUARE.format(beam="M4")), replace(LIMITS, laser=True))
    made = [(switch.device, switch.on) for chunk in stream for switch in chunk.switches]
    on, off = ("spindle_cw", True), ("spindle_cw", False)
    assert made == [on, off, on, on, off]  # the third one has another power
