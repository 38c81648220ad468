# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Tabs: their places, and where the tool must be above them.

         width
      |<------->|            The tab's material is a rectangle across the whole cut; the tool is lifted wherever
 .---.+---------+.---.       its disc would enter it, so that the width stays, on bends too and from passes beside.
(  o  | the tab |  o  )
 '---'+---------+'---'       No tab stands on a corner, near an entry or a lead, or nearer to another tab than the
      |         |            tool needs to get down between them, or near a dog-bone.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely import Polygon

from CNCStepper.cycles.contours.contour_model import Tabs
from CNCStepper.cycles.contours.contour_parameters import MOST_TABS
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve

CORNER_RAD = math.radians(8.0)  # a path that turns by more at a vertex has a corner there
BEND_RAD = math.radians(60.0)  # over a tab's width a path may bend by so much
SAMPLES = 1500  # sample places of a contour
PHASES = 60  # even distributions of tabs that are compared
SURE_MM = 0.003  # by so much the tool is lifted earlier than it must be
FLAT_MM = 0.0005
QUARTER = 64  # chords a quarter of a turn of the tool
STEP = 0.05  # of the tool's radius, between sample places: what is missed then is thinner than STEP² / 8 of it
HALVINGS = 24


@dataclass(frozen=True)
class TabContext:
    """The surroundings of tabs on one path: the tool's radius, the scrap's side, the width of the cut.

    wall_mm, scrap_mm: from the path to the part and to the far edge of the cut. busy: ways on which the tool goes
    down: entries, leads and dog-bones. free_from_mm: where the stretch ends over which a closed path runs twice.
    """

    tool_mm: float
    scrap: int
    wall_mm: float
    scrap_mm: float
    busy: Sequence[Curve]
    free_from_mm: float


def tabs_wanted(path: Curve, tabs: Tabs) -> int:
    """Return the number of tabs of a path; raises CycleError where their spacing needs more than MOST_TABS."""
    if path.length_mm > MOST_TABS * tabs.spacing_mm > 0.0:
        raise CycleError(
            "tabs-many",
            Text("spacing_mm asks for more than {most_tabs} tabs on one contour", most_tabs=MOST_TABS),
            value=f"{tabs.spacing_mm:g} mm",
            limit=Text("at least {length_mm:.3g} mm", length_mm=path.length_mm / MOST_TABS),
            advice="make spacing_mm larger",
        )
    return tabs.count or max(math.ceil(path.length_mm / tabs.spacing_mm), 1)


def tab_places(path: Curve, tabs: Tabs, ground: TabContext) -> list[float]:
    """Return the lengths of tabs along a path: as many as asked for, or as many as fit."""
    places = np.arange(SAMPLES) * path.length_mm / SAMPLES
    fit = places[_allowed(path, places, tabs, ground)]
    wanted = tabs_wanted(path, tabs)
    apart_mm = tabs.width_mm + 3.0 * ground.tool_mm
    found = _nearest_even(fit, wanted, path, apart_mm)
    if len(found) < wanted:
        found = _packed(fit, wanted, path, apart_mm)
    return found


def tab_area(path: Curve, place_mm: float, tabs: Tabs, ground: TabContext) -> Polygon:
    """Return the rectangle of a tab at a place of a path."""
    (x, y), (u, v) = path.at_length(place_mm)
    ends = path.at_length(place_mm + np.array([-0.5, 0.5]) * tabs.width_mm)[1] @ (1, 1j)
    along, here = complex(u, v), complex(x, y)
    bulge_mm = tabs.width_mm / 2.0 * math.tan(abs(float(np.angle(ends[1] / ends[0]))) / 4.0)
    left, right = ground.scrap_mm, ground.wall_mm
    if ground.scrap < 0:
        left, right = right, left
    half, up, down = tabs.width_mm / 2.0, left + bulge_mm, -(right + bulge_mm)
    corners = [here + along * complex(*each) for each in ((-half, down), (half, down), (half, up), (-half, up))]
    return Polygon([(corner.real, corner.imag) for corner in corners])


def stretches(path: Curve, areas: Sequence[Polygon], tool_mm: float) -> list[tuple[Curve, bool]]:
    """Return a path in pieces, each with whether the tool's disc would enter one of the areas along it."""
    line = shapely.LineString(path.points(FLAT_MM))
    near = [area for area in areas if shapely.distance(line, area) < tool_mm + SURE_MM]
    if not near:
        return [(path, False)]
    grown = shapely.union_all(shapely.buffer(near, tool_mm + SURE_MM, quad_segs=QUARTER))
    shapely.prepare(grown)

    def lifted(lengths_mm: np.ndarray) -> np.ndarray:
        return shapely.contains_xy(grown, path.at_length(lengths_mm)[0])

    count = max(math.ceil(path.length_mm / (STEP * tool_mm)), 16)
    places = np.linspace(0.0, path.length_mm, count + 1)
    up = lifted(places)
    change = np.flatnonzero(up[1:] != up[:-1])
    low, high = places[change], places[change + 1]
    for _ in range(HALVINGS):
        middle = (low + high) / 2.0
        as_low = lifted(middle) == up[change]
        low, high = np.where(as_low, middle, low), np.where(as_low, high, middle)
    pieces = path.split(high)
    middles = np.array([piece.length_mm for piece in pieces]).cumsum() - [piece.length_mm / 2.0 for piece in pieces]
    return list(zip(pieces, lifted(middles).tolist(), strict=True))


def _allowed(path: Curve, places: np.ndarray, tabs: Tabs, ground: TabContext) -> np.ndarray:
    """Return at which places a tab may stand, bool[n]."""
    half_mm = tabs.width_mm / 2.0 + ground.tool_mm
    allowed = np.ones(len(places), bool)
    for first, last in _corners(path, tabs, ground):
        allowed &= _outside(places, first - half_mm, last + half_mm, path)
    allowed &= _outside(places, -half_mm - ground.tool_mm, ground.free_from_mm + half_mm + ground.tool_mm, path)
    if not path.closed:
        allowed &= (places > half_mm) & (places < path.length_mm - half_mm)
    bend = _bend(path, places, tabs.width_mm)
    across_mm = max(ground.wall_mm, ground.scrap_mm) + tabs.width_mm / 2.0 * np.tan(bend / 4.0)
    away_mm = np.hypot(tabs.width_mm / 2.0, across_mm) + ground.tool_mm + SURE_MM
    spots = shapely.points(path.at_length(places)[0])
    for way in ground.busy:
        allowed &= shapely.distance(spots, shapely.LineString(way.points(FLAT_MM))) > away_mm
    return allowed & (bend < BEND_RAD)


def _outside(places: np.ndarray, first: float, last: float, path: Curve) -> np.ndarray:
    if not path.closed:
        return (places < first) | (places > last)
    return (
        (places - first) % path.length_mm > last - first
        if last - first < path.length_mm
        else np.zeros_like(places, bool)
    )


def _corners(path: Curve, tabs: Tabs, ground: TabContext) -> list[tuple[float, float]]:
    """Return the stretches of a path that are corners: sharp vertices, and arcs round sharp corners of the wall."""
    before, begin, end = path.before_mm, path.begin_directions @ (1, 1j), path.end_directions @ (1, 1j)
    turns = np.angle(begin / np.roll(end, 1))
    turns[0] *= path.closed
    sharp = before[:-1][np.abs(turns) > CORNER_RAD]
    toward_wall = -path.curvatures * ground.scrap
    with np.errstate(divide="ignore"):
        wall_radius = np.where(toward_wall > 0.0, 1.0 / toward_wall - ground.wall_mm, np.inf)
    tight = (wall_radius < tabs.width_mm / 2.0) & (np.abs(path.sweeps_rad) > CORNER_RAD)
    arcs = zip(before[:-1][tight].tolist(), before[1:][tight].tolist(), strict=True)
    return [(place, place) for place in sharp.tolist()] + list(arcs)


def _bend(path: Curve, places: np.ndarray, width_mm: float) -> np.ndarray:
    """Return by how much a path turns over a tab's width, rad[n]."""
    ends = []
    for half in (-0.5, 0.5):
        there = places + half * width_mm
        ends.append(path.at_length(there % path.length_mm if path.closed else there)[1] @ (1, 1j))
    return np.abs(np.angle(ends[1] / ends[0]))


def _nearest_even(fit: np.ndarray, wanted: int, path: Curve, apart_mm: float) -> list[float]:
    """Return evenly spread places, each moved to the nearest one that fits; none when they come too near each other.

    Round a closed path they are spread from where they have to be moved least, in the middle of what fits.
    """
    if not len(fit):
        return []
    pitch_mm = path.length_mm / wanted
    phases = np.arange(PHASES) / PHASES if path.closed else np.array([0.5])
    ideal = (phases[:, None] + np.arange(wanted)) * pitch_mm
    found = _nearest(fit, ideal, path)
    moved_mm = _apart_mm(found, ideal, path)
    gaps = np.diff(np.sort(found, axis=1), axis=1, append=np.nan)
    if path.closed:
        gaps[:, -1] = found.min(axis=1) + path.length_mm - found.max(axis=1)
    good = np.nanmin(gaps, axis=1, initial=math.inf) >= (apart_mm if wanted > 1 else 0.0)
    if not good.any():
        return []
    other = np.setdiff1d(np.arange(SAMPLES) * path.length_mm / SAMPLES, fit)
    room_mm = _apart_mm(_nearest(other, found, path), found, path).min(axis=1) if len(other) else np.zeros(len(found))
    best = np.lexsort((-room_mm, np.round((moved_mm**2).sum(axis=1), 6), ~good))[0]
    return np.sort(found[best]).tolist()


def _nearest(fit: np.ndarray, places: np.ndarray, path: Curve) -> np.ndarray:
    """Return for each place the nearest of some in order, along a closed path also past its end."""
    around = np.r_[fit[-1] - path.length_mm, fit, fit[0] + path.length_mm] if path.closed else fit
    after = np.clip(np.searchsorted(around, places), 1, max(len(around) - 1, 1)) if len(around) > 1 else 0 * places
    low, high = around[np.int64(after) - 1], around[np.int64(after)]
    near = np.where(places - low <= high - places, low, high)
    return near % path.length_mm if path.closed else near


def _apart_mm(one: np.ndarray, other: np.ndarray, path: Curve) -> np.ndarray:
    away_mm = np.abs(one - other)
    return np.minimum(away_mm, path.length_mm - away_mm) if path.closed else away_mm


def _packed(fit: np.ndarray, wanted: int, path: Curve, apart_mm: float) -> list[float]:
    """Return as many places as fit beside each other, at most as many as wanted, spread evenly over them."""
    found: list[float] = []
    for place in fit.tolist():
        round_ = path.closed and found and place - found[0] > path.length_mm - apart_mm
        if not round_ and (not found or place - found[-1] >= apart_mm):
            found.append(place)
    if len(found) <= wanted:
        return found
    return [found[index * len(found) // wanted] for index in range(wanted)]
