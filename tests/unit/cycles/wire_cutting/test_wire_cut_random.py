# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random sheets of random parts, cut with the wire and judged by exact geometry, apart from the cycle."""

from __future__ import annotations

from collections import Counter
from functools import cache

import numpy as np
import pytest
from shapely import Polygon

from CNCStepper.cycles.cycle import Answer, Setup
from CNCStepper.cycles.wire_cutting.wire_cut import WireCut
from CNCStepper.errors import CycleError
from CNCStepper.machine.processes import PROCESSES
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.state import Start, State
from CNCStepper.toolpath import TableBuilder, Toolpath
from helpers.cycles.random_wire_sheets import LAYOUTS, Sheet, random_wire_sheet
from helpers.cycles.seeds import SEEDS
from helpers.cycles.wire_judge import (
    crosses_nowhere,
    cut_whole,
    holes_while_it_hangs,
    in_one_way,
    keeps_off,
    path_of,
    sweeps,
)

TOLERANCE_MM = 0.01
REFUSED = 0.1  # of the cases at most: parts too close for any way


def operation(seed: int, sheet: Sheet) -> WireCut:
    rng = np.random.default_rng(seed + 10_000)
    return WireCut(
        tool=1,
        curves=sheet.curves,
        entry_slit=sheet.layout == "nested",
        enter_from=str(rng.choice(["nearest", "left", "right", "front", "back"])),  # type: ignore[arg-type]
        leave=str(rng.choice(["back", "edge"])),  # type: ignore[arg-type]
        corner_dwell_s=float(rng.choice([0.0, 0.4])),
        corner_distance_mm=float(rng.choice([0.0, 3.0])),
        tolerance_mm=TOLERANCE_MM,
    )


def setup_of(sheet: Sheet) -> Setup:
    tool = Tool(number=1, shape="wire", diameter_mm=sheet.kerf_mm, feed_mm_min=300, plunge_mm_min=300)
    return Setup(tool, 10, 2, sheet.outline, thickness_mm=40.0, process=PROCESSES["hot-wire"], has_z=False)


@cache
def made(seed: int) -> tuple[Sheet, WireCut, Toolpath, Answer] | CycleError:
    sheet = random_wire_sheet(seed)
    cycle, table = operation(seed, sheet), TableBuilder(Start(), State())
    try:
        answer = cycle.cut(setup_of(sheet), table)
    except CycleError as error:
        return error
    return sheet, cycle, table.toolpath(), answer


@pytest.mark.slow
@pytest.mark.parametrize("seed", SEEDS)
def test_the_wire_cuts_every_part_whole_in_one_way(seed: int) -> None:
    case = made(seed)
    if isinstance(case, CycleError):
        assert case.code in ("wire-way", "wire-slit"), str(case)
        return
    sheet, cycle, path, answer = case
    outline, wire = Polygon(sheet.outline.points(0.001)), path_of(path)
    in_one_way(path, outline, sheet.kerf_mm / 2.0)
    keeps_off(wire, sheet, TOLERANCE_MM)
    crosses_nowhere(wire)
    cut_whole(wire, sheet, answer, outline, TOLERANCE_MM)
    holes_while_it_hangs(wire, answer, outline)
    sweeps(wire, sheet, answer, outline)
    assert wire.slit.any() == (cycle.entry_slit and len(sheet.outer) > len(answer.parts))
    if cycle.leave == "back":
        assert np.allclose(wire.points[0], wire.points[-1])


def test_the_sheets_have_all_that_is_hard() -> None:
    shares: Counter[str] = Counter()
    for seed in SEEDS:
        case = made(seed)
        if isinstance(case, CycleError):
            shares["refused"] += 1
            continue
        sheet, cycle, path, answer = case
        shares[sheet.layout] += 1
        shares["several parts"] += len(answer.parts) > 2
        shares["tight"] += sheet.tight > 0
        shares["at the edge"] += sheet.at_edge > 0
        shares["slits"] += any(span.kind == "slit" for span in path.spans)
        shares["lines"] += bool(sheet.lines)
        shares["out at an edge"] += cycle.leave == "edge"
        shares["dwells"] += answer.figures["corner_dwells"] > 0
        shares["slow corners"] += answer.figures["corner_slow_mm"] > 0
        shares["ways back"] += sum(span.kind == "link" for span in path.spans) > 3
    print(dict(shares))
    assert shares["refused"] <= REFUSED * len(SEEDS)
    least = dict.fromkeys(LAYOUTS, 0.12) | {"several parts": 0.8, "tight": 0.25, "at the edge": 0.2, "slits": 0.12}
    least |= {"lines": 0.12, "out at an edge": 0.3, "dwells": 0.2, "slow corners": 0.2, "ways back": 0.5}
    assert {name: share for name, share in least.items() if shares[name] < share * len(SEEDS)} == {}
