# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where pulses may go: to a parallel port or into a recording, and nothing else is ever opened or written over."""

from __future__ import annotations

import os
import time
from pathlib import Path

import pytest

from CNCStepper.control.pulses import output_ports
from CNCStepper.control.pulses.output_ports import SerialOutput, open_output
from CNCStepper.control.pulses.parallel_port import (
    CLAIM,
    DATA_DIRECTION,
    READ_STATUS,
    RELEASE,
    WRITE_CONTROL,
    WRITE_DATA,
    ParallelPort,
    high_pins,
)
from CNCStepper.errors import LinkError

POSIX = os.name != "nt"


@pytest.mark.parametrize("content", [b"G21 G90\nG1 X1 F100\n", b"G", b"\0" * 50])
def test_a_file_that_is_no_recording_is_left_as_it_is(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "job.nc"
    path.write_bytes(content)
    with pytest.raises(LinkError, match=r"job\.nc is no recording of pulses, and is not written over"):
        open_output(f"record:{path}", False, 0)
    assert path.read_bytes() == content


def test_a_folder_that_is_not_there_is_said(tmp_path: Path) -> None:
    with pytest.raises(LinkError, match="cannot be written") as caught:
        open_output(f"record:{tmp_path / 'none' / 'pulses'}", False, 0)
    assert caught.value.code == "pulse-port"


if POSIX:

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
        port = ParallelPort(tmp_path / "port")
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
        with pytest.raises(LinkError, match="it has accepted nothing for") as caught:
            for _ in range(10_000):
                port.write(bytes(1000), 1000)
        assert caught.value.code == "port-lost"
        os.close(ours)
        with pytest.raises(LinkError, match="is lost"):
            port.status()
        port.close()
        os.close(theirs)
