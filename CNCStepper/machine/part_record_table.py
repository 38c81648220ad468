# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of measured parts while it is typed, pasted, read and written: texts in, records and sentences out.

    clipboard, CSV file ──► rows of texts ──► judged(): a PartRecord each, {(row, column): sentence} ──► csv_text()

A CSV file has a line of headings; `read_csv` takes the columns of MEASURED and of NOMINAL by them.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

from CNCStepper.errors import CNCStepperError, JobError, Place, Text
from CNCStepper.input_file import read_input
from CNCStepper.machine.axis_tests import check_reading
from CNCStepper.machine.libraries.table_draft import number_of
from CNCStepper.machine.part_records import DIAMETERS, PartRecord, part_record
from CNCStepper.quantities import Bounds

MEASURED = ("height_mm", *(f"d{number}_mm" for number in range(1, DIAMETERS + 1)))
NOMINAL = ("nominal_height_mm", "nominal_diameter_mm")
FIGURES = ("mean_mm", "deviation_mm", "diameter_ratio", "height_ratio")
DECIMALS = {"mean_mm": 4, "deviation_mm": 4, "diameter_ratio": 5, "height_ratio": 5}
MOST_PARTS = 1_000  # the window judges all at each key
MOST_BYTES = 1_000_000
NOMINAL_MM = Bounds("length")
Rows = list[list[str]]


@dataclass
class Judged:
    """What a table comes to: of each row its record, None where it is not whole; what is wrong, by row and column."""

    records: list[PartRecord | None] = field(default_factory=list)
    problems: dict[tuple[int, int], str] = field(default_factory=dict)

    @property
    def whole(self) -> list[PartRecord]:
        """The records of the rows that are whole."""
        return [record for record in self.records if record is not None]


def judged(rows: Sequence[Sequence[str]], height_mm: float, diameter_mm: float) -> Judged:
    """Return the records of rows of len(MEASURED) texts; an empty cell is no problem, its row just not whole."""
    found = Judged()
    for row, texts in enumerate(rows):
        values_mm = []
        for column, text in enumerate(texts):
            if text.strip():
                try:
                    values_mm.append(_reading(text, diameter_mm if column else height_mm))
                except CNCStepperError as error:
                    found.problems[row, column] = error.sentence
                except ValueError as error:
                    found.problems[row, column] = error.args[0]
        is_whole = len(values_mm) == len(MEASURED)
        found.records.append(part_record(values_mm, height_mm, diameter_mm) if is_whole else None)
    return found


def _reading(text: str, nominal_mm: float) -> float:
    value_mm = number_of(text.strip())
    check_reading(value_mm, nominal_mm)
    return value_mm


def figures_of(record: PartRecord, height_mm: float, diameter_mm: float) -> dict[str, float]:
    """Return what is worked out of a record, by the keys of FIGURES."""
    diameters = record.diameters_mm
    ratios = record.diameter_ratio(diameter_mm), record.height_ratio(height_mm)
    return dict(zip(FIGURES, (diameters.mean_mm, diameters.deviation_mm, *ratios), strict=True))


def require_few(parts: int) -> None:
    """Raise JobError for more parts than a table takes."""
    if parts > MOST_PARTS:
        what, advice = "these are more parts than one table takes", "make several tables of them"
        raise JobError("part-records-many", what, value=f"{parts}", limit=f"{MOST_PARTS}", advice=advice)


def rows_of_text(text: str) -> Rows:
    """Return the cells of a pasted text; lines without any number, such as headings, are left out.

    Raises JobError for a text that is longer than any table.
    """
    if len(text) > MOST_BYTES:
        what, value = "the text is too long for a table of parts", f"{len(text) / 1e6:.3g} MB"
        limit = f"{MOST_BYTES / 1e6:.3g} MB"
        raise JobError("part-records-many", what, value=value, limit=limit, advice="copy only the cells of the parts")
    rows = [_cells(line) for line in text.splitlines()]
    return [row for row in rows if any(_is_number(cell) for cell in row)]


def _cells(line: str) -> list[str]:
    """Return the cells of a line between tabs, semicolons, blanks, or commas that are no decimal sign."""
    for sign in ("\t", ";"):
        if sign in line:
            return [cell.strip() for cell in line.split(sign)]
    words = line.split()
    if len(words) == 1 and not _is_number(line):
        words = line.split(",")
    return [word.strip(" ,") for word in words]


def _is_number(text: str) -> bool:
    with suppress(ValueError):
        number_of(text)
        return True
    return False


def csv_text(records: Sequence[PartRecord], height_mm: float, diameter_mm: float) -> str:
    """Return a table as a CSV file that a spreadsheet opens, what is worked out in it too."""
    file = io.StringIO()
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(("part", *MEASURED, *FIGURES, *NOMINAL))
    for number, record in enumerate(records, start=1):
        figures = figures_of(record, height_mm, diameter_mm)
        worked_out = (f"{figures[key]:.{DECIMALS[key]}f}" for key in FIGURES)
        measured = (f"{value:.10g}" for value in (record.height_mm, *record.diameters_mm.values_mm))
        writer.writerow((number, *measured, *worked_out, f"{height_mm:.10g}", f"{diameter_mm:.10g}"))
    return file.getvalue()


def read_csv(path: Path) -> tuple[Rows, tuple[float, float]]:
    """Return the rows of texts of a CSV file and the nominal height and diameter, mm; raises JobError."""
    text = read_input(path, MOST_BYTES).decode("utf-8-sig", errors="replace")
    rows = list(csv.DictReader(text.splitlines()))
    lacks = [key for key in (*MEASURED, *NOMINAL) if not rows or rows[0].get(key) is None]
    if lacks:
        raise JobError(
            "part-records-file",
            Text("'{path}' is no file of part records", path=path.name),
            advice=Text("its first line has to name the columns {keys}", keys=", ".join((*MEASURED, *NOMINAL))),
        )
    require_few(len(rows))
    nominal_mm = (_nominal(rows[0], key, path) for key in NOMINAL)
    return [[row[key] or "" for key in MEASURED] for row in rows], (next(nominal_mm), next(nominal_mm))


def _nominal(row: Mapping[str, str], key: str, path: Path) -> float:
    try:
        value_mm = number_of(row[key])
    except ValueError as error:
        advice = "correct the number"
        raise JobError("part-records-file", error.args[0], place=Place(str(path)), advice=advice) from error
    return NOMINAL_MM.require(value_mm, key, Place(str(path)))
