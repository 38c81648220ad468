# SPDX-License-Identifier: LGPL-2.1-or-later
"""From random holds back along the cut and forward again, judged by the machine's own trace.

25 cases a program, each with a hold at least; 500 in `make soak`.
"""

from __future__ import annotations

import os
import random
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.gcode.wire.backlash_compensation import backlash_of
from CNCStepper.recovery.retract.path_retract import HeldProgram
from CNCStepper.recovery.retract.places_on_path import Place
from helpers.control.retract_bench import (
    CORNERS_MM,
    ROUNDING_MM,
    STEP_MM,
    Cut,
    along_mm,
    loose_table,
    path_of,
    polyline,
    worst_distance_mm,
)
from helpers.control.retract_programs import PROGRAMS

pytestmark = pytest.mark.slow
CASES = int(os.environ.get("CNCSTEPPER_CASES", "25"))
SEEDS, LOOSE_SEEDS = range(1, 1 + max(25, CASES)), range(1, 1 + max(5, CASES // 5))
END_MM = 0.013  # a step of X or Y
NOISE = 0.01  # of the length measured


def somewhere(held: HeldProgram, rng: random.Random) -> Place:
    """Return where a person may want to go."""
    lines = [held.file_line(Place(row, 0.0)) for row in range(held.way.begin_before(held.place), held.place.row + 1)]
    return rng.choice(
        [
            lambda: held.back_by(rng.uniform(0.05, 25.0)),
            lambda: held.back_to_line(rng.choice(lines)),
            held.back_to_entry,
            held.forward_by,
            lambda: held.forward_by(rng.uniform(0.05, 10.0)),
        ]
    )()


class Wanderer:
    """Holds now and then, goes back and forth along the cut, and in the end lets the job go on.

    gone_mm: how far the machine should have gone by what is known of its places.
    """

    def __init__(self, cut: Cut, rng: random.Random, total_s: float):
        self.cut, self.rng = cut, rng
        self.total_s = total_s
        self.gone_mm = self.last_mm = 0.0
        self.stands = 0

    def person(self):
        for _ in range(self.rng.choice((1, 1, 2))):
            yield self.rng.uniform(0.05, self.total_s)
            if self.cut.phase != "done":
                yield from self.cut.hold()
            if self.cut.phase == "done":
                return
            for _ in range(self.rng.randint(1, 3)):
                yield from self.wander()
            held = yield from self.find()
            yield from self.cut.go(held.rest())

    def wander(self):
        held = yield from self.find()
        target = somewhere(held, self.rng)
        yield from self.cut.go(held.along(target))
        if self.rng.random() < 0.3:
            yield self.rng.uniform(0.0, 4.0)  # the spindle comes up, then the way is held half done
            yield from self.cut.hold()
        yield self.cut.arrived

    def find(self):
        """Return what a client finds, and compare it with how far the axes have gone."""
        found: list[HeldProgram] = []
        yield from self.cut.find(found)
        way = found[0].way
        here_mm = along_mm(way, found[0].place)
        self.gone_mm += abs(here_mm - self.last_mm)
        self.last_mm, self.stands = here_mm, self.stands + 1
        assert self.gone_mm == pytest.approx(self.cut.length_mm, rel=NOISE, abs=CORNERS_MM), (
            "another pass than the one cut"
        )
        assert along_mm(way, found[0].found.late) - here_mm < CORNERS_MM, "one pass is taken for several"
        return found[0]


@cache
def whole(name: str) -> tuple[np.ndarray, Cut, float]:
    """Return a program's way as points, its cut without a hold, and how long that took in s."""
    cut = Cut(Path(), PROGRAMS[name])
    assert cut.run(lambda: iter(())).done
    return polyline(path_of(PROGRAMS[name])), cut, cut.table.clock() - 100.0


def wandered(cut: Cut, name: str, rng: random.Random) -> None:
    """Let somebody wander along the cut of a program, and judge where the tool was."""
    line, undisturbed, total_s = whole(name)
    wanderer = Wanderer(cut, rng, total_s)
    outcome = cut.run(wanderer.person)
    assert outcome.done, outcome.text
    assert not cut.refused
    assert wanderer.stands >= 2 or cut.length_mm == pytest.approx(undisturbed.length_mm, rel=NOISE)
    worst_mm = worst_distance_mm(cut.trace, line)
    print(f"{wanderer.stands} stands, {worst_mm:.4f} mm")
    assert worst_mm <= STEP_MM + ROUNDING_MM
    assert np.allclose(
        cut.trace[-1], undisturbed.trace[-1], rtol=0.0, atol=END_MM if backlash_of(cut.machine, "grbl") else 0.0
    )


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("name", PROGRAMS)
def test_way_back_and_forward_again_is_exact_from_any_hold(name: str, seed: int, tmp_path: Path) -> None:
    wandered(Cut(tmp_path, PROGRAMS[name]), name, random.Random(f"{name} {seed}"))


@pytest.mark.parametrize("seed", LOOSE_SEEDS)
@pytest.mark.parametrize("name", PROGRAMS)
def test_tool_of_loose_axes_goes_the_same_way_back_and_forward_again(name: str, seed: int, tmp_path: Path) -> None:
    rng = random.Random(f"loose {name} {seed}")
    wandered(Cut(tmp_path, PROGRAMS[name], loose_table(rng)), name, rng)
