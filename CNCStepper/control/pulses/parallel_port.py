# SPDX-License-Identifier: LGPL-2.1-or-later
"""A parallel port through its device file, by Linux's ppdev: data and control are written, status pins are read."""

from __future__ import annotations

import os
import struct
from pathlib import Path

from CNCStepper.errors import LinkError, Text

WRITE_DATA, WRITE_CONTROL, DATA_DIRECTION = 0x40017086, 0x40017084, 0x40047090  # of Linux's ppdev.h
READ_STATUS = 0x80017081
CLAIM, RELEASE = 0x0000708B, 0x0000708C
OUTPUT = struct.pack("i", 0)  # the direction of the data pins
STATUS_BITS = {15: 3, 13: 4, 12: 5, 10: 6, 11: 7}  # of the pins
INVERTED_STATUS = (11,)
REAL_BUSY_NS = 1_000_000
PARALLEL_PORTS = 99  # the major number of Linux's /dev/parport*


def high_pins(register: int) -> frozenset[int]:
    """Return the pins that are high for the value of the status register."""
    return frozenset(pin for pin, bit in STATUS_BITS.items() if bool(register >> bit & 1) != (pin in INVERTED_STATUS))


class ParallelPort:
    """A parallel port by its device file, such as /dev/parport0; raises LinkError where it cannot be had."""

    patience_ns, is_real, sleep_ns = 0, True, REAL_BUSY_NS

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

    def status(self) -> int:
        """Return the status register."""
        register: bytes = self._ioctl(self._file, READ_STATUS, b"\0")
        return register[0]

    def queued(self) -> int:
        """Return 0: registers are set at once."""
        return 0

    def rest(self) -> None:
        """Do nothing."""

    def close(self) -> None:
        """Give the port back."""
        self._ioctl(self._file, RELEASE)
        os.close(self._file)


def is_parallel_port(path: Path) -> bool:
    """Return whether a path is the device file of a parallel port; nothing is opened."""
    if not path.is_char_device():
        return False
    return os.major(path.stat().st_rdev) == PARALLEL_PORTS


def no_port(path: Path, error: OSError) -> LinkError:
    """Return the refusal of a parallel port that the system does not let us have."""
    advice = "load the module ppdev, and give your user access to the device"
    return LinkError(
        "pulse-port", Text("{path} is no parallel port that can be had: {error}", path=path, error=error), advice=advice
    )
