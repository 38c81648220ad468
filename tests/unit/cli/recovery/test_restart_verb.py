# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper restart`, as a newcomer calls it; sent to a virtual controller of its own."""

from __future__ import annotations

import shlex
import signal
import subprocess
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from importlib import resources
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result

from CNCStepper.cli.main import group
from CNCStepper.control.journal.replay import FirstProgram
from CNCStepper.control.journal.store import replays
from CNCStepper.control.program.certificate import Certificate, digest_of_text
from CNCStepper.control.service.connection_session import attach, jobs_running
from helpers.cli.command_line import command, forked

PROGRAM = (
    "G21 G90\nT1\nM3 S12000\nG4 P1\nG0 Z10\nX0 Y0\nG1 Z-1 F300\nX20 F2000\nY10\nX0\nG0 Z10\nG92 X5 Y5\nX10 Y10\n"
    "G1 Z-1 F300\nX20 F2000\nG3 X20 Y10 I-5 J0\nG0 Z10\nG92.1\nM5\nM2\n"
)
PAUSE_LIMIT_S = 120.0
AGAINST = ("--machine", "table-a", "--stock", "100,100,10", "--tool", "flat:2")


@pytest.fixture
def program(tmp_path: Path) -> Path:
    path = tmp_path / "peça de teste.nc"
    path.write_text(PROGRAM, encoding="utf-8")
    return path


def called(*arguments: str | Path) -> Result:
    return CliRunner().invoke(group, ["restart", *map(str, arguments)])


def test_without_a_place_the_contours_are_listed(program: Path) -> None:
    result = called(program, *AGAINST)
    assert result.exit_code == 0, result.output
    assert "      1      7" in result.output
    assert "      2     14" in result.output


def test_a_dry_run_tells_and_writes_nothing(program: Path) -> None:
    result = called(program, *AGAINST, "--line", "10")
    assert result.exit_code == 0, result.output
    assert "enters line 10 at X20.000 Y10.000 Z-1.000" in result.output
    assert "starts the spindle at 12000 rpm" in result.output
    assert [path.name for path in program.parent.iterdir()] == [program.name]


def test_program_and_certificate_are_written(program: Path) -> None:
    out, certificate = program.with_name("resto.nc"), program.with_name("resto.json")
    result = called(program, *AGAINST, "--contour", "2", "-o", out, "--certificate", certificate)
    assert result.exit_code == 0, result.output
    text = out.read_text("utf-8")
    assert text.startswith("(restart of peca de teste.nc at line 14)")
    proof = Certificate.read(certificate)
    proof.compare("program", digest_of_text(text))
    first = FirstProgram.of(proof.send_job().restart_of)
    assert first and (first.file, first.sha256) == (str(program.resolve()), digest_of_text(PROGRAM))
    own = text.splitlines()
    for line, there in enumerate(PROGRAM.splitlines(), 1):
        if line > 15:
            assert any(first.line(here) == line and own[here - 1] == there for here in range(1, len(own) + 1))


def test_a_restart_that_would_crash_is_refused(program: Path) -> None:
    out = program.with_name("resto.nc")
    result = called(program, *AGAINST, "--line", "16", "--height", "-0.5", "-o", out)
    assert result.exit_code == 1
    assert "[place-unknown-in-stock]" in result.output
    assert "this restart is refused" in result.output


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--line", "2"), "nothing is cut before this place"),
        (("--line", "5", "--contour", "1"), "give one"),
        (("--contour", "9"), "there is no contour 9"),
        (("--operation", "x"), "no operation, or more than one, is called 'x'"),
    ],
)
def test_a_place_that_is_none_is_refused_in_words(program: Path, arguments: tuple[str, ...], words: str) -> None:
    error = called(program, *AGAINST, *arguments).exception
    assert words in str(error)


@pytest.mark.parametrize("arguments", [("--line", "0"), ("--at", "5"), ("--at", "a,b"), ("--overlap", "-1")])
def test_a_wrong_option_is_a_usage_error(program: Path, arguments: tuple[str, ...]) -> None:
    assert called(program, *AGAINST, *arguments).exit_code == 2


def test_a_machine_is_needed(program: Path) -> None:
    result = called(program, "--line", "10")
    assert result.exit_code == 2
    assert "--machine" in result.output


def test_without_stock_it_says_so_and_is_not_sent(program: Path) -> None:
    result = called(program, "--machine", "table-a", "--line", "10")
    assert result.exit_code == 0 and "NOT simulated on a stock" in result.output
    assert "NOT cut" not in called(program, *AGAINST, "--line", "10").output
    result = called(program, "--machine", "table-a", "--line", "10", "--port", "COM999")
    assert result.exit_code == 2 and "or --without-stock" in " ".join(result.output.split())
    assert called(program, *AGAINST, "--line", "10", "--without-stock").exit_code == 2


def test_a_dry_run_says_that_it_goes_up_and_never_down(program: Path) -> None:
    result = called(program, *AGAINST, "--line", "10", "--certificate", program.with_suffix(".json"))
    assert "goes to Z 10.000 first, straight up (it is not sent while the tool stands higher)" in result.output
    lift = Certificate.read(program.with_suffix(".json")).send_job().lift
    assert lift == {"system": "G54", "z_mm": 10.0, "height_mm": 10.0}


@pytest.fixture
def table(tmp_path: Path) -> Iterator[tuple[str, Path]]:
    """A running virtual grbl: its port and its trace."""
    trace = tmp_path / "trace.csv"
    words = ("virtual", "grbl", "--tcp", "127.0.0.1:0", "--speed", "50", "--trace", trace)
    process = subprocess.Popen(command(*words), stdout=subprocess.PIPE, encoding="utf-8", preexec_fn=forked(*words))
    assert process.stdout
    yield f"socket://{process.stdout.readline().strip().rpartition(' ')[2].removeprefix('socket://')}", trace
    process.terminate()
    assert process.wait(30) == 0


@pytest.mark.slow
def test_the_rest_is_cut_on_a_controller_with_the_shift_of_g92(program: Path, table: tuple[str, Path]) -> None:
    port, trace = table
    on_sigterm = signal.getsignal(signal.SIGTERM)
    result = called(program, *AGAINST, "--line", "16", "--port", port, "--zero-confirmed", "--resume-pauses")
    signal.signal(signal.SIGTERM, on_sigterm)
    assert result.exit_code == 0, result.output
    assert "the machine is idle" in result.output
    rows = [line.split(",")[1:4] for line in trace.read_text("utf-8").splitlines() if line[:1].isdigit()]
    places = np.array(rows, float)
    low = places[places[:, 2] < -0.99]
    centre = np.array([20 - 5 - 5, 10 + 5])  # G92 has moved the zero by -5, 5
    assert np.hypot(*(low[:, :2] - centre).T) == pytest.approx(5.0, abs=0.05)
    assert places[-1, 2] == pytest.approx(10.0, abs=0.01)


def stop_at_pause() -> None:
    """Stop the job that runs, as from another terminal, where it pauses."""
    until_s = time.monotonic() + PAUSE_LIMIT_S
    while not (running := jobs_running()):
        assert time.monotonic() < until_s
        time.sleep(0.05)
    with attach(running[0]) as session:
        while session.status().phase != "paused":
            assert time.monotonic() < until_s
            time.sleep(0.05)
        session.stop()


@pytest.mark.slow
def test_what_resume_offers_runs_as_it_is_pasted(
    program: Path, table: tuple[str, Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A job of a profile of one's own is stopped at a pause; the line that is offered then cuts the rest."""
    monkeypatch.setattr(signal, "signal", lambda number, handler: None)
    profile = program.with_name("My own çable.toml")
    shipped = resources.files("CNCStepper.machine") / "profiles" / "table-a.toml"
    profile.write_text(shipped.read_text("utf-8").replace("Cutting table A", "My own çable"), "utf-8")
    program.write_text(PROGRAM.replace("G92 X5 Y5\n", "G4 P0.1\nS12000\nM0\nG92 X5 Y5\n"), "utf-8")
    stock = ("--stock", "100,100,10", "--tool", "flat:2", "--dialect", "grbl")
    sending = ("--port", table[0], "--machine", str(profile), *stock, "--zero-confirmed")
    with ThreadPoolExecutor(1) as another:
        stopped = another.submit(stop_at_pause)
        assert CliRunner().invoke(group, ["send", str(program), *sending]).exit_code == 1
        stopped.result()
    journal = next(story.path for story in replays() if story.header["file"] == str(program.resolve()))
    told = CliRunner().invoke(group, ["resume", str(journal)]).output.splitlines()
    pasted = shlex.split(told[-1].removeprefix("restart"))
    assert pasted[:2] == ["cncstepper", "restart"] and str(profile) in pasted
    result = CliRunner().invoke(group, [*pasted[1:], "--zero-confirmed", "--resume-pauses"])
    assert result.exit_code == 0, result.output
    assert "simulated on the stock that the earlier moves have left" in result.output
    assert "the machine is idle" in result.output
