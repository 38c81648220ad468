# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of a drawing: its chains in their colours, and what is wrong with it, marked at its place."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from CNCStepper.drawing.chain_list import counts_of, drawing_box_mm
from CNCStepper.drawing.drawing import Chain, Drawing
from CNCStepper.drawing.repair.problems import KINDS, Kind, Problem
from CNCStepper.geometry.curve import Curve
from CNCStepper.simulation.views.picture_style import GREY, GROUND, INK, head, new_figure, number_text, save_figure

WIDTH_INCH, HEAD_INCH, FOOT_INCH, SIDE_INCH = 11.0, 1.05, 0.75, 0.95
LEAST_INCH, MOST_INCH = 3.0, 11.0  # height of the drawn area
CHORD_SHARE = 1.0 / 4000.0  # of the drawing's size: how far chords leave the arcs
MARGIN = 0.05
MOST_MARKS, MOST_NUMBERS, MOST_LAYERS = 2000, 40, 8
MARK_SPACING = 0.012  # of the width: problems that are nearer have their numbers in one place
PALETTE = ("#1f4e9e", "#b4530a", "#2f7d32", "#7a3fa0", "#0f7f86", "#8a6d00", "#a12c5b", "#4a5460")
LIGHTEST = 0.72  # of the luminance: lighter lines could not be seen on the paper
STYLES: dict[Kind, dict[str, Any]] = {
    "open": {"marker": "o", "color": "#b06a00"},
    "gap": {"marker": "s", "color": "#c0267e"},
    "double": {"marker": "D", "color": "#0b7285"},
    "tiny": {"marker": "v", "color": "#5b1fa6"},
    "crossing": {"marker": "X", "color": "#c92a2a"},
    "overlap": {"marker": "P", "color": "#c92a2a"},
}


def save_drawing_picture(file: Path, drawing: Drawing, title: str, problems: Sequence[Problem] = ()) -> None:
    """Draw a drawing as PNG or SVG, as the file's name ends; problems are numbered as they are listed.

    Raises JobError for another ending.
    """
    box = drawing_box_mm(drawing.chains)
    figure, axes = _paper(box)
    head(figure, title, _facts(drawing, box))
    lines = _draw_chains(axes, drawing, box)
    marks = _draw_problems(axes, problems)
    _legend(figure, [*lines, *marks])
    save_figure(figure, file)


def _paper(box: tuple[float, float, float, float]) -> tuple[Figure, Axes]:
    """Return a figure in the drawing's proportions and its axes, millimetres along both."""
    left, low, right, high = box
    margin = MARGIN * max(right - left, high - low)
    wide, tall = right - left + 2.0 * margin, high - low + 2.0 * margin
    inside = WIDTH_INCH - 2.0 * SIDE_INCH
    height = float(np.clip(inside * tall / wide, LEAST_INCH, MOST_INCH))
    whole = height + HEAD_INCH + FOOT_INCH + 0.55
    figure = new_figure(WIDTH_INCH, whole)
    place = (SIDE_INCH / WIDTH_INCH, (FOOT_INCH + 0.55) / whole, inside / WIDTH_INCH, height / whole)
    axes = figure.add_axes(place)
    axes.set_facecolor(GROUND)
    axes.grid(color="white", lw=0.8)
    axes.set_axisbelow(True)
    axes.set(xlabel="X (mm)", ylabel="Y (mm)", aspect="equal")
    axes.set_xlim(left - margin, right + margin)
    axes.set_ylim(low - margin, high + margin)
    return figure, axes


def _facts(drawing: Drawing, box: tuple[float, float, float, float]) -> Iterable[str]:
    left, low, right, high = box
    closed = sum(chain.curve.closed for chain in drawing.chains)
    yield f"{right - left:.6g} × {high - low:.6g} mm"
    yield f"from X{number_text(round(left, 3))} Y{number_text(round(low, 3))}"
    yield f"{closed} closed, {len(drawing.chains) - closed} open chains"


def _draw_chains(axes: Axes, drawing: Drawing, box: tuple[float, float, float, float]) -> list[Line2D]:
    """Draw the chains and return the entries of the legend, one a layer and colour."""
    left, low, right, high = box
    chord_mm = CHORD_SHARE * max(right - left, high - low, 1e-3)
    entries = []
    for number, count in enumerate(counts_of(drawing.chains)):
        colour = seen_colour(count.colour, number)
        own = [chain for chain in drawing.chains if _is_of(chain, count.layer, count.colour)]
        lines = LineCollection([_points(chain.curve, chord_mm) for chain in own], colors=colour, linewidths=1.3)
        axes.add_collection(lines)
        filled = [_points(chain.curve, chord_mm) for chain in own if chain.attributes.filled and chain.curve.closed]
        for points in filled if len(filled) <= MOST_MARKS else []:
            axes.fill(*points.T, color=colour, alpha=0.10, lw=0)
        if number < MOST_LAYERS:
            label = f"{count.layer or 'no layer'} {count.colour}".strip()
            entries.append(Line2D([], [], color=colour, lw=1.8, label=f"{label}: {count.closed + count.open}"))
    return entries


def _is_of(chain: Chain, layer: str, colour: str) -> bool:
    return chain.attributes.layer == layer and chain.attributes.colour == colour


def _points(curve: Curve, chord_mm: float) -> np.ndarray:
    return curve.points(chord_mm) if curve.bulge.any() else curve.xy


def seen_colour(colour: str, number: int) -> str:
    """Return a colour in which a line is seen on white paper: its own, one of the palette for none or a light one."""
    if not colour:
        return PALETTE[number % len(PALETTE)]
    red, green, blue = to_rgb(colour)
    return colour if 0.2126 * red + 0.7152 * green + 0.0722 * blue < LIGHTEST else PALETTE[number % len(PALETTE)]


def _draw_problems(axes: Axes, problems: Sequence[Problem]) -> list[Line2D]:
    """Mark problems with their numbers, and return the entries of the legend, one a kind."""
    marked: Mapping[Kind, list[Problem]] = {kind: [] for kind in KINDS}
    for problem in problems[:MOST_MARKS]:
        marked[problem.kind].append(problem)
    for kind, own in marked.items():
        if own:
            places = np.array([problem.place_mm for problem in own])
            axes.plot(*places.T, ls="", ms=8, mec="white", mew=0.8, zorder=5, **STYLES[kind])
    near_mm = MARK_SPACING * (axes.get_xlim()[1] - axes.get_xlim()[0])
    for place_mm, numbers, kind in _numbers(problems[:MOST_NUMBERS], near_mm):
        colour = STYLES[kind]["color"]
        axes.annotate(numbers, place_mm, (6, 5), textcoords="offset points", fontsize=9, color=colour, zorder=6)
    return [
        Line2D([], [], ls="", ms=8, label=f"{KINDS[kind]}: {len(own)}", **STYLES[kind])
        for kind, own in marked.items()
        if own
    ]


def _numbers(problems: Sequence[Problem], near_mm: float) -> list[tuple[tuple[float, float], str, Kind]]:
    """Return where numbers are written, those of problems in one place together, and the kind of the first."""
    found: dict[tuple[int, int], tuple[tuple[float, float], list[str], Kind]] = {}
    for number, problem in enumerate(problems, start=1):
        x, y = problem.place_mm
        cell = (round(x / near_mm), round(y / near_mm))
        found.setdefault(cell, (problem.place_mm, [], problem.kind))[1].append(str(number))
    return [(place_mm, ", ".join(numbers), kind) for place_mm, numbers, kind in found.values()]


def _legend(figure: Figure, entries: Sequence[Line2D]) -> None:
    figure.legend(
        handles=list(entries),
        loc="lower center",
        bbox_to_anchor=(0.5, 0.12 / figure.get_size_inches()[1]),
        ncols=min(max(len(entries), 1), 4),
        frameon=False,
        fontsize=10,
        labelcolor=INK if entries else GREY,
        columnspacing=1.6,
    )
