# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mini-lathe's controller at the virtual lathe, which knows nothing of it."""

from __future__ import annotations

import random

import pytest

from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.virtual.lathe.machine import Mode
from helpers.controllers.lathe_twin import LatheAtTwin

PUBLISHED = {
    "rapids": "N30 G00 X-10. # N40 Z-50. # N50 X5000 Z50. #\nM02 #\n",
    "feeds": "N30 G01X-10. F1. # N40 Z-50. # N50 X5000 Z50. F2500 #\nM02 #\n",
    "absolute": "G90#\nG00 X5. Z8. # X3. #\nG01 Z-1. F1. #\nG91#\nG01 X-.5 Z-.25 F.5 #\n",
    "inches": "G71#\nG00X-.1Z.2#\nG70#\nG21#\nG01X-4.F2.#\n",
}


@pytest.mark.parametrize("program", PUBLISHED.values(), ids=PUBLISHED)
def test_published_records_end_where_they_are_reckoned_to_end(program: str) -> None:
    bench = LatheAtTwin()
    for line in prepare(program, "mini-lathe").lines:
        bench.send(f"{line}\n")
    bench.finish()
    assert not bench.twin.moving and bench.twin.refused == [] and bench.twin.buffer.lost == 0
    assert bench.board.places_mm[::2] == pytest.approx(bench.twin.places_mm) and "error" not in bench.said
    assert bench.twin.mode is (Mode.ENDED if "M02" in program else Mode.AUTOMATIC)
    assert bench.sent.startswith(b"YG") and bench.sent.endswith(b"#?")


def test_random_records_are_reckoned_step_for_step_and_the_buffer_never_fills() -> None:
    seed = random.randrange(10**9)
    print("seed", seed)
    dice = random.Random(seed)
    bench = LatheAtTwin()
    kinds = set()
    for _ in range(60):
        way = "".join(f"{axis}{dice.uniform(-2, 2):.4f}" for axis in dice.choice(("X", "Z", "XZ")))
        record = dice.choice((f"G00{way}#", f"G01{way}F{dice.choice((0.4, 1.0, 2.0))}#"))
        kinds.add((record[:3], "X" in way, "Z" in way))
        bench.send(f"{record}\n")
    bench.finish()
    assert len(kinds) == 6 and bench.twin.refused == [] and bench.twin.buffer.lost == 0
    assert bench.board.places_mm[::2] == pytest.approx(bench.twin.places_mm) and not bench.twin.moving


@pytest.mark.parametrize(("line", "steps"), [("X-1.5F120", 0), ("Z2F60", 0), ("X3F1400", 4), ("Z-.1F1400", 4)])
def test_jogs_go_their_way(line: str, steps: int) -> None:
    bench = LatheAtTwin()
    bench.send(f"$J=G91{line}\n", 0.05)
    bench.finish()
    bench.wait(0.2)
    assert not bench.twin.moving and bench.twin.mode is Mode.MANUAL
    axis = 0 if line[0] == "X" else 1
    wanted, there = float(line[1 : line.index("F")]), bench.twin.places_mm[axis]
    assert there == pytest.approx(wanted, abs=(steps + 0.5) / 80)
    assert bench.board.places_mm[2 * axis] == pytest.approx(there, abs=(steps + 0.5) / 80)


def test_zero_by_hand_and_a_program_from_there() -> None:
    bench = LatheAtTwin()
    bench.send("$J=G91X-2F120\n$J=G91Z1F120\n", 0.05)
    bench.finish()
    bench.send("G10L20P1X0Z0\nG90#\nG00X1.Z-1.#\n", 0.1)
    bench.finish()
    assert bench.twin.places_mm == pytest.approx((-1.0, 0.0)) and bench.board.places_mm == pytest.approx((-1, 0, 0))


def test_what_a_hold_leaves_is_cut_and_no_more() -> None:
    bench = LatheAtTwin()
    for _ in range(12):
        bench.send("G01X-.5F1.#\n")
    bench.wait(1.0)
    bench.send("!", 4.0)
    assert bench.board.state == "Hold:0" and not bench.twin.moving
    assert bench.board.places_mm[0] == pytest.approx(bench.twin.places_mm[0]) and -3.5 <= bench.twin.places_mm[0] < -1.0
    bench.send("~", 0.1)
    bench.finish()
    assert bench.twin.places_mm[0] == -6.0
