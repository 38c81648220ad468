# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of an order: both kinds of CSV, each wrong value told with its line, the others kept."""

from __future__ import annotations

from pathlib import Path

import pytest

from CNCStepper.errors import JobError
from CNCStepper.job.batch.order_rows import OrderRow, read_rows


def rows_of(folder: Path, text: str) -> list[OrderRow]:
    for name in ("a.dxf", "t.toml"):
        (folder / name).write_text("", "utf-8")
    (folder / "order.csv").write_text(text, "utf-8")
    return read_rows(folder / "order.csv")


def test_rows_of_both_kinds_of_csv(tmp_path: Path) -> None:
    wanted = [OrderRow(2, tmp_path / "a.dxf", tmp_path / "t.toml", "mild-steel", 1.5, 12)]
    assert rows_of(tmp_path, "drawing,template,material,thickness_mm,count\na.dxf,t.toml,mild-steel,1.5,12\n") == wanted
    text = "\ufeffDrawing;Template;Material;Thickness_mm;Count\r\na.dxf;t.toml;mild-steel;1,5;12\r\n;;;;\r\n"
    assert rows_of(tmp_path, text) == wanted


def test_what_is_left_out_is_the_template_s(tmp_path: Path) -> None:
    (row,) = rows_of(tmp_path, "template,drawing\nt.toml,a.dxf\n")
    assert (row.material, row.thickness_mm, row.count, row.error) == ("", None, 1, None)


@pytest.mark.parametrize(
    ("cells", "value"),
    [
        ("b.dxf,t.toml,,3,1", "b.dxf"),
        (",t.toml,,3,1", ""),
        ('"a\n.dxf",t.toml,,3,1', "a\\x0a.dxf"),
        ("a.dxf,u.toml,,3,1", "u.toml"),
        ("a.dxf,t.toml,,three,1", "three"),
        ("a.dxf,t.toml,,nan,1", "nan"),
        ("a.dxf,t.toml,,-3,1", "-3"),
        ("a.dxf,t.toml,,3,0", "0"),
        ("a.dxf,t.toml,,3,1.5", "1.5"),
        ("a.dxf,t.toml,,3,99999999999999999999", "99999999999999999999"),
        ("a.dxf,t.toml,,3,1,1", "6"),
    ],
)
def test_a_wrong_row_is_told_with_line_value_and_remedy(tmp_path: Path, cells: str, value: str) -> None:
    good, wrong, last = rows_of(
        tmp_path, f"drawing,template,material,thickness_mm,count\na.dxf,t.toml,,3,1\n{cells}\na.dxf,t.toml,,4,2\n"
    )
    assert good.error is None and last.error is None and last.thickness_mm == 4.0
    assert wrong.error and wrong.error.place and wrong.error.place.line == 3 + cells.count("\n")
    assert value in wrong.error.value and wrong.error.advice
    assert wrong.count == (0 if wrong.error.code == "order-count" else 1), "a table shows what was ordered"


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("", "order-columns"),
        ("drawing,template,price\n", "order-columns"),
        ("drawing,drawing,template\n", "order-columns"),
        ("drawing,template\n", "order-rows"),
        ("drawing,template\n" + "a.dxf,t.toml\n" * 10_001, "order-rows"),
        ('drawing,template\n"a.dxf,t.toml\n', "order-csv"),
    ],
)
def test_an_order_that_is_none_is_refused(tmp_path: Path, text: str, code: str) -> None:
    with pytest.raises(JobError) as told:
        rows_of(tmp_path, text)
    assert told.value.code == code and told.value.advice
