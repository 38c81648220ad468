# SPDX-License-Identifier: LGPL-2.1-or-later
"""Real processes, killed by the plan of the virtual controller in the middle of a job: a sender, and its client."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from fault_judge import covers, follows
from trace_file import rows_at, rows_of_file

from CNCStepper.control.journal.replay import KILLED, RUNNING
from CNCStepper.control.journal.store import latest_unfinished, replays
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.files import read_private
from CNCStepper.errors import LinkError

PLAN = '[[fault]]\nkind = "kill"\nat_byte = {}\npid_file = "{}"\n'
PLACES = [(-(number % 5), -(number % 7), 0) for number in range(500)]
LINES = ("G21G90G94G17F3000", *(f"G1X{x}Y{y}" for x, y, _ in PLACES))
SERVE = (sys.executable, "-u", "-m", "CNCStepper.cli.main", "virtual", "grbl", "--tcp", "127.0.0.1:0", "--speed", "10")
CLIENT = """
import sys
from pathlib import Path
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.session.client import SessionClient
SessionClient.start(SendJob.from_json(sys.stdin.read()), python=sys.executable, folder=Path(sys.argv[1])).wait()
"""
LIMIT_S = 120.0


@contextmanager
def machine_that_kills(
    folder: Path, at_byte: int = 3000, more: tuple[str, ...] = ()
) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """A virtual machine that kills whose number is in the folder's "pid", and its address; it writes trace.csv."""
    plan = folder / "plan.toml"
    plan.write_text(PLAN.format(at_byte, (folder / "pid").as_posix()), "utf-8")
    options = ("--faults", str(plan), "--trace", str(folder / "trace.csv"), *more)
    with subprocess.Popen([*SERVE, *options], stdout=subprocess.PIPE, text=True) as machine:
        try:
            yield machine, machine.stdout.readline().split()[-1]
        finally:
            machine.terminate()


@pytest.mark.slow
def test_killed_sender_is_told_as_lost_and_its_position_as_unknown(tmp_path):
    with machine_that_kills(tmp_path) as (machine, address):
        job = SendJob(address, LINES, zero_confirmed=True)
        client = SessionClient.start(job, python=sys.executable, folder=tmp_path)
        (tmp_path / "pid").write_text(str(read_private(client.session_file)["process"]), "utf-8")
        with pytest.raises(LinkError, match="position is unknown") as caught:
            client.wait(limit_s=LIMIT_S)
        assert caught.value.code == "session-lost"
        assert "kill at byte 3000" in machine.stdout.readline()
    assert latest_unfinished(tmp_path).end == KILLED
    assert follows(rows_at(PLACES), rows_of_file(tmp_path / "trace.csv"))


@pytest.mark.slow
def test_killed_client_leaves_its_sender_to_cut_the_part_exactly(tmp_path):
    with machine_that_kills(tmp_path) as (machine, address):
        job = SendJob(address, LINES, zero_confirmed=True)
        with subprocess.Popen(
            [sys.executable, "-c", CLIENT, str(tmp_path)], stdin=subprocess.PIPE, text=True
        ) as client:
            (tmp_path / "pid").write_text(str(client.pid), "utf-8")
            client.communicate(job.to_json())
        assert client.returncode != 0 and "kill at byte 3000" in machine.stdout.readline()
        end_s = time.monotonic() + LIMIT_S
        while (story := next(replays(tmp_path))).end == RUNNING:
            assert time.monotonic() < end_s, story
            time.sleep(0.1)
    assert story.is_done and story.finished == len(LINES), story
    assert covers(rows_at(PLACES), rows_of_file(tmp_path / "trace.csv"))
