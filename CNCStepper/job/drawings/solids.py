# SPDX-License-Identifier: LGPL-2.1-or-later
"""STEP, BREP and FCStd files, and scripts that a person names, as drawings: level faces, a section, or the outline."""

from __future__ import annotations

import zipfile
from pathlib import Path
from typing import Any

import numpy as np

from CNCStepper.drawing.drawing import Drawing, Share
from CNCStepper.drawing.read_drawing import SCRIPT, ReadOptions
from CNCStepper.drawing.solids.edge_curves import canonical, loops_of, ordered
from CNCStepper.drawing.solids.mesh_outline import outline, outline_area_mm2
from CNCStepper.drawing.solids.solid_drawing import OUTLINE, solid_drawing
from CNCStepper.errors import JobError, Place, placed
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.fitting.point_fit import refitted
from CNCStepper.input_file import read_input
from CNCStepper.job.drawings.solid_process import DOCUMENT, LIMIT_S, read_solid

MOST_BYTES = 100_000_000
MOST_SCRIPT_BYTES = 1_000_000
MOST_UNPACKED_BYTES = 400_000_000
MOST_MEMBERS = 20_000
MESH_SHARE = 0.25  # of the tolerance: how far the mesh of a curved face leaves it


def read(path: Path, options: ReadOptions, share: Share) -> Drawing:
    """Return the drawing of a STEP, BREP or FCStd file; raises JobError with the reason where there is none."""
    require_readable(path)
    return _drawing(path, options, share, LIMIT_S)


def require_readable(path: Path) -> None:
    """Raise JobError for a file that is too large, that is empty, or that is no document where it should be one."""
    content = read_input(path, MOST_BYTES)
    if path.suffix.casefold() == DOCUMENT:
        _require_small(path, Place(str(path)))
    elif not content.strip():
        raise JobError("solid-file", "the file is empty", advice="export it again", place=Place(str(path)))


def read_script(path: Path, options: ReadOptions, share: Share, limit_s: float | None = None) -> Drawing:
    """Run a CadQuery or build123d script that the person has named, and return its solid as a drawing.

    A script is a program: never call this for a file that a document or a job names. It ends after `limit_s`,
    LIMIT_S for None, and as soon as it takes too much memory, writes a file, starts a process or opens a connection.
    """
    if path.suffix.casefold() != SCRIPT:
        advice = "name a script with the suffix .py"
        raise JobError("solid-script", "this is no Python script", advice=advice, place=Place(str(path)))
    read_input(path, MOST_SCRIPT_BYTES)
    return _drawing(path, options, share, LIMIT_S if limit_s is None else limit_s)


def _drawing(path: Path, options: ReadOptions, share: Share, limit_s: float) -> Drawing:
    place = Place(str(path))
    height = OUTLINE if options.height_mm is None else repr(float(options.height_mm))
    answer = read_solid(path, height, MESH_SHARE * options.tolerance_mm, limit_s)
    share(0.8)
    with placed(place):
        curves = _outline(answer, options.tolerance_mm) if height == OUTLINE else _faces(answer, options.tolerance_mm)
        return solid_drawing(curves, options, path.stem, place)


def _faces(answer: dict[str, Any], tolerance_mm: float) -> list[Curve]:
    return ordered([curve for edges in answer["loops"] for curve in loops_of(edges, tolerance_mm)])


def _outline(answer: dict[str, Any], tolerance_mm: float) -> list[Curve]:
    """Return the outline: the exact edges of a height whose level faces cover all of it, else lines and arcs.

    Faces cover it when their area is that of the mesh but for the band in which the mesh may leave a curved edge.
    """
    triangles = np.array(answer["triangles"], float).reshape(-1, 3, 2)
    if not len(triangles):
        return []
    whole_mm2 = outline_area_mm2(triangles)
    for edges in answer["levels"]:
        curves = loops_of(edges, tolerance_mm)
        if all(curve.closed for curve in curves):
            band_mm2 = MESH_SHARE * tolerance_mm * sum(curve.length_mm for curve in curves)
            if abs(_area_mm2(curves) - whole_mm2) <= band_mm2:
                return curves
    return ordered([canonical(refitted(ring, tolerance_mm)) for ring in outline(triangles)])


def _area_mm2(curves: list[Curve]) -> float:
    """Return the area inside closed curves that do not cross, holes taken out."""
    corners = np.array([curve.xy[0] for curve in curves])
    depths = sum((np.abs(curve.winding(corners)) > 0).astype(int) * _others(curve, curves) for curve in curves)
    signs = np.where(np.asarray(depths) % 2 == 0, 1.0, -1.0)
    return float(sum(sign * abs(curve.area_mm2) for sign, curve in zip(signs.tolist(), curves, strict=True)))


def _others(curve: Curve, curves: list[Curve]) -> np.ndarray:
    return np.array([int(other is not curve) for other in curves])


def _require_small(path: Path, place: Place) -> None:
    """Raise JobError for a document that is no archive, or unpacks to more than is read."""
    try:
        with zipfile.ZipFile(path) as archive:
            members = archive.infolist()
    except (zipfile.BadZipFile, OSError, ValueError, NotImplementedError) as error:
        raise JobError("solid-file", "not a FreeCAD document", advice="save it again", place=place) from error
    size = sum(member.file_size for member in members)
    if size > MOST_UNPACKED_BYTES or len(members) > MOST_MEMBERS:
        value, limit = f"{size / 1e6:.3g} MB, {len(members)} files", f"{MOST_UNPACKED_BYTES / 1e6:g} MB, {MOST_MEMBERS}"
        what, advice = "the document unpacks to too much", "save the solid in a document of its own"
        raise JobError("solid-large", what, value=value, limit=limit, place=place, advice=advice)
