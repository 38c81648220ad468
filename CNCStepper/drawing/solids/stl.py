# SPDX-License-Identifier: LGPL-2.1-or-later
"""STL meshes, binary and ASCII, as drawings: a section at a height, or the whole outline seen from above.

A binary file says how many triangles it holds: 84 bytes and 50 for each. One that is not as long as it says is refused
before any of them is read.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from CNCStepper.drawing.drawing import Drawing, Share
from CNCStepper.drawing.read_drawing import ReadOptions
from CNCStepper.drawing.solids.edge_curves import canonical, ordered
from CNCStepper.drawing.solids.mesh_outline import at_height, outline
from CNCStepper.drawing.solids.solid_drawing import solid_drawing
from CNCStepper.errors import JobError, Place, Text, placed
from CNCStepper.input_file import read_input

MOST_BYTES = 100_000_000
LARGEST_MM = 1e6
HEADER_BYTES, TRIANGLE_BYTES = 84, 50
ROW = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
VERTEX = re.compile(rb"^\s*vertex\s+(\S+)\s+(\S+)\s+(\S+)\s*$", re.MULTILINE | re.IGNORECASE)


def read(path: Path, options: ReadOptions, share: Share) -> Drawing:
    """Return the drawing of an STL file; raises JobError for a damaged one and one that has nothing there."""
    place = Place(str(path))
    unit_mm = options.unit_mm or 1.0
    triangles = read_triangles(read_input(path, MOST_BYTES), place) * unit_mm
    share(0.5)
    with placed(place):
        chains = outline(triangles[:, :, :2]) if options.height_mm is None else at_height(triangles, options.height_mm)
        return solid_drawing(ordered([canonical(chain) for chain in chains]), options, "", place, unit_mm)


def read_triangles(content: bytes, place: Place) -> np.ndarray:
    """Return the corners of the triangles, float64[n, 3, 3]; raises JobError for a file that is no STL."""
    claimed = int.from_bytes(content[80:HEADER_BYTES], "little")
    length_bytes = HEADER_BYTES + TRIANGLE_BYTES * claimed
    is_text = content[:5].lower() == b"solid" and b"facet" in content[:2000].lower()
    if len(content) >= HEADER_BYTES and len(content) == length_bytes and claimed:
        corners = np.frombuffer(content, ROW, claimed, HEADER_BYTES)["corners"].astype(float)
    elif is_text:
        corners = _text_triangles(content, place)
    else:
        what = Text("not an STL file, or one that ends too early: it names {claimed} triangles", claimed=claimed)
        value, limit = f"{len(content)} bytes", f"{length_bytes} bytes"
        raise JobError("stl-file", what, value=value, limit=limit, advice="export it again", place=place)
    if not (np.abs(corners) <= LARGEST_MM).all():
        limit, advice = f"{LARGEST_MM:g}", "repair the mesh, and export it again"
        raise JobError(
            "stl-number", "a corner of the mesh is no number in bounds", limit=limit, place=place, advice=advice
        )
    return corners


def _text_triangles(content: bytes, place: Place) -> np.ndarray:
    try:
        numbers = np.array([float(word) for corner in VERTEX.findall(content) for word in corner])
    except ValueError as error:
        advice = "repair the mesh, and export it again"
        raise JobError("stl-number", "a corner of the mesh is no number", place=place, advice=advice) from error
    if not len(numbers) or len(numbers) % 9:
        advice = "export it again, as binary STL"
        raise JobError("stl-file", "the triangles of the STL file are not whole", advice=advice, place=place)
    return numbers.reshape(-1, 3, 3)
