# SPDX-License-Identifier: LGPL-2.1-or-later
"""Density and sheets of `nest`, beside spyrrow alone in the same run, on instances of strip packing.

    bench_nesting.py [FOLDER [SECONDS]]   FOLDER holds the instances as JSON; 60 s for each side of each by default

Strips: the same time, cores and seed for both; the start of the process and our own last steps count in `nest` alone.
Sheets: the strip of spyrrow alone is cut up at the sheet's length, each sheet beginning
with the first part that is left; our layer nests the same parts on the same sheets. Then a set with holes of our own.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

import shapely

from CNCStepper.job.nesting.nest_files import density_of
from CNCStepper.job.nesting.order_file import Order, read_order
from CNCStepper.job.nesting.strip_process import LATE_S, pack_strip
from CNCStepper.nesting.nest import nest
from CNCStepper.nesting.nesting_model import Budget, Item, Sheet, Spacing, placed
from CNCStepper.nesting.strips import StripPart, extents_mm, first_windows

PUBLISHED = {  # best densities in %, sparrow's own logs of 1200 s on 16 cores
    "albano": 89.8,
    "fu": 92.4,
    "jakobs1": 89.3,
    "marques": 92.0,
    "shapes0": 70.0,
    "shirts": 90.9,
    "swim": 79.8,
    "trousers": 92.6,
}
SHEET_SHARES = {"fu": 0.62, "marques": 0.45, "shirts": 0.42, "trousers": 0.8}  # a sheet's length by the strip's height
MOST_SHEETS = 24


def main(folder: Path, time_s: float) -> None:
    """Print both sides of each instance."""
    print(f"nesting, {time_s:g} s a side, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f} at the start")
    print(f"{'instance':10} {'published':>9} {'spyrrow':>8} {'nest':>8} {'of published':>12}")
    shares = []
    for name, published in PUBLISHED.items():
        order = read_order(folder / f"{name}.json")
        alone, _ = _alone(order, time_s)
        layout = nest(order.items, order.sheets, order.spacing, Budget(time_s), pack_strip)
        ours = 100.0 * density_of(order, layout)
        shares.append(ours / published)
        print(f"{name:10} {published:9.1f} {alone:8.2f} {ours:8.2f} {100.0 * ours / published:11.1f}%", flush=True)
    print(f"mean of published: {100.0 * sum(shares) / len(shares):.1f}%")
    for name, share in SHEET_SHARES.items():
        _sheets(name, read_order(folder / f"{name}.json"), share, time_s)
    _holes(time_s / 4.0)


def _alone(order: Order, time_s: float) -> tuple[float, list]:
    """Return the density in % that spyrrow alone reaches, and where its parts begin and end."""
    parts = [StripPart(n, item.outline, item.count, item.rotations_deg) for n, item in enumerate(order.items)]
    places = pack_strip(parts, order.strip_height_mm, Budget(time_s + LATE_S), 1) or []  # 48 and 12 of 60 s
    extents = extents_mm(parts, places)
    area = sum(item.outline.area * item.count for item in order.items)
    return 100.0 * area / (order.strip_height_mm * float(extents[:, :2].max())), extents  # type: ignore[return-value]


def _sheets(name: str, order: Order, share: float, time_s: float) -> None:
    length_mm = share * order.strip_height_mm
    _, extents = _alone(order, time_s)
    plate = Sheet("plate", shapely.box(0.0, 0.0, length_mm, order.strip_height_mm))
    layout = nest(order.items, (plate,) * MOST_SHEETS, order.spacing, Budget(time_s), pack_strip)
    cut = first_windows(extents, length_mm)  # type: ignore[arg-type]
    area = sum(item.outline.area * item.count for item in order.items) / plate.outline.area
    print(f"{name:10} sheets of {length_mm:g} mm: spyrrow cut up {cut}, nest {len(layout.sheets)}, area of {area:.2f}")


def _holes(time_s: float) -> None:
    """Nest frames with parts that fit into them: how many lie in holes."""
    frame = shapely.box(0, 0, 120, 120).difference(shapely.box(15, 15, 105, 105))
    bar = shapely.box(0, 0, 80, 12)
    items = (Item("frame", frame, frame, 6), Item("bar", bar, bar, 40, (0.0, 90.0)))
    sheet = Sheet("plate", shapely.box(0, 0, 500, 260))
    layout = nest(items, (sheet,) * 4, Spacing(2.0, 3.0), Budget(time_s), pack_strip)
    frames = [shapely.Polygon(placed(frame, each).exterior) for each in layout.placements if each.item == 0]
    bars = [placed(bar, each) for each in layout.placements if each.item == 1]
    within = sum(any(outer.contains(part) for outer in frames) for part in bars)
    print(f"frames: {within} of {len(bars)} bars lie in holes, {len(layout.sheets)} sheets of 4, spyrrow uses no holes")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        print("bench_nesting: without the folder of the instances (albano.json ... trousers.json) only our own set")
        _holes(15.0)
    else:
        main(Path(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else 60.0)
