# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random sheets of random parts, judged by exact geometry apart from the cycle: `helpers/cycles/sheet_judge.py`."""

from __future__ import annotations

from collections import Counter

import pytest

from CNCStepper.cycles.cycle import Answer, Setup
from CNCStepper.cycles.sheet_cutting import sheet_plan
from CNCStepper.cycles.sheet_cutting.sheet_cut import SheetCut
from CNCStepper.errors import CycleError
from CNCStepper.machine.cut_charts import CutData
from CNCStepper.machine.processes import PROCESSES
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.state import Start
from CNCStepper.toolpath import TableBuilder, Toolpath
from helpers.cycles.random_sheets import TRAITS, Sheet, random_sheet
from helpers.cycles.seeds import SEEDS
from helpers.cycles.sheet_judge import faults

DELAY_S = 0.4
LEADS = ({"kind": "line", "length_mm": 4.0}, {"kind": "arc", "radius_mm": 3.0}, None)


def setup_of(sheet: Sheet, seed: int) -> Setup:
    values = {"process": "plasma", "material": "mild-steel", "thickness_mm": 3.0, "feed_mm_min": 3000.0}
    data = CutData(**values, kerf_mm=sheet.kerf_mm, pierce_delay_s=DELAY_S, lead_in_mm=sheet.pierce_mm,
                   pierce_height_mm=3.8, cut_height_mm=1.5)  # fmt: skip
    tool = Tool(number=1, shape="jet", diameter_mm=sheet.kerf_mm, feed_mm_min=3000.0, plunge_mm_min=1000.0)
    return Setup(tool, 10.0, 2.0, sheet.outline, thickness_mm=3.0, process=PROCESSES["plasma"], cut_data=data,
                 has_z=seed % 2 == 0)  # fmt: skip


def has_tabs(seed: int) -> bool:
    return seed % 5 == 3


def cut(sheet: Sheet, seed: int) -> tuple[Toolpath, Answer] | CycleError:
    table = TableBuilder(Start())
    lead = {"lead_in": LEADS[seed % 3]} if LEADS[seed % 3] else {}
    held = {"tabs": {"count": 1 + seed % 3, "width_mm": 1.5}} if has_tabs(seed) else {}
    operation = SheetCut(curves=tuple(sheet.curves), overcut_mm=float(seed % 4 == 1), **lead, **held)
    try:
        answer = operation.cut(setup_of(sheet, seed), table)
    except CycleError as error:
        assert table.index == 0
        return error
    return table.toolpath(), answer


@pytest.mark.slow
@pytest.mark.parametrize("seed", SEEDS)
def test_nothing_touches_a_part_and_nothing_is_cut_after_it_moved(seed: int) -> None:
    sheet = random_sheet(seed)
    found = cut(sheet, seed)
    if isinstance(found, CycleError):
        assert found.code in ("lead-room", "tab-room", "tab-lead") and found.advice, found
        assert (found.code == "lead-room") <= bool(found.limit) and has_tabs(seed) >= ("tab" in found.code)
        return
    path, answer = found
    told = faults(path, sheet.curves, sheet.outline, sheet.kerf_mm, sheet.pierce_mm, DELAY_S)
    held = [f"part {number} is too large, or hangs on the sheet" for number in range(sheet.parts)]
    assert told == (held if has_tabs(seed) else []), (seed, sorted(sheet.traits))
    assert len(answer.parts) == sheet.parts


@pytest.mark.slow
def test_the_generator_has_the_hard_cases_and_few_are_refused() -> None:
    sheets = {seed: random_sheet(seed) for seed in SEEDS}
    cut_ones = [sheet for seed, sheet in sheets.items() if not isinstance(cut(sheet, seed), CycleError)]
    assert len(cut_ones) > 0.7 * len(sheets)
    tabbed = [seed for seed, sheet in sheets.items() if has_tabs(seed) and sheet in cut_ones]
    assert len(tabbed) > 0.08 * len(sheets)
    shares = Counter(trait for sheet in cut_ones for trait in sheet.traits)
    assert all(shares[trait] >= 0.1 * len(cut_ones) for trait in TRAITS), shares


@pytest.mark.slow
def test_the_judge_sees_a_wider_kerf_a_near_pierce_and_what_has_moved(monkeypatch: pytest.MonkeyPatch) -> None:
    """The same programs are judged with another kerf and distance, and made without an order."""
    sheet = random_sheet(2)
    path, _ = cut(sheet, 2)
    wider = faults(path, sheet.curves, sheet.outline, sheet.kerf_mm + 0.1, sheet.pierce_mm, DELAY_S)
    assert any("comes within" in fault for fault in wider) and any("too small" in fault for fault in wider)
    nearer = faults(path, sheet.curves, sheet.outline, sheet.kerf_mm, sheet.pierce_mm + 9.0, DELAY_S)
    assert any(fault.startswith("pierce") for fault in nearer)
    assert any("delay" in fault for fault in faults(path, sheet.curves, sheet.outline, sheet.kerf_mm, 0.0, DELAY_S + 1))
    monkeypatch.setattr(sheet_plan, "precedence", lambda *_: [])
    path, _ = cut(sheet, 2)
    told = faults(path, sheet.curves, sheet.outline, sheet.kerf_mm, sheet.pierce_mm, DELAY_S)
    assert any("free already" in fault for fault in told)
