# SPDX-License-Identifier: LGPL-2.1-or-later
"""A published machine without hardware in a process of its own, for the window to be connected to."""

from __future__ import annotations

import subprocess
import threading
from pathlib import Path

from CNCStepper.control.processes.python_finder import command, environment, find_python

END_S = 10.0


class Twin:
    """A virtual machine of a kind (`parport`, `board`, `lathe`); `told` are the lines that it has printed so far."""

    def __init__(self, kind: str, folder: Path, *options: str):
        self.trace = folder / "trace.csv"
        words = ("virtual", kind, "--tcp", "127.0.0.1:0", "--trace", str(self.trace), *options)
        pipe = subprocess.PIPE
        self._process = subprocess.Popen(
            command(find_python(), "CNCStepper.cli.main", *words), env=environment(), stdin=pipe, stdout=pipe, text=True
        )
        assert self._process.stdout
        self.address = self._process.stdout.readline().split()[-1]
        self.told: list[str] = []
        threading.Thread(target=self._read, daemon=True).start()

    def press(self, line: str) -> None:
        """Type a line: "press 12" keeps a pin of a parallel port pressed, "release 12" lets it go."""
        assert self._process.stdin
        self._process.stdin.write(line + "\n")
        self._process.stdin.flush()

    def has_told(self, words: str) -> bool:
        """Return whether a line with these words was printed."""
        return any(words in line for line in self.told)

    def place_mm(self) -> tuple[float, ...]:
        """Return where the motors are, once the trace has it: X, Y and Z, of the lathe X and Z."""
        rows = self.trace.read_text().splitlines()
        return tuple(round(float(value), 3) for value in rows[-1].split(",")[1:])

    def kill(self) -> None:
        """End it at once."""
        self._process.kill()

    def end(self) -> None:
        """End it and wait until it has gone."""
        self._process.terminate()
        try:
            self._process.wait(END_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait(END_S)

    def _read(self) -> None:
        assert self._process.stdout
        for line in self._process.stdout:
            self.told.append(line.strip())
