# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of an order: as CSV for a spreadsheet, and as text for a person, with what was refused below."""

from __future__ import annotations

import csv
from collections.abc import Iterator, Sequence
from io import StringIO

from CNCStepper.errors import CNCStepperError, Text
from CNCStepper.job.batch.order_costs import Figures, figures_of, row_figures, total_figures
from CNCStepper.job.batch.run_batch import BatchResult
from CNCStepper.output_files import MADE_BY
from CNCStepper.safe_text import printable

HEAD = (
    "line", "drawing", "template", "material", "thickness_mm", "count",
    "made", "sheets", "metres", "pierces", "hours", "cost", "currency", "state",
)  # fmt: skip
SHEET_HEAD = ("sheet", "parts", "metres", "pierces", "hours", "cost", "currency", "state")
TEXT_COLUMNS = ("line", "drawing", "material", "thickness_mm", "count", "made", "sheets", "metres", "pierces", "hours",
                "cost", "state")  # fmt: skip
LONGEST = 80  # characters of a cell
LEFT = ("drawing", "material", "state", "sheet")


def row_table(result: BatchResult) -> list[dict[str, str]]:
    """Return the rows of the order with their figures, and a last one with the sums, as texts by column."""
    table = []
    for number, (row, figures) in enumerate(zip(result.rows, row_figures(result), strict=True)):
        told = {
            "line": f"{row.line}",
            "drawing": printable(row.drawing.name, LONGEST),
            "template": printable(row.template.name, LONGEST),
            "material": printable(row.material, LONGEST),
            "thickness_mm": "" if row.thickness_mm is None else f"{row.thickness_mm:g}",
            "count": f"{row.count}",
            "state": state_of(result, number),
        }
        table.append(told | _cells(figures))
    wanted = sum(row.count for row in result.rows)
    total = {"drawing": "total", "count": f"{wanted}", "state": "done" if result.is_whole else "incomplete"}
    return [*table, total | _cells(total_figures(result))]


def _cells(figures: Figures) -> dict[str, str]:
    return {
        "made": f"{figures.parts}",
        "sheets": f"{figures.sheets:.2f}",
        "metres": f"{figures.metres:.3f}",
        "pierces": f"{figures.pierces:.0f}",
        "hours": f"{figures.hours:.4f}",
        "cost": "" if figures.cost is None else f"{figures.cost:.2f}",
        "currency": figures.currency,
    }


def state_of(result: BatchResult, number: int) -> str:
    """Return what became of a row: "done", "refused" or how many parts found no place."""
    if number in result.errors:
        return "refused"
    own = [sheet for sheet in result.sheets if number in sheet.rows]
    if any(sheet.error is not None or sheet.result["refused"] for sheet in own):
        return "sheet refused"
    if number in result.unplaced:
        return f"{result.unplaced[number][0]} without a place"
    return "done"


def sheet_table(result: BatchResult) -> list[dict[str, str]]:
    """Return the sheets with their figures, as texts by column."""
    table = []
    for sheet in result.sheets:
        parts = {"sheet": sheet.name, "parts": f"{sum(sheet.rows.values())}"}
        if sheet.error is not None:
            table.append(parts | {"state": "refused"})
        else:
            state = "refused" if sheet.result["refused"] else "done"
            table.append(parts | _cells(figures_of(sheet)) | {"state": state})
    return table


def csv_bytes(head: Sequence[str], table: Sequence[dict[str, str]]) -> bytes:
    """Return a table as CSV."""
    text = StringIO()
    writer = csv.DictWriter(text, head, restval="", extrasaction="ignore", lineterminator="\n")
    writer.writeheader()
    writer.writerows(table)
    return text.getvalue().encode("utf-8")


def text_table(result: BatchResult, title: str) -> str:
    """Return both tables, what the nests save by common lines, and all refusals as text."""
    lines = [f"{title}, {MADE_BY}", "", *_aligned(TEXT_COLUMNS, row_table(result))]
    lines += ["", *_aligned(SHEET_HEAD, sheet_table(result))]
    notes = [f"nest {group}: {note}" for group, nest in sorted(result.nests.items()) for note in nest["notes"]]
    problems = [*notes, *refusals(result)]
    return "\n".join([*lines, *([""] if problems else []), *problems]) + "\n"


def refusals(result: BatchResult) -> Iterator[Text]:
    """Yield a sentence for each row, part and sheet that was not made: where, the value, the remedy."""
    for number, error in sorted(result.errors.items()):
        yield Text("line {line}: {name}: {error}", **_row(result, number), error=error)
    for number, (count, why) in sorted(result.unplaced.items()):
        yield Text("line {line}: {count} of {name} not placed: {why}", **_row(result, number), count=count, why=why)
    for sheet in result.sheets:
        problems: Sequence[str | CNCStepperError] = sheet.result["refused"] if sheet.error is None else [sheet.error]
        yield from (Text("{name}: {error}", name=sheet.name, error=each) for each in problems)


def _row(result: BatchResult, number: int) -> dict[str, object]:
    row = result.rows[number]
    return {"line": row.line, "name": printable(row.drawing.name, LONGEST)}


def _aligned(head: Sequence[str], table: Sequence[dict[str, str]]) -> list[str]:
    rows = [dict(zip(head, head, strict=True)), *table]
    wide = {name: max(len(row.get(name, "")) for row in rows) for name in head}
    return [
        "  ".join(
            row.get(name, "").ljust(wide[name]) if name in LEFT else row.get(name, "").rjust(wide[name])
            for name in head
        ).rstrip()
        for row in rows
    ]
