# SPDX-License-Identifier: LGPL-2.1-or-later
"""The offer of an order as PDF: what is made of what, the price of a part and of a row, the sum.

Only rows that are made whole are offered: the sum is that of the prices above it, each rounded to a hundredth.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from io import BytesIO
from pathlib import Path

from matplotlib.backends.backend_pdf import PdfPages
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import Text
from CNCStepper.job.batch.order_costs import Figures, row_figures
from CNCStepper.job.batch.order_tables import state_of
from CNCStepper.job.batch.run_batch import BatchResult
from CNCStepper.output_files import MADE_BY
from CNCStepper.safe_text import printable
from CNCStepper.simulation.views.picture_style import GREY, INK

A4_INCH = (8.27, 11.69)
MARGIN_INCH, LINE_INCH = 0.8, 0.24
ROWS_A_PAGE = 32
LONGEST, LONGEST_UNOFFERED, LONGEST_MATERIAL = 30, 18, 16  # characters
TITLES = ((38, 18.0), (60, 11.5))  # characters of a title, and the size of their letters
COLUMNS = (  # title, place of its end in inches, or of its begin where the text is on its left
    (Text("Drawing"), 0.8, "left"),
    (Text("Material"), 3.3, "left"),
    (Text("Thickness"), 5.05, "right"),
    (Text("Count"), 5.95, "right"),
    (Text("Each"), 6.7, "right"),
    (Text("Price"), 7.47, "right"),
)
Cells = tuple[str, ...]
LookUp = Callable[[str], str]


def save_offer(file: Path, result: BatchResult, title: str, look_up: LookUp = str) -> None:
    """Write the offer of an order; rows that are not made are named without a price.

    look_up: gives a sentence in the language of the offer.
    """
    about = {"Title": title, "Creator": MADE_BY, "CreationDate": None}
    offered = [figures for _, figures in _offered(result)]
    total, buffer = _total(offered), BytesIO()
    rows = _rows(result, look_up)
    pages = [rows[first : first + ROWS_A_PAGE] for first in range(0, len(rows), ROWS_A_PAGE)]
    with PdfPages(buffer, metadata=about) as pdf:
        for number, page in enumerate(pages, start=1):
            figure = _page(title, page, f"{number} / {len(pages)}", look_up)
            if number == len(pages):
                _sum(figure, _height_inch(len(page)) - 0.12, total, look_up)
            pdf.savefig(figure)
    write_whole(file, buffer.getvalue())


def _offered(result: BatchResult) -> list[tuple[int, Figures]]:
    """Return the rows that are made whole, by number, their prices in whole hundredths."""
    offered = [each for each in enumerate(row_figures(result)) if state_of(result, each[0]) == "done"]
    for _, figures in offered:
        figures.cost = None if figures.cost is None else round(figures.cost, 2)
    return offered


def _total(offered: Sequence[Figures]) -> Figures:
    total = Figures()
    for figures in offered:
        total.parts += figures.parts
        total.add(figures)
    return total


def _rows(result: BatchResult, look_up: LookUp) -> list[Cells]:
    offered, rows = dict(_offered(result)), list[Cells]()
    for number, (row, read) in enumerate(zip(result.rows, result.reads, strict=True)):
        figures, each, price = offered.get(number), "", ""
        if figures and figures.cost is not None:
            each, price = f"{figures.cost / row.count:.2f}", f"{figures.cost:.2f}"
        name = printable(row.drawing.stem, LONGEST if figures else LONGEST_UNOFFERED)
        named = name if figures else Text("{name} (not offered)", name=name).translated(look_up)
        thickness_mm = read.get("thickness_mm", row.thickness_mm)
        thickness = "" if thickness_mm is None else f"{thickness_mm:g} mm"
        material = printable(read.get("material") or row.material, LONGEST_MATERIAL)
        rows.append((named, look_up(material), thickness, f"{row.count}", each, price))
    return rows


def _page(title: str, rows: Sequence[Cells], number: str, look_up: LookUp) -> Figure:
    figure = Figure(figsize=A4_INCH)
    _title(figure, title)
    y = _height_inch(0)
    for name, x, side in COLUMNS:
        _text(figure, x, y, look_up(name), side, colour=GREY)
    _rule(figure, y - 0.08)
    for place, cells in enumerate(rows, start=1):
        for (_, x, side), cell in zip(COLUMNS, cells, strict=True):
            _text(figure, x, _height_inch(place), cell, side)
    _text(figure, MARGIN_INCH, 0.5, MADE_BY, colour=GREY, size=8)
    _text(figure, A4_INCH[0] - MARGIN_INCH, 0.5, number, "right", colour=GREY, size=8)
    return figure


def _title(figure: Figure, title: str) -> None:
    """Write a title on one line, a long one in smaller letters, and cut what does not fit."""
    most, size = next((each for each in TITLES if len(title) <= each[0]), TITLES[-1])
    _text(figure, MARGIN_INCH, A4_INCH[1] - MARGIN_INCH - 0.2, printable(title, most), size=size, weight="bold")


def _height_inch(row: int) -> float:
    """Return where a row of the table stands above the foot of its page; row 0 is its head."""
    return A4_INCH[1] - MARGIN_INCH - 0.75 - row * LINE_INCH


def _sum(figure: Figure, y: float, total: Figures, look_up: LookUp) -> None:
    """Write the sum of what is offered, and what it takes."""
    _rule(figure, y)
    y -= LINE_INCH
    _text(figure, MARGIN_INCH, y, look_up(Text("Total")), weight="bold")
    _text(figure, COLUMNS[-1][1], y, _price(total).translated(look_up), "right", weight="bold")
    y -= 1.6 * LINE_INCH
    facts = Text(
        "{parts} parts on {sheets:.4g} sheets, {metres:.1f} m cut, {pierces:.0f} pierces, "
        "{hours:.2f} hours of the machine",
        parts=total.parts,
        sheets=total.sheets,
        metres=total.metres,
        pierces=total.pierces,
        hours=total.hours,
    )
    _text(figure, MARGIN_INCH, y, facts.translated(look_up), colour=GREY, size=9)


def _price(total: Figures) -> Text:
    if total.cost is not None:
        return Text("{cost:.2f} {currency}", cost=total.cost, currency=total.currency)
    if "," in total.currency:
        return Text("no sum of {currencies}", currencies=total.currency)
    return Text("no rates in the machine's profile")


def _text(
    figure: Figure, x: float, y: float, text: str, side: str = "left", *,
    size: float = 10, weight: str = "normal", colour: str = INK,
) -> None:  # fmt: skip
    figure.text(
        x / A4_INCH[0], y / A4_INCH[1], text, ha=side, fontsize=size, fontweight=weight, color=colour, parse_math=False
    )


def _rule(figure: Figure, y: float) -> None:
    """Draw a line across the page."""
    left, right = MARGIN_INCH / A4_INCH[0], 1.0 - MARGIN_INCH / A4_INCH[0]
    figure.add_artist(Line2D([left, right], [y / A4_INCH[1]] * 2, color=GREY, linewidth=0.8))
