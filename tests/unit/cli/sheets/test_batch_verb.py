# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper batch`: a wrong row costs no other one, the exit status says it, the offer is there."""

from __future__ import annotations

from pathlib import Path

from click.testing import CliRunner

from CNCStepper.cli.sheets.batch import command
from helpers.batch.small_orders import write_order


def test_a_wrong_row_is_told_and_the_others_go_on(tmp_path: Path) -> None:
    rows = ["square.dxf,laser.toml,plywood,3,1", "square.dxf,laser.toml,cheese,3,1", "gone.dxf,laser.toml,plywood,3,1"]
    order, out = write_order(tmp_path, rows), tmp_path / "out"
    answer = CliRunner().invoke(command, [str(order), "-o", str(out), "--workers", "1"])
    assert answer.exit_code == 1, answer.output
    assert "line 3: square.dxf" in answer.stderr and "cheese" in answer.stderr
    assert "line 4: gone.dxf" in answer.stderr and "correct it" in answer.stderr
    assert str(tmp_path) in answer.stderr and "cncstepper-batch-" not in answer.stderr
    table = (out / "order.txt").read_text("utf-8")
    assert "incomplete" in table and table.count("refused") == 2
    assert (out / "job-1-1.nc").exists() and (out / "offer.pdf").read_bytes().startswith(b"%PDF")
    again = CliRunner().invoke(command, [str(order), "-o", str(out), "--workers", "1"])
    assert again.exit_code == 1 and "2 found done" in again.output
