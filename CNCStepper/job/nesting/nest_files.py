# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a nested order: a drawing of each sheet, remnants as drawings, placements as JSON, a picture.

sheet-0.dxf          the parts' chains on their layers, the rim of the sheet on SHEET, common lines on COMMON
remnant-0-0.dxf      what is left of a sheet in one piece, ready to be a sheet of the next order
placements.json      [{"sheet": 0, "item": 2, "x": 10.0, "y": 5.0, "rotation_deg": 90.0}, ...]
nest.png             all sheets that are used
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np
import shapely
from shapely import Polygon

from CNCStepper.atomic_file import write_whole
from CNCStepper.drawing.drawing import Attributes, Chain, Drawing
from CNCStepper.drawing.writers.dxf_writer import dxf_bytes
from CNCStepper.geometry.curve import from_points
from CNCStepper.job.nesting.order_file import Order
from CNCStepper.job.nesting.shared_cuts import block_chains, on_sheet, part_chains, shared_cuts
from CNCStepper.nesting.common_lines import CommonCuts
from CNCStepper.nesting.nesting_model import Layout, Placement, placed

FILES = {  # names that are written, and what they are by output_files.py
    r"sheet-\d+\.dxf": "drawing",
    r"remnant-\d+-\d+\.dxf": "drawing",
    r"placements\.json": "placements",
    r"nest\.png": "picture",
}
SHEET = Attributes(layer="SHEET")
SLIVER_MM = 5.0  # half the width below which a remnant is scrap
LEAST_REMNANT = 0.02  # of the sheet's area
CHORD_MM = 0.05


def density_of(order: Order, layout: Layout) -> float:
    """Return the parts' area by that of the sheets used; of a strip: by its length used times its height."""
    if not layout.placements:
        return 0.0
    area = sum(order.items[placement.item].exact.area for placement in layout.placements)
    if order.strip_height_mm:
        return area / (order.strip_height_mm * strip_length_mm(order, layout))
    return area / sum(order.sheets[number].outline.area for number in layout.sheets)


def strip_length_mm(order: Order, layout: Layout) -> float:
    """Return how much of a strip is used: from its begin to the end of the last part and its margin."""
    ends = [placed(order.items[each.item].exact, each).bounds[2] for each in layout.placements]
    return max(ends, default=0.0) + order.spacing.margin_mm


def write_nest(
    order: Order, layout: Layout, folder: Path, shared: Mapping[int, CommonCuts] | None = None
) -> list[Path]:
    """Write all files of a layout into a folder; return their paths, the sheets first.

    shared: the common lines of each sheet, where they are known.
    """
    from CNCStepper.job.nesting.nest_picture import save_nest_picture  # a third of the start of a worker

    folder.mkdir(parents=True, exist_ok=True)
    shared = shared_cuts(order, layout) if shared is None else shared
    paths = []
    for number in layout.sheets:
        paths.append(folder / f"sheet-{number}.dxf")
        write_whole(paths[-1], dxf_bytes(sheet_drawing(order, layout, number, shared.get(number))))
        for count, remnant in enumerate(remnants(order, layout, number)):
            paths.append(folder / f"remnant-{number}-{count}.dxf")
            write_whole(paths[-1], dxf_bytes(remnant_drawing(remnant)))
    paths.append(folder / "placements.json")
    write_whole(paths[-1], placements_json(layout).encode("utf-8"))
    paths.append(folder / "nest.png")
    save_nest_picture(paths[-1], order, layout, density_of(order, layout), shared)
    return paths


def placements_json(layout: Layout) -> str:
    """Return the placements as JSON, a line each."""
    rows = [json.dumps(_row(placement)) for placement in sorted(layout.placements)]
    return "[\n" + ",\n".join(rows) + "\n]\n" if rows else "[]\n"


def _row(placement: Placement) -> dict[str, float]:
    return {
        "sheet": placement.sheet,
        "item": placement.item,
        "x": placement.x_mm,
        "y": placement.y_mm,
        "rotation_deg": placement.rotation_deg,
    }


def used_outline(order: Order, layout: Layout, number: int) -> Polygon:
    """Return the outline of a sheet; of a strip only as long as it is used."""
    if not order.strip_height_mm:
        return order.sheets[number].outline
    return shapely.box(0.0, 0.0, strip_length_mm(order, layout), order.strip_height_mm)


def sheet_drawing(order: Order, layout: Layout, number: int, cuts: CommonCuts | None = None) -> Drawing:
    """Return the drawing of a sheet: its rim, and the chains of its parts; cuts: what the parts share."""
    cuts, lie = cuts or CommonCuts(), on_sheet(layout, number)
    rim = _rings(used_outline(order, layout, number))
    chains = (*rim, *part_chains(order, lie, cuts), *block_chains(order, lie, cuts))
    return Drawing(chains, kerf_mm=order.kerf_mm if cuts.blocks else None)


def remnant_drawing(remnant: Polygon) -> Drawing:
    """Return the drawing of a remnant, a sheet of the next order."""
    return Drawing(tuple(_rings(remnant)))


def _rings(polygon: Polygon) -> Iterator[Chain]:
    for ring in (polygon.exterior, *polygon.interiors):
        yield Chain(from_points(np.asarray(ring.coords)[:-1], closed=True), SHEET)


def remnants(order: Order, layout: Layout, number: int) -> list[Polygon]:
    """Return what is left of a sheet, in its own coordinates: pieces without slivers; of a strip none."""
    if order.strip_height_mm:
        return []
    sheet = order.sheets[number].outline
    parts = [placed(order.items[each.item].exact, each) for each in layout.placements if each.sheet == number]
    cut = shapely.union_all([part.buffer(order.kerf_mm) if order.kerf_mm else part for part in parts])
    wide = sheet.difference(cut).buffer(-SLIVER_MM).buffer(SLIVER_MM).intersection(sheet.difference(cut))
    pieces = [_settled(piece) for piece in shapely.get_parts(wide) if isinstance(piece, Polygon)]
    kept = [piece for piece in pieces if piece.area >= LEAST_REMNANT * sheet.area]
    return sorted(kept, key=lambda piece: (-round(piece.area, 3), piece.bounds))


def _settled(piece: Polygon) -> Polygon:
    """Return a remnant of few corners, the same ones whatever corner the calculation began with."""
    return shapely.normalize(piece).simplify(CHORD_MM)
