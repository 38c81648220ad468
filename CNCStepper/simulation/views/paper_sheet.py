# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program on paper: what it is, the work surface with the tool's path, and the text with line numbers.

The work surface is seen from above; a program without Y is a lathe's and is seen with Z to the right.

PDF in A4 pages through matplotlib, or one HTML page that needs nothing beside it.
"""

from __future__ import annotations

import html
import textwrap
from collections.abc import Iterator
from dataclasses import dataclass
from io import BytesIO, StringIO
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_pdf import PdfPages
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from matplotlib.patches import Polygon, Rectangle
from matplotlib.textpath import text_to_path

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import JobError, Text
from CNCStepper.gcode.syntax.words import program_lines
from CNCStepper.output_files import MADE_BY
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.views.path_lines import FROM_ABOVE, LATHE, drawn_path
from CNCStepper.simulation.views.picture_style import COLOURS, GREY, GROUND, INK, STOCK_COLOUR, TEXTS, draw_path, legend
from CNCStepper.toolpath import Toolpath

A4_INCH = (8.27, 11.69)
MARGIN_INCH = 0.6
TEXT_POINTS, LINE_INCH = 7.0, 0.125
COLUMNS, CHARACTERS = 2, 48  # of the text on a page, and in a line of a column beside its number
MOST_CHARACTERS = 120  # that are ever tried in a line of the head
TITLE_INCH, FACT_INCH = 0.3, 0.22
LEAST_MM, NARROWEST = 10.0, 0.25  # what a picture shows at least, and its shorter side in shares of the longer
KINDS = (".pdf", ".html", ".htm")
PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="generator" content="made by CNCStepper"><title>{title}</title><style>
body {{ font: 14px sans-serif; color: {ink}; max-width: 60em; margin: 2em auto; }}
h1 {{ font-size: 22px; }} th {{ text-align: left; font-weight: normal; color: {grey}; padding-right: 1.5em; }}
svg {{ max-width: 100%; height: auto; }} ol {{ font: 12px monospace; columns: 2; column-gap: 3em; padding-left: 4em; }}
li {{ white-space: pre-wrap; overflow-wrap: anywhere; break-inside: avoid; }} li::marker {{ color: {grey}; }}
@media print {{ body {{ margin: 0; max-width: none; }} ol {{ break-before: page; font-size: 9px; }} }}
</style></head><body>
<h1>{title}</h1>
<table>{facts}</table>
{picture}
<ol>{lines}</ol>
</body></html>
"""


@dataclass(frozen=True)
class Sheet:
    """What is printed. facts: (name, value), as file, process, material. stock: None where it is not known.

    limits_mm: low and high corner of the travel in work coordinates, float64[2, 3], None where the work zero is not
    known. bar_mm: the same of a lathe's bar in half section, X the radius.
    """

    title: str
    facts: tuple[tuple[str, str], ...]
    text: str
    toolpath: Toolpath
    stock: Stock | None = None
    limits_mm: np.ndarray | None = None
    bar_mm: np.ndarray | None = None


def save_sheet(file: Path, sheet: Sheet) -> None:
    """Write a program's sheet as PDF or HTML, as the file's name ends; raises JobError for another ending."""
    if file.suffix.lower() not in KINDS:
        what = Text("'{file}' is no kind of sheet that can be written", file=file.name)
        raise JobError("sheet-kind", what, advice="end it in .pdf or .html")
    if file.suffix.lower() == ".pdf":
        about = {"Title": sheet.title, "Creator": MADE_BY, "CreationDate": None}
        buffer = BytesIO()
        with PdfPages(buffer, metadata=about) as pages:
            for figure in _pages(sheet):
                pages.savefig(figure)
        write_whole(file, buffer.getvalue())
    else:
        write_whole(file, _html(sheet).encode("utf-8"))


def _pages(sheet: Sheet) -> Iterator[Figure]:
    """Yield the first page, with the picture, then the text."""
    rows = _rows(sheet.text)
    on_a_page = COLUMNS * int((A4_INCH[1] - 3 * MARGIN_INCH) / LINE_INCH)
    texts = [rows[first : first + on_a_page] for first in range(0, len(rows), on_a_page)]
    figure = Figure(figsize=A4_INCH)
    top = _head(figure, sheet) - 0.3
    _picture(figure, sheet, (MARGIN_INCH + 0.3, 1.3, A4_INCH[0] - 2 * MARGIN_INCH - 0.3, top - 1.3))
    _foot(figure, sheet, 1, 1 + len(texts))
    yield figure
    for number, text in enumerate(texts, start=2):
        figure = Figure(figsize=A4_INCH)
        for column in range(COLUMNS):
            part = text[column * on_a_page // COLUMNS : (column + 1) * on_a_page // COLUMNS]
            x = MARGIN_INCH + column * (A4_INCH[0] - 2 * MARGIN_INCH) / COLUMNS
            figure.text(
                x / A4_INCH[0],
                1 - 1.2 * MARGIN_INCH / A4_INCH[1],
                "\n".join(part),
                fontsize=TEXT_POINTS,
                family="monospace",
                va="top",
                linespacing=LINE_INCH * 72 / TEXT_POINTS,
                parse_math=False,
                color=INK,
            )
        _foot(figure, sheet, number, 1 + len(texts))
        yield figure


def _rows(text: str) -> list[str]:
    """Return the lines with their numbers, long ones as several."""
    rows: list[str] = []
    for number, line in enumerate(program_lines(text), start=1):
        clean = "".join(letter if letter.isprintable() else " " for letter in line)
        parts = textwrap.wrap(clean, CHARACTERS, drop_whitespace=False) or [""]
        rows += [f"{number:6d}  {parts[0]}", *(f"{'':8}{part}" for part in parts[1:])]
    return rows


def _head(figure: Figure, sheet: Sheet) -> float:
    """Write title and facts, long ones in several lines; return how high above the foot they end, in inches."""
    width, height = A4_INCH
    x, y = MARGIN_INCH / width, height - 0.8
    for line in _broken(sheet.title, 16, width - 2 * MARGIN_INCH, "bold"):
        figure.text(x, y / height, line, fontsize=16, fontweight="bold", color=INK, parse_math=False)
        y -= TITLE_INCH
    y -= 0.05
    for name, value in sheet.facts:
        figure.text(x, y / height, name, fontsize=10, color=GREY, parse_math=False)
        for line in _broken(value, 10, width - 2 * MARGIN_INCH - 1.2):
            figure.text(x + 1.2 / width, y / height, line, fontsize=10, color=INK, parse_math=False)
            y -= FACT_INCH
    return y


def _broken(text: str, points: float, wide_inch: float, weight: str = "normal") -> list[str]:
    """Return a text as lines that are not wider than that, words whole where they can be."""
    font = FontProperties(size=points, weight=weight)
    lines = [""]
    for characters in range(MOST_CHARACTERS, 0, -1):
        lines = textwrap.wrap(text, characters) or [""]
        if all(text_to_path.get_text_width_height_descent(line, font, False)[0] <= 72 * wide_inch for line in lines):
            break
    return lines


def _foot(figure: Figure, sheet: Sheet, number: int, count: int) -> None:
    width, height = A4_INCH
    y = 0.35 / height
    title, *more = _broken(sheet.title, 8, width - 2 * MARGIN_INCH - 0.8)
    title += "\N{HORIZONTAL ELLIPSIS}" * bool(more)
    figure.text(MARGIN_INCH / width, y, title, fontsize=8, color=GREY, parse_math=False)
    figure.text(1 - MARGIN_INCH / width, y, f"{number} / {count}", fontsize=8, color=GREY, ha="right")


def _picture(figure: Figure, sheet: Sheet, box_inch: tuple[float, float, float, float]) -> None:
    """Draw the work surface at the top of a box (left, bottom, width, height), as large as fits; nothing if empty."""
    left, bottom, width, height = box_inch
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    names = _draw(axes, sheet)
    if names == ["zero"]:
        axes.remove()
        return
    size_mm = _shown_mm(axes)
    scale = min(width / size_mm[0], height / size_mm[1])
    wide, high = size_mm * scale
    place = np.array([left + (width - wide) / 2, bottom + height - high, wide, high])
    axes.set_position(tuple(place / np.tile(figure.get_size_inches(), 2)))
    legend(figure, names, (left + width / 2) / figure.get_size_inches()[0], place[1] - 0.75)


def _shown_mm(axes: Axes) -> np.ndarray:
    """Widen a narrow view, so that it has room for its numbers; return width and height in mm."""
    limits = np.array([axes.get_xlim(), axes.get_ylim()])
    size = limits[:, 1] - limits[:, 0]
    wanted = np.maximum(size, max(LEAST_MM, NARROWEST * size.max()))
    low = limits.mean(axis=1) - wanted / 2
    axes.set(xlim=(low[0], low[0] + wanted[0]), ylim=(low[1], low[1] + wanted[1]))
    return wanted


def _draw(axes: Axes, sheet: Sheet) -> list[str]:
    """Draw travel, stock, path and work zero; return what there is, for the legend, "zero" alone where nothing is."""
    seen = list(LATHE if sheet.bar_mm is not None else _seen(sheet.toolpath))
    axes.set_facecolor(GROUND)
    axes.grid(color="white", lw=0.8)
    axes.set_axisbelow(True)
    names = draw_path(axes, drawn_path(sheet.toolpath, tuple(seen)), lambda points: points[:, seen], plunge_lines=False)
    if (workpiece := _workpiece(sheet, seen)) is not None:
        axes.add_patch(workpiece)
        names = [*names, "workpiece"]
    axes.plot(0, 0, "+", color=COLOURS["zero"], ms=14, mew=2.0, zorder=5)
    if sheet.limits_mm is not None:
        low, high = sheet.limits_mm[:, seen]
        axes.add_patch(Rectangle(tuple(low), *(high - low), fill=False, ec=COLOURS["limits"], ls=(0, (6, 3)), lw=1.2))
        names = [*names, "limits"]
    horizontal, vertical = (TEXTS["axis"].format(name="XYZ"[axis]) for axis in seen)
    axes.set(xlabel=horizontal, ylabel=vertical)
    axes.autoscale_view()
    axes.margins(0.04)
    return [*names, "zero"]


def _seen(toolpath: Toolpath) -> tuple[int, int]:
    """Return the two axes that a picture of the path shows."""
    ends = toolpath.table().end
    return LATHE if len(ends) and np.isnan(ends[:, 1]).all() and np.isfinite(ends[:, 2]).any() else FROM_ABOVE


def _workpiece(sheet: Sheet, seen: list[int]) -> Polygon | Rectangle | None:
    """Return the outline of the stock or the bar as it is seen, None where neither is known."""
    style: dict[str, Any] = {"fc": STOCK_COLOUR, "ec": INK, "lw": 1.0, "zorder": 1}
    stock = sheet.stock
    if sheet.bar_mm is not None:
        low, high = sheet.bar_mm[:, seen]
    elif stock is None:
        return None
    elif tuple(seen) == FROM_ABOVE:
        return Polygon(np.asarray(stock.outline.exterior.coords), **style)
    else:
        low, high = np.asarray(stock.low_mm)[seen], np.asarray(stock.high_mm)[seen]
    return Rectangle(tuple(low), *(high - low), **style)


def _html(sheet: Sheet) -> str:
    figure = Figure(figsize=(9.0, 7.0))
    _picture(figure, sheet, (0.8, 1.2, 8.0, 5.6))
    drawing = StringIO()
    with matplotlib.rc_context({"svg.hashsalt": "CNCStepper"}):  # the same picture is the same bytes
        figure.savefig(drawing, format="svg", metadata={"Date": None}, bbox_inches="tight")
    picture = drawing.getvalue()
    facts = (f"<tr><th>{html.escape(name)}</th><td>{html.escape(value)}</td></tr>" for name, value in sheet.facts)
    lines = (f"<li>{html.escape(line)}</li>" for line in program_lines(sheet.text))
    return PAGE.format(
        title=html.escape(sheet.title),
        facts="".join(facts),
        picture=picture[picture.index("<svg") :],
        lines="\n".join(lines),
        ink=INK,
        grey=GREY,
    )
