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
from cut_programs import PROGRAMS
from cut_table import CORNERS_MM, ROUNDING_MM, STEP_MM, Cut, along_mm, path_of, polyline, worst_distance_mm

from CNCStepper.gcode.retreat.way import Place, Way
from CNCStepper.job.retreat import Held

pytestmark = pytest.mark.slow
SEEDS = range(1, 1 + max(25, int(os.environ.get("CNCSTEPPER_CASES", "25"))))
NOISE = 0.01  # of the length measured


def somewhere(held: Held, rng: random.Random) -> Place:
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

    def __init__(self, cut: Cut, way: Way, rng: random.Random, total_s: float):
        self.cut, self.way, self.rng = cut, way, rng
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
        found: list[Held] = []
        yield from self.cut.find(found)
        here_mm = along_mm(self.way, found[0].place)
        self.gone_mm += abs(here_mm - self.last_mm)
        self.last_mm, self.stands = here_mm, self.stands + 1
        assert self.gone_mm == pytest.approx(self.cut.length_mm, rel=NOISE, abs=CORNERS_MM), (
            "another pass than the one cut"
        )
        assert along_mm(self.way, found[0].found.late) - here_mm < CORNERS_MM, "one pass is taken for several"
        return found[0]


@cache
def whole(name: str) -> tuple[Way, np.ndarray, Cut, float]:
    """Return a program's way, that as points, its cut without a hold, and how long that took in s."""
    path = path_of(PROGRAMS[name])
    cut = Cut(Path(), PROGRAMS[name])
    assert cut.run(lambda: iter(())).done
    return Way(path), polyline(path), cut, cut.table.clock() - 100.0


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("name", PROGRAMS)
def test_way_back_and_forward_again_is_exact_from_any_hold(name: str, seed: int, tmp_path: Path) -> None:
    way, line, undisturbed, total_s = whole(name)
    cut = Cut(tmp_path, PROGRAMS[name])
    wanderer = Wanderer(cut, way, random.Random(f"{name} {seed}"), total_s)
    outcome = cut.run(wanderer.person)
    assert outcome.done, outcome.text
    assert not cut.refused
    assert wanderer.stands >= 2 or cut.length_mm == pytest.approx(undisturbed.length_mm, rel=NOISE)
    assert np.array_equal(cut.trace[-1], undisturbed.trace[-1])
    assert worst_distance_mm(cut.trace, line) <= STEP_MM + ROUNDING_MM
