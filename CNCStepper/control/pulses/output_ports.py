# SPDX-License-Identifier: LGPL-2.1-or-later
"""The output ports of a pulse player: names, accepted data, and the latest permitted write.

    /dev/parport0        the registers, through Linux's ppdev; status pins are read
    record:FILE          CSV of every write: t_s,data,control, of a board t_s,byte
    socket://host:port   data and control, a byte each, or a board's bytes; the status register comes back
    a serial device      the same: a board by its serial driver, or a virtual machine at a pseudo-terminal

What is written is either a data and a control register, or the bytes of a board with their number. A port does not
wait for its device: where it takes nothing for WRITE_LIMIT_S it is lost.
"""

from __future__ import annotations

import os
import select
import socket
import stat
import time
from contextlib import suppress
from pathlib import Path
from typing import Any, BinaryIO, Protocol
from urllib.parse import urlsplit

from CNCStepper.atomic_file import followed
from CNCStepper.control.pulses.pacing import NEVER_NS, NS_PER_S
from CNCStepper.control.pulses.parallel_port import ParallelPort, is_parallel_port
from CNCStepper.control.pulses.pulse_ring import NO_INPUTS
from CNCStepper.errors import LinkError, Text

RECORD, SOCKET = "record:", "socket://"
READ_LIMIT_S, WRITE_LIMIT_S = 3.0, 1.0  # of the board's source
BOARD_BAUD = 1_000_000  # the FIFO has none; the driver wants a number
NETWORK_PATIENCE_NS = 250_000_000
BOARD_PATIENCE_NS = 20_000_000
BUSY_NS = 150_000
FLUSH_S = 0.1
SEND_BUFFER_BYTES = 4096
HEADS = (b"t_s,data,control\n", b"t_s,byte\n")


class OutputPort(Protocol):
    """A port.

    patience_ns: by how much a write may be late there at least; is_real: motors follow it, so that its process goes
    before others and what comes late is no pulse any more. sleep_ns: until so long before a write its process sleeps.
    """

    patience_ns: int
    is_real: bool
    sleep_ns: int

    def write(self, first: Any, second: int) -> None:
        """Write the data and the control register, or a board's bytes and their number; raises LinkError."""

    def status(self) -> int:
        """Return the status register, NO_INPUTS where none is known; raises LinkError."""

    def queued(self) -> int:
        """Return how many bytes the system has taken and not sent."""

    def rest(self) -> None:
        """Do deferred work while no pulses are due."""

    def close(self) -> None:
        """Give the port back."""


def open_output(name: str, is_board: bool, begin_ns: int, again: bool = False) -> OutputPort:
    """Open a port by its name; raises LinkError where it cannot be had.

    begin_ns: of the recorded times, by `time.perf_counter_ns`. again: a recording is continued.
    """
    if name.startswith(RECORD):
        return RecordedOutput(Path(name.removeprefix(RECORD)), is_board, begin_ns, again)
    if name.startswith(SOCKET):
        return SocketOutput(name, is_board)
    if "://" in name:
        advice = "give /dev/parport0, socket://host:port, a serial device, or record:FILE"
        raise LinkError("pulse-port", Text("{name} is no port for pulses", name=name), advice=advice)
    if is_parallel_port(Path(name)):
        if is_board:
            what = Text("{name} is a parallel port, and the machine is a board", name=name)
            advice = "name a serial device, socket://host:port or record:FILE, or choose another machine"
            raise LinkError("pulse-port", what, advice=advice)
        return ParallelPort(Path(name))
    return SerialOutput(name, is_board)


class RecordedOutput:
    """A CSV file with a row for each write, of a board for each byte; raises LinkError for a file that is another."""

    patience_ns, is_real, sleep_ns = NEVER_NS, False, BUSY_NS

    def __init__(self, path: Path, is_board: bool, begin_ns: int, again: bool):
        head = HEADS[is_board]
        self._file = path.open("ab") if again else recording_file(path, head)
        if not again:
            self._file.write(head)
            self._file.flush()
        self._begin_ns, self._flushed_s = begin_ns, time.monotonic()
        self._text = self._of_bytes if is_board else self._of_registers

    def write(self, first: Any, second: int) -> None:
        """Note a write."""
        self._file.write(self._text((time.perf_counter_ns() - self._begin_ns) / NS_PER_S, first, second))

    @staticmethod
    def _of_registers(at_s: float, data: int, control: int) -> bytes:
        return b"%.9f,%d,%d\n" % (at_s, data, control)

    @staticmethod
    def _of_bytes(at_s: float, data: bytes, _: int) -> bytes:
        return b"".join(b"%.9f,%d\n" % (at_s, byte) for byte in data)

    def status(self) -> int:
        """Return that there is none."""
        return NO_INPUTS

    def queued(self) -> int:
        """Return 0: a file takes all."""
        return 0

    def rest(self) -> None:
        """Put what was written into the file, now and then."""
        if time.monotonic() - self._flushed_s > FLUSH_S:
            self._file.flush()
            self._flushed_s = time.monotonic()

    def close(self) -> None:
        """Close the file."""
        self._file.close()


def recording_file(path: Path, begin: bytes) -> BinaryIO:
    """Open a file to record in, empty; raises LinkError where it holds something else, which is left as it is.

    begin: what each recording of the kind begins with.
    """
    try:
        target = followed(path)
        target.touch()
        file = target.open("r+b", buffering=1 << 20)
    except OSError as error:
        what = Text("{path} cannot be written: {error}", path=path, error=error)
        advice = "choose a folder that exists and that you may write to"
        raise LinkError("pulse-port", what, advice=advice) from error
    if not stat.S_ISREG(os.fstat(file.fileno()).st_mode) or file.read(len(begin)) not in (b"", begin):
        file.close()
        advice = "name a new file, or one that pulses were recorded in"
        raise LinkError(
            "pulse-port", Text("{path} is no recording of pulses, and is not written over", path=path), advice=advice
        )
    file.seek(0)
    file.truncate()
    return file


class _StreamOutput:
    """Bytes to a socket or a serial device that takes them without waiting."""

    sleep_ns = BUSY_NS

    def __init__(self, name: str, is_board: bool):
        self._name, self._status = name, NO_INPUTS
        self.write = self._write_bytes if is_board else self._write_registers

    def _write_registers(self, data: int, control: int) -> None:
        self._send(bytes((data, control)))

    def _write_bytes(self, data: bytes, _: int) -> None:
        self._send(data)

    def _send(self, data: bytes) -> None:
        try:
            while data:
                try:
                    data = data[self._put(data) :]
                except (BlockingIOError, InterruptedError):
                    if not select.select([], [self._descriptor()], [], WRITE_LIMIT_S)[1]:
                        raise TimeoutError(
                            Text("it has accepted nothing for {limit:g} s", limit=WRITE_LIMIT_S)
                        ) from None
        except OSError as error:
            raise self._lost(error) from error

    def status(self) -> int:
        """Return the last byte that came, NO_INPUTS before the first."""
        try:
            if data := self._get():
                self._status = data[-1]
        except (BlockingIOError, InterruptedError):
            pass
        except OSError as error:
            raise self._lost(error) from error
        return self._status

    def rest(self) -> None:
        """Do nothing."""

    def _lost(self, error: OSError) -> LinkError:
        return LinkError(
            "port-lost",
            Text("the port {name} is lost: {error}", name=self._name, error=error),
            advice="check cable and power, then move the tool to the work zero and set it there before its next move",
        )

    def _put(self, data: bytes) -> int:
        raise NotImplementedError

    def _get(self) -> bytes:
        raise NotImplementedError

    def _descriptor(self) -> int:
        raise NotImplementedError


class SocketOutput(_StreamOutput):
    """A virtual machine at `socket://host:port`."""

    patience_ns, is_real = NETWORK_PATIENCE_NS, False

    def __init__(self, name: str, is_board: bool):
        super().__init__(name, is_board)
        try:
            address = urlsplit(name)
            self._socket = socket.create_connection((address.hostname or "", address.port or 0), READ_LIMIT_S)
        except (OSError, ValueError) as error:
            what = Text("nothing answers at {name}: {error}", name=name, error=error)
            raise LinkError("pulse-port", what, advice="start it, or write socket://host:port") from error
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, SEND_BUFFER_BYTES)
        self._socket.setblocking(False)

    def queued(self) -> int:
        """Return 0: the system is given a small buffer."""
        return 0

    def close(self) -> None:
        """Close it after the bytes that are written."""
        with suppress(OSError):
            self._socket.shutdown(socket.SHUT_WR)
        self._socket.close()

    def _put(self, data: bytes) -> int:
        return self._socket.send(data)

    def _get(self) -> bytes:
        data = self._socket.recv(SEND_BUFFER_BYTES)
        if not data:
            raise ConnectionError("the other end has closed it")
        return data

    def _descriptor(self) -> int:
        return self._socket.fileno()


class SerialOutput(_StreamOutput):
    """A serial device: a board by its serial driver, or a virtual machine at a pseudo-terminal."""

    def __init__(self, name: str, is_board: bool):
        super().__init__(name, is_board)
        import serial

        try:
            self._port = serial.Serial(
                name, BOARD_BAUD, timeout=READ_LIMIT_S, write_timeout=WRITE_LIMIT_S, exclusive=True
            )
        except (OSError, ValueError) as error:
            advice = "name a parallel port, a serial device, socket://host:port, or record:FILE"
            raise LinkError(
                "pulse-port", Text("{name} cannot be had: {error}", name=name, error=error), advice=advice
            ) from error
        self.is_real = not os.path.realpath(name).startswith("/dev/pts/")
        self.patience_ns = BOARD_PATIENCE_NS if self.is_real else NETWORK_PATIENCE_NS

    def queued(self) -> int:
        """Return how many bytes wait in the system."""
        try:
            return int(self._port.out_waiting)
        except OSError as error:
            raise self._lost(error) from error

    def close(self) -> None:
        """Close it after the bytes that are written, unless the device takes nothing."""
        end_s = time.monotonic() + WRITE_LIMIT_S
        with suppress(OSError):
            while self._port.out_waiting and time.monotonic() < end_s:
                time.sleep(0.001)
            if self._port.out_waiting:
                self._port.reset_output_buffer()
        self._port.close()

    def _put(self, data: bytes) -> int:
        if os.name == "posix":
            return os.write(self._port.fileno(), data)
        return int(self._port.write(data) or 0)

    def _get(self) -> bytes:
        waiting = self._port.in_waiting
        return bytes(self._port.read(waiting)) if waiting else b""

    def _descriptor(self) -> int:
        return int(self._port.fileno())
