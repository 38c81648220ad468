# SPDX-License-Identifier: LGPL-2.1-or-later
"""The virtual grbl in a process of its own, also one that kills the sender."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

PLAN = '[[fault]]\nkind = "kill"\nat_byte = {}\npid_file = "{}"\n'
COMMAND = (
    sys.executable,
    "-u",
    "-m",
    "CNCStepper.cli.main",
    "virtual",
    "grbl",
    "--tcp",
    "127.0.0.1:0",
    "--speed",
    "10",
)
SERVE = """
import sys
from CNCStepper.machine.profile import load_machine
from CNCStepper.virtual.server.grbl_server import serve
port = {{sys.argv[1]: sys.argv[2]}}
serve(load_machine("table-a"), **port, speed={speed}, homing={homing}, ready=lambda address: print(address, flush=True))
"""


@contextmanager
def virtual_grbl(kind: str = "tcp", where: object = "127.0.0.1:0", speed: float = 50.0, homing: bool = False):
    """Run a virtual grbl and yield its address."""
    command = [sys.executable, "-c", SERVE.format(speed=speed, homing=homing), kind, str(where)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout
        try:
            yield process.stdout.readline().strip()
        finally:
            process.terminate()


@contextmanager
def machine_that_kills(
    folder: Path, at_byte: int = 3000, more: tuple[str, ...] = ()
) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """A virtual machine that kills whose number is in the folder's "pid", and its address; it writes trace.csv."""
    plan = folder / "plan.toml"
    plan.write_text(PLAN.format(at_byte, (folder / "pid").as_posix()), "utf-8")
    options = ("--faults", str(plan), "--trace", str(folder / "trace.csv"), *more)
    with subprocess.Popen([*COMMAND, *options], stdout=subprocess.PIPE, text=True) as machine:
        try:
            yield machine, machine.stdout.readline().split()[-1]
        finally:
            machine.terminate()
