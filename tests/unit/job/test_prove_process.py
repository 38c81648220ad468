# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program of a cutting process is proven whole and piece by piece alike; the report has the pieces cut free."""

from pathlib import Path

import pytest

from CNCStepper.job import prove_file as prove_file_module
from CNCStepper.job.prove import PriorPrograms, Proof, prove
from CNCStepper.job.prove_file import FileProof, prove_file
from CNCStepper.machine.processes import PROCESSES
from CNCStepper.simulation import table_parts
from helpers.simulation.torch_programs import (
    DATA,
    SHEET,
    START,
    TABLE,
    beam,
    hole,
    square,
    square_part,
    text_of,
)

PLASMA = PROCESSES["plasma"]
GIVEN = {
    "start": START,
    "stock": SHEET,
    "tools": beam(),
    "process": PLASMA,
    "cut_data": DATA,
    "parts": [square_part(60, 60, 30, [(75, 75, 6)])],
}
GOOD = text_of((hole(75, 75, 6), square(60, 60, 30)))
WRONG = text_of((square(60, 60, 30), hole(75, 75, 6, delay="")))


def both(text: str, folder: Path) -> tuple[Proof, FileProof]:
    (folder / "p.nc").write_text(text, "utf-8")
    return prove(text, TABLE, file="p.nc", **GIVEN), prove_file(folder / "p.nc", TABLE, name="p.nc", **GIVEN)


def test_the_report_has_the_pieces_in_their_order_with_line_and_time(tmp_path: Path) -> None:
    whole, by_file = both(GOOD, tmp_path)
    assert not whole.refused and whole.report["pieces"] == by_file.report["pieces"]
    slug, part = whole.report["pieces"]
    assert set(slug) == {"area_mm2", "centre_mm", "falls_at_line", "falls_at_s"}
    assert part["centre_mm"] == pytest.approx([75, 75], abs=0.01)
    row = whole.toolpath.table().line.tolist().index(part["falls_at_line"])
    assert part["falls_at_s"] == pytest.approx(whole.times_s[row], abs=1e-5)
    assert 0 < slug["falls_at_s"] < part["falls_at_s"] < whole.report["time_s"]


@pytest.mark.parametrize("rows", [1, 5, 1_000_000])
def test_a_file_in_parts_has_the_findings_of_the_whole(
    rows: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(prove_file_module, "PART_ROWS", rows)
    monkeypatch.setattr(table_parts, "PART_ROWS", rows)
    whole, by_file = both(WRONG, tmp_path)
    assert [str(one) for one in whole.findings] == [str(one) for one in by_file.findings]
    assert {one.code for one in whole.findings if one.severity == "error"} == {"piece-free", "pierce-delay"}


def test_milling_has_no_pieces_and_none_of_these_findings(tmp_path: Path) -> None:
    mill = {name: value for name, value in GIVEN.items() if name not in ("process", "cut_data", "parts")}
    proof = prove(WRONG, TABLE, file="p.nc", **mill)
    assert proof.report["pieces"] == [] and not proof.pieces
    assert not {one.code for one in proof.findings} & {"piece-free", "pierce-delay"}


def test_what_the_program_before_has_cut_free_stays_free() -> None:
    first = prove(text_of((square(60, 60, 30),)), TABLE, file="1.nc", **GIVEN)
    second = text_of((hole(75, 75, 6),))
    alone, after = (
        prove(second, TABLE, file="2.nc", **GIVEN, before=before) for before in (None, PriorPrograms.of([first]))
    )
    assert not alone.refused
    found = [one for one in after.findings if one.severity == "error"]
    assert [one.code for one in found] == ["piece-free"] and found[0].place.file == "2.nc"
    assert [piece.row < 0 for piece in after.pieces] == [True]


def test_a_scene_shows_as_fallen_what_is_free_at_its_moment() -> None:
    from CNCStepper.simulation.removal.timeline import TimelinePosition

    proof = prove(GOOD, TABLE, file="p.nc", **GIVEN)
    slug, part = proof.pieces
    moments = [
        TimelinePosition(0.0, row, share, 1) for row, share in ((slug.row, 0.5), (slug.row, 1.0), (part.row, 1.0))
    ]
    assert [len(proof.scene(moment).fallen) for moment in moments] == [0, 1, 2]
    assert len(proof.scene().fallen) == 2
