# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes a drawing as DXF R2004 in mm: a polyline with bulges for each chain, on its layer and in its colour.

A layer whose name DXF does not allow gets one that no other layer has; layers "A" and "a" are one. Letters outside the
code page are \\U+XXXX.
"""

from __future__ import annotations

import io
import itertools
from collections.abc import Iterable
from typing import Any

import numpy as np

from CNCStepper.cancellation import checkpoint
from CNCStepper.drawing.drawing import KERF, Chain, Drawing
from CNCStepper.output_files import MADE_BY

NOT_IN_NAMES = str.maketrans(dict.fromkeys('<>/\\":;?*|=`', "_"))  # signs that a layer's name must not have
LONGEST_NAME = 255
LONGEST_NUMBER = 8  # characters of what tells equal names apart
LAYER_0 = "0"  # that every file has


def dxf_bytes(drawing: Drawing) -> bytes:
    """Return the file's content, an LWPOLYLINE for each chain."""
    import ezdxf  # it takes 0.4 s

    ezdxf.options.write_fixed_meta_data_for_testing = True  # no dates: the same drawing is the same bytes
    document = ezdxf.new("R2004", units=ezdxf.units.MM)
    document.header.custom_vars.append("Creator", MADE_BY)
    if drawing.kerf_mm is not None:
        document.header.custom_vars.append(KERF, repr(drawing.kerf_mm))
    space = document.modelspace()
    layers = layer_names(chain.attributes.layer for chain in drawing.chains)
    for chain in drawing.chains:
        checkpoint()
        attributes = _attributes(chain, layers)
        if attributes["layer"] not in document.layers:
            document.layers.add(attributes["layer"])
        closed, rows = _rows(chain)
        space.add_lwpolyline(rows, format="xyb", close=closed, dxfattribs=attributes)
    classes = document.classes
    classes.add_required_classes(document.dxfversion)  # from a set, whose order is that of its hashes
    classes.classes = dict(sorted(classes.classes.items()))
    text = io.StringIO()
    document.write(text)
    return bytes(document.encode(f"999\n{MADE_BY}\n{text.getvalue()}"))


def layer_names(layers: Iterable[str]) -> dict[str, str]:
    """Return the name in the file for each layer: its own where DXF allows that, else another one that is free.

    DXF compares names without case: layers that differ by case alone are one, with the name of the first.
    """
    allowed = {layer: _allowed(layer) for layer in layers}
    own: dict[str, str] = {}
    names = {layer: own.setdefault(name.casefold(), name) for layer, name in allowed.items() if layer == name}
    names[""] = own.setdefault(LAYER_0, LAYER_0)
    for layer, name in allowed.items():
        if layer not in names:
            names[layer] = next(free for free in _numbered(name) if free.casefold() not in own)
            own[names[layer].casefold()] = names[layer]
    return names


def _allowed(layer: str) -> str:
    return layer.translate(NOT_IN_NAMES)[:LONGEST_NAME].strip() or LAYER_0


def _numbered(name: str) -> Iterable[str]:
    """Yield a name, then it with the numbers 2, 3, ..."""
    yield name
    for number in itertools.count(2):
        yield f"{name[: LONGEST_NAME - LONGEST_NUMBER]}_{number}"


def _attributes(chain: Chain, layers: dict[str, str]) -> dict[str, Any]:
    """Return layer and colour as ezdxf takes them."""
    told = chain.attributes
    return {"layer": layers[told.layer], **({"true_color": int(told.colour[1:], 16)} if told.colour else {})}


def _rows(chain: Chain) -> tuple[bool, np.ndarray]:
    """Return whether the polyline is closed, and its rows of x, y and the bulge to the next one."""
    curve = chain.curve
    if curve.closed:
        return True, np.column_stack([curve.xy[:-1], curve.bulge])
    return False, np.column_stack([curve.xy, np.append(curve.bulge, 0.0)])
