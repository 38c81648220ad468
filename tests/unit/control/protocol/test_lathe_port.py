# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mini-lathe's port: 8E1 where parity can be had, 8N1 with a word of it where it cannot, and recordings."""

from __future__ import annotations

import os
import socket
from pathlib import Path
from typing import Any

import pytest
import serial

from CNCStepper.control.protocol.lathe.serial_port import BYTE_S, open_port
from CNCStepper.errors import LinkError


@pytest.fixture
def given(monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """What pyserial is given; nothing is opened."""
    asked: dict[str, Any] = {}

    def opened(name: str, **settings: Any) -> object:
        asked.update(settings, name=name)
        return object()

    monkeypatch.setattr(serial, "serial_for_url", opened)
    return asked


@pytest.mark.parametrize("name", ["/dev/ttyUSB0", "COM3"])
def test_a_serial_device_is_opened_8e1_at_9600(name: str, given: dict[str, Any]) -> None:
    assert open_port(name).note == ""
    assert (given["name"], given["baudrate"], given["bytesize"], given["stopbits"]) == (name, 9600, 8, 1)
    assert given["parity"] == serial.PARITY_EVEN == "E" and given["exclusive"] is True
    assert BYTE_S == 11 / 9600


@pytest.mark.parametrize("name", ["socket://127.0.0.1:2300", "loop://"])
def test_where_there_is_no_parity_it_is_opened_8n1_and_says_so(name: str, given: dict[str, Any]) -> None:
    assert "opened 8N1" in open_port(name).note
    assert (given["parity"], given["baudrate"]) == (serial.PARITY_NONE, 9600)


def test_a_pseudo_terminal_behind_a_link_is_opened_8n1_and_gets_the_bytes(tmp_path: Path) -> None:
    master, slave = os.openpty()
    (tmp_path / "lathe").symlink_to(os.ttyname(slave))
    port = open_port(str(tmp_path / "lathe"))
    assert "opened 8N1" in port.note
    port.write(b"I2.0?A")
    assert os.read(master, 10) == b"I2.0?A"
    port.check()
    port.close()
    os.close(slave)
    os.close(master)


def test_a_far_end_that_goes_is_a_lost_link() -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = open_port(f"socket://127.0.0.1:{server.getsockname()[1]}")
        far, _ = server.accept()
        port.write(b"A")
        assert far.recv(4) == b"A"
        far.close()
        with pytest.raises(LinkError, match="broke"):
            for _ in range(3):
                port.check()
        port.close()


def test_a_port_that_is_not_there_is_refused_with_what_to_do() -> None:
    with pytest.raises(LinkError, match="there is no port /dev/ttyNone"):
        open_port("/dev/ttyNone")


def test_a_recording_has_a_row_a_byte(tmp_path: Path) -> None:
    port = open_port(f"record:{tmp_path / 'lathe.csv'}")
    port.write(b"YG")
    port.check()
    port.close()
    head, *rows = (tmp_path / "lathe.csv").read_text().splitlines()
    assert head == "t_s,byte" and [row.split(",")[1] for row in rows] == ["59", "47"]
    assert all(0.0 <= float(row.split(",")[0]) < 5.0 for row in rows)


def test_a_recording_never_writes_over_a_file(tmp_path: Path) -> None:
    (tmp_path / "mine").write_text("kept")
    with pytest.raises(LinkError, match="cannot be recorded in"):
        open_port(f"record:{tmp_path / 'mine'}")
    assert (tmp_path / "mine").read_text() == "kept"
