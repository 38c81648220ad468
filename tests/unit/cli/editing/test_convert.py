# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper convert`: the program on standard output, the report beside it, and a table of dialects that is true."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from CNCStepper.cli.main import group
from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects import dialect, dialect_names

DOCUMENT = Path(__file__).parents[4] / "docs" / "reference" / "dialects.md"
PROGRAM = "%\nG21 G90\nM3 S1000\nG0 X0 Y0 Z5\nG98 G81 X1 Y1 Z-2 R1 F100\nG80\nG4 P1.5\nM2\n%\n"


def run(*arguments: str | Path) -> Result:
    return CliRunner().invoke(group, [*map(str, arguments)])


@pytest.fixture
def drilled(tmp_path: Path) -> Path:
    path = tmp_path / "furação.ngc"
    path.write_text(PROGRAM, "utf-8")
    return path


def test_the_program_goes_out_and_the_report_beside_it(drilled, tmp_path):
    made = run("convert", drilled, "--to", "marlin", "--rapid", "3000")
    assert made.exit_code == 0
    assert "G4 P1500" in made.stdout and "G0 X0.000 Y0.000 Z5.000 F3000" in made.stdout
    assert made.stderr == "note: G81 became plain moves (line 5)\n"
    out = tmp_path / "part.nc"
    again = run("convert", drilled, "--to", "mach:dwell=ms", "--out", out)
    assert again.exit_code == 0 and not again.stdout
    assert out.read_bytes().isascii() and b"\r" not in out.read_bytes() and "G4 P1500\n" in out.read_text()


def test_what_the_target_lacks_is_refused_or_left_out(drilled):
    refused = run("convert", drilled, "--to", "thesis-a")
    assert isinstance(refused.exception, ProgramError) and "no words for the spindle" in str(refused.exception)
    made = run("convert", drilled, "--to", "thesis-a", "--leave-out", "spindle", "--leave-out", "dwell")
    assert made.exit_code == 0 and "note: left out: thesis A has no dwells\n" in made.stderr


def test_what_cannot_be_written_names_its_line(tmp_path):
    program = tmp_path / "peça.ngc"
    program.write_text("G21 G90\nG0 X0 Y5 Z5\nM3 S1000\nG1 Z-1 F100\nX5 Y9\nM2\n", "ascii")
    for target, line, *more in (("thesis-a", 4), ("mini-lathe", 5, "--leave-out", "spindle")):
        told = str(run("convert", program, "--to", target, *more).exception)
        assert told.startswith(f"{program}:{line}: ")


def test_an_output_that_cannot_be_written_names_its_line(tmp_path):
    program = tmp_path / "out.ngc"
    program.write_text("G21 G90\nM62 P1\nG0 X0 Y0\nX5\nM2\n", "ascii")
    told = str(run("convert", program, "--to", "grbl").exception)
    assert told.startswith(f"{program}:2: grbl 1.1 programs are written without 'output' (value M62 P1); take it out")


def test_a_further_axis_is_refused_with_the_line_that_moves_it(tmp_path):
    program = tmp_path / "turned.ngc"
    program.write_text("G21 G90\nG0 X0 Y0 Z5 A0\nX5\nG1 A90 F100\nM2\n", "ascii")
    told = str(run("convert", program, "--to", "grbl").exception)
    assert told.startswith(f"{program}:4: programs with more than the axes X, Y and Z are not written")


def test_what_lasts_is_noted_once(tmp_path):
    program = tmp_path / "part.ngc"
    moves = "".join(f"X{number}\n" for number in range(1, 30))
    program.write_text(f"G21 G90 G64\nM3 S1000\nG0 X0 Y0\nG91\nG1 F100\n{moves}G90\nG1 X0\nG91\nX1\nM2\n", "ascii")
    told = run("convert", program, "--to", "thesis-a", "--leave-out", "spindle").stderr
    assert "left out: G64, the exact path is followed as far as the machine does (line 1)\n" in told
    assert "incremental coordinates became absolute (2 times, first at line 4)\n" in told
    assert "left out: thesis A has no words for the spindle\n" in told


def test_the_lengths_of_tools_come_from_a_table(tmp_path):
    (tmp_path / "tool.tbl").write_text("T1 P1 D6 Z41.5 ; flat 6 mm\n", "ascii")
    program = tmp_path / "part.ngc"
    program.write_text("G21 G90\nT1 M6\nG43 H1\nG0 X0 Y0 Z5\nM2\n", "ascii")
    made = run("convert", program, "--to", "grbl", "--tool-table", tmp_path / "tool.tbl")
    assert made.exit_code == 0 and "G43.1 Z41.500" in made.stdout


def test_an_unknown_dialect_is_a_usage_error(drilled):
    for name in ("grrbl", "mach:dwell=days"):
        assert run("convert", drilled, "--to", name).exit_code == 2
        assert run("trace", drilled, "--dialect", name).exit_code == 2


def row(name: str) -> list[str]:
    """Return the cells of a row of the document's table, without its name."""
    line = next(line for line in DOCUMENT.read_text("utf-8").splitlines() if line.startswith(f"| {name} |"))
    return [cell.strip() for cell in line.strip("|").split("|")[1:]]


def test_the_document_says_what_the_definitions_do():
    lines = DOCUMENT.read_text("utf-8").splitlines()
    names = next([cell.strip() for cell in line.strip("| ").split("|")] for line in lines if "grbl |" in line)
    lathes = next([cell.strip() for cell in line.strip("| ").split("|")] for line in lines if "fanuc-lathe |" in line)
    assert sorted([*names, *lathes]) == dialect_names()
    for name, line, systems, turns in zip(
        names, row("line, characters"), row("work offsets"), row("P turns"), strict=True
    ):
        one = dialect(name)
        assert line == (str(one.line_limit) if one.line_limit else "–")
        assert systems == (str(len(one.writing.work_systems)) if one.writing.work_systems else "none")
        assert (turns == "yes") == ("G2" in one.codes and "P" in one.codes["G2"].takes)
    for name, cell in zip(names, row("expressions · O-words"), strict=True):
        one = dialect(name)
        assert cell == " · ".join("yes" if has else "no" for has in (one.expressions, one.o_words))
    for name, cell in zip(names, row("canned cycles written"), strict=True):
        cycles = dialect(name).writing.canned
        assert cell.replace("G81–G83", "G81 G82 G83") == (" ".join(sorted(cycles)) or "none")


def test_a_folder_that_is_not_there_is_made_and_the_option_is_called_as_everywhere(drilled, tmp_path):
    out = tmp_path / "saída nova" / "part.nc"
    made = run("convert", drilled, "--to", "grbl", "-o", out)
    assert made.exit_code == 0 and made.stderr.endswith(f"{out}: written; {len(out.read_text().splitlines())} lines\n")


def test_program_that_presumes_where_the_tool_stands_says_so(tmp_path):
    program = tmp_path / "peça.nc"
    program.write_text("G90 X40 Y0 F300\nG0 X0 Y0\n", "ascii")
    made = run("convert", program, "--dialect", "thesis-a", "--to", "grbl")
    assert made.exit_code == 0 and "G1 X40.000 Y0.000 Z0.000 F300\nG0 X0.000\n" in made.stdout
    assert "begins with the tool at the work zero" in made.stderr
    placed = run("convert", program, "--dialect", "thesis-a", "--to", "grbl", "--position", "0,0,0")
    assert placed.stdout == made.stdout and not placed.stderr
