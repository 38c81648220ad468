# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where pulses may go: to a parallel port or into a recording, and nothing else is ever opened or written over."""

from __future__ import annotations

import os
import socket
import time
from pathlib import Path

import pytest

from CNCStepper.control.pulses import output_ports, ports
from CNCStepper.control.pulses.output_ports import ParallelOutput, SerialOutput
from CNCStepper.control.pulses.ports import (
    CLAIM,
    DATA_DIRECTION,
    MAGIC,
    READ_STATUS,
    RECORD,
    RELEASE,
    WRITE_CONTROL,
    WRITE_DATA,
    ParallelPort,
    high_pins,
    open_port,
    read_recording,
)
from CNCStepper.errors import LinkError

POSIX = os.name != "nt"


def test_a_recording_holds_what_was_written_and_when(tmp_path: Path) -> None:
    path = tmp_path / "gravação 1"
    for data in (1, 7):  # the second time over the first recording
        port = open_port(path)
        port.write(data, 11)
        port.write(0, 3)
        port.close()
        assert [(d, c) for _, d, c in read_recording(path)] == [(data, 11), (0, 3)]
    first, second = (at for at, _, _ in read_recording(path))
    assert first <= second and path.read_bytes().startswith(MAGIC)


def test_a_recording_that_was_cut_off_is_read_as_far_as_it_goes(tmp_path: Path) -> None:
    path = tmp_path / "pulses"
    path.write_bytes(MAGIC + RECORD.pack(5, 1, 2) + b"\0\0\0")
    assert read_recording(path) == [(5, 1, 2)]


@pytest.mark.parametrize("content", [b"G21 G90\nG1 X1 F100\n", b"G", b"\0" * 50])
def test_a_file_that_is_no_recording_is_left_as_it_is(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "job.nc"
    path.write_bytes(content)
    with pytest.raises(LinkError, match=r"job\.nc is no recording of pulses, and is not written over"):
        open_port(path)
    assert path.read_bytes() == content


def test_a_folder_that_is_not_there_is_said(tmp_path: Path) -> None:
    with pytest.raises(LinkError, match="cannot be written") as caught:
        open_port(tmp_path / "none" / "pulses")
    assert caught.value.code == "pulse-port"


if POSIX:

    @pytest.mark.parametrize("path", ["/dev/no-such-port", "/dev/zero", os.devnull, "/dev"])
    def test_what_is_no_parallel_port_is_said(path: str) -> None:
        with pytest.raises(LinkError, match="pulse-port"):
            open_port(Path(path))

    def test_a_serial_line_is_not_even_opened(monkeypatch: pytest.MonkeyPatch) -> None:
        """To open one resets many a controller."""
        ours, theirs = os.openpty()
        try:
            monkeypatch.setattr(ports.os, "open", lambda *_: pytest.fail("it was opened"))
            with pytest.raises(LinkError, match="no parallel port"):
                open_port(Path(os.ttyname(theirs)))
        finally:
            os.close(ours)
            os.close(theirs)

    def test_sockets_pipes_and_links_to_devices_are_refused(tmp_path: Path) -> None:
        os.mkfifo(tmp_path / "pipe")
        (tmp_path / "link").symlink_to("/dev/zero")
        with socket.socket(socket.AF_UNIX) as one:
            one.bind(str(tmp_path / "socket"))
            for name in ("pipe", "link", "socket"):
                with pytest.raises(LinkError, match="no parallel port"):
                    open_port(tmp_path / name)

    class Device:
        """ioctl of a parallel port, on a file; notes what it is asked, and refuses `deaf_to`."""

        def __init__(self, monkeypatch: pytest.MonkeyPatch, deaf_to: int = 0):
            self.asked, self.files, self._deaf_to = [], [], deaf_to
            monkeypatch.setattr("fcntl.ioctl", self)

        def __call__(self, file: int, request: int, value: bytes = b"") -> None:
            self.files.append(file)
            if request == self._deaf_to:
                raise OSError("it is deaf")
            self.asked.append((request, value))

    def test_a_parallel_port_is_claimed_turned_to_output_and_given_back(
        monkeypatch: pytest.MonkeyPatch, tmp_path: Path
    ) -> None:
        device = Device(monkeypatch)
        (tmp_path / "port").touch()
        port = ParallelPort(tmp_path / "port")
        for _ in range(2):  # what does not change is written too, so that a trial does what pulses do
            port.write(5, 11)
        port.close()
        written = [(WRITE_DATA, b"\5"), (WRITE_CONTROL, b"\x0b")] * 2
        assert device.asked == [(CLAIM, b""), (DATA_DIRECTION, b"\0" * 4), *written, (RELEASE, b"")]

    @pytest.mark.parametrize("deaf_to", [CLAIM, DATA_DIRECTION])
    def test_a_port_that_cannot_be_claimed_is_closed(
        monkeypatch: pytest.MonkeyPatch, tmp_path: Path, deaf_to: int
    ) -> None:
        device = Device(monkeypatch, deaf_to)
        (tmp_path / "port").touch()
        with pytest.raises(LinkError, match="ppdev"):
            ParallelPort(tmp_path / "port")
        with pytest.raises(OSError, match="descriptor"):
            os.fstat(device.files[0])

    def test_the_status_register_of_a_parallel_port_is_read(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
        answers = {READ_STATUS: b"\x58"}
        monkeypatch.setattr("fcntl.ioctl", lambda file, request, value=b"": answers.get(request, b""))
        (tmp_path / "port").touch()
        port = ParallelOutput(tmp_path / "port")
        assert high_pins(port.status()) == {10, 11, 13, 15}  # the port turns 11 round
        assert port.is_real and port.patience_ns == 0
        port.close()

    def test_a_board_that_takes_nothing_for_a_second_is_lost(monkeypatch: pytest.MonkeyPatch) -> None:
        """Its time-outs are those of its source; what the system holds is counted, so that a hold need not wait."""
        monkeypatch.setattr(output_ports, "WRITE_LIMIT_S", 0.05)
        ours, theirs = os.openpty()
        port = SerialOutput(os.ttyname(theirs), is_board=True)
        assert (port._port.timeout, port._port.write_timeout) == (3.0, 0.05)
        port.write(b"\x0a\x10", 2)
        assert os.read(ours, 10) == b"\x0a\x10"
        os.write(ours, b"\x18\x20")
        end_s = time.monotonic() + 5.0
        while (status := port.status()) < 0 and time.monotonic() < end_s:
            time.sleep(0.001)  # a pseudo-terminal hands bytes on a little later
        assert status == 0x20
        with pytest.raises(LinkError, match="it takes nothing for") as caught:
            for _ in range(10_000):
                port.write(bytes(1000), 1000)
        assert caught.value.code == "port-lost"
        os.close(ours)
        with pytest.raises(LinkError, match="is lost"):
            port.status()
        port.close()
        os.close(theirs)
