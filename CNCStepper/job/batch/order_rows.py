# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of an order from CSV: drawing, template, material, thickness_mm, count.

    drawing,template,material,thickness_mm,count
    gasket.dxf,sheet-plasma.toml,mild-steel,3,12

Comma or semicolon between the columns; with semicolons numbers may have a decimal comma, as spreadsheets write them in
countries that do. An empty material or thickness is that of the template. Paths are relative to the file. A wrong row
is an error of its own, and the other rows stay.
"""

from __future__ import annotations

import csv
from collections.abc import Callable
from dataclasses import dataclass
from io import StringIO
from pathlib import Path
from typing import Any

from CNCStepper.errors import CNCStepperError, JobError, Place, Text
from CNCStepper.input_file import is_there, read_input
from CNCStepper.nesting.nesting_model import MOST_PARTS
from CNCStepper.quantities import Bounds
from CNCStepper.safe_text import printable

COLUMNS = ("drawing", "template", "material", "thickness_mm", "count")
MOST_BYTES = 16_000_000
MOST_ROWS = 10_000


@dataclass(frozen=True)
class OrderRow:
    """One row. line: of the file, from 1. thickness_mm: None: the template's. error: why the row is refused.

    Of a refused row a count that is wrong is 0, a thickness None.
    """

    line: int
    drawing: Path
    template: Path
    material: str = ""
    thickness_mm: float | None = None
    count: int = 1
    error: CNCStepperError | None = None


def read_rows(path: Path) -> list[OrderRow]:
    """Return the rows of an order; raises JobError for a file without rows, with too many, or with other columns."""
    place = Place(str(path))
    try:
        text = read_input(path, MOST_BYTES).decode("utf-8-sig")
        lines = list(StringIO(text, newline=None))
        mark = ";" if lines and ";" in lines[0] else ","
        reader = csv.reader(lines, delimiter=mark, strict=True)
        head = [name.strip().casefold() for name in next(reader, [])]
        _require_columns(head, place)
        rows = [_row(head, cells, reader.line_num, path, mark) for cells in reader if any(map(str.strip, cells))]
    except UnicodeDecodeError as error:
        advice = "save it as CSV in UTF-8"
        raise JobError("order-encoding", "the order is no UTF-8 text", advice=advice, place=place) from error
    except csv.Error as error:
        broken = Text("the order is no CSV: {error}", error=error)
        raise JobError("order-csv", broken, advice="save it as CSV", place=place) from error
    if not 1 <= len(rows) <= MOST_ROWS:
        what, limit = "the order has no rows, or too many", f"1 to {MOST_ROWS}"
        raise JobError("order-rows", what, value=f"{len(rows)}", limit=limit, advice="split the order", place=place)
    return rows


def _require_columns(head: list[str], place: Place) -> None:
    missing = {"drawing", "template"} - set(head)
    unknown = [name for name in head if name not in COLUMNS]
    if missing or unknown or len(set(head)) < len(head):
        raise JobError(
            "order-columns",
            "the first line of an order names its columns: drawing and template, and material, thickness_mm, count",
            value=printable(", ".join(head), 200),
            limit=", ".join(COLUMNS),
            advice=Text("write as the first line, with commas or semicolons: {columns}", columns=",".join(COLUMNS)),
            place=Place(place.file, 1),
        )


def _row(head: list[str], cells: list[str], line: int, path: Path, mark: str) -> OrderRow:
    """Return a row with all values that are right; where one is wrong, with the first error."""
    told = dict(zip(head, (cell.strip() for cell in cells), strict=False))
    drawing, template = (path.parent / told.get(name, "") for name in ("drawing", "template"))
    errors: list[CNCStepperError] = []

    def read(value: Callable[[], Any], otherwise: Any = None) -> Any:
        try:
            return value()
        except CNCStepperError as error:
            errors.append(error.at(Place(str(path), line)))
            return otherwise

    read(lambda: _require_width(cells, head))
    read(lambda: _require_file("drawing", told.get("drawing", ""), drawing))
    read(lambda: _require_file("template", told.get("template", ""), template))
    thickness = told.get("thickness_mm")
    thickness_mm = read(lambda: _number(thickness, "thickness_mm", "depth", mark)) if thickness else None
    count = read(lambda: _count(told.get("count") or "1"), 0)
    return OrderRow(line, drawing, template, told.get("material", ""), thickness_mm, count, next(iter(errors), None))


def _require_width(cells: list[str], head: list[str]) -> None:
    if len(cells) > len(head):
        what, advice = "the row has more values than there are columns", "put a text with commas in quotes"
        raise JobError("order-row", what, value=f"{len(cells)}", limit=f"{len(head)}", advice=advice)


def _require_file(name: str, told: str, file: Path) -> None:
    if not told:
        raise JobError("order-file", Text("the row names no {name}", name=name), advice="write the name of a file")
    if not is_there(file):
        raise JobError(
            "order-file",
            Text("there is no {name} of that name", name=name),
            value=printable(told, 300),
            advice="correct it; paths are relative to the order",
        )


def _number(told: str, name: str, kind: str, mark: str) -> float:
    try:
        return Bounds(kind).require(float(told.replace(",", ".") if mark == ";" else told), name)
    except ValueError as error:
        if isinstance(error, JobError):
            raise
        raise Bounds(kind).refusal(printable(told, 60), name) from error


def _count(told: str) -> int:
    if not (told.isascii() and told.isdigit()) or not 1 <= int(told[:9]) <= MOST_PARTS or len(told) > 9:
        what, advice = "count is no whole number within its bounds", "write how many parts are wanted"
        raise JobError("order-count", what, value=printable(told, 60), limit=f"1 to {MOST_PARTS}", advice=advice)
    return int(told)
