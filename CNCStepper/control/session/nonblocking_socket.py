# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines of JSON over the socket of a session, without ever waiting: for a thread that draws windows."""

from __future__ import annotations

import select
import socket
from collections.abc import Mapping
from typing import Any

from CNCStepper import text_json
from CNCStepper.control.session.local_socket import Address, close_in_order, is_own_peer

READ_BYTES = 262_144  # in one look, so that a flood does not keep the window
OUTBOX_LIMIT_BYTES = 100_000


class LineSocket:
    """A connection that is being made, made, or `closed`; nothing here waits and nothing raises when it breaks."""

    def __init__(self, address: Address):
        self.closed = False
        self._made = False
        self._outbox = bytearray()
        self._tail = bytearray()
        try:
            self._socket = address.new_socket()
        except OSError:  # none of that kind on this system
            self.closed = True
            return
        self._socket.setblocking(False)
        self._connect(address)

    def send(self, content: Mapping[str, Any]) -> None:
        """Send a line now, or as soon as the other side takes it."""
        self._outbox += text_json.dumps(content).encode("ascii") + b"\n"
        self._write()

    def receive(self) -> list[dict[str, Any]]:
        """Return the lines that have come; raises ValueError for what is no line of JSON."""
        self._write()
        if self.closed or not self._made:
            return []
        try:
            data = self._socket.recv(READ_BYTES)
        except BlockingIOError:
            return []
        except OSError:
            data = b""
        if not data:
            self.close()
        self._tail += data
        *lines, self._tail = self._tail.split(b"\n")
        return [text_json.loads(line) for line in lines]

    def close(self) -> None:
        """Close it; what was written before still arrives."""
        if self.closed:
            return
        self.closed = True
        close_in_order(self._socket)

    def _connect(self, address: Address) -> None:
        try:
            self._socket.connect(address.target)
            self._made = is_own_peer(self._socket)
            if not self._made:
                self.close()
        except BlockingIOError:
            if address.path:  # a Unix socket is connected at once, or has no room
                self.close()
        except OSError:
            self.close()

    def _write(self) -> None:
        if self.closed or not self._is_made():
            return
        try:
            while self._outbox:
                del self._outbox[: self._socket.send(self._outbox)]
        except BlockingIOError:
            if len(self._outbox) > OUTBOX_LIMIT_BYTES:  # nobody reads there any more
                self.close()
        except OSError:
            self.close()

    def _is_made(self) -> bool:
        """Return whether the connection stands; a refused one is closed."""
        if not self._made:
            _, writable, failed = select.select([], [self._socket], [self._socket], 0)
            if failed or (writable and self._socket.getsockopt(socket.SOL_SOCKET, socket.SO_ERROR)):
                self.close()
            else:
                self._made = bool(writable)
        return self._made
