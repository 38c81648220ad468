# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sender killed in the middle of a job: its journal's interval holds where the virtual machine really was."""

from __future__ import annotations

import random
import re
import socket
import sys
import time

import pytest
from click.testing import CliRunner
from test_virtual_controller import virtual_grbl

from CNCStepper.cli.recovery.resume import command
from CNCStepper.control.journal.replay import KILLED, RUNNING, read_replay
from CNCStepper.control.journal.store import journals
from CNCStepper.control.program.certificate import digest_of_text
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.service.position_trust_file import PositionTrustFile
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.stream.position_trust import LOST, NOTHING_AGAINST

KILLS = 8
LIMIT_S = 60.0
HEAD = ["G21G90G94", "G10L20P1X0Y0Z0"]
STEP_MM = 0.1  # a line
MOVES = 4000


def program(sign: int) -> list[str]:
    return [*HEAD, *(f"G1X{sign * STEP_MM * number:.1f}F3000" for number in range(1, MOVES + 1))]


class Table:
    """The virtual machine's own word, by no code of `control`."""

    def __init__(self, address: str):
        host, port = address.removeprefix("socket://").rsplit(":", 1)
        self._wire = socket.create_connection((host, int(port)), LIMIT_S)
        self._wire.settimeout(LIMIT_S)
        self._offset_mm = 0.0

    def seen(self) -> tuple[str, float]:
        """Return its state and its machine position along X."""
        self._wire.sendall(b"?")
        said = b""
        while not (report := re.search(rb"<(\w+)[^>\n]*\|MPos:([-\d.]+)[^>]*>", said)):
            said += self._wire.recv(4096)
        self._offset_mm = float(offset[1]) if (offset := re.search(rb"WCO:([-\d.]+)", said)) else self._offset_mm
        return report[1].decode(), float(report[2])

    def at_rest(self) -> float:
        """Wait until it stands; return its machine position along X."""
        end_s = time.monotonic() + LIMIT_S
        while time.monotonic() < end_s:
            seen = [self.seen() for _ in range(40)]  # the offset comes with some reports only
            if {state for state, _ in seen} == {"Idle"}:
                return seen[-1][1]
            time.sleep(0.02)
        raise AssertionError("it does not come to rest")

    def lines_made(self, x_mm: float) -> float:
        """Return how many lines of the program are made at a machine position, the last perhaps in part."""
        return abs(x_mm - self._offset_mm) / STEP_MM + len(HEAD)

    def leave(self) -> None:
        self._wire.close()


@pytest.fixture(scope="module")
def table():
    with virtual_grbl(speed=1.0) as address:
        yield address


def killed(address: str, folder, moves: int, **job):
    """Send until so many lines are sent and kill the sender; return what the machine had made then and in the end."""
    client = SessionClient.start(SendJob(address, zero_confirmed=True, **job), python=sys.executable, folder=folder)
    end_s = time.monotonic() + LIMIT_S
    while (status := client.status()).sent < moves and status.phase in ("connecting", "running"):
        assert time.monotonic() < end_s, status
    (path, *_) = journals(folder)
    running = read_replay(path).end
    client._process.kill()
    client._process.wait()
    machine = Table(address)
    _, then_mm = machine.seen()
    finally_mm = machine.at_rest()
    machine.leave()
    kept = PositionTrustFile.of_port(folder, address)
    assert kept.trust == LOST
    kept.keep(NOTHING_AGAINST)  # as when a person has looked, and set the zero
    return running, machine.lines_made(then_mm), machine.lines_made(finally_mm), read_replay(path)


@pytest.mark.slow
def test_after_each_kill_the_interval_holds_the_truth(table, tmp_path):
    seed = random.randrange(2**32)
    rng = random.Random(seed)
    print(f"seed {seed}")
    widths = []
    for kill in range(KILLS):
        moves = rng.randrange(1, 500)
        running, then, finally_, story = killed(table, tmp_path, moves, lines=program((-1) ** kill))
        assert running == RUNNING and story.end == KILLED and not story.faults
        assert story.finished <= then + 1e-6, (kill, moves)
        assert story.group.acknowledged - 0.2 <= finally_ <= story.may_be_sent + 0.2, (kill, moves)
        widths.append(story.may_be_sent - story.finished)
    assert max(widths) < MOVES, widths  # and it says something


@pytest.mark.slow
def test_resume_states_the_interval_and_the_restart(table, tmp_path):
    text = "(part)\n" + "".join(f"{line}\n" for line in program(1))
    file = tmp_path / "peça 1.nc"
    file.write_text(text, "utf-8")
    folder = tmp_path / "sessions"
    folder.mkdir()
    lines = program(1)
    told = {"file": str(file), "file_lines": range(2, len(lines) + 2), "program_sha256": digest_of_text(text)}
    _, _, _, story = killed(table, folder, 200, lines=lines, **told)
    said = CliRunner().invoke(command, [str(story.path)])
    assert said.exit_code == 0, said.output
    assert f"all before line {story.finished + 2} is cut" in said.output or not story.finished
    assert f"line {story.may_be_sent + 1} may have been sent" in said.output
    assert f"cncstepper restart '{file}' --line {story.finished + 2}" in said.output
    file.write_text(text + "M2\n", "utf-8")
    assert "was changed since" in CliRunner().invoke(command, [str(story.path)]).output
