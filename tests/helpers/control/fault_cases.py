# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs and plans of faults for a seed."""

from __future__ import annotations

from math import cos, radians, sin
from random import Random

from CNCStepper.virtual.faults.plan import KINDS, WIRE_KINDS, Fault, FaultPlan

PROGRAMS = 24
SIMULATED = KINDS
OPENING_BYTES = 20  # of the questions at the begin
HEARD_OPENING_BYTES = 1500


def program_of(seed: int) -> tuple[str, ...]:
    """Return one of the programs: one or two contours of lines and arcs, some of it incremental, some of it twice."""
    random = Random(f"program {seed % PROGRAMS}")
    dwell = ("G4P0.2",) if random.random() < 0.3 else ()
    pause = ("M0",) if random.random() < 0.2 else ()
    contours = [_contour(random, "X1.000Y1.000"), *[_contour(random, "X4.000Y2.000")] * random.choice((0, 1))]
    return (
        "G21G90G94G17",
        f"M3S{random.choice((8000, 12000))}",
        "G0Z.5",
        *contours[0],
        *dwell,
        *pause,
        *(line for contour in contours[1:] for line in contour),
        "G0X0Y0",
        "M5",
        "M2",
    )


SHIFTS = (
    ("G43.1Z-0.25", "G0Z.5"),
    ("G0Z.5", "G0X0Y0", "G92X-2Y1"),
    ("G43.1Z0.5", "G0Z.5", "G0X0Y0", "G92X2Y1Z.6"),
)


def shifted_program_of(seed: int) -> tuple[str, ...]:
    """Return such a program with a tool's length, a G92, or both: what a reset takes, and a restart must bring back."""
    lines = program_of(seed)
    up = lines.index("G0Z.5")
    return (*lines[:up], *SHIFTS[seed % len(SHIFTS)], *lines[up + 1 :])


def _contour(random: Random, begin: str) -> list[str]:
    """Return a cut from above to above, in one pass or in two that lie on each other."""
    passes = [f"G1{begin}F1500", "Z-0.5F700", *_cuts(random, begin, random.randrange(4, 14))]
    shifts = [f"G1X{random.uniform(-2, 2):.3f}Y{random.uniform(-2, 2):.3f}" for _ in range(5)]
    incremental = ["G91", *shifts, "G90"] if random.random() < 0.5 else []
    return [f"G0{begin}", *passes * random.choice((1, 1, 2)), *incremental, "G0Z.5"]


def _cuts(random: Random, begin: str, count: int) -> list[str]:
    """Return straight cuts, and full circles through the place the tool is at."""
    cuts, here = [], begin
    for _ in range(count):
        feed = random.choice(("", "", "F1500", "F4000"))
        if random.random() < 0.2:
            turn = radians(random.uniform(0, 360))
            cuts.append(f"G{random.choice((2, 3))}{here}I{1.5 * cos(turn):.3f}J{1.5 * sin(turn):.3f}{feed}")
        else:
            here = f"X{random.uniform(0, 8):.3f}Y{random.uniform(0, 8):.3f}"
            cuts.append(f"G1{here}{feed}")
    return cuts


def plan_of(seed: int, kinds: tuple[str, ...] = SIMULATED) -> FaultPlan:
    """Return one to three faults, the first of a kind that goes round with the seed."""
    random = Random(f"plan {seed}")
    count = random.choice((1, 1, 1, 2, 3))
    chosen = [kinds[seed % len(kinds)], *(random.choice(kinds) for _ in range(count - 1))]
    return FaultPlan(seed=seed, fault=tuple(_fault(kind, random) for kind in chosen))


def _fault(kind: str, random: Random) -> Fault:
    way = random.choice(("in", "out"))
    words: dict[str, object] = {"kind": kind, "way": way, "for_s": random.choice((0.05, 0.5, 3.0))}
    if kind in WIRE_KINDS:
        first, size = (OPENING_BYTES, 500) if way == "in" else (HEARD_OPENING_BYTES, 3000)
        words["at_byte"] = random.randrange(first, first + size) if random.random() < 0.9 else random.randrange(first)
        words["count"] = random.choice((1, 1, 1, 2, 5, 30)) if kind != "delay" else 1
    else:
        words["at_s"] = random.uniform(0.5, 5.0) if random.random() < 0.95 else random.uniform(0, 0.5)
        words["count"] = {"flood": random.choice((1, 20, 400)), "withhold": random.choice((1, 1, 2))}.get(kind, 1)
        words["code"] = random.choice((1, 2))
        words["when"] = random.choice(("any", "motion", "rest"))
    return Fault(**words)  # type: ignore[arg-type]
