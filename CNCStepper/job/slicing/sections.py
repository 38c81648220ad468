# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sections of a solid, one for each sheet of a stack: of a mesh from its triangles, of a solid from OCCT.

STL               closed mesh ──► sheet_heights.py ──► polygons: what lies in an odd number of its loops
STEP, BREP,       process (job/drawings/solid_process.py) ──► edges of each solid at each height ──► lines and arcs
FCStd             within SECTION_TOLERANCE_MM
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import shapely
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from CNCStepper.cancellation import checkpoint
from CNCStepper.drawing.solids.edge_curves import loops_of
from CNCStepper.drawing.solids.mesh_outline import section
from CNCStepper.drawing.solids.sheet_heights import (
    AXES,
    MOST_SLICES,
    question_of,
    section_heights,
    sheet_begins,
    sheet_count,
)
from CNCStepper.errors import JobError, Place, Text, placed
from CNCStepper.geometry.curve import Curve, from_points
from CNCStepper.geometry.region import Region
from CNCStepper.job.drawings.solid_process import read_solid
from CNCStepper.job.drawings.solids import require_readable
from CNCStepper.nesting.outlines import EXACT_MM, holding_polygon

MERGED_DECIMALS = 6  # of mm: corners of triangles that are one
SECTION_TOLERANCE_MM = 0.002  # within which arcs follow ellipses and splines
OVERLAP_SHARE = 1e-5  # of a section's area in which solids of one file may overlap
LIMIT_S = 110.0


@dataclass(frozen=True)
class Outline:
    """One piece of a section. polygon: holds the piece within EXACT_MM; rings: its lines and arcs, as they are cut."""

    polygon: Polygon
    rings: tuple[Curve, ...]
    area_mm2: float


@dataclass(frozen=True)
class Sections:
    """What a stack is made of: where each sheet begins along the axis, the pieces of its section; the volume held.

    sheet_volumes_mm3: what of the solid lies in each sheet; () where only the whole volume is known.
    """

    begins_mm: tuple[float, ...]
    outlines: tuple[tuple[Outline, ...], ...]
    thickness_mm: float
    volume_mm3: float
    sheet_volumes_mm3: tuple[float, ...] = ()


def mesh_sections(triangles: np.ndarray, axis: str, thickness_mm: float) -> Sections:
    """Return the sections of a closed mesh, float64[n, 3, 3] in mm; raises JobError for an open one, many sheets."""
    mesh = triangles[:, :, AXES[axis]]
    require_closed(mesh)
    low_mm, high_mm = float(mesh[:, :, 2].min()), float(mesh[:, :, 2].max())
    _require_few(sheet_count(low_mm, high_mm, thickness_mm))
    heights = section_heights(low_mm, high_mm, thickness_mm, levels=[])
    outlines = tuple(tuple(_outlines(section_area(mesh, height_mm))) for height_mm in heights)
    begins_mm = sheet_begins(low_mm, high_mm, thickness_mm)
    volumes_mm3 = tuple(slab_volumes_mm3(mesh, [*begins_mm, begins_mm[-1] + thickness_mm]))
    return Sections(tuple(begins_mm), outlines, thickness_mm, volume_mm3(mesh), volumes_mm3)


def solid_sections(path: Path, axis: str, thickness_mm: float) -> Sections:
    """Return the sections of a STEP, BREP or FCStd file.

    Raises MissingPackage where no program reads such files, JobError for a file that holds no closed solid, for many
    sheets, for solids that overlap and for a section that is not closed.
    """
    require_readable(path)
    answer = read_solid(path, question_of(axis, thickness_mm), SECTION_TOLERANCE_MM, LIMIT_S)
    begins = sheet_begins(answer["low_mm"], answer["high_mm"], thickness_mm)
    with placed(Place(str(path))):
        outlines = tuple(
            tuple(_exact_outlines(edges, number)) for number, edges in enumerate(answer["sections"], start=1)
        )
    return Sections(tuple(begins), outlines, thickness_mm, answer["volume_mm3"])


def _exact_outlines(solids: Sequence[Sequence[object]], number: int) -> list[Outline]:
    """Return the pieces of a sheet, from the edges of each solid in its section."""
    loops = [loops_of(edges, SECTION_TOLERANCE_MM) for edges in solids]  # type: ignore[arg-type]
    if any(not curve.closed for curves in loops for curve in curves):
        what = Text("the section of sheet {number} is not closed", number=number)
        raise JobError("slice-open", what, advice="repair the solid, or use another thickness")
    whole = Region.even_odd([curve for curves in loops for curve in curves])
    apart_mm2 = sum(Region.even_odd(curves).area_mm2 for curves in loops)
    if apart_mm2 - whole.area_mm2 > OVERLAP_SHARE * apart_mm2:
        what = Text("solids of the file overlap at sheet {number}", number=number)
        raise JobError("slice-overlap", what, advice="unite them to one solid, and export it again")
    pieces = [] if whole.empty else whole.parts()
    return [Outline(holding_polygon(piece, EXACT_MM), piece.loops, piece.area_mm2) for piece in pieces]


def _require_few(count: int) -> None:
    if count > MOST_SLICES:
        what, advice = "the stack has too many sheets", "use thicker sheets"
        raise JobError("slice-count", what, value=f"{count}", limit=f"{MOST_SLICES}", advice=advice)


def require_closed(mesh: np.ndarray) -> None:
    """Raise JobError unless each edge of the mesh belongs to as many triangles one way as the other."""
    corners, numbers = np.unique(mesh.reshape(-1, 3).round(MERGED_DECIMALS), axis=0, return_inverse=True)
    faces = numbers.reshape(-1, 3)
    begins, ends = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    real = begins != ends
    keys = np.minimum(begins, ends)[real] * len(corners) + np.maximum(begins, ends)[real]
    ways = np.where(begins < ends, 1, -1)[real]
    _, edges = np.unique(keys, return_inverse=True)
    open_edges = int((np.bincount(edges, ways) != 0).sum())
    if open_edges:
        advice = "repair the mesh, and export it again"
        raise JobError("slice-open", "the solid is not closed", value=f"{open_edges} open edges", advice=advice)


def volume_mm3(mesh: np.ndarray) -> float:
    """Return the volume in a closed mesh."""
    first, second, third = mesh[:, 0], mesh[:, 1], mesh[:, 2]
    return abs(float(np.einsum("ij,ij->i", first, np.cross(second, third)).sum())) / 6.0


def slab_volumes_mm3(mesh: np.ndarray, heights_mm: Sequence[float]) -> list[float]:
    """Return the volume of a closed mesh between each height and the next one, exactly, the heights ascending."""
    level = mesh[:, :, :2]
    sides = level[:, 1:] - level[:, :1]
    areas = (sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0]) / 2.0
    above = [float((areas * _mean_above(mesh[:, :, 2], height)).sum()) for height in heights_mm]
    sign = np.sign(float((areas * mesh[:, :, 2].mean(axis=1)).sum()))  # of a mesh that is inside out
    return [float(sign * (one - other)) for one, other in itertools.pairwise(above)]


def _mean_above(z: np.ndarray, height_mm: float) -> np.ndarray:
    """Return the mean over each triangle of how far it lies above a height, 0 where below; z: of its corners."""
    checkpoint()
    low, middle, high = (np.sort(z, axis=1) - height_mm).T
    mean = (low + middle + high) / 3.0
    top, bottom = (low < 0.0) & (middle <= 0.0) & (high > 0.0), (low < 0.0) & (middle > 0.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        mean = np.where(top, high**3 / (3.0 * (high - low) * (high - middle)), mean)
        mean = np.where(bottom, mean - low**3 / (3.0 * (middle - low) * (high - low)), mean)
    return np.where(high <= 0.0, 0.0, mean)


def section_area(mesh: np.ndarray, height_mm: float) -> BaseGeometry:
    """Return the section of a closed mesh at a height as polygons: what lies in an odd number of its loops."""
    checkpoint()
    rings = [shapely.make_valid(Polygon(curve.xy)) for curve in section(mesh, height_mm) if _is_ring(curve)]
    whole: BaseGeometry = Polygon()
    for ring in sorted(rings, key=lambda ring: -ring.area):
        whole = whole.symmetric_difference(ring)
    return whole


def _is_ring(curve: Curve) -> bool:
    return curve.closed and len(curve) > 2


def _outlines(area: BaseGeometry) -> list[Outline]:
    """Return the pieces of a section of a mesh."""
    parts = [part for part in shapely.get_parts(area) if isinstance(part, Polygon) and part.area > 0.0]
    return [Outline(part, tuple(map(_curve, (part.exterior, *part.interiors))), part.area) for part in parts]


def _curve(ring: shapely.LinearRing) -> Curve:
    return from_points(np.asarray(ring.coords)[:-1], closed=True)
