# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes a drawing as SVG in mm: a path for each chain, in the group of its layer; arcs stay arcs.

The page begins at the drawing's zero, or farther left and down where the drawing does.
"""

from __future__ import annotations

from collections.abc import Iterator
from xml.sax.saxutils import escape, quoteattr

import numpy as np

from CNCStepper.cancellation import checkpoint
from CNCStepper.drawing.chain_list import drawing_box_mm
from CNCStepper.drawing.drawing import Chain, Drawing
from CNCStepper.geometry.curve import Curve
from CNCStepper.output_files import MADE_BY

INK = "#000000"
LINE_MM = 0.1
DIGITS = 6


def svg_bytes(drawing: Drawing) -> bytes:
    """Return the file's content; y of the file points down, as SVG has it."""
    left, low, right, high = drawing_box_mm(drawing.chains)
    left, low = min(left, 0.0), min(low, 0.0)
    size = f'width="{_number(right - left)}mm" height="{_number(high - low)}mm"'
    view = f'viewBox="{_number(left)} 0 {_number(right - left)} {_number(high - low)}"'
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} {view}>',
        f"<desc>{escape(MADE_BY)}</desc>",
        *_groups(drawing, high),
        "</svg>",
    ]
    return ("\n".join(lines) + "\n").encode("utf-8")


def _groups(drawing: Drawing, high_mm: float) -> Iterator[str]:
    layers: dict[str, list[Chain]] = {}
    for chain in drawing.chains:
        layers.setdefault(chain.attributes.layer, []).append(chain)
    for layer, chains in layers.items():
        yield f"<g id={quoteattr(layer)}>"
        yield from (_path(chain, high_mm) for chain in chains)
        yield "</g>"


def _path(chain: Chain, high_mm: float) -> str:
    checkpoint()
    told = chain.attributes
    colour = told.colour or INK
    paint = f'fill="{colour}"' if told.filled else f'fill="none" stroke="{colour}" stroke-width="{LINE_MM}"'
    name = f" id={quoteattr(told.name)}" if told.name else ""
    return f'<path{name} {paint} d="{path_data(chain.curve, high_mm)}"/>'


def path_data(curve: Curve, high_mm: float) -> str:
    """Return the curve as the data of an SVG path whose y points down from `high_mm`."""
    xy = np.column_stack([curve.xy[:, 0], high_mm - curve.xy[:, 1]])
    parts = [f"M{_number(xy[0, 0])} {_number(xy[0, 1])}"]
    radii = curve.radii_mm.tolist()
    for (x, y), bulge, radius_mm in zip(xy[1:].tolist(), curve.bulge.tolist(), radii, strict=True):
        end = f"{_number(x)} {_number(y)}"
        if bulge == 0.0:
            parts.append(f"L{end}")
        else:
            large, turn = int(abs(bulge) > 1.0), int(bulge < 0.0)
            parts.append(f"A{_number(radius_mm)} {_number(radius_mm)} 0 {large} {turn} {end}")
    return "".join(parts) + ("Z" if curve.closed else "")


def _number(value: float) -> str:
    return f"{value:.{DIGITS}f}".rstrip("0").rstrip(".")
