# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the machine stands and what it knows before the first line, as every verb that reads programs is told it."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from CNCStepper.cli.common.start_state_options import StartOptions
from CNCStepper.cli.main import group
from CNCStepper.job.start_state_file import start_from
from CNCStepper.state import Start

READERS = ("check", "time", "simulate", "convert", "compact", "print", "send")
EDITS = ("offset", "scale", "rotate", "mirror", "units", "feeds", "renumber", "replace", "reverse", "split")
OPTIONS = ("--work-zero", "--position", "--parameters", "--tool-table", "--search")
INCREMENTAL = "G21 G91 F100\nG1 X5 Y1\nG2 X4 Y0 I2 J0\nM2\n"
HOMING = "G21 G90\nG0 X1 Y1 Z5\nG28\nG1 X5 Y5 F100\nM2\n"
PARKED = "5161 -5\n5162 -6\n5163 -1\n5221 -200\n5222 -150\n5223 -30\n"


def run(*arguments: str | Path) -> Result:
    return CliRunner().invoke(group, [str(argument) for argument in arguments])


def told(result: Result) -> str:
    return f"{result.output}{result.exception or ''}"


@pytest.fixture
def kept(tmp_path: Path) -> Path:
    path = tmp_path / "máquina 1.var"
    path.write_text(PARKED, "ascii")
    return path


@pytest.mark.parametrize("verb", [*((name,) for name in READERS), *(("edit", name) for name in EDITS)], ids=" ".join)
def test_every_verb_that_reads_programs_has_them_all(verb: tuple[str, ...]) -> None:
    told = run(*verb, "--help").output
    assert all(f"{option} " in told for option in OPTIONS)


def verbs(program: Path, out: Path) -> list[tuple[str | Path, ...]]:
    """Return the verbs that read a program, each with what it needs; `simulate` and `print` are slower."""
    return [
        ("check", program, "--machine", "table-a", "--dialect", "linuxcnc"),
        ("convert", program, "--to", "linuxcnc", "-o", out / "converted.nc"),
        ("edit", "feeds", program, "--factor", "2", "--dialect", "linuxcnc"),
        ("edit", "units", program, "--to", "inch", "--dialect", "linuxcnc"),
        ("edit", "split", program, "--dialect", "linuxcnc"),
        ("compact", program, "--tolerance", "0.01", "--dialect", "linuxcnc"),
        ("print", program, "-o", out / "sheet.html", "--dialect", "linuxcnc"),
    ]


def test_a_program_that_begins_in_increments_is_read_where_the_position_is_told(tmp_path: Path) -> None:
    program = tmp_path / "peça 1.ngc"
    program.write_text(INCREMENTAL, "ascii")
    for verb in verbs(program, tmp_path):
        bare, placed = run(*verb), run(*verb, "--position", "10,20,30")
        if verb[1] in ("feeds", "split"):  # their sense does not depend on the place
            continue
        assert bare.exit_code == 1 and "known position" in told(bare), told(bare)
        assert placed.exit_code == 0, (verb, told(placed))


def test_the_places_of_g28_and_the_work_offsets_come_from_linuxcncs_file(tmp_path: Path, kept: Path) -> None:
    program = tmp_path / "home.ngc"
    program.write_text(HOMING, "ascii")
    for verb in verbs(program, tmp_path):
        bare, remembered = run(*verb), run(*verb, "--parameters", kept)
        assert bare.exit_code == 1 and "the position stored for G28 is not known" in told(bare), told(bare)
        assert remembered.exit_code == 0 or verb[1] in ("units", "split"), (verb, told(remembered))
    beyond = run("check", program, "--machine", "table-a", "--parameters", kept, "--work-zero", "-2,-150,-30")
    assert beyond.exit_code == 1 and "home.ngc:4:" in beyond.output


def test_the_time_begins_where_the_machine_stands(tmp_path: Path) -> None:
    program = tmp_path / "one.ngc"
    program.write_text("G21 G90 G94\nG1 X100 F600\nM2\n", "ascii")
    took_s = {
        place: float(run("time", program, "--machine", "table-a", "--position", place).output) for place in PLACES
    }
    assert took_s[PLACES[0]] == pytest.approx(2 * took_s[PLACES[1]], rel=0.05)


PLACES = ("0,0,0", "50,0,0")


def test_subroutines_are_found_in_other_folders(tmp_path: Path) -> None:
    library = tmp_path / "minha biblioteca"
    library.mkdir()
    (library / "hop.ngc").write_text("o<hop> sub\nG0 X#1\no<hop> endsub\n", "ascii")
    program = tmp_path / "main.ngc"
    program.write_text("G21 G90 F100\nG0 X1 Y1 Z5\no<hop> call [7]\nM2\n", "ascii")
    plain = ("--dialect", "linuxcnc", "--machine", "table-a")
    for verb in (
        ("check", program, *plain),
        ("check", program, "--dialect", "grblhal", "--machine", "table-a"),
        ("time", program, *plain),
        ("convert", program, "--to", "grbl"),
        ("trace", program),
        ("print", program, "-o", tmp_path / "sheet.html", *plain),
        ("edit", "feeds", program, "--factor", "2", "--dialect", "linuxcnc"),
    ):
        assert run(*verb).exit_code == 1, verb
        result = run(*verb, "--search", library)
        assert result.exit_code == 0, (verb, told(result))


def test_trace_takes_the_files_that_rs274_takes(tmp_path: Path, kept: Path) -> None:
    program, table = tmp_path / "lengths.ngc", tmp_path / "mill.tbl"
    program.write_text("G20 G90\nT7 M6\nG43\nG0 X1 Z2\nM2\n", "ascii")
    table.write_text("T7 P3 Z1.25 D0.5\n", "ascii")
    result = run("trace", program, "--tool-table", table, "--parameters", kept)
    assert result.exit_code == 0, told(result)
    assert "USE_TOOL_LENGTH_OFFSET(0.0000 0.0000 1.2500" in result.output
    assert "SET_G5X_OFFSET(1, -5080.0000, -3810.0000, -762.0000" in result.output


def test_send_is_told_the_start_or_takes_the_one_of_the_certificate(tmp_path: Path) -> None:
    program, table, proof = tmp_path / "lengths.ngc", tmp_path / "mill.tbl", tmp_path / "proof.json"
    program.write_text("G21 G90\nT7 M6\nG43 H7\nG0 Z20\nG0 X5 Y1\nM2\n", "ascii")
    table.write_text("T7 P3 Z12.5 D6\n", "ascii")
    nowhere = ("--port", str(tmp_path / "no port"), "--zero-confirmed")
    shipped = resources.files("CNCStepper.machine") / "profiles" / "table-a.toml"
    machine = tmp_path / "hal.toml"
    machine.write_text(shipped.read_text("utf-8").replace('"grbl"', '"grblhal"'), "utf-8")
    lengths = ("--machine", machine, "--dialect", "linuxcnc")
    assert "dialect-differs" in told(run("send", program, *nowhere, *lengths, "--tool-table", table))
    program.write_text("G21 G90\nG0 Z20\no<hop> call [5]\nM2\n", "ascii")
    (tmp_path / "library").mkdir()
    (tmp_path / "library" / "hop.ngc").write_text("o<hop> sub\nG0 X#1 Y[#5420+1]\no<hop> endsub\n", "ascii")
    given = ("--dialect", "grblhal", "--search", tmp_path / "library", "--position", "-9,-8,-7")
    checked = run(
        "check", program, "--machine", machine, *given, "--work-zero", "-100,-100,-40", "--certificate", proof
    )
    assert checked.exit_code == 0, told(checked)
    assert "port-missing" in told(run("send", program, *nowhere, "--certificate", proof))
    other = run("send", program, *nowhere, "--certificate", proof, *given)
    assert "from another start state" in told(other) or "are not those that were proven" in told(other)


def test_where_subroutines_are_found_is_kept_but_no_part_of_the_fingerprint() -> None:
    from dataclasses import asdict

    start = StartOptions(work_zero=(1.0, 2.0, 3.0), search=("a", "b ç")).start()
    assert start is not None and start.search == ("a", "b ç")
    assert start.sha256() == Start.with_work_zero((1.0, 2.0, 3.0)).sha256()
    assert start_from(asdict(start) | {"position_mm": [None, None, None]}) == Start(
        start.position_mm, work_offsets_mm={"G54": (1.0, 2.0, 3.0)}, zero_known=True, search=("a", "b ç")
    )
    assert StartOptions().start() is None
