# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of two lathe programs: both parts in half section, their largest difference enlarged, and both paths.

 ____________________________________      _______________
|        the whole of what is turned  O|  |   about O      |      O: the largest difference
|______________________________________|  |________________|
 __________________________________________________________
|        the paths, as those of a mill                     |
|__________________________________________________________|
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import shapely
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch, PathPatch, Rectangle
from matplotlib.path import Path as Outline
from matplotlib.ticker import FuncFormatter, MaxNLocator
from shapely.geometry.base import BaseGeometry

from CNCStepper.job.comparison.turned_difference import ComparedSections, gone_only
from CNCStepper.job.comparison.turned_picture_words import TURNED_WORDS
from CNCStepper.simulation.comparison.path_overlay import PathComparison
from CNCStepper.simulation.tip_segments import Segments, chains
from CNCStepper.simulation.views.comparison_picture import (
    COLOURS,
    FINEST,
    LEGEND,
    LONGEST,
    draw_paths,
    mark,
    mark_entry,
    path_corners,
    path_entries,
)
from CNCStepper.simulation.views.path_lines import LATHE
from CNCStepper.simulation.views.picture_style import (
    COLOURS as SHADES,
)
from CNCStepper.simulation.views.picture_style import (
    GREY,
    GROUND,
    INK,
    TEXTS,
    head,
    new_figure,
    number_text,
    save_figure,
)

WIDTH_INCH, HEAD_INCH, LEFT_INCH = 12.0, 1.25, 0.95
INSIDE_INCH = WIDTH_INCH - 2 * LEFT_INCH
LABELS_INCH, LEGEND_INCH = 0.5, 0.75  # of an axis; its legend
LEAST_INCH, MOST_INCH = 2.2, 5.0  # heights of the views
ENLARGED_INCH, BETWEEN_INCH = 3.1, 0.85  # width of the enlarged view, and to the left of it
MARGIN = 0.05  # about what is shown, in shares of its size
LEAST_SHOWN = 0.2  # of the bar's diameter: so much of its length is shown at least
SEEN_DEPTHS = 8.0  # the enlarged view is so many times as high as the largest difference is deep
SHADE = 0.55
HATCHES = {"first": "////", "second": "\\\\\\\\"}
OUTLINES: dict[str, Any] = {"first": {"lw": 1.4, "ls": "-"}, "second": {"lw": 1.2, "ls": (0, (5, 1.5))}}
Box = tuple[float, float, float, float]  # z and radius from, then to


def save_turned_comparison(
    file: Path,
    found: PathComparison,
    turned: ComparedSections,
    names: tuple[str, str],
    facts: Sequence[str] = (),
    words: Mapping[str, str] = TURNED_WORDS,
) -> None:
    """Draw both parts and paths as PNG or SVG, as the file's name ends; words: those of TURNED_WORDS, translated.

    Raises JobError for another ending.
    """
    box, path_box = _box(turned), _box_of_paths(found)
    width = INSIDE_INCH - (ENLARGED_INCH + BETWEEN_INCH if turned.rings else 0.0)
    heights = _height(box, width), _height(path_box, INSIDE_INCH)
    below = LABELS_INCH + LEGEND_INCH
    whole = HEAD_INCH + sum(heights) + 2 * below
    figure, bottom = new_figure(WIDTH_INCH, whole), whole - HEAD_INCH - heights[0]
    head(figure, " · ".join(names), facts)
    section = _axes(figure, (LEFT_INCH, bottom, width, heights[0]), box)
    _sections(section, turned)
    if turned.rings:
        right = (WIDTH_INCH - LEFT_INCH - ENLARGED_INCH, bottom, ENLARGED_INCH, heights[0])
        _enlarge(figure, section, right, turned, words)
    _legend(figure, bottom - LABELS_INCH, _of_parts(turned, names, words))
    paths = _axes(figure, (LEFT_INCH, below, INSIDE_INCH, heights[1]), path_box)
    finest_mm = max(path_box[2] - path_box[0], path_box[3] - path_box[1]) / FINEST
    draw_paths(paths, found, LATHE, lambda pieces: _drawn(pieces, finest_mm))
    _legend(figure, LEGEND_INCH, path_entries(found, names, words))
    save_figure(figure, file)


def _box(turned: ComparedSections) -> Box:
    """Return what of the bar is shown: all that is turned, with a margin."""
    z_low, _, z_high, radius = turned.stock.region.bounds
    cut = turned.stock.region.difference(turned.first.region.intersection(turned.second.region))
    begin = min(z_low if cut.is_empty else cut.bounds[0], z_high - LEAST_SHOWN * radius)
    margin = MARGIN * max(z_high - begin, radius)
    return max(begin - margin, z_low) - margin / 4, -margin / 4, z_high + margin, radius + margin


def _box_of_paths(found: PathComparison) -> Box:
    """Return what both paths need, with a margin; a millimetre where there is nothing."""
    low, high = path_corners(found)[:, list(LATHE)]
    margin = MARGIN * max(float((high - low).max()), 1.0)
    return (*(low - margin).tolist(), *(high + margin).tolist())


def _height(box: Box, width_inch: float) -> float:
    return float(np.clip(width_inch * (box[3] - box[1]) / (box[2] - box[0]), LEAST_INCH, MOST_INCH))


def _axes(figure: Figure, place_inch: Box, box: Box) -> Axes:
    """Return a half plane at left, bottom, width and height; it has one scale, and diameters beside the radii."""
    axes = figure.add_axes(tuple(np.array(place_inch) / np.tile(figure.get_size_inches(), 2)))
    axes.set_facecolor(GROUND)
    axes.grid(color="white", lw=0.8)
    axes.set_axisbelow(True)
    size, place = np.array([box[2] - box[0], box[3] - box[1]]), np.array(place_inch[2:])
    spare = ((size / place).max() * place - size) / 2  # one scale in both directions
    axes.set(xlim=(box[0] - spare[0], box[2] + spare[0]), ylim=(box[1] - spare[1], box[3] + spare[1]))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda z, _: number_text(round(z, 6))))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda r, _: f"ø{number_text(round(2 * abs(r), 6))}"))
    axes.set(xlabel=TEXTS["axis"].format(name="Z"), ylabel=TEXTS["axis"].format(name="X"))
    return axes


def _sections(axes: Axes, turned: ComparedSections) -> None:
    """Draw the bar, what both parts have, and what each program alone has removed."""
    axes.add_patch(_patch(turned.stock.region, fc=SHADES["raw"], ec=GREY, lw=0.8, ls="--", zorder=1))
    common = turned.first.region.intersection(turned.second.region)
    axes.add_patch(_patch(common, fc=SHADES["part"], ec="none", zorder=2))
    for name, region in _gone(turned):
        axes.add_patch(_patch(region, fc=COLOURS[name], ec=COLOURS[name], lw=1.4, alpha=SHADE, zorder=3))
        axes.add_patch(_patch(region, fill=False, ec="white", lw=0.0, hatch=HATCHES[name], zorder=3.2))
    for name, part in (("first", turned.first), ("second", turned.second)):
        axes.add_patch(_patch(part.region, fill=False, ec=COLOURS[name], zorder=4, **OUTLINES[name]))
    axes.axhline(0, color=INK, lw=0.8, ls=(0, (12, 3, 2, 3)), zorder=5)


def _gone(turned: ComparedSections) -> Iterator[tuple[str, BaseGeometry]]:
    yield "first", gone_only(turned.first, turned.second)
    yield "second", gone_only(turned.second, turned.first)


def _patch(region: BaseGeometry, **style: object) -> PathPatch:
    """Return a region with its holes as a patch."""
    rings = [Outline(np.asarray(ring.coords), closed=True) for ring in shapely.get_rings(shapely.get_parts(region))]
    return PathPatch(Outline.make_compound_path(*rings) if rings else Outline(np.zeros((0, 2))), **style)  # type: ignore[arg-type]


def _enlarge(
    figure: Figure, section: Axes, place_inch: Box, turned: ComparedSections, words: Mapping[str, str]
) -> None:
    """Show the place of the largest difference larger beside the whole, and where that is."""
    ring = turned.rings[0]
    radius, z = ring.place_mm
    *_, width, height = place_inch
    low, _, high, radius_high = _box(turned)
    up = min(SEEN_DEPTHS / 2 * ring.depth_mm, radius_high / 3, (high - low) / 3 * height / width)
    along = up * width / height
    near = _axes(figure, place_inch, (z - along, radius - up, z + along, radius + up))
    near.xaxis.set_major_locator(MaxNLocator(4))
    near.set(ylabel="")
    _sections(near, turned)
    inch_a_mm = height / np.ptp(section.get_ylim())
    text = words["enlarged"].format(times=height / (2 * up) / inch_a_mm)
    near.set_title(text, fontsize=10.5, color=GREY, loc="left")
    mark(section, z, radius)
    frame = Rectangle((z - along, radius - up), 2 * along, 2 * up, fill=False, ec=INK, lw=0.7, zorder=7)
    section.add_patch(frame)


def _drawn(pieces: Segments, finest_mm: float) -> Iterator[np.ndarray]:
    """Yield pieces as lines without points that would be drawn as one, none too long for the painter."""
    for chain in chains(pieces):
        line = shapely.get_coordinates(shapely.simplify(shapely.LineString(chain[:, list(LATHE)]), finest_mm / 2))
        for first, last in pairwise([*range(0, len(line) - 1, LONGEST), len(line) - 1]):
            yield line[first : last + 1]


def _of_parts(turned: ComparedSections, names: tuple[str, str], words: Mapping[str, str]) -> Iterator[Artist]:
    """Yield the entries of the legend of the parts, with what each program alone has removed."""
    for key, name, volume in zip(("first", "second"), names, turned.volumes_mm3, strict=True):
        text = words["removed"].format(name=name, volume=volume / 1000)
        yield Patch(fc=COLOURS[key], ec=COLOURS[key], alpha=SHADE, hatch=HATCHES[key], label=text)
    yield Patch(fc=SHADES["part"], ec=INK, lw=0.6, label=words["left"])
    yield Patch(fc=SHADES["raw"], ec=GREY, ls="--", lw=0.8, label=words["bar"])
    if turned.rings:
        yield mark_entry(words["deepest"].format(distance=turned.rings[0].depth_mm))


def _legend(figure: Figure, top_inch: float, entries: Iterable[Artist]) -> None:
    place = (0.5, top_inch / figure.get_figheight())
    figure.legend(handles=list(entries), loc="upper center", bbox_to_anchor=place, **LEGEND)
