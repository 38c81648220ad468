# SPDX-License-Identifier: LGPL-2.1-or-later
"""A telnet connection as a port: the bytes without telnet's own commands, every option of which is declined.

IAC DO n -> IAC WONT n     IAC WILL n -> IAC DONT n     IAC SB ... IAC SE, other IAC x: left out     IAC IAC: 0xff
"""

from __future__ import annotations

from typing import Any

SE, SB, WILL, WONT, DO, DONT, IAC = 240, 250, 251, 252, 253, 254, 255
DECLINED = {DO: WONT, WILL: DONT}
TELNET_PORT = 23


class TelnetPort:
    """The port of a socket with telnet's commands taken out; what it raises is the socket port's own."""

    def __init__(self, port: Any):
        self._port = port
        self._held = b""  # the beginning of a command whose end has not come

    @property
    def _socket(self) -> Any:
        return self._port._socket

    @property
    def in_waiting(self) -> int:
        """Whether bytes wait, in pyserial's form."""
        return int(self._port.in_waiting)

    def fileno(self) -> int:
        """Return what `select` waits on."""
        return int(self._port.fileno())

    def read(self, count: int) -> bytes:
        """Return the bytes that have come, without commands; these are answered."""
        data, answers, self._held = plain_bytes(self._held + self._port.read(count))
        if answers:
            self._port.write(answers)
        return data

    def write(self, data: bytes) -> int:
        """Write bytes; 0xff is written twice, as telnet wants it."""
        self._port.write(data.replace(bytes([IAC]), bytes([IAC, IAC])))
        return len(data)

    def close(self) -> None:
        """Close the connection."""
        self._port.close()


def plain_bytes(data: bytes) -> tuple[bytes, bytes, bytes]:
    """Return the bytes of `data` that are no commands, the answers to its commands, and an unfinished end."""
    plain, answers = bytearray(), bytearray()
    while (at := data.find(IAC)) >= 0:
        plain += data[:at]
        length = _command_length(data[at:])
        if not length:
            return bytes(plain), bytes(answers), data[at:]
        command = data[at + 1]
        if command == IAC:
            plain.append(IAC)
        elif command in DECLINED:
            answers += bytes([IAC, DECLINED[command], data[at + 2]])
        data = data[at + length :]
    return bytes(plain + data), bytes(answers), b""


def _command_length(data: bytes) -> int:
    """Return the length of the command that begins `data`, 0 where its end has not come."""
    if len(data) < 2:
        return 0
    if data[1] == SB:
        return data.find(bytes([IAC, SE])) + 2 if bytes([IAC, SE]) in data else 0
    wanted = 3 if data[1] in (WILL, WONT, DO, DONT) else 2
    return wanted if len(data) >= wanted else 0


def socket_url(url: str) -> str:
    """Return the pyserial URL of a telnet one: telnet://HOST is socket://HOST:23."""
    address = url.removeprefix("telnet://").rstrip("/")
    has_port = address.rpartition(":")[2].isdecimal() and ":" in address
    return f"socket://{address}" if has_port else f"socket://{address}:{TELNET_PORT}"
