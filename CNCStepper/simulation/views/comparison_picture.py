# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of two tool paths over each other: common, only in the first, only in the second; cuts and rapids.

A mill's or a table's paths are seen from above, and from the side where they have heights; a lathe's in its XZ plane.
The colours are told apart by the colour-blind, and the lines by width and dashes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from CNCStepper.simulation.comparison.path_overlay import PathComparison
from CNCStepper.simulation.comparison.picture_words import WORDS
from CNCStepper.simulation.tip_segments import Segments, chains
from CNCStepper.simulation.views.path_lines import FROM_ABOVE, LATHE
from CNCStepper.simulation.views.picture_style import GROUND, INK, TEXTS, head, new_figure, save_figure

COLOURS = {"common": "#8a929b", "first": "#d55e00", "second": "#0072b2"}  # of Okabe and Ito's palette
DASHES: dict[str, Any] = {"common": "-", "first": "-", "second": (0, (5, 1.5))}
WIDTHS = {"common": 0.9, "first": 2.6, "second": 1.5}
ORDER = ("common", "first", "second")
RAPID_WIDTH, RAPID_DASHES = 0.8, (0, (1, 2))
WIDTH_INCH, HEAD_INCH, FOOT_INCH, LEFT_INCH, GAP_INCH = 12.0, 1.05, 1.15, 0.95, 0.75
MOST_INCH, LEAST_INCH, SIDE_INCH = 8.0, 3.0, 1.6  # heights of the views
MARGIN = 0.04
FINEST = 4000  # points nearer than that share of the view are drawn as one
LONGEST = 5000  # points of a drawn line
SIDE = (0, 2)
LEGEND: dict[str, Any] = {"ncols": 3, "frameon": False, "fontsize": 10.5, "columnspacing": 1.6, "handlelength": 3.2}


def save_comparison(
    file: Path,
    found: PathComparison,
    names: tuple[str, str],
    facts: Sequence[str] = (),
    words: Mapping[str, str] = WORDS,
) -> None:
    """Draw both paths as PNG or SVG, as the file's name ends; words: those of WORDS in another language.

    Raises JobError for another ending.
    """
    box = path_corners(found)
    seen = _plane(box)
    views = [seen] if seen == LATHE or box[1, 2] - box[0, 2] <= 0 else [seen, SIDE]
    figure, axes = _paper(box, views)
    head(figure, " · ".join(names), facts)
    for view, place in zip(views, axes, strict=True):
        _draw(place, found, view, box)
    _legend(figure, found, names, words)
    save_figure(figure, file)


def path_corners(found: PathComparison) -> np.ndarray:
    """Return the low and the high corner of both paths, float64[2, 3]; a millimetre where there is nothing."""
    ends = [each for judged in (found.first, found.second) for each in (judged.pieces.begin, judged.pieces.end)]
    points = np.vstack([*ends, np.zeros((1, 3))]) if not sum(map(len, ends)) else np.vstack(ends)
    return np.stack([points.min(axis=0), points.max(axis=0)])


def _plane(box: np.ndarray) -> tuple[int, int]:
    """Return the plane that is looked at: ZX for paths without Y, as a lathe's, else XY."""
    size = box[1] - box[0]
    return LATHE if size[1] == 0 < size[2] else FROM_ABOVE


def _paper(box: np.ndarray, views: Sequence[tuple[int, int]]) -> tuple[Figure, list[Axes]]:
    """Return a figure with a place for each view, one below the other; the first has one scale in both directions."""
    size = np.maximum(box[1] - box[0], 1e-3)
    inside = WIDTH_INCH - 2 * LEFT_INCH
    across, up = (size[axis] * (1 + 2 * MARGIN) for axis in views[0])
    heights = [float(np.clip(inside * up / across, LEAST_INCH, MOST_INCH)), SIDE_INCH][: len(views)]
    whole = HEAD_INCH + sum(heights) + FOOT_INCH + GAP_INCH * (len(views) - 1)
    figure, top, axes = new_figure(WIDTH_INCH, whole), whole - HEAD_INCH, []
    for number, height in enumerate(heights):
        top -= height + (GAP_INCH if number else 0.0)
        place = figure.add_axes((LEFT_INCH / WIDTH_INCH, top / whole, inside / WIDTH_INCH, height / whole))
        place.set_facecolor(GROUND)
        place.grid(color="white", lw=0.8)
        place.set_axisbelow(True)
        axes.append(place)
    return figure, axes


def _draw(axes: Axes, found: PathComparison, seen: tuple[int, int], box: np.ndarray) -> None:
    """Draw both paths and mark the largest deviation in one view."""
    low, high = (box[side, list(seen)] for side in (0, 1))
    margin = MARGIN * max(float((high - low).max()), 1e-3)
    finest_mm = max(float((high - low).max()), 1e-3) / FINEST
    draw_paths(axes, found, seen, lambda pieces: _lines(pieces, seen, finest_mm))
    axes.set(xlabel=TEXTS["axis"].format(name="XYZ"[seen[0]]), ylabel=TEXTS["axis"].format(name="XYZ"[seen[1]]))
    axes.set_xlim(low[0] - margin, high[0] + margin)
    if seen == SIDE:
        spare = MARGIN * max(float(high[1] - low[1]), 1e-3) * 2
        axes.set_ylim(low[1] - spare, high[1] + spare)
    else:
        axes.set_ylim(low[1] - margin, high[1] + margin)
        axes.set_aspect("equal")


def draw_paths(
    axes: Axes, found: PathComparison, seen: tuple[int, int], lines_of: Callable[[Segments], Iterable[np.ndarray]]
) -> None:
    """Draw both paths in a plane, and mark their largest deviation; lines_of: the lines that are drawn of segments."""
    for name, pieces, rapid in _kinds(found):
        width, dashes = (RAPID_WIDTH, RAPID_DASHES) if rapid else (WIDTHS[name], DASHES[name])
        style = {"colors": COLOURS[name], "linewidths": width, "linestyles": [dashes]}
        axes.add_collection(LineCollection(list(lines_of(pieces)), zorder=2 + ORDER.index(name), **style))
    if found.deviation is not None:
        mark(axes, *np.array(found.deviation.place_mm)[list(seen)])


def mark(axes: Axes, x: float, y: float) -> None:
    """Draw a circle about a place; `mark_entry` names it in the legend."""
    axes.plot(x, y, "o", ms=16, mfc="none", mec=INK, mew=1.6, zorder=8)


def mark_entry(text: str) -> Line2D:
    """Return the entry of the legend for a circle that `mark` draws."""
    return Line2D([], [], ls="", marker="o", ms=10, mfc="none", mec=INK, label=text)


def _kinds(found: PathComparison) -> Iterator[tuple[str, Segments, bool]]:
    """Yield name, pieces and whether they are rapids of all that is drawn, what is on top last."""
    for rapid in (True, False):
        yield "common", found.first.chosen(not rapid, True), rapid
        yield "first", found.first.chosen(not rapid, False), rapid
        yield "second", found.second.chosen(not rapid, False), rapid


def _lines(pieces: Segments, seen: tuple[int, int], finest_mm: float) -> Iterator[np.ndarray]:
    """Yield the pieces as lines, without points that would be drawn as one, and none too long for the painter."""
    for chain in chains(pieces):
        flat = chain[:, list(seen)]
        cells = np.round(flat / finest_mm)
        kept = np.append(True, (cells[1:] != cells[:-1]).any(axis=1))
        kept[-1] = True
        flat = flat[kept]
        for first in range(0, max(len(flat) - 1, 1), LONGEST - 1):
            yield flat[first : first + LONGEST]


def path_entries(found: PathComparison, names: tuple[str, str], words: Mapping[str, str]) -> Iterator[Line2D]:
    """Yield the entries of the legend of the paths, with the length of cut that each has alone."""
    texts = {"common": words["common"]}
    for key, name, judged in zip(("first", "second"), names, (found.first, found.second), strict=True):
        texts[key] = f"{words[key].format(name=name)}: {judged.length_mm(True, False):.2f} mm"
    for key in ORDER:
        yield Line2D([], [], color=COLOURS[key], lw=WIDTHS[key], ls=DASHES[key], label=texts[key])
    yield Line2D([], [], color=INK, lw=RAPID_WIDTH * 1.4, ls=RAPID_DASHES, label=words["rapid"])
    if found.deviation is not None:
        yield mark_entry(words["deviation"].format(distance=found.deviation.distance_mm))


def _legend(figure: Figure, found: PathComparison, names: tuple[str, str], words: Mapping[str, str]) -> None:
    entries = list(path_entries(found, names, words))
    foot = (0.5, 0.12 / figure.get_size_inches()[1])
    figure.legend(handles=entries, loc="lower center", bbox_to_anchor=foot, **LEGEND)
