# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper steps` as a stranger uses it: every form, to a file or printed, forwards and back."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from CNCStepper.cli.main import group
from CNCStepper.cli.program.steps import COILS, FORMS
from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.signals.coils import WIRES
from CNCStepper.motion.signals.port_bytes import read_board

SIX = "G21 G90 G17\nM3 S1000\nG1 X0.05 F60\nG1 X0.025\nM5\nM2\n"  # 80 steps/mm: four steps there, two back


def run(*arguments: str | Path) -> Result:
    return CliRunner().invoke(group, [str(argument) for argument in ("steps", *arguments)])


@pytest.fixture
def six(tmp_path: Path) -> Path:
    path = tmp_path / "peça nº 6.nc"
    path.write_text(SIX, encoding="utf-8")
    return path


def test_the_published_six_pulses_as_letters_and_as_bytes(six: Path) -> None:
    assert run(six, "--machine", "table-a", "--as", "letters").stdout == "sAAAADDt\n"
    made = run(six, "--machine", "table-a", "--as", "board").stdout_bytes
    assert [byte for byte in made if byte != 0x30] == [0x0A, 0x09, 0x05, 0x06, 0x05, 0x09]
    assert read_board(made)[:, 0].tolist() == [1, 1, 1, 1, -1, -1]


@pytest.mark.slow
def test_every_form_to_a_file_is_what_is_printed(six: Path, tmp_path: Path) -> None:
    for form in FORMS:
        out = tmp_path / "saída" / f"six.{form}"
        printed = run(six, "--machine", "table-a", "--as", form)
        assert printed.exit_code == 0, printed.output
        assert run(six, "--machine", "table-a", "--as", form, "-o", out).exit_code == 0
        assert out.read_bytes() == printed.stdout_bytes
    assert not list(out.parent.glob("*.part"))


@pytest.mark.parametrize(
    ("coils", "there_and_back"),
    [
        ("one_phase", "1000 0100 0010 0001 0010 0100"),
        ("two_phases", "1010 1001 0101 0110 0101 1001"),
        ("two_phases_a", "1100 0110 0011 1001 0011 0110"),
        ("half_step", "1000 1100 0100 0110 0100 1100"),
        ("bipolar", "+--+ +-+- -++- -+-+ -++- +-+-"),
    ],
)
def test_the_coils_of_each_motor_go_through_the_published_sequence(
    six: Path, tmp_path: Path, coils: str, there_and_back: str
) -> None:
    """A second motor of the axis that is mounted the other way round goes through it backwards."""
    source = Path(__file__).parents[4] / "CNCStepper" / "machine" / "profiles" / "table-a.toml"
    profile = tmp_path / "dois motores.toml"
    profile.write_text(source.read_text("utf-8") + '\n[signals]\nmotors = ["x", "y", "z", "-x"]\n', "utf-8")
    head, *rows = run(six, "--machine", profile, "--as", "coils", "--coils", coils).stdout.splitlines()
    assert head == "time_s,x,y,z,x2"
    columns = list(zip(*(row.split(",") for row in rows), strict=True))
    assert " ".join(columns[1]) == there_and_back
    assert len(set(columns[2])) == len(set(columns[3])) == 1  # they stand
    wires = WIRES[coils]
    assert [wires.index(word) for word in columns[4]] == [(-2 - k) % len(wires) for k in (0, 1, 2, 3, 2, 1)]
    refused = run(six, "--machine", profile, "--as", "letters", "--coils", coils)
    assert refused.exit_code == 2 and "belongs to --as coils" in refused.output
    times = [float(time) for time in columns[0]]
    assert times == sorted(times) and set(COILS) == set(WIRES)


def test_the_way_back_ends_where_the_program_begins(six: Path) -> None:
    assert run(six, "--machine", "table-a", "--as", "letters", "--back").stdout == "AADDDD\n"
    from_there = run(six, "--machine", "table-a", "--as", "letters", "--back-from", "0.06").stdout
    assert from_there == "DDDD\n"


def test_a_file_of_letters_goes_the_same_ways(six: Path, tmp_path: Path) -> None:
    letters = tmp_path / "six.txt"
    letters.write_bytes(run(six, "--machine", "table-a", "--as", "letters").stdout_bytes)
    again = ("--machine", "table-a", "--letters-every", "2")
    assert run(letters, *again, "--as", "letters").stdout == "sAAAADDt\n"
    rows = run(letters, *again, "--as", "csv").stdout.splitlines()
    assert rows[2] == "0.002000000,1,0,0," and rows[-2] == "0.012000000,2,0,0,"
    back = run(letters, *again, "--as", "csv", "--back-from", "0.01").stdout.splitlines()
    assert [row.split(",")[1] for row in back[1:]] == ["4", "3", "2", "1", "0"]


def test_what_cannot_be_stepped_is_refused_and_leaves_no_file(six: Path, tmp_path: Path) -> None:
    out = tmp_path / "six.vcd"
    turned = tmp_path / "turned.nc"
    turned.write_text("G21 G90\nG10 L2 P1 R30\nG1 X1 F100\nM2\n", "ascii")
    refused = run(turned, "--machine", "table-a", "--dialect", "linuxcnc", "--as", "vcd", "-o", out)
    assert refused.exit_code == 1 and "turned" in str(refused.exception)
    bad = tmp_path / "bad.txt"
    bad.write_bytes(b"AA@")
    refused = run(bad, "--machine", "table-a", "--letters-every", "1", "--as", "vcd", "-o", out)
    assert refused.exit_code == 1 and "'@'" in str(refused.exception)
    assert not list(tmp_path.glob("six.vcd*"))


def test_the_signals_of_a_profile_are_followed(six: Path, tmp_path: Path) -> None:
    profile = tmp_path / "mesa.toml"
    shipped = load_machine("table-a").model_dump(mode="json", exclude_none=True)
    assert shipped["signals"]["motors"] == ["x", "y", "z"]
    source = Path(__file__).parents[4] / "CNCStepper" / "machine" / "profiles" / "table-a.toml"
    extra = '\n[signals]\nmotors = ["x", "y", "z", "-x"]\npins = { x_step = -9, x_direction = 2, y_step = 3 }\n'
    profile.write_text(source.read_text("utf-8") + extra, "utf-8")
    refused = run(six, "--machine", profile, "--as", "parport")
    assert refused.exit_code == 1 and "y_direction" in str(refused.exception)
    assert "x2_step" in run(six, "--machine", profile, "--as", "vcd").stdout
    profile.write_text(source.read_text("utf-8") + "\n[signals]\npins = { x_step = 11 }\n", "utf-8")
    refused = run(six, "--machine", profile, "--as", "parport")
    assert refused.exit_code == 2 and "input" in refused.output


def test_the_backlash_of_an_axis_is_in_its_pulses(six: Path, tmp_path: Path) -> None:
    source = Path(__file__).parents[4] / "CNCStepper" / "machine" / "profiles" / "table-a.toml"
    profile = tmp_path / "folga.toml"
    profile.write_text(source.read_text("utf-8").replace("backlash_mm = 0.0", "backlash_mm = 0.0375", 1), "utf-8")
    made = run(six, "--machine", profile, "--as", "letters").stdout
    assert made == "sAAAAAAADDDDDt\n"  # its zero is true coming from its switch: the motor first crosses three steps
