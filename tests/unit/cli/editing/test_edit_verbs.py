# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper edit`, `compact` and `print` as a person calls them."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from CNCStepper.cli.main import group

SQUARE = """(square)
G21 G90 G17
M3 S10000
G4 P4
G0 X10 Y10 Z5
G1 Z-1 F200
X40 F500
Y40
X10
Y10
G0 Z5
M5
M2
"""


def call(*words: str | Path) -> Result:
    return CliRunner().invoke(group, [str(word) for word in words])


@pytest.fixture
def square(tmp_path: Path) -> Path:
    path = tmp_path / "square ç.nc"
    path.write_text(SQUARE, encoding="utf-8")
    return path


def test_the_difference_is_shown_and_nothing_written(square: Path) -> None:
    result = call("edit", "offset", square, "--x", "5")
    assert result.exit_code == 0, result.output
    assert "-X40 F500\n+X45 F500\n" in result.output
    assert "not written; add --out FILE or --in-place; 3 lines changed" in result.output
    assert square.read_text(encoding="utf-8") == SQUARE


@pytest.mark.parametrize(
    ("words", "line"),
    [
        (["offset", "--x", "5", "--y", "-2.5"], "G0 X15 Y7.5 Z5"),
        (["scale", "--factor", "0.5"], "G0 X5 Y5 Z2.5"),
        (["scale", "--x", "2"], "G0 X20 Y10 Z5"),
        (["rotate", "--angle", "90", "--about", "10,10"], "X10 Y40 F500"),
        (["mirror", "--axis", "x", "--at", "25"], "G0 X40 Y10 Z5"),
        (["units", "--to", "inch"], "X1.5748 F19.685"),
        (["feeds", "--factor", "1.2"], "X40 F600"),
        (["renumber", "--step", "5"], "N35 X40 F500"),
        (["replace", "F500", "F450"], "X40 F450"),
        (["reverse"], "Y40 F500"),
    ],
)
def test_each_verb_writes_what_it_says(square: Path, tmp_path: Path, words: list[str], line: str) -> None:
    out = tmp_path / "new" / "new.nc"
    verb, *more = words
    finds = more[:2] if verb == "replace" else []
    result = call("edit", verb, square, *finds, *more[len(finds) :], "--out", out)
    assert result.exit_code == 0, result.output
    assert line in out.read_text(encoding="utf-8").splitlines()
    assert f"{out}: written" in result.output
    assert square.read_text(encoding="utf-8") == SQUARE


def test_in_place(square: Path) -> None:
    assert call("edit", "feeds", square, "--factor", "2", "--in-place").exit_code == 0
    assert "X40 F1000" in square.read_text(encoding="utf-8")
    assert [path.name for path in square.parent.iterdir()] == [square.name]
    assert call("edit", "feeds", square, "--factor", "2", "--in-place", "--out", "x.nc").exit_code == 2


def test_a_link_stays_one_and_a_file_that_may_not_be_written_stays_as_it_is(square: Path) -> None:
    link = square.with_name("link.nc")
    link.symlink_to(square)
    result = call("edit", "replace", link, "F500", "F450", "--in-place")
    assert result.exit_code == 0 and "; 1 line changed" in result.output
    assert link.is_symlink() and "X40 F450" in square.read_text(encoding="utf-8")
    square.chmod(0o444)
    refused = call("edit", "feeds", square, "--factor", "2", "--in-place").exception
    assert isinstance(refused, PermissionError) and "read-only" in str(refused)
    assert "X40 F450" in square.read_text(encoding="utf-8")


@pytest.mark.parametrize("number", ["nan", "inf", "-inf", "1e300", "1,5", "ten"])
def test_what_is_no_number_is_told_before_anything_is_read(square: Path, number: str) -> None:
    verbs = (
        ("edit", "offset", "--x"),
        ("edit", "scale", "--factor"),
        ("edit", "scale", "--z"),
        ("edit", "rotate", "--angle"),
        ("edit", "mirror", "--axis", "x", "--at"),
        ("edit", "feeds", "--factor"),
        ("compact", "--tolerance"),
        ("convert", "--to", "marlin", "--rapid"),
    )
    for *verb, option in verbs:
        result = call(*verb, square, option, number)
        assert result.exit_code == 2 and f"'{number}' is not a number" in result.output
    assert call("edit", "rotate", square, "--angle", "90", "--about", f"{number},0").exit_code == 2
    assert call("edit", "scale", square, "--factor", "0").exit_code == 2


def test_the_verbs_are_told_in_whole_sentences() -> None:
    assert "..." not in call("edit", "--help").output.split("Commands:")[1]


def test_what_the_checks_refuse_is_not_written(square: Path) -> None:
    words = ["--machine", "table-a", "--work-zero", "0,0,0", "--in-place"]
    good = call("edit", "offset", square, "--x", "1", "--machine", "table-a")
    assert good.exit_code == 0, good.output
    far = call("edit", "scale", square, "--factor", "100", *words)
    assert far.exit_code == 1
    assert "not changed; the new program would be refused" in far.output
    assert f"{square}:" in far.output.splitlines()[0]
    assert square.read_text(encoding="utf-8") == SQUARE


def test_a_refusal_names_the_line(square: Path) -> None:
    square.write_text(SQUARE.replace("Y40\n", "G2 X40 Y40 J15\nG1\n"), encoding="utf-8")
    result = call("edit", "scale", square, "--x", "2")
    assert result.exit_code == 1
    assert ":8:" in str(result.exception)


def test_split_writes_a_program_for_each_tool(square: Path, tmp_path: Path) -> None:
    second = "M5\nM0\nT2\nM3 S8000\n" + SQUARE[SQUARE.index("G4") :]
    square.write_text(SQUARE.replace("M3", "T1\nM3", 1).replace("M5\nM2\n", second), encoding="utf-8")
    result = call("edit", "split", square, "--out", tmp_path / "parts")
    assert result.exit_code == 0, result.output
    assert sorted(path.name for path in (tmp_path / "parts").iterdir()) == ["square ç-1-T1.nc", "square ç-2-T2.nc"]


@pytest.mark.slow
def test_compact_tells_how_much_shorter(tmp_path: Path) -> None:
    path = tmp_path / "line.nc"
    path.write_text("G21 G90\nG0 X0 Y0\nG1 X0.1 F100\n" + "".join(f"X{k / 10}\n" for k in range(2, 50)) + "M2\n")
    result = call("compact", path, "--tolerance", "0.01", "--in-place")
    assert "52 lines become 5" in result.output
    assert path.read_text() == "G21 G90\nG0 X0 Y0\nG1 X0.1 F100\nX4.9\nM2\n"


@pytest.mark.parametrize(("name", "begins"), [("sheet.pdf", b"%PDF"), ("sheet.html", b"<!DOCTYPE html>")])
def test_print(square: Path, tmp_path: Path, name: str, begins: bytes) -> None:
    out = tmp_path / name
    words = ["--process", "milling", "--material", "plywood <5", "--stock", "50,50,10", "--tool", "flat:6"]
    result = call("print", square, "--out", out, *words, "--machine", "table-a", "--work-zero", "100,50,0")
    assert result.exit_code == 0, result.output
    content = out.read_bytes()
    assert content.startswith(begins)
    call("print", square, "--out", out, *words, "--machine", "table-a", "--work-zero", "100,50,0")
    assert out.read_bytes() == content
    if name.endswith("html"):
        text = content.decode("utf-8")
        assert "<td>milling</td>" in text
        assert "<td>plywood &lt;5</td>" in text
        assert "<li>X40 F500</li>" in text
        assert "<svg" in text


def test_print_knows_its_kinds(square: Path, tmp_path: Path) -> None:
    assert "end it in .pdf or .html" in str(call("print", square, "--out", tmp_path / "a.doc").exception)


def test_what_latin_1_cannot_say_makes_the_file_utf_8(tmp_path: Path) -> None:
    program = tmp_path / "furação.nc"
    program.write_bytes("G21 (furação)\nG0 X1\nM2\n".encode("latin-1"))
    assert call("edit", "feeds", program, "--factor", "1", "--in-place").exit_code == 0
    assert program.read_bytes() == "G21 (furação)\nG0 X1\nM2\n".encode("latin-1")
    assert call("edit", "replace", program, "--comments", "--in-place", "furação", "tamanho €").exit_code == 0
    assert program.read_bytes() == "G21 (tamanho €)\nG0 X1\nM2\n".encode()
