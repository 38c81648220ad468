# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a verb that takes long says on the terminal, and how it is stopped."""

from __future__ import annotations

import io
import os
import subprocess
import sys
import threading
from pathlib import Path

import ezdxf
import pytest
from click.testing import CliRunner

from CNCStepper import kernel_cache
from CNCStepper.cli import job_file
from CNCStepper.cli.common import progress as progress_module
from CNCStepper.cli.common.language import OVERRIDE
from CNCStepper.cli.common.progress import Progress
from CNCStepper.cli.editing import convert as convert_verb
from CNCStepper.cli.main import group
from CNCStepper.cli.program import check
from CNCStepper.errors import Text
from CNCStepper.gcode.conversion import convert
from CNCStepper.gcode.interpreter import program_file
from CNCStepper.gcode.interpreter.fast_path import text_runs
from CNCStepper.job.prove import STAGES


class Terminal(io.StringIO):
    """Keeps what is written; `said` is set once a text is among it."""

    def __init__(self, awaited: str):
        super().__init__()
        self.awaited, self.said = awaited, threading.Event()

    def isatty(self) -> bool:
        return True

    def write(self, text: str) -> int:
        count = super().write(text)
        if self.awaited in self.getvalue():
            self.said.set()
        return count


class Log(Terminal):
    """A file that keeps the same."""

    def isatty(self) -> bool:
        return False


def test_a_terminal_hears_what_is_done_and_how_far_it_is_and_is_left_clean() -> None:
    terminal = Terminal("timing: 50%")
    with Progress("reading", terminal, patience_s=0.01) as progress:
        progress.share(1.0)
        progress.doing("timing")
        progress.share(0.5)
        assert terminal.said.wait(30)
    last = terminal.getvalue().split("\r")[-2:]
    assert last[1] == "" and not last[0].strip() and len(last[0]) >= len("timing: 50%")


def test_a_stage_is_shown_in_the_language_of_the_locale(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(OVERRIDE, "pt")
    terminal = Terminal("(Ctrl+C interrompe)")
    stage = Text("{stage} {name}", stage=check.STAGES["read"], name="a.nc")
    with Progress(stage, terminal, patience_s=0.01):
        assert terminal.said.wait(30), terminal.getvalue()
    assert "lendo de volta a.nc: 0 s" in terminal.getvalue()


def test_who_is_quick_says_nothing() -> None:
    terminal, file = Terminal("reading"), io.StringIO()
    with Progress("reading", terminal, patience_s=60):
        pass
    with Progress("reading", file, patience_s=0):
        pass
    assert terminal.getvalue() == file.getvalue() == ""


def test_a_file_gets_a_line_now_and_then(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(progress_module, "LOG_EVERY_S", 0.02)
    file = Log("reading: 50%")
    with Progress("reading", file, patience_s=0) as progress:
        progress.share(0.5)
        assert file.said.wait(30)
    lines = file.getvalue().splitlines()
    assert lines and all(line.startswith("reading:") and "Ctrl" not in line for line in lines)


def test_every_stage_has_its_words() -> None:
    assert tuple(check.STAGES) == STAGES
    assert tuple(convert_verb.STAGES) == convert.STAGES


def test_a_first_run_says_that_kernels_are_compiled(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(kernel_cache.VARIABLE, str(tmp_path))
    monkeypatch.setattr(kernel_cache, "folder", lambda: tmp_path)
    (kernel := tmp_path / "geometry").mkdir()
    terminal = Terminal("s, compiling the kernels")
    with Progress("reading", terminal, patience_s=0.01):
        assert terminal.said.wait(30)
    os.utime(kernel, (0, 0))
    assert not kernel_cache.has_grown(progress_module.COMPILED_S)


def zigzag(tmp_path: Path) -> Path:
    path = tmp_path / "many.nc"
    lines = (f"X{n % 7} Y{n * 0.001:.3f}\n" for n in range(6_000))
    path.write_text("G21 G90 G17\nG0 Z5\nG0 X0 Y0\nM3 S1000\nG1 Z-1 F1000\n" + "".join(lines) + "M5\nM2\n", "ascii")
    return path


@pytest.mark.slow
@pytest.mark.parametrize("verb", ["check", "convert"])
def test_a_check_and_a_conversion_say_how_far_they_are(verb: str, tmp_path: Path, monkeypatch) -> None:
    told: dict[str, list[float]] = {"at once": []}
    for module in (text_runs, program_file):
        monkeypatch.setattr(module, "PIECE", 5_000)
    monkeypatch.setattr(Progress, "doing", lambda self, what: told.setdefault(what.partition(" many")[0], []))
    monkeypatch.setattr(Progress, "share", lambda self, share: told[list(told)[-1]].append(share))
    path = zigzag(tmp_path)
    more = {"check": ("--machine", "table-a"), "convert": ("--to", "linuxcnc", "-o", str(tmp_path / "out.nc"))}
    result = CliRunner().invoke(group, [verb, str(path), *more[verb]])
    assert result.exit_code == 0, result.output
    counted = [shares for shares in told.values() if shares]
    assert len(counted) == {"check": 1, "convert": 3}[verb]
    for shares in counted:
        assert len(shares) > 5 and max(shares) > 0.9 and min(shares) < 0.3 and all(0 <= share <= 1 for share in shares)


def test_a_verb_says_how_much_of_a_drawing_it_has_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    document = ezdxf.new(units=4)
    for y in range(300):
        document.modelspace().add_line((0, y), (9, y))
    document.saveas(tmp_path / "a.dxf")
    job = tmp_path / "job.toml"
    example = (Path(__file__).parents[4] / "examples" / "jobs" / "cycles" / "face.toml").read_text("utf-8")
    job.write_text(example + '[[shape]]\nname = "all"\ndxf = {file = "a.dxf", layer = "0"}\n', "utf-8")
    shares: list[float] = []
    monkeypatch.setattr(Progress, "share", lambda self, share: shares.append(share))
    job_file.job_of(job)
    assert len(shares) >= 3 and shares == sorted(shares) and shares[-1] > 0.8


@pytest.mark.parametrize("verb", ["time", "check"])
def test_ctrl_c_ends_a_verb_with_a_sentence(verb: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    program = tmp_path / "peça 1.nc"
    program.write_text("G21\nG0 X1\nM2\n", encoding="utf-8")

    def press(*arguments: object, **named: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("CNCStepper.gcode.interpreter.program_file.FileReading.chunks", press)
    monkeypatch.setattr("CNCStepper.gcode.wire.read_back.refused_lines", press)
    outcome = CliRunner().invoke(group, [verb, str(program), "--machine", "table-a"])
    assert outcome.exit_code == 130 and "stopped by Ctrl+C" in outcome.stderr
    assert len(outcome.stderr.strip().splitlines()) == 1 and not outcome.stdout


def test_a_program_from_a_pipe_takes_the_time_of_the_program() -> None:
    words = [sys.executable, "-m", "CNCStepper.cli", "time", "/dev/stdin", "--machine", "table-a"]
    if not os.path.exists("/dev/stdin"):  # Windows has no such name
        return
    text = "G21 G90\nG1 X10 F600\nM2\n"
    outcome = subprocess.run(words, input=text, capture_output=True, text=True, timeout=120)
    assert outcome.returncode == 0 and 1 < float(outcome.stdout) < 2


@pytest.mark.parametrize("verb", ["check", "time", "print", "simulate"])
@pytest.mark.parametrize("kind", ["a folder", "a pipe (FIFO)", "a device"])
def test_what_is_no_file_is_refused_at_once(verb: str, kind: str, tmp_path: Path) -> None:
    place = tmp_path / "place.nc"
    if kind == "a folder":
        place.mkdir()
    elif not hasattr(os, "mkfifo"):  # Windows has neither
        return
    elif kind == "a device":
        place = Path("/dev/zero")
    else:
        os.mkfifo(place)
    outcome = CliRunner().invoke(group, [verb, str(place), "--machine", "table-a"])
    assert outcome.exit_code == 2
    assert (kind if kind != "a folder" else "directory") in outcome.stderr


def test_a_program_from_a_pipe_is_checked_as_its_file_and_nothing_is_left(tmp_path: Path) -> None:
    if not os.path.exists("/dev/stdin"):  # Windows has no such name
        pytest.skip("no /dev/stdin")
    file, spools = tmp_path / "p.nc", tmp_path / "spools"
    spools.mkdir()
    file.write_text("G21 G90\nG0 Z5\nG0 X0 Y0\nG1 X10 F99999\nM2\n", "ascii")
    words = [sys.executable, "-m", "CNCStepper.cli", "check", "--machine", "table-a"]
    of_file = subprocess.run([*words, str(file)], capture_output=True, text=True)
    environment = os.environ | {"TMPDIR": str(spools)}
    of_pipe = subprocess.run(
        [*words, "/dev/stdin"], input=file.read_text("ascii"), capture_output=True, text=True, env=environment
    )
    assert "feed-above-rate" in of_file.stdout and of_pipe.returncode == of_file.returncode
    assert of_pipe.stdout == of_file.stdout.replace(str(file), "/dev/stdin")
    assert not list(spools.iterdir())
