# SPDX-License-Identifier: LGPL-2.1-or-later
"""`ports`, `home`, `zero`, `jog` and `console` at a virtual controller, and what each refuses."""

from __future__ import annotations

import subprocess
from collections.abc import Callable, Iterator

import click
import pytest

from CNCStepper.cli.machine.console import Session, converse
from CNCStepper.cli.machine.jog import jog_line
from CNCStepper.cli.machine.service_client import ServiceClient
from CNCStepper.control.service.position_trust_file import PositionTrustFile
from CNCStepper.control.session.files import session_folder
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.control.stream.position_trust import LOST, NOTHING_AGAINST
from CNCStepper.errors import MachineRefusal
from helpers.cli.command_line import called, command, forked


class FakeTalk:
    """A service that does all at once, and notes what it was asked."""

    def __init__(self) -> None:
        self.asked: list[str] = []
        self.answer = "ok"
        self.status = SenderStatus("idle", machine_state="Idle", wpos_mm=(1.0, 2.0, 3.0), position_known=False, stand=7)
        self.client = self
        self.is_over = False
        self.hold = lambda: self._note("hold", "held")
        self.resume = lambda stand: self._note(f"resume {stand}", "busy")
        self.stop = lambda: self._note("stop", "idle")

    def _note(self, what: str, phase: str) -> None:
        self.asked.append(what)
        self.status = SenderStatus(phase, machine_state=phase, stand=7)

    def heard(self) -> list[dict[str, str]]:
        return []

    def check(self) -> None:
        assert not self.is_over

    def ask_status(self) -> SenderStatus:
        return self.status

    def override(self, values: dict[str, str]) -> None:
        self.asked.append(" ".join(["override", *values.values()]))

    def type(self, text: str) -> str:
        self.asked.append(text)
        return self.answer

    def home(self) -> None:
        self.asked.append("home")

    def set_zero(self, axes: str) -> None:
        self.asked.append(f"zero {axes}")

    def until(self, done: Callable[[dict], bool]) -> dict:
        event = {"event": "status"}
        assert done(event)
        return event


def test_words_of_a_console_do_what_they_say(capsys):
    talk = FakeTalk()
    session = Session(talk)
    for line in ("$$", "$H", "unlock", "zero", "zero Z", "jog X1 Y-2 F300", "!", "~",
                 "feed +10", "flood", "stop", "G0 X1", ""):  # fmt: skip
        session.do(line)
    assert talk.asked == [
        "$$", "home", "$X", "zero XYZ", "zero Z", "$J=G91G21X1.0000Y-2.0000F300.0", "hold", "resume 7",
        "override feed 10", "override coolant flood", "stop", "G0 X1",
    ]  # fmt: skip


def test_console_shows_where_the_machine_stands_and_that_it_is_unknown(capsys):
    Session(FakeTalk()).do("?")
    assert capsys.readouterr().out == "Idle  X1.000 Y2.000 Z3.000  position unknown\n"


class QuietService:
    """A service whose machine does not change: it tells its status only where it is asked."""

    def __init__(self) -> None:
        self.status = SenderStatus("alarm", machine_state="Alarm")
        self.phase = "connected"
        self.asked: list[str] = []

    def ask(self, command: str) -> None:
        self.asked.append(command)

    def poll(self) -> list[dict[str, str]]:
        return [{"event": self.asked.pop()}] if self.asked else []


def test_console_shows_a_machine_that_does_not_change_as_often_as_it_is_asked(capsys):
    talk = ServiceClient.__new__(ServiceClient)
    talk.client = QuietService()
    for _ in range(3):
        Session(talk).do("?")
    assert capsys.readouterr().out == "Alarm\n" * 3


class GrblService(QuietService):
    """A service whose machine tells its overrides with the third status, and a change with the next but one."""

    def __init__(self) -> None:
        super().__init__()
        self.told = [None, None, (100, 100, 100)]

    def ask(self, command: str, **values: str) -> None:
        super().ask(command)
        if command == "override":
            self.told += [self.told[-1] or (100, 100, 100), (110, 100, 100)]
        else:
            self.status = SenderStatus("idle", overrides=self.told.pop(0) if len(self.told) > 1 else self.told[0])


def test_override_is_shown_where_those_of_before_were_not_told_yet(capsys):
    talk = ServiceClient.__new__(ServiceClient)
    talk.client = GrblService()
    Session(talk).do("feed +10")
    assert capsys.readouterr().out == "110/100/100 %\n"


@pytest.mark.parametrize("line", ["feed 5", "spindle", "rapid +10"])
def test_override_that_there_is_not_is_refused(line):
    talk = FakeTalk()
    with pytest.raises(click.UsageError, match="there is no override"):
        Session(talk).do(line)
    assert talk.asked == []


def test_answer_that_is_no_ok_is_a_refusal():
    talk = FakeTalk()
    talk.answer = "error:22 no feed rate was set; give an F word"
    with pytest.raises(click.ClickException, match="error:22"):
        Session(talk).do("G1X1")


def test_refusal_in_a_conversation_is_said_and_the_next_line_is_asked_for(monkeypatch, capsys):
    talk = FakeTalk()
    talk.answer = "error:22 no feed rate was set; give an F word"
    typed = iter(["G1X1", "jog X", "jog X1 Fast", "home", "history", "quit", "G0X9"])
    monkeypatch.setattr("builtins.input", lambda prompt: next(typed))
    converse(talk)
    assert talk.asked == ["G1X1", "home"]
    said = capsys.readouterr().out
    assert "error:22" in said and "is no way" in said and said.endswith("G1X1\njog X\njog X1 Fast\nhome\n")


def test_end_of_input_and_ctrl_c_at_the_prompt(monkeypatch, capsys):
    def typed(prompt: str) -> str:
        raise ends.pop()

    ends = [EOFError(), KeyboardInterrupt()]
    monkeypatch.setattr("builtins.input", typed)
    converse(FakeTalk())
    assert not ends


@pytest.mark.parametrize("way", [("X",), ("A1",), ("X1", "X2"), ("X1Y2",), ("X1e3",), ("",)])
def test_what_is_no_way_is_refused(way):
    with pytest.raises(click.UsageError, match="is no way"):
        jog_line(way, 1000.0)


def test_ways_are_read():
    assert jog_line(("x-.5", "Z10."), 500.0) == "$J=G91G21X-0.5000Z10.0000F500.0"


@pytest.fixture(scope="module")
def port() -> Iterator[str]:
    """A virtual grbl that must be homed."""
    words = ("virtual", "grbl", "--tcp", "127.0.0.1:0", "--speed", "50", "--homing")
    process = subprocess.Popen(command(*words), stdout=subprocess.PIPE, encoding="utf-8", preexec_fn=forked(*words))
    assert process.stdout
    yield process.stdout.readline().strip().rpartition(" ")[2]
    process.terminate()
    assert process.wait(20) == 0


@pytest.mark.slow
def test_newcomer_asks_homes_jogs_zeroes_and_types(port, monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "état ç"))
    asked = called("ports", "--ask", port)
    assert asked.returncode == 0 and "grbl 1.1 1.1h.20190830" in asked.stdout and "Alarm" in asked.stdout
    assert "128 bytes" in asked.stdout
    assert PositionTrustFile.of_port(session_folder(), port).trust == LOST
    refused = called("jog", "X-1", "--port", port)
    assert refused.returncode == 1 and "home the machine" in refused.stderr
    homed = called("home", "--port", port)
    assert homed.returncode == 0 and "the machine is homed" in homed.stdout
    assert PositionTrustFile.of_port(session_folder(), port).trust == NOTHING_AGAINST
    jogged = called("jog", "X-2", "Y-3", "--port", port, "--feed", "2000")
    assert jogged.returncode == 0 and "X-3.000 Y-4.000" in jogged.stdout.splitlines()[-1]
    zeroed = called("zero", "xy", "--port", port)
    assert zeroed.returncode == 0 and "X0.000 Y0.000" in zeroed.stdout.splitlines()[-1]
    typed = called("console", "--port", port, answer="$G\nG0 X-3\nG1 X!\nG0 X0\n")
    left = called("console", "--port", port, answer="$G\n?\n?\nfeed +10\n?\nquit\nG1 X!\n")
    assert left.stdout.count("\nIdle  ") == 3 and "\n110/100/100 %\n" in left.stdout
    assert left.returncode == 0 and not left.stderr
    assert typed.returncode == 1 and "would act as a command" in typed.stderr
    assert "[GC:G0 G54" in typed.stdout and typed.stdout.splitlines()[-1] == "ok"


@pytest.mark.slow
def test_port_where_nothing_answers_is_said(port):
    silent = called("ports", "--ask", "socket://127.0.0.1:9")
    assert silent.returncode == 1 and "nothing answers" in silent.stdout


def test_refusal_of_a_service_keeps_its_words():
    class Refusing(FakeTalk):
        def set_zero(self, axes: str) -> None:
            raise MachineRefusal("axes", f"'{axes}' names no axes", advice="write for example XYZ, or Z alone")

    with pytest.raises(MachineRefusal, match="names no axes"):
        Session(Refusing()).do("zero W")
