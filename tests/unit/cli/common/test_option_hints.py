# SPDX-License-Identifier: LGPL-2.1-or-later
"""The refusal of a CAM program names the command that converts it, as it is pasted; that command helps."""

from __future__ import annotations

import shlex
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from CNCStepper.cli.common import option_hints
from CNCStepper.cli.main import group, main

FOREIGN = Path(__file__).parents[3] / "data" / "foreign"
GOOD = sorted(path.name for path in FOREIGN.glob("*.nc") if not path.name.startswith("rotary-moves"))
VERBS = {
    "check": ("--machine", "table-a"),
    "time": ("--machine", "table-a"),
    "steps": ("--machine", "table-a", "--as", "csv"),
    "simulate": ("--stock", "60,40,10", "--tool", "flat:3", "-o", "part.png"),
    "print": ("-o", "sheet.pdf"),
    "send": ("--machine", "table-a", "--port", "socket://127.0.0.1:1"),
    "compact": ("--tolerance", "0.01"),
    "drive": ("--machine", "table-a", "--port", "socket://127.0.0.1:1"),
    "restart": ("--machine", "table-a", "--line", "9"),
}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for path in FOREIGN.glob("*.nc"):
        (tmp_path / f"peça {path.name}").write_bytes(path.read_bytes())
        (tmp_path / f"-{path.name}").write_bytes(path.read_bytes())
    monkeypatch.chdir(tmp_path)
    return tmp_path


def said(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], *words: str) -> list[str]:
    """Run a command as its own process would; return the lines on standard error."""
    monkeypatch.setattr(sys, "argv", ["cncstepper", *words])
    with pytest.raises(SystemExit) as end:
        main()
    assert end.value.code == 1
    return capsys.readouterr().err.splitlines()


def offered(lines: list[str]) -> list[str]:
    """Return the command that is offered, as a shell reads it."""
    (line,) = [line for line in lines if "cncstepper convert" in line]
    assert line.startswith("hint: ")
    return shlex.split(line[line.index("cncstepper ") :])


@pytest.mark.skipif(sys.platform == "win32", reason="quoted as a POSIX shell reads it")
@pytest.mark.parametrize("name", GOOD)
@pytest.mark.parametrize("front", ["peça ", "-"])
def test_the_offered_command_makes_a_program_that_check_passes(
    name: str, front: str, folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = f"{front}{name}"
    before = (folder / path).read_bytes()
    words = offered(said(monkeypatch, capsys, "check", "--machine", "table-a", "--", path))
    assert words[1:3] == ["convert", path if front != "-" else f"./{path}"]
    assert words[words.index("--tool-change") + 1] == "pause" and "--to grbl" in " ".join(words)
    done = CliRunner().invoke(group, words[1:])
    assert done.exit_code == 0, done.output
    checked = CliRunner().invoke(group, ["check", "--machine", "table-a", words[-1]])
    assert checked.exit_code == 0, checked.output
    assert (folder / path).read_bytes() == before
    again = offered(said(monkeypatch, capsys, "time", "--machine", "table-a", "--", path))
    assert again[-1] != words[-1] and not (folder / again[-1]).exists()


@pytest.mark.parametrize("verb", VERBS)
def test_every_verb_offers_it(
    verb: str, folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    lines = said(monkeypatch, capsys, verb, "peça tool-changes.nc", *VERBS[verb])
    assert offered(lines)[1] == "convert", lines


def test_the_command_keeps_what_is_said_of_the_start(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "sub").mkdir()
    start = ("--work-zero", "-90,-70,-20", "--search", "sub")
    words = offered(said(monkeypatch, capsys, "time", "peça percent.nc", "--machine", "table-a", *start))
    assert words[words.index("--work-zero") + 1] == "-90,-70,-20"
    assert Path(words[words.index("--search") + 1]) == folder / "sub"
    assert CliRunner().invoke(group, words[1:]).exit_code == 0


def test_real_rotary_moves_are_told_why_nothing_converts_them(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    lines = said(monkeypatch, capsys, "check", "peça rotary-moves.nc", "--machine", "table-a")
    assert not any("cncstepper convert" in line for line in lines)
    assert any("no conversion" in line and "X, Y and Z" in line and ":9:" in line for line in lines)


def test_a_program_that_is_only_wrong_is_offered_nothing(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for text in ("G21 G90\nG1 X10\nM2\n", "G21 G90\nG1 X10 F100 Q5\n"):
        (folder / "wrong.nc").write_text(text, "ascii")
        lines = said(monkeypatch, capsys, "time", "wrong.nc", "--machine", "table-a")
        assert len(lines) == 1 and "hint" not in lines[0], lines


def test_a_command_for_windows_is_quoted_as_windows_reads_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(option_hints.sys, "platform", "win32")
    assert (
        option_hints.shell_line(["cncstepper", "convert", r"C:\peça 1\p.nc"]) == r'cncstepper convert "C:\peça 1\p.nc"'
    )
