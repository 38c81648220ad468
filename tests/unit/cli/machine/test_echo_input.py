# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a controller says by itself while a person types: shown as it comes, once, with the line below it again."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from types import SimpleNamespace

import pytest

from CNCStepper.cli.machine import console as echo_input
from CNCStepper.cli.machine.console import EchoInput
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.errors import LinkError

LIMIT_S = 30.0
IDLE = SenderStatus("idle", machine_state="Idle", wpos_mm=(1.0, 2.0, 3.0))
ALARM = SenderStatus("alarm", machine_state="Alarm", message="a limit switch was hit (ALARM:1); find the cause")


class FakeTalk:
    """A service whose events wait in a list until they are looked at."""

    def __init__(self) -> None:
        self.status = IDLE
        self.events: list[dict[str, str]] = []
        self.looks = 0
        self.is_over = False
        self.client = SimpleNamespace(
            error=LinkError("service-lost", "the service is gone", advice="look at the cable")
        )

    def heard(self) -> list[dict[str, str]]:
        self.looks += 1
        told, self.events = self.events, []
        return told


@pytest.fixture(autouse=True)
def quick(monkeypatch):
    monkeypatch.setattr(echo_input, "LOOK_EVERY_S", 0.001)
    monkeypatch.setattr(echo_input, "_typed", lambda: "G0 X")


def wait_until(true: Callable[[], bool]) -> None:
    end_s = time.monotonic() + LIMIT_S
    while not true():
        assert time.monotonic() < end_s
        time.sleep(0.001)


def look_twice(talk: FakeTalk) -> None:
    """Wait until all that was there is shown."""
    looks = talk.looks
    wait_until(lambda: talk.looks > looks + 1)


def test_message_comes_above_the_line_that_is_typed(capsys):
    talk = FakeTalk()
    with EchoInput(talk, "> "):
        talk.events = [{"event": "message", "text": "Pgm End"}, {"event": "status"}, {"event": "phase", "text": "idle"}]
        look_twice(talk)
    assert capsys.readouterr().out == "\rPgm End\n> G0 X"


def test_short_message_covers_what_was_typed(capsys, monkeypatch):
    monkeypatch.setattr(echo_input, "_typed", lambda: "G0 X10 Y10")
    talk = FakeTalk()
    with EchoInput(talk, "> "):
        talk.events = [{"event": "warning", "text": "no"}]
        look_twice(talk)
    assert capsys.readouterr().out.split("\n") == ["\r" + "no".ljust(12), "> G0 X10 Y10"]


def test_alarm_is_told_once_with_its_reason(capsys):
    talk = FakeTalk()
    again = EchoInput(talk, "> ")
    for _ in range(2):
        with again:
            talk.status = ALARM
            look_twice(talk)
    said = capsys.readouterr().out
    assert said.count("\rAlarm  a limit switch was hit (ALARM:1); find the cause\n") == 1 and said.count("\r") == 1


def test_alarm_of_the_line_before_is_told_and_a_hold_that_was_asked_for_is_not(capsys):
    talk = FakeTalk()
    again = EchoInput(talk, "> ")
    talk.status = SenderStatus("held", machine_state="Hold:0")
    with again:
        look_twice(talk)
    assert capsys.readouterr().out == ""
    talk.status = ALARM
    with again:
        look_twice(talk)
    assert "ALARM:1" in capsys.readouterr().out


def test_nothing_is_taken_from_the_service_while_nobody_types():
    talk = FakeTalk()
    with EchoInput(talk, "> "):
        look_twice(talk)
    looks = talk.looks
    talk.events = [{"event": "answer", "text": "ok"}]
    time.sleep(0.02)
    assert talk.looks == looks and talk.events


def test_lost_link_is_said_at_once(capsys):
    talk = FakeTalk()
    with EchoInput(talk, "> "):
        talk.is_over = True
        wait_until(lambda: "the service is gone" in capsys.readouterr().out)


def test_where_the_typed_line_is_not_known_it_stays_where_it_is(capsys, monkeypatch):
    monkeypatch.undo()
    monkeypatch.setitem(sys.modules, "readline", None)
    talk = FakeTalk()
    monkeypatch.setattr(echo_input, "LOOK_EVERY_S", 0.001)
    with EchoInput(talk, "> "):
        talk.events = [{"event": "message", "text": "Pgm End"}]
        look_twice(talk)
    assert capsys.readouterr().out == "\nPgm End\n> "


if sys.platform != "win32":

    @pytest.mark.slow
    def test_alarm_is_seen_at_the_prompt_of_a_terminal(tmp_path, monkeypatch):
        """A hard limit is pressed at a virtual grbl while nobody types anything."""
        import os
        import pty
        import subprocess

        from helpers.cli.command_line import command

        monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "peça 1"))
        board = subprocess.Popen(
            command("virtual", "grbl", "--tcp", "127.0.0.1:0", "--typed"),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            encoding="utf-8",
        )
        assert board.stdin and board.stdout
        address = board.stdout.readline().strip().rpartition(" ")[2]
        here, there = pty.openpty()
        console = subprocess.Popen(command("console", "--port", address), stdin=there, stdout=there, stderr=there)
        seen = b""

        def until(text: bytes) -> None:
            nonlocal seen
            while text not in seen:
                seen += os.read(here, 4096)

        until(b"> ")
        os.write(here, b"$21=1\n")
        until(b"ok\r\n> ")
        os.write(here, b"G0 half")
        until(b"G0 half")
        seen = b""
        board.stdin.write("press X\n")
        board.stdin.flush()
        until(b"(ALARM:1)")
        until(b"\n> G0 half")
        os.write(here, b"\x15quit\n")
        assert console.wait(LIMIT_S) == 0
        board.terminate()
        assert board.wait(LIMIT_S) == 0
        os.close(here)
        os.close(there)
