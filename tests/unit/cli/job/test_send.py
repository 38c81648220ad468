# SPDX-License-Identifier: LGPL-2.1-or-later
"""`send` to `virtual grbl`, as two terminals of a newcomer.

The controller and the sender are processes of their own always, the command line itself where a terminal matters.
"""

from __future__ import annotations

import subprocess
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.control.program.bundle import Lines, Numbers
from CNCStepper.control.program.certificate import Certificate, digest_of_text
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.session.status import DONE, Outcome, SenderStatus
from helpers.cli.command_line import called, command, forked

CONFIRMED = ("--machine", "table-a", "--zero-confirmed")
PROGRAM = "G21 G90\nG0 Z5\nG0 X10 Y0\nG1 Z-1 F300\n(MSG, look)\nM0\nG3 X10 Y0 I-10 J0 F2000\nG0 Z5\nM2\n"


@pytest.fixture
def table(tmp_path: Path) -> Iterator[tuple[str, Path]]:
    """A running virtual grbl: its port and its trace."""
    trace = tmp_path / "trace.csv"
    words = ("virtual", "grbl", "--tcp", "127.0.0.1:0", "--speed", "20", "--trace", trace)
    process = subprocess.Popen(command(*words), stdout=subprocess.PIPE, encoding="utf-8", preexec_fn=forked(*words))
    assert process.stdout
    said = process.stdout.readline().strip()
    yield f"socket://{said.rpartition(' ')[2].removeprefix('socket://')}", trace
    process.terminate()
    assert process.wait(10) == 0


def send(path: Path, port: str, *more: str, answer: str = "") -> subprocess.CompletedProcess[str]:
    words = ("send", path, "--port", port, "--machine", "table-a", *more)
    options = {"capture_output": True, "encoding": "utf-8", "timeout": 60}
    return subprocess.run(command(*words), input=answer, preexec_fn=forked(*words), **options)


@pytest.fixture
def program(tmp_path: Path) -> Path:
    path = tmp_path / "círculo 1.nc"
    path.write_text(PROGRAM, encoding="utf-8")
    return path


@pytest.mark.slow
def test_a_program_is_cut_to_its_end(program: Path, table: tuple[str, Path]) -> None:
    port, trace = table
    sent = send(program, port, "--zero-confirmed", "--resume-pauses")
    assert sent.returncode == 0, sent.stderr
    assert "8 of 8 lines acknowledged" in sent.stdout
    again = send(program, port, "--zero-confirmed", answer="\n")
    assert again.returncode == 0, again.stderr
    assert "look" in again.stderr
    path = np.loadtxt(trace, delimiter=",", skiprows=1)
    assert trace.read_text("ascii").startswith("t_s,x_mm,y_mm,z_mm\n")
    cutting = path[path[:, 3] <= -1 + 1e-9]
    assert abs(np.hypot(cutting[:, 1], cutting[:, 2]) - 10).max() < 2 / 80


@pytest.mark.slow
def test_a_stop_at_the_pause_is_exit_1(program: Path, table: tuple[str, Path]) -> None:
    sent = called("send", program, "--port", table[0], *CONFIRMED, answer="s\n")
    assert sent.returncode == 1
    assert "stop" in sent.stdout.lower()


@pytest.mark.slow
def test_nobody_to_ask_means_no_cut(program: Path, table: tuple[str, Path]) -> None:
    sent = send(program, table[0])
    assert sent.returncode == 1
    assert "--zero-confirmed" in sent.stderr and "Traceback" not in sent.stderr


@pytest.mark.slow
def test_a_port_that_is_not_there(program: Path) -> None:
    sent = send(program, "/dev/no-such-port", "--zero-confirmed")
    assert sent.returncode == 1
    assert "/dev/no-such-port" in sent.stderr and "Traceback" not in sent.stderr


@pytest.mark.slow
def test_a_machine_in_alarm_is_refused(program: Path, tmp_path: Path) -> None:
    words = ("virtual", "grbl", "--tcp", "127.0.0.1:0", "--homing")
    process = subprocess.Popen(command(*words), stdout=subprocess.PIPE, encoding="utf-8", preexec_fn=forked(*words))
    assert process.stdout
    port = "socket://" + process.stdout.readline().strip().rpartition(" ")[2].removeprefix("socket://")
    sent = called("send", program, "--port", port, *CONFIRMED)
    process.terminate()
    process.wait(10)
    assert sent.returncode == 1
    assert "alarm" in sent.stderr.lower() and "Traceback" not in sent.stderr


def test_a_program_that_does_not_fit_the_machine_is_not_sent(tmp_path: Path) -> None:
    path = tmp_path / "large.nc"
    path.write_text("G21 G90\nG0 Z5\nG0 X0 Y0\nG1 X500 F500\nM2\n", encoding="ascii")
    sent = called("send", path, "--port", "socket://127.0.0.1:9", *CONFIRMED)
    assert sent.returncode == 1
    assert "large.nc:4" in sent.stdout


@pytest.mark.slow
def test_tool_is_touched_off_at_a_pause_and_lines_are_stepped(program: Path, table: tuple[str, Path]) -> None:
    answers = "\n\n\n\nx1 z2\nzero z\nall\n"  # four lines alone; at the pause jog, set the zero, and cut the rest
    sent = called("send", program, "--port", table[0], *CONFIRMED, "--unchecked", "--step", answer=answers)
    assert sent.returncode == 0, sent.stderr
    assert sent.stderr.index("zero of Z set in G54") < sent.stderr.index("back to where the program paused")


@pytest.mark.slow
def test_only_enter_alone_goes_on(program: Path, table: tuple[str, Path]) -> None:
    sent = called("send", program, "--port", table[0], *CONFIRMED, answer="x\nwhat\nstop\n")
    assert sent.returncode == 1
    assert sent.stderr.count("is no answer") == 2


ZERO = ("--work-zero", "-200,-200,-40")


@pytest.fixture
def certificate(program: Path, tmp_path: Path) -> Path:
    path = tmp_path / "certificado 1.json"
    stock = ("--stock", "40,40,5", "--tool", "flat:6")
    check = ("check", program, "--machine", "table-a", *stock, *ZERO, "--certificate", path)
    assert called(*check).returncode == 1  # its spindle stands still
    program.write_text(PROGRAM.replace("G0 Z5\n", "M3 S10000\nG4 P3\nG0 Z5\n", 1), encoding="utf-8")
    told = called(*check)
    assert told.returncode == 0, told.stdout
    assert "pierces 1" in told.stdout and "cm³ removed" in told.stdout
    return path


def certified(program: Path, port: str, path: Path, *more: str | Path) -> subprocess.CompletedProcess[str]:
    given = ("--port", port, "--certificate", path, "--zero-confirmed", "--resume-pauses")
    return called("send", program, *given, *more)


def set_zero(port: str, zero: str) -> None:
    import serial

    with serial.serial_for_url(port, timeout=5) as line:
        line.read_until(b"help]\r\n")
        line.write(f"G10 L2 P1 {zero}\n".encode("ascii"))
        assert line.readline().strip() == b"ok"


@pytest.mark.slow
def test_a_certified_program_is_cut_where_it_was_proven(
    program: Path, certificate: Path, table: tuple[str, Path]
) -> None:
    port = table[0]
    set_zero(port, "X0 Y0 Z0")  # whoever does this hears the greeting
    elsewhere = certified(program, port, certificate)
    assert elsewhere.returncode == 1
    assert "work zero is not where the program was proven" in elsewhere.stderr and "G54" in elsewhere.stderr
    set_zero(port, "X-200 Y-200 Z-40")
    sent = certified(program, port, certificate, "--machine", "table-a", "--tool", "flat:6", *ZERO)
    assert sent.returncode == 0, sent.stderr
    assert "10 of 10 lines acknowledged" in sent.stdout


def test_other_bytes_machines_starts_and_tools_are_refused(program: Path, certificate: Path, tmp_path: Path) -> None:
    nowhere = "socket://127.0.0.1:9"
    slower = tmp_path / "slower.toml"
    profile = (Path(__file__).parents[4] / "examples" / "machines" / "table-a.toml").read_text("utf-8")
    slower.write_text(profile.replace("5000", "4000"), encoding="utf-8")
    for word, more in (
        ("machine", ("--machine", slower)),
        ("start", ("--work-zero", "-200,-200,-41")),
        ("tools", ("--tool", "flat:5")),
        ("stock", ("--stock", "41,40,5")),
    ):
        sent = certified(program, nowhere, certificate, *more)
        assert sent.returncode == 1 and f"[certificate-{word}]" in sent.stderr, sent.stderr
    program.write_text(program.read_text("utf-8").replace("X10", "X9"), encoding="utf-8")
    assert "[certificate-program]" in certified(program, nowhere, certificate).stderr
    certificate.write_bytes(certificate.read_bytes().replace(b"look", b"talk"))
    assert "[certificate-changed]" in certified(program, nowhere, certificate).stderr


@pytest.mark.slow
def test_a_certified_program_is_never_held_whole(
    program: Path, certificate: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What is watched is read a block at a time."""
    jobs = []

    def watch(job: SendJob, resume_pauses: bool, keep_min: float) -> Outcome:
        assert isinstance(job.lines, Lines) and isinstance(job.file_lines, Numbers)
        jobs.append((list(job.lines), list(job.file_lines)))
        assert job.program_sha256 == digest_of_text(program.read_text("utf-8"))
        return Outcome(DONE, "", True, SenderStatus("idle", total=len(job.lines)))

    monkeypatch.setattr("CNCStepper.cli.job.session_watch.watch", watch)
    monkeypatch.setattr("CNCStepper.cli.job.send.read_program", lambda path: pytest.fail("it is held"))
    sent = certified(program, "nowhere", certificate, "--machine", "table-a", *ZERO)
    assert sent.returncode == 0, sent.stderr
    proven = Certificate.read(certificate)
    assert jobs == [(list(proven.lines), list(proven.file_lines))] and len(proven.lines) == 10


def test_a_program_whose_subroutine_was_changed_since_is_refused(tmp_path: Path) -> None:
    program, other, path = (tmp_path / name for name in ("program.nc", "down.ngc", "c.json"))
    other.write_text("o<down> sub\nG1 Z-1 F300\no<down> endsub\n", encoding="ascii")
    program.write_text("G21 G90\nM3 S10000\nG4 P3\nG0 Z5\no<down> call\nG0 Z5\nM5\nM2\n", encoding="ascii")
    halted = ("--machine", "table-a", "--dialect", "grblhal", *ZERO)
    told = called("check", program, *halted, "--certificate", path)
    assert told.returncode == 0, told.stdout + told.stderr
    same = certified(program, "/dev/no-such-port", path)
    assert "/dev/no-such-port" in same.stderr and "[certificate" not in same.stderr
    other.write_text("o<down> sub\nG1 Z-2 F300\no<down> endsub\n", encoding="ascii")
    changed = certified(program, "/dev/no-such-port", path)
    assert changed.returncode == 1 and "[certificate-wire]" in changed.stderr, changed.stderr


@pytest.mark.slow
def test_other_bytes_are_sent_when_told(program: Path, certificate: Path, table: tuple[str, Path]) -> None:
    program.write_text(program.read_text("utf-8").replace("X10", "X9").replace("I-10", "I-9"), encoding="utf-8")
    sent = certified(program, table[0], certificate, "--despite-certificate")
    assert sent.returncode == 0, sent.stderr
    assert "its text differs" in sent.stderr and "10 of 10" in sent.stdout


@pytest.mark.slow
def test_a_certificate_with_errors_is_refused_unless_told(
    program: Path, tmp_path: Path, table: tuple[str, Path]
) -> None:
    path = tmp_path / "c.json"
    far = ("--work-zero", "-5,-200,-40")
    called("check", program, "--machine", "table-a", *far, "--certificate", path)
    sent = certified(program, table[0], path)
    assert sent.returncode == 1 and "[certificate-errors]" in sent.stderr and f"{program}:3:" in sent.stderr
    sent = certified(program, table[0], path, "--despite-certificate", "--allow-differences")
    assert sent.returncode == 0, sent.stderr


CLAMP = "[[clamp]]\ncorners_mm = [[-5, -5], [5, 5]]\ntop_mm = 30\n\n[[tool]]"


@pytest.fixture
def job(tmp_path: Path) -> Path:
    """A job file whose program and certificate lie beside it."""
    folder = Path(__file__).parents[4] / "examples" / "jobs"
    text = (folder / "elliptical-pocket.toml").read_text("utf-8").replace("../machines/table-a.toml", "table-a")
    job = tmp_path / "job.toml"
    job.write_text(text, encoding="utf-8")
    assert called("run", job, "--out", tmp_path).returncode == 0
    return job


@pytest.mark.slow
def test_a_job_without_a_certificate_is_checked_against_all_that_it_says(job: Path, tmp_path: Path) -> None:
    def sent(*more: str) -> subprocess.CompletedProcess[str]:
        given = ("--port", "/dev/no-such-port", "--job", job, "--zero-confirmed")
        return called("send", tmp_path / "program.nc", *given, *more)

    assert "/dev/no-such-port" in sent().stderr and not sent().stdout.count("error")
    text = job.read_text("utf-8")
    for old, new, code in (("[[tool]]", CLAMP, "clamp"), ("depth_mm = 10", "depth_mm = 9.9", "gouge")):
        job.write_text(text.replace(old, new), encoding="utf-8")
        refused = sent()
        assert refused.returncode == 1 and f"[{code}]" in refused.stdout and not refused.stderr, refused.stdout
        assert "/dev/no-such-port" in sent("--unchecked").stderr


@pytest.mark.slow
def test_a_job_whose_tools_were_changed_since_is_refused(job: Path, tmp_path: Path) -> None:
    text = job.read_text("utf-8")
    program, path = tmp_path / "program.nc", tmp_path / "certificate.zip"
    same = certified(program, "/dev/no-such-port", path, "--job", job)
    assert "/dev/no-such-port" in same.stderr and "[certificate" not in same.stderr
    for old, new, word in (
        ("= 6.0", "= 5.9", "tools"),
        ("70, 20]", "70, 21]", "stock"),
        ("[[tool]]", CLAMP, "keep_out"),
    ):
        assert old in text
        job.write_text(text.replace(old, new), encoding="utf-8")
        other = certified(program, "/dev/no-such-port", path, "--job", job)
        assert other.returncode == 1 and f"[certificate-{word}]" in other.stderr, other.stderr


@pytest.mark.parametrize(("dialect", "text"), [("thesis-a", "G90 X40 Y0 F300\n"), ("linuxcnc", "#1=5\nG0 X#1\nM2\n")])
@pytest.mark.parametrize("given", [("--machine", "table-a"), ("--unchecked",)])
def test_language_that_the_controller_does_not_read_is_refused_at_once(
    tmp_path: Path, dialect: str, text: str, given: tuple[str, ...]
) -> None:
    program = tmp_path / "peça 1.nc"
    program.write_text(text, encoding="utf-8")
    nowhere = ("--port", "socket://127.0.0.1:9", "--zero-confirmed")
    sent = called("send", program, *nowhere, "--dialect", dialect, *given)
    assert sent.returncode == 1 and "[dialect-differs]" in sent.stderr, sent.stderr
    assert f"cncstepper convert PROGRAM --dialect {dialect} --to grbl -o NEW" in sent.stderr


def test_certificate_of_a_program_in_another_language_is_refused_too(tmp_path: Path) -> None:
    program, path = tmp_path / "peça 1.ngc", tmp_path / "c.json"
    program.write_text("G21 G90 G94 G17\nG0 X1\nM2\n", encoding="utf-8")
    check = ("check", program, "--machine", "table-a", "--dialect", "linuxcnc", "--certificate", path)
    assert called(*check).returncode == 0
    sent = certified(program, "socket://127.0.0.1:9", path, "--despite-certificate")
    assert sent.returncode == 1 and "[dialect-differs]" in sent.stderr, sent.stderr
