# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sender in a process of its own, killed by the plan of the virtual controller in the middle of its job."""

from __future__ import annotations

import subprocess
import sys

import pytest

from CNCStepper.control.send_job import SendJob
from CNCStepper.control.session import SessionClient
from CNCStepper.control.session_file import read_private
from CNCStepper.errors import LinkError

PLAN = '[[fault]]\nkind = "kill"\nat_byte = 3000\npid_file = "{}"\n'
LINES = ("G21G90G94G17F3000", *(f"G1X-{number % 5}Y-{number % 7}" for number in range(500)))
SERVE = (sys.executable, "-u", "-m", "CNCStepper.cli.main", "virtual", "grbl", "--tcp", "127.0.0.1:0", "--speed", "10")


@pytest.mark.slow
def test_killed_sender_is_told_as_lost_and_its_position_as_unknown(tmp_path):
    plan, killed = tmp_path / "plan.toml", tmp_path / "pid"
    plan.write_text(PLAN.format(killed.as_posix()), "utf-8")
    with subprocess.Popen([*SERVE, "--faults", str(plan)], stdout=subprocess.PIPE, text=True) as machine:
        try:
            address = machine.stdout.readline().split()[-1]
            job = SendJob(address, LINES, zero_confirmed=True)
            client = SessionClient.start(job, python=sys.executable, folder=tmp_path)
            killed.write_text(str(read_private(client.session_file)["process"]), "utf-8")
            with pytest.raises(LinkError, match="position is unknown") as caught:
                client.wait(limit_s=120)
            assert caught.value.code == "session-lost"
            assert "kill at byte 3000" in machine.stdout.readline()
        finally:
            machine.terminate()
