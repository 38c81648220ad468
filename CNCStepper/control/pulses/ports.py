# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where pulses go out: a parallel port through its device file (Linux), or a file that records what it would get.

Nothing else is opened for writing: no other device, and no file that is something else than a recording.
"""

from __future__ import annotations

import os
import stat
import struct
from pathlib import Path
from typing import BinaryIO, Protocol

from CNCStepper.atomic_file import followed
from CNCStepper.errors import LinkError, Text

WRITE_DATA, WRITE_CONTROL, DATA_DIRECTION = 0x40017086, 0x40017084, 0x40047090  # of Linux's ppdev.h
READ_STATUS = 0x80017081
CLAIM, RELEASE = 0x0000708B, 0x0000708C
OUTPUT = struct.pack("i", 0)  # the direction of the data pins
STATUS_BITS = {15: 3, 13: 4, 12: 5, 10: 6, 11: 7}  # of the pins
INVERTED_STATUS = (11,)
PARALLEL_PORTS = 99  # the major number of Linux's /dev/parport*


def high_pins(register: int) -> frozenset[int]:
    """Return the pins that are high for the value of the status register."""
    return frozenset(pin for pin, bit in STATUS_BITS.items() if bool(register >> bit & 1) != (pin in INVERTED_STATUS))


class Port(Protocol):
    """Two registers that are written together."""

    def write(self, data: int, control: int) -> None:
        """Set both registers."""

    def close(self) -> None:
        """Let go of the port."""


class ParallelPort:
    """A parallel port by its device file, such as /dev/parport0; raises LinkError where it cannot be had."""

    def __init__(self, path: Path):
        from fcntl import ioctl

        self._ioctl = ioctl
        try:
            self._file = os.open(path, os.O_RDWR)
        except OSError as error:
            raise no_port(path, error) from error
        try:
            ioctl(self._file, CLAIM)
            ioctl(self._file, DATA_DIRECTION, OUTPUT)
        except OSError as error:
            os.close(self._file)
            raise no_port(path, error) from error

    def write(self, data: int, control: int) -> None:
        """Set both registers, also where they do not change: a trial takes as long as pulses do."""
        self._ioctl(self._file, WRITE_DATA, bytes((data,)))
        self._ioctl(self._file, WRITE_CONTROL, bytes((control,)))

    def close(self) -> None:
        """Give the port back."""
        self._ioctl(self._file, RELEASE)
        os.close(self._file)


def is_parallel_port(path: Path) -> bool:
    """Return whether a path is the device file of a parallel port; nothing is opened."""
    if not path.is_char_device():
        return False
    return os.major(path.stat().st_rdev) == PARALLEL_PORTS


def recording_file(path: Path, begin: bytes) -> BinaryIO:
    """Open a file to record in, empty; raises LinkError where it holds something else, which is left as it is.

    begin: what each recording of the kind begins with.
    """
    try:
        target = followed(path)
        target.touch()
        file = target.open("r+b", buffering=1 << 20)
    except OSError as error:
        raise LinkError("pulse-port", Text("{path} cannot be written: {error}", path=path, error=error)) from error
    if not stat.S_ISREG(os.fstat(file.fileno()).st_mode) or file.read(len(begin)) not in (b"", begin):
        file.close()
        advice = "name a new file, or one that pulses were recorded in"
        raise LinkError(
            "pulse-port", Text("{path} is no recording of pulses, and is not written over", path=path), advice=advice
        )
    file.seek(0)
    file.truncate()
    return file


def no_port(path: Path, error: OSError) -> LinkError:
    """Return the refusal of a parallel port that the system does not let us have."""
    advice = "load the module ppdev, and let your user use the device"
    return LinkError(
        "pulse-port", Text("{path} is no parallel port that can be had: {error}", path=path, error=error), advice=advice
    )
