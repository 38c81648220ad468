# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of places from which a program can be restarted, and the words for the one that is chosen."""

from __future__ import annotations

import pytest

from CNCStepper.recovery.restart.restart_places import RequestedPlace
from CNCStepper.workbench.restart.restart_places import CONTOUR, OPERATION, Row, chosen, line_of, row_of, rows_of

TOLD = {
    "operations": [[1, 10, "face"], [2, 40, "pocket"], [3, 80, "pocket"]],
    "contours": [
        [1, 12, "face", "X0.000 Y0.000 Z-1.000", 220.5],
        [2, 41, "pocket", "X5.000 Y5.000 Z-2.000", 80.0],
        [3, 60, "pocket", "X5.000 Y5.000 Z-4.000", 80.0],
        [4, 81, "pocket", "X50.000 Y5.000 Z-4.000", 80.0],
    ],
}
ROWS = rows_of(TOLD)


def test_every_operation_stands_before_its_contours() -> None:
    kinds = [(row.kind, row.number) for row in ROWS]
    assert kinds == [
        (OPERATION, 1), (CONTOUR, 1), (OPERATION, 2), (CONTOUR, 2), (CONTOUR, 3), (OPERATION, 3), (CONTOUR, 4),
    ]  # fmt: skip
    assert ROWS[1] == Row(CONTOUR, 1, 12, "face", "X0.000 Y0.000 Z-1.000", 220.5)


def test_an_operation_that_begins_with_its_contour_stands_before_it() -> None:
    rows = rows_of({"operations": [[1, 4, "slot"]], "contours": [[1, 4, "slot", "X0", 46.0]]})
    assert [row.kind for row in rows] == [OPERATION, CONTOUR]


def test_two_operations_of_one_name_are_named_by_their_numbers() -> None:
    assert [row.where for row in ROWS if row.kind == OPERATION] == [
        RequestedPlace(operation=number) for number in "123"
    ]
    assert ROWS[-1].where == RequestedPlace(contour=4)


@pytest.mark.parametrize(
    ("where", "said", "row", "line"),
    [
        (RequestedPlace(line=43), "From line 43", None, 43),
        (RequestedPlace(line=43, time=2), "From line 43, the time that it is run: 2", None, 43),
        (RequestedPlace(operation="2"), "From the operation pocket", 2, 40),
        (RequestedPlace(contour=3), "From contour 3", 4, 60),
        (RequestedPlace(at_mm=(1, -2.5, -0.0004)), "From the place that was clicked, X1.000 Y-2.500 Z-0.000", None, 0),
    ],
)
def test_the_choice_is_said_and_found_in_the_list(where: RequestedPlace, said: str, row: int | None, line: int) -> None:
    text, values = chosen(where, ROWS)
    assert text.format(*values) == said
    assert (row_of(where, ROWS), line_of(where, ROWS)) == (row, line)
