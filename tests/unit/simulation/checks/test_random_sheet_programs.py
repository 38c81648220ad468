# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs of random sheets are clean, and each is refused once a single thing of one cut is spoilt."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
import pytest
import shapely

from CNCStepper.cycles.cycle import Setup
from CNCStepper.cycles.sheet_cutting.sheet_cut import SheetCut
from CNCStepper.errors import CycleError
from CNCStepper.gcode.dialects import dialect
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.writer.write import WriteOptions, write
from CNCStepper.machine.profile import load_machine
from CNCStepper.simulation.stock import Stock
from CNCStepper.state import Start
from CNCStepper.toolpath import TableBuilder
from helpers.cycles.random_sheets import random_sheet
from helpers.cycles.seeds import SEEDS
from helpers.simulation.torch_programs import DATA, Cut, Plate, beam, cuts_of, text_of

TORCH = load_machine("torch-table")
START = Start.with_work_zero((-1100.0, -1100.0, -50.0))
LEAST = 0.7  # of the seeds give a program; the others have no room for a lead
MUTATIONS = ("no M5", "no G4", "behind its outline", "lead into the part", "pierce on the part")


@dataclass(frozen=True)
class Made:
    """A program of a random sheet: its text, its cuts with all words written, and what it is checked against."""

    text: str
    cuts: list[Cut]
    plate: Plate


@cache
def made(seed: int) -> Made | None:
    """Return a sheet's program by `sheet_cut`; None where the cycle refuses the sheet."""
    sheet = random_sheet(seed)
    box = np.array(sheet.outline.box_mm)
    low, high = box[:2], box[2:]
    curves = tuple(curve.moved(*(-low)) for curve in sheet.curves)
    kerf = {"kerf_mm": sheet.kerf_mm, "lead_in_mm": sheet.pierce_mm}
    data, tool = DATA.model_copy(update=kerf), beam(kerf_mm=sheet.kerf_mm)
    tool = tool.model_copy(update={"feed_mm_min": DATA.feed_mm_min, "plunge_mm_min": 500.0})
    plate = Plate(machine=TORCH, data=data, stock=Stock((*(high - low), 3.0), "top-left-front"))
    outline = sheet.outline.moved(*(-low))
    setup = Setup(tool, 10.0, 2.0, outline, thickness_mm=3.0, process=plate.process, cut_data=data, power_s=1000.0)
    table = TableBuilder(Start())
    try:
        answer = SheetCut(curves=curves, lead_in={"kind": "line", "length_mm": 4.0}).cut(setup, table)
    except CycleError:
        return None
    text = write(table.toolpath(), dialect("grbl"), WriteOptions())
    plate = replace(plate, parts=answer.parts, start=START, tool=tool)
    return Made(text, cuts_of(interpret(text, START)), plate)


def spoilt(program: Made, mutation: str, rng: np.random.Generator) -> list[Cut] | None:
    """Return the cuts with one thing wrong; None where the program has no cut with which that can be."""
    cuts = list(program.cuts)
    at = int(rng.integers(len(cuts)))
    if mutation == "no M5":
        if len(cuts) < 2:
            return None
        at = min(at, len(cuts) - 2)  # behind the last one the program's own M5 stands
        cuts[at] = replace(cuts[at], off="")
        return cuts
    if mutation == "no G4":
        cuts[at] = replace(cuts[at], delay="")
        return cuts
    if mutation == "behind its outline":
        return _moved_behind(program, rng)
    return _into_part(program, cuts, at, mutation)


def _moved_behind(program: Made, rng: np.random.Generator) -> list[Cut] | None:
    """Return the cuts with a hole moved behind the outline round it."""
    shapes = [shapely.Polygon(part.exterior) for part in program.plate.parts]
    pairs = []
    for number, cut in enumerate(program.cuts):
        round_it = [k for k, shape in enumerate(shapes) if shape.contains(shapely.Point(cut.pierce_mm))]
        if round_it:
            smallest = shapes[min(round_it, key=lambda k: shapes[k].area)]
            behind = [k for k in range(number + 1, len(program.cuts)) if _goes_round(program.cuts[k], smallest)]
            pairs += [(number, behind[0])] if behind else []
    if not pairs:
        return None
    hole, outline = pairs[int(rng.integers(len(pairs)))]
    order = [k for k in range(len(program.cuts)) if k != hole]
    order.insert(order.index(outline) + 1, hole)
    return [program.cuts[k] for k in order]


def _goes_round(cut: Cut, shape: shapely.Polygon) -> bool:
    """Return whether a cut begins beside a shape and leads in to within a kerf of its edge."""
    first = shapely.Point(_target(cut.blocks[0]))
    return not shape.contains(shapely.Point(cut.pierce_mm)) and shape.exterior.distance(first) < 1.6


def _into_part(program: Made, cuts: list[Cut], at: int, mutation: str) -> list[Cut] | None:
    """Return the cuts with one lead turned to the other side of its contour, or pierced in the middle of a part."""
    cut, parts = cuts[at], shapely.union_all(list(program.plate.parts))
    if mutation == "pierce on the part":
        part = program.plate.parts[at % len(program.plate.parts)].representative_point()
        cuts[at] = replace(cut, pierce_mm=(part.x, part.y))
        return cuts
    for number in [*range(at, len(cuts)), *range(at)]:
        cut = cuts[number]
        onto, begin = np.array(_target(cut.blocks[0])), np.array(cut.pierce_mm)
        turned = onto + (onto - begin)
        if cut.blocks[0].startswith("G1") and parts.contains(shapely.Point(turned)):
            cuts[number] = replace(cut, pierce_mm=tuple(turned.tolist()))
            return cuts
    return None


def _target(block: str) -> tuple[float, float]:
    words = {word[0]: float(word[1:]) for word in block.split()[1:]}
    return words["X"], words["Y"]


@pytest.mark.slow
@pytest.mark.parametrize("seed", SEEDS)
def test_a_clean_program_passes_and_a_spoilt_one_is_refused(seed: int) -> None:
    program = made(seed)
    if program is None:
        return
    assert program.plate.codes(program.text) == set()
    assert program.plate.codes(text_of(program.cuts)) == set()
    rng = np.random.default_rng(seed)
    for mutation in MUTATIONS:
        cuts = spoilt(program, mutation, rng)
        if cuts is not None:
            assert program.plate.codes(text_of(cuts)) & CODES[mutation], (seed, mutation)


CODES = {
    "no M5": {"rapid-in-stock"},
    "no G4": {"pierce-delay"},
    "behind its outline": {"piece-free"},
    "lead into the part": {"pierce-on-part", "cut-in-part"},
    "pierce on the part": {"pierce-on-part"},
}


@pytest.mark.slow
def test_the_generator_makes_every_mutation_often_enough() -> None:
    programs = [(seed, program) for seed in SEEDS if (program := made(seed)) is not None]
    assert len(programs) > LEAST * len(SEEDS)
    had = Counter(
        mutation
        for seed, program in programs
        for mutation in MUTATIONS
        if spoilt(program, mutation, np.random.default_rng(seed)) is not None
    )
    assert all(had[mutation] >= 0.5 * len(programs) for mutation in MUTATIONS), had
