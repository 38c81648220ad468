# SPDX-License-Identifier: LGPL-2.1-or-later
"""The offer of an order as PDF: what is made of what, the price of a part and of a row, the sum."""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO
from pathlib import Path

from matplotlib.backends.backend_pdf import PdfPages
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from CNCStepper.atomic_file import write_whole
from CNCStepper.job.batch.order_costs import row_figures, total_figures
from CNCStepper.job.batch.order_tables import state_of
from CNCStepper.job.batch.run_batch import BatchResult
from CNCStepper.output_files import MADE_BY
from CNCStepper.simulation.views.picture_style import GREY, INK

A4_INCH = (8.27, 11.69)
MARGIN_INCH, LINE_INCH = 0.8, 0.24
ROWS_A_PAGE = 32
LONGEST = 34  # characters of a part's name
COLUMNS = (  # title, place of its end in inches, or of its begin where the text is on its left
    ("Part", 0.8, "left"),
    ("Material", 3.6, "left"),
    ("Thickness", 5.2, "right"),
    ("Count", 5.85, "right"),
    ("Each", 6.6, "right"),
    ("Price", 7.47, "right"),
)
Cells = tuple[str, ...]


def save_offer(file: Path, result: BatchResult, title: str) -> None:
    """Write the offer of an order; rows that are not made are named without a price."""
    about = {"Title": title, "Creator": MADE_BY, "CreationDate": None}
    rows, buffer = _rows(result), BytesIO()
    pages = [rows[first : first + ROWS_A_PAGE] for first in range(0, len(rows), ROWS_A_PAGE)]
    with PdfPages(buffer, metadata=about) as pdf:
        for number, page in enumerate(pages, start=1):
            pdf.savefig(_page(title, page, number, len(pages), result))
    write_whole(file, buffer.getvalue())


def _rows(result: BatchResult) -> list[Cells]:
    rows: list[Cells] = []
    for number, (row, figures) in enumerate(zip(result.rows, row_figures(result), strict=True)):
        sound = state_of(result, number) == "done"
        each = price = ""
        if sound and figures.cost is not None:
            each, price = f"{figures.cost / row.count:.2f}", f"{figures.cost:.2f}"
        thickness = "" if row.thickness_mm is None else f"{row.thickness_mm:g} mm"
        name = row.drawing.stem
        name = name if len(name) <= LONGEST else name[: LONGEST - 1] + "…"
        rows.append((name if sound else f"{name} (not offered)", row.material, thickness, f"{row.count}", each, price))
    return rows


def _page(title: str, rows: Sequence[Cells], number: int, pages: int, result: BatchResult) -> Figure:
    figure = Figure(figsize=A4_INCH)
    y = A4_INCH[1] - MARGIN_INCH - 0.2
    _text(figure, MARGIN_INCH, y, title, size=18, weight="bold")
    y -= 0.55
    for name, x, side in COLUMNS:
        _text(figure, x, y, name, side, colour=GREY)
    _rule(figure, y - 0.08)
    for cells in rows:
        y -= LINE_INCH
        for (_, x, side), cell in zip(COLUMNS, cells, strict=True):
            _text(figure, x, y, cell, side)
    if number == pages:
        _sum(figure, y - 0.12, result)
    _text(figure, MARGIN_INCH, 0.5, MADE_BY, colour=GREY, size=8)
    _text(figure, A4_INCH[0] - MARGIN_INCH, 0.5, f"{number} / {pages}", "right", colour=GREY, size=8)
    return figure


def _sum(figure: Figure, y: float, result: BatchResult) -> None:
    """Write the sum, and what it takes."""
    total = total_figures(result)
    _rule(figure, y)
    y -= LINE_INCH
    _text(figure, MARGIN_INCH, y, "Total", weight="bold")
    cost = "no rates in the machine's profile" if total.cost is None else f"{total.cost:.2f} {total.currency}".strip()
    _text(figure, COLUMNS[-1][1], y, cost, "right", weight="bold")
    y -= 1.6 * LINE_INCH
    facts = (
        f"{total.parts} parts on {total.sheets:g} sheets, {total.metres:.1f} m cut, {total.pierces:.0f} pierces, "
        f"{total.hours:.2f} hours of the machine"
    )
    _text(figure, MARGIN_INCH, y, facts, colour=GREY, size=9)


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
