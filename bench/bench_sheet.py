# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sheet of 500 parts with 1000 holes: kerf, proven leads, order and moves, with and without the rules."""

from __future__ import annotations

import time

from CNCStepper.cycles.cycle import Setup
from CNCStepper.cycles.sheet_cutting.sheet_cut import SheetCut
from CNCStepper.geometry.curve import Curve, circle
from CNCStepper.geometry.shapes.rectangle import rectangle
from CNCStepper.machine.cut_charts import CutData
from CNCStepper.machine.processes import PROCESSES
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.state import Start
from CNCStepper.toolpath import TableBuilder

COLUMNS, ROWS = 25, 20
MOST_S, MOST_SHARE = 2.0, 0.10
TIMES = 5
PLAIN = {"small_holes": {"diameter_mm": 0.0}}
OWN: dict[str, object] = {}  # the rules of plasma itself: small holes
ALL = {"arcs": {"radius_mm": 5.0}, "corners": {"angle_deg": 60.0}, "overcut_mm": 1.0}


def sheet() -> tuple[Curve, ...]:
    """Return the outlines of plates with rounded corners and two holes each."""
    part = [rectangle((0.0, 0.0), (40.0, 30.0), 3.0), circle((10.0, 10.0), 4.0), circle((28.0, 15.0), 6.0)]
    places = [(50.0 * column, 40.0 * row) for column in range(COLUMNS) for row in range(ROWS)]
    return tuple(curve.moved(*place) for place in places for curve in part)


def setup() -> Setup:
    """Return plasma on 3 mm steel."""
    data = CutData(process="plasma", material="mild-steel", thickness_mm=3.0, feed_mm_min=3850.0, kerf_mm=1.5,
                   pierce_height_mm=3.8, pierce_delay_s=0.4, cut_height_mm=1.5, lead_in_mm=2.0)  # fmt: skip
    tool = Tool(number=1, shape="jet", diameter_mm=1.5, feed_mm_min=3850.0, plunge_mm_min=1000.0)
    return Setup(tool, 10.0, 2.0, thickness_mm=3.0, process=PROCESSES["plasma"], cut_data=data)


def seconds(curves: tuple[Curve, ...], rules: dict[str, object]) -> tuple[float, float]:
    """Return wall and processor seconds of the whole cycle."""
    operation = SheetCut(curves=curves, **rules)
    wall, cpu = time.perf_counter(), time.process_time()
    operation.cut(setup(), TableBuilder(Start()))
    return time.perf_counter() - wall, time.process_time() - cpu


def main() -> None:
    """Print the seconds, and what the rules add in processor time: other programs run beside this one."""
    curves = sheet()
    seconds(curves[:9], ALL)
    runs = [[seconds(curves, rules) for rules in (PLAIN, OWN, ALL)] for _ in range(TIMES)]
    wall = min(run[1][0] for run in runs)
    plain, own, every = (min(run[number][1] for run in runs) for number in range(3))
    print(f"sheet: {COLUMNS * ROWS} parts, {len(curves)} contours: {wall:.2f} s (processor {own:.2f} s), ", end="")
    print(f"limit {MOST_S:g} s; the rules of plasma add {own / plain - 1.0:.1%} of processor time, ", end="")
    print(f"limit {MOST_SHARE:.0%}; with arcs, corners and overcut besides {every / plain - 1.0:.1%}")


if __name__ == "__main__":
    main()
