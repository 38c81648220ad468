# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mini-lathe's port: 9600 baud, eight data bits, even parity, one stop bit; nothing ever comes back.

a serial device             8E1
socket://…, a pseudo-       8N1, and `note` says so: sockets have no parity, and Linux refuses it to
terminal, loop://           pseudo-terminals
record:FILE                 a file of t_s,byte for each byte that is sent
"""

from __future__ import annotations

import csv
import os
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import IO, Any, Protocol

from CNCStepper.control.protocol.lathe.jog_guard import JogGuard, guard_of
from CNCStepper.control.transport.link import cause_of, load_pyserial, port_refusal
from CNCStepper.errors import LinkError, Text

BAUD = 9600
BITS = 11  # of a byte on the line: start, eight data bits, parity, stop
BYTE_S = BITS / BAUD
WRITE_LIMIT_S = 1.0
READ_BYTES = 256
RECORD = "record:"
PSEUDO_TERMINALS = "/dev/pts/"
NO_PARITY = "the port is opened 8N1: neither a socket nor a pseudo-terminal has parity (the lathe itself wants 8E1)"


class LathePort(Protocol):
    """The output for the lathe's bytes; note: a warning about the port, or ""."""

    note: str

    def write(self, data: bytes) -> None:
        """Send all of `data`; raises LinkError where the port is gone."""

    def check(self) -> None:
        """Raise LinkError where the port is gone."""

    def close(self) -> None:
        """Give the port back."""


class SerialPort:
    """A port of pyserial, opened with timeout 0; guard: releases a jog if this process is killed."""

    def __init__(self, port: Any, name: str, note: str = "", guard: JogGuard | None = None):
        self.note = note
        self._port, self._name, self._guard = port, name, guard

    def write(self, data: bytes) -> None:
        """Send all of `data`; raises LinkError where the port is gone."""
        if self._guard:
            self._guard.before(data)
        try:
            self._port.write(data)
        except (OSError, ValueError) as error:
            raise _lost(self._name, error) from error
        if self._guard:
            self._guard.after(data)

    def check(self) -> None:
        """Raise LinkError where the port is closed; input is discarded, since the lathe sends nothing."""
        try:
            self._port.read(READ_BYTES)
        except (OSError, ValueError) as error:
            raise _lost(self._name, error) from error

    def close(self) -> None:
        """Send what waits, and give the port back."""
        with suppress(Exception):  # termios' own errors are no OSError; the port may be closed
            self._port.flush()
        if self._guard:
            self._guard.close()
        with suppress(OSError, ValueError):
            self._port.close()


class RecordingPort:
    """A file that gets a row t_s,byte for each byte, byte in hexadecimal; t_s from the opening."""

    note = ""

    def __init__(self, file: IO[str], clock: Callable[[], float] = time.monotonic):
        self._file, self._clock, self._begin_s = file, clock, clock()
        self._rows = csv.writer(file, lineterminator="\n")
        self._rows.writerow(("t_s", "byte"))

    def write(self, data: bytes) -> None:
        """Note each byte."""
        now_s = self._clock() - self._begin_s
        self._rows.writerows((f"{now_s:.6f}", f"{byte:02X}") for byte in data)
        self._file.flush()

    def check(self) -> None:
        """Do nothing: a file does not go away."""

    def close(self) -> None:
        """Close the file."""
        self._file.close()


def open_port(name: str) -> LathePort:
    """Open a serial device, URL of pyserial, pseudo-terminal or `record:FILE`.

    Raises LinkError with advice where it cannot be opened, MissingPackage without pyserial.
    """
    if name.startswith(RECORD):
        return _recording(Path(name.removeprefix(RECORD)))
    serial = load_pyserial()
    has_parity = "://" not in name and not os.path.realpath(name).startswith(PSEUDO_TERMINALS)
    try:
        port = serial.serial_for_url(
            name,
            baudrate=BAUD,
            bytesize=serial.EIGHTBITS,
            parity=serial.PARITY_EVEN if has_parity else serial.PARITY_NONE,
            stopbits=serial.STOPBITS_ONE,
            timeout=0,
            write_timeout=WRITE_LIMIT_S,
            exclusive=True,
        )
    except (OSError, ValueError, TypeError, AttributeError) as error:  # a bad URL ends in any of these
        raise port_refusal(name, error) from error
    return SerialPort(port, name, "" if has_parity else NO_PARITY, guard_of(_descriptor(port)))


def _descriptor(port: Any) -> int | None:
    try:
        return int(port.fileno())
    except (AttributeError, OSError):
        return None


def _recording(path: Path) -> RecordingPort:
    try:
        return RecordingPort(path.open("x", encoding="ascii", newline=""))
    except OSError as error:
        raise LinkError(
            "recording",
            Text("{path} cannot be recorded in: {error}", path=path, error=error),
            advice="name a file that is not there yet, in a folder that you may write in",
        ) from error


def _lost(name: str, error: Exception) -> LinkError:
    return LinkError(
        "link-lost",
        Text("the link to {name} broke: {error}", name=name, error=cause_of(error)),
        advice="the lathe finishes a move that it has begun: switch it off, then set its zero again",
    )
