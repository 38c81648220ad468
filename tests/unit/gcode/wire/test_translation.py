# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs in another language than their controller's: the lines sent lead along the program's own path."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.wire.translation import ROUNDED_END_MM, TranslatedFile, translate
from CNCStepper.machine.backlash import Backlash
from CNCStepper.motion.planner.backlash_moves import tool_moves
from CNCStepper.state import Start
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, RAPID, join_chunks

THESIS = "thesis-a:z=none,spindle=always,feed=900"
FLAT = "grbl:z=none,spindle=switch,feed=900,outputs=pins"
PINS = "grbl:outputs=pins"
PROGRAM_1 = (  # of the published test part 1
    "g90\ny-80\nG2 x-80 y0 i0 j0\nG90\nx-160 y0\nG2 x0 y160 i0 j0\nG90\ny80\nG2 x80 y0 i0 j0\nG90\nx160\n"
    "G2 x0 y-160 i0 j0\ng90\ny-80\n"
)


def test_published_program_becomes_lines_of_grbl_with_the_lines_of_the_file() -> None:
    wire, path = translate(PROGRAM_1, THESIS, FLAT)
    assert tuple(wire.lines) == (
        "G17G21G90G94G54", "M3", "G1Y-80F900", "G2X-80Y0I0J80", "G1X-160", "G2X0Y160I160J0", "G1Y80", "G2X80Y0I0J-80",
        "G1X160", "G2X0Y-160I-160J0", "G1Y-80", "M2",
    )  # fmt: skip
    assert wire.file_lines.tolist() == [2, 2, 2, 3, 5, 6, 8, 9, 11, 12, 14, 14]
    assert path.table().line.tolist() == [2, 3, 5, 6, 8, 9, 11, 12, 14]


def test_feed_of_the_machine_and_incremental_mode_go_over_the_wire_as_places() -> None:
    wire, _ = translate("G0\nX15 Y10\nG91\nX20\nX-10 Y7\nX-10 Y-7\n", "thesis-a:feed=300", "grbl:outputs=pins")
    assert tuple(wire.lines)[1:-1] == ("G0X15Y10", "G1X35F300", "G1X25Y17", "G1X15Y10")


def test_what_happens_between_moves_is_sent_in_its_place() -> None:
    text = "G21 G90 G54\nM64 P1\nG0 X5\nM3 S500\nG4 P0.5\nM8\n(MSG,look)\nG1 X6 F100\nM0\nM5 M9\nM65 P1\nG0 X0\nM2\n"
    wire, _ = translate(text, "linuxcnc", PINS, start=Start.at_zero())
    assert tuple(wire.lines) == (
        "G17G21G90G94G54", "M64P1", "G0X5", "M3S500", "G4P0.5", "M8", "G1X6F100", "M0", "M5", "M9", "M65P1", "G0X0",
        "M2",
    )  # fmt: skip
    assert wire.messages == {6: "look"} or wire.messages == {5: "look"}


@pytest.mark.parametrize(
    ("line", "code"),
    [("M66 P0 L0", "translate-event"), ("M68 E0 Q1", "translate-event"), ("G38.2 Z-5 F10", "translate-event"),
     ("G2 X0 Y0 I5 J0 P2 F9", "translate-turns"), ("G10 L2 P1 X5\nG0 X1", "translate-zero")],
)  # fmt: skip
def test_what_no_controller_of_ours_does_is_refused_with_its_line(line: str, code: str) -> None:
    with pytest.raises(ProgramError) as refusal:
        translate(f"G21\nG0 X0 Y0 Z0\n{line}\nG0 X9\nM2\n", "linuxcnc", PINS, "part.ngc", Start.at_zero())
    assert refusal.value.code == code and refusal.value.place and refusal.value.place.line >= 3


def random_program(rng: random.Random) -> str:
    """Return a thesis program of rapids, cuts, arcs of every size, some of them full or tiny."""
    lines, x, y = ["G0", "X0 Y0"], 0.0, 0.0
    for _ in range(40):
        kind = rng.choice("GLIAAFT")
        if kind in "GL":
            x, y = (round(rng.uniform(-300, 300), 3) for _ in "xy")
            lines += [("G0" if kind == "G" else "G90"), f"X{x} Y{y}"]
        elif kind == "I":
            dx, dy = (round(rng.uniform(-5, 5), 4) for _ in "xy")
            lines += ["G91", f"X{dx} Y{dy}", "G90"]
            x, y = round(x + dx, 6), round(y + dy, 6)
        else:
            radius = 10.0 ** rng.uniform(-1, 2.4)
            begin = rng.uniform(0, math.tau)
            cx, cy = x - radius * math.cos(begin), y - radius * math.sin(begin)
            sweep = math.tau if kind == "F" else rng.uniform(1e-4, 2e-3) if kind == "T" else rng.uniform(0.01, 6.2)
            sense = rng.choice((-1, 1))
            if kind != "F":
                x, y = cx + radius * math.cos(begin + sense * sweep), cy + radius * math.sin(begin + sense * sweep)
            lines += [f"{'G3' if sense > 0 else 'G2'} X{x:.6f} Y{y:.6f} I{cx:.6f} J{cy:.6f}", "G90"]
            x, y = round(x, 6), round(y, 6)
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize("seed", range(25))
def test_random_programs_lead_the_same_way(seed: int) -> None:
    text = random_program(random.Random(seed))
    print(f"seed {seed}")
    own = interpret(text, None, THESIS).table()
    assert {RAPID, LINE, ARC_CW, ARC_CCW} <= set(own.kind.tolist()), "the generator must make every kind of row"
    assert (np.diff(own.end, axis=0) == 0).all(axis=1).any() or seed > 5 or "F" in text
    wire, path = translate(text, THESIS, FLAT)
    again = interpret(wire.text, path.start, FLAT).table()
    assert np.abs(again.end - own.end).max() <= ROUNDED_END_MM
    assert np.array_equal(path.table().end, again.end), "what is planned is what the wire says"
    assert np.array_equal(path.table().line, own.line)
    assert all(len(line) < 80 for line in wire.lines)


def test_work_zero_of_the_start_stays_that_of_the_wire() -> None:
    start = Start.with_work_zero((100.0, 50.0, 0.0))
    wire, path = translate("G21\nG0 X1 Y2 Z3\nG92 X0\nG0 X5\nM2\n", "linuxcnc", PINS, start=start)
    assert tuple(wire.lines)[1:-1] == ("G0X1Y2Z3", "G0X6")
    assert path.table().end[-1].tolist() == [106.0, 52.0, 3.0]


def test_file_read_piece_by_piece_gives_what_the_whole_text_gives(tmp_path) -> None:
    text = random_program(random.Random(7)) * 30
    whole_wire, whole = translate(text, THESIS, FLAT)
    program = tmp_path / "part.nc"
    program.write_text(text)
    lines: list[str] = []
    reading = TranslatedFile(program, None, THESIS, FLAT, sink=lambda wire: lines.extend(wire.lines))
    table = join_chunks(list(reading.chunks()))
    assert tuple(lines) == tuple(whole_wire.lines) and reading.sha256 == whole_wire.sha256
    assert reading.count == len(lines) and np.array_equal(table.end, whole.table().end)


PLAY = Backlash((0.3, 0.2, 0.0), (-1, -1, -1), (40.0, 40.0, 40.0))
WITH_EVENTS = "G21 G90\nG0 X0 Y0\n(Operation: edge)\nG1 X9 F300\nM0\nG1 X2 Y4\nG4 P0.5\nG2 X2 Y0 I0 J-2\nG1 X5\nM2\n"


@pytest.mark.parametrize(("text", "source"), [(random_program(random.Random(3)), THESIS), (WITH_EVENTS, "linuxcnc")])
def test_backlash_is_compensated_in_the_lines_sent_and_the_tool_goes_the_programs_way(
    text: str, source: str, tmp_path
) -> None:
    target = FLAT if source == THESIS else PINS
    start = Start.at_zero()
    own = interpret(text, start, source).table()
    wire, motors = translate(text, source, target, start=start, play=PLAY)
    again = interpret(wire.text, start, target).table()
    assert len(again) > len(own) and np.array_equal(motors.table().end, again.end)
    tool = tool_moves(motors, PLAY)
    lasts = np.array([np.flatnonzero(motors.table().line <= line)[-1] for line in own.line])
    assert np.abs(tool.table().end[lasts][:, :2] - own.end[:, :2]).max() < 1 / 40
    program = tmp_path / "part.nc"
    program.write_text(text)
    lines: list[str] = []
    reading = TranslatedFile(program, start, source, target, PLAY, sink=lambda wire: lines.extend(wire.lines))
    rows, events = [], []
    for chunk in reading.chunks():
        rows.append(chunk)
        events += reading.take_events()
    events += reading.take_events()
    assert tuple(lines) == tuple(wire.lines) and np.array_equal(join_chunks(rows).end, again.end)
    assert events == motors.events
    if source != THESIS:
        kinds = {event.kind: event.index for event in motors.events}
        assert motors.table().line[kinds["pause"]] == 6 and motors.table().line[kinds["dwell"]] == 8
