# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two ways to prove a program, whole and piece by piece, and their comparison."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from CNCStepper.gcode.interpreter import program_file
from CNCStepper.gcode.wire import wire_file
from CNCStepper.gcode.wire.wire_file import WireFile
from CNCStepper.job import prove_file as prove_file_module
from CNCStepper.job.make_certificate import certificate_of
from CNCStepper.job.prove import prove
from CNCStepper.job.prove_file import FileProof, prove_file
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.stock import Stock
from CNCStepper.toolpath import COLUMNS, Chunk

TABLE = load_machine("table-a")
STOCK, FLAT = Stock((60, 50, 20)), Tool(number=1, shape="flat", diameter_mm=6)
CORED = Tool(number=2, shape="flat", diameter_mm=6, core_diameter_mm=2)


def machine_with(controller: str = "grbl", **of_axes: Any) -> Machine:
    axes = {name: axis.model_copy(update=of_axes) for name, axis in TABLE.axis.items()}
    return TABLE.model_copy(update={"axis": axes, "controller": controller})


@pytest.fixture(params=[(1, 40), (3, 200), (50, 1 << 21)], ids=lambda value: f"rows{value[0]}-bytes{value[1]}")
def pieces(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let chunks, parts and pieces of the file be small."""
    rows, size = request.param
    chunks = WireFile.chunks

    def small(self: WireFile) -> Iterator[Chunk]:
        for chunk in chunks(self):
            for first in range(0, len(chunk), rows):
                some = (getattr(chunk, name)[first : first + rows] for name in COLUMNS)
                yield Chunk(chunk.first + first, *some)

    monkeypatch.setattr(WireFile, "chunks", small)
    monkeypatch.setattr(prove_file_module, "PART_ROWS", 2 * rows)
    monkeypatch.setattr(program_file, "PIECE", size)
    monkeypatch.setattr(program_file, "BLOCK", rows)
    monkeypatch.setattr(program_file, "MOST_BLOCKS", 2)
    monkeypatch.setattr(wire_file, "BLOCKS", 2 * rows)


def both(folder: Path, text: str, machine: Machine, dialect: str = "grbl", **more: Any) -> tuple[Any, FileProof]:
    file = folder / "ç program.nc"
    file.write_text(text, encoding="utf-8", newline="")
    stock, tools, start = (more.get(name) for name in ("stock", "tools", "start"))
    whole = prove(text, machine, file=str(file), dialect=dialect, stock=stock, tools=tools, start=start)
    sent = folder / "sent"
    shutil.rmtree(sent, ignore_errors=True)
    sent.mkdir()
    parts = prove_file(file, machine, dialect=dialect, stock=stock, tools=tools, start=start, sent=sent)
    return whole, parts


def assert_same(whole: Any, parts: FileProof) -> None:
    assert parts.findings == whole.findings
    volume, own = (proof.report.pop("removed_volume_mm3") for proof in (whole, parts))
    assert own == (volume if volume is None else pytest.approx(volume, abs=1e-3))
    assert parts.report == whole.report
    for proof in (whole, parts):
        proof.report["removed_volume_mm3"] = 0.0
    assert certificate_of(parts).sha256 == certificate_of(whole).sha256
