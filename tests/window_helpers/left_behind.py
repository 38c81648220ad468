# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by a plain Python: a window's side of a job that is cut on a virtual grbl, to be killed while it is cut.

It prints the number of lines that are acknowledged, about ten times a second.
"""

import subprocess
import sys
import time
from pathlib import Path

from CNCStepper.control.program.send_job import SendJob, write_job
from CNCStepper.control.service.connection_client import ConnectionClient


def main(folder: Path) -> None:
    """Cut a job of some minutes."""
    words = ["virtual", "grbl", "--tcp", "127.0.0.1:0", "--until-left"]
    machine = subprocess.Popen(
        [sys.executable, "-m", "CNCStepper.cli.main", *words],
        stdout=subprocess.PIPE, text=True, start_new_session=True,
    )  # fmt: skip
    address = machine.stdout.readline().split()[-1]
    file = folder / "send.zip"
    lines = ["G21", "G90", "G94", *(f"G1X{index % 2 * 5}Y{index % 3}F300" for index in range(400))]
    write_job(file, SendJob(port="", lines=lines, file="left-behind.nc"))
    client = ConnectionClient.launch(address)
    wait_for(client, "idle")
    client.set_zero("XYZ")
    client.run(file, zero_confirmed=True)
    while True:
        client.poll()
        print(client.status.acknowledged, flush=True)
        time.sleep(0.1)


def wait_for(client: ConnectionClient, phase: str) -> None:
    """Poll until the service is in a phase."""
    while client.status.phase != phase:
        client.poll()
        assert client.phase != "gone", client.error
        time.sleep(0.05)


main(Path(sys.argv[1]))
