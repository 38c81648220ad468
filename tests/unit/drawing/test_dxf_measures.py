# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths and areas of splines, ellipses, bulges and hatches of DXF, judged by ezdxf's own paths."""

from __future__ import annotations

import math
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import ezdxf
import numpy as np
import pytest
from ezdxf import path as ezdxf_path

from CNCStepper.drawing.drawing import Drawing
from CNCStepper.drawing.read_drawing import ReadOptions, read_drawing

TOLERANCE_MM = 0.005
FINE_MM = 1e-5  # of the judge
LENGTH_SHARE = 2e-4  # by which arcs within the tolerance may be longer or shorter than the curve
DRAWN = 12  # of each kind
PITCH_MM = 100.0


def read(document: Any, folder: Path) -> Drawing:
    document.saveas(folder / "measures.dxf")
    return read_drawing(folder / "measures.dxf", ReadOptions(tolerance_mm=TOLERANCE_MM))


def measures(points: np.ndarray) -> tuple[float, float]:
    """Return length and area of a closed or open line; the area is that between its ends."""
    x, y = (points - points[0]).T
    area_mm2 = 0.5 * abs(float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))))
    return float(np.hypot(*np.diff(points, axis=0).T).sum()), area_mm2


def judge(entity: Any) -> list[tuple[float, float]]:
    """Return lengths and areas of an entity's paths as ezdxf flattens them."""
    paths: Iterable[Any] = (
        ezdxf_path.from_hatch(entity) if entity.dxftype() == "HATCH" else [ezdxf_path.make_path(entity)]
    )
    return [measures(np.array([tuple(point)[:2] for point in each.flattening(FINE_MM, 16)])) for each in paths]


def add(space: Any, kind: str, rng: np.random.Generator, x: float, y: float) -> Any:
    """Add one closed entity of a kind about a place."""
    angles = np.sort(rng.uniform(0, math.tau, 7))
    ring = np.column_stack([x + rng.uniform(15, 30) * np.cos(angles), y + rng.uniform(15, 30) * np.sin(angles)])
    turn, ratio = rng.uniform(0, math.tau), float(rng.uniform(0.05, 1.0))
    major = (30 * math.cos(turn), 30 * math.sin(turn))
    if kind == "ellipse":
        return space.add_ellipse((x, y), major, ratio)
    if kind == "spline":
        return space.add_open_spline(np.vstack([ring, ring[:1]]), 3)
    if kind == "bulge":
        return space.add_lwpolyline(np.column_stack([ring, rng.uniform(-0.9, 0.9, 7)]), "xyb", close=True)
    hatch = space.add_hatch()
    if kind == "hatch of bulges":
        hatch.paths.add_polyline_path(np.column_stack([ring, rng.uniform(0, 0.9, 7)]), is_closed=True)
    elif kind == "hatch of an ellipse":
        hatch.paths.add_edge_path().add_ellipse((x, y), major, ratio, 0, 360)
    else:
        edges = hatch.paths.add_edge_path()
        edges.add_spline(control_points=ring, degree=3, knot_values=ezdxf.math.open_uniform_knot_vector(7, 4))
        edges.add_line(ring[-1], ring[0])
    return hatch


@pytest.mark.parametrize(
    "kind", ["spline", "ellipse", "bulge", "hatch of bulges", "hatch of an ellipse", "hatch of a spline"]
)
def test_lengths_and_areas_are_those_of_ezdxf(kind: str, tmp_path: Path) -> None:
    rng, document = np.random.default_rng(3), ezdxf.new("R2010")
    document.units = 4
    space = document.modelspace()
    entities = [add(space, kind, rng, number * PITCH_MM, 0.0) for number in range(DRAWN)]
    wanted = [found for entity in entities for found in judge(entity)]
    chains = read(document, tmp_path).chains
    assert len(chains) == len(wanted) == DRAWN
    for chain, (length_mm, area_mm2) in zip(chains, wanted, strict=True):
        assert chain.curve.closed
        assert chain.curve.length_mm == pytest.approx(length_mm, rel=LENGTH_SHARE)
        assert abs(chain.curve.area_mm2) == pytest.approx(area_mm2, abs=TOLERANCE_MM * length_mm)
