# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ear of a sender's process: a loopback port where clients that know the token watch and command.

One JSON object a line, both ways:

    -> {"token": ..., "command": "attach" | "status" | "hold" | "resume" | "stop"}
    <- {"event": "status", "status": {...}}      {"event": "accepted", "command": ...}
       {"event": "message" | "warning" | "phase", "text": ...}
       {"event": "refused", "text": ...}         {"event": "outcome", "outcome": {...}}

An attached client hears everything from the session's beginning on. The thread of this server never
touches the machine's port, so that a slow or dead client cannot delay the cut.
"""

from __future__ import annotations

import hmac
import json
import secrets
import selectors
import socket
import threading
import time
from collections import deque
from dataclasses import replace
from queue import SimpleQueue
from typing import Any

from CNCStepper.control.outcome import Outcome
from CNCStepper.control.sender import Sender

STATUS_EVERY_S = 0.1
LINE_LIMIT_BYTES = 4096
BACKLOG_LIMIT_BYTES = 1_000_000  # of a client that does not read
PEER_LIMIT = 32
SILENCE_LIMIT_S = 5.0  # of a peer that has not shown the token
FAREWELL_LIMIT_S = 1.0
HISTORY = 500


class Peer:
    """One connection; `known` after it has shown the token, `attached` when it wants all events."""

    def __init__(self, connection: socket.socket):
        self.connection = connection
        self.since_s = time.monotonic()
        self.known = False
        self.attached = False
        self.inbox = b""
        self.outbox = b""


class SessionServer:
    """Serves one sender on 127.0.0.1; `port` and `token` are for the session file."""

    def __init__(self) -> None:
        self.token = secrets.token_urlsafe(32)
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.port: int = self._listener.getsockname()[1]
        self._sender: Sender | None = None
        self._news: SimpleQueue[dict[str, Any]] = SimpleQueue()
        self._history: deque[dict[str, Any]] = deque(maxlen=HISTORY)
        self._peers: dict[socket.socket, Peer] = {}
        self._selector = selectors.DefaultSelector()
        self._ended = threading.Event()
        self._last_status: Any = None
        self._thread = threading.Thread(target=self._serve, name="session", daemon=True)

    def start(self, sender: Sender) -> None:
        """Begin to listen for `sender`."""
        self._sender = sender
        self._listener.setblocking(False)
        self._selector.register(self._listener, selectors.EVENT_READ)
        self._thread.start()

    def tell(self, kind: str, text: str) -> None:
        """Pass on what the sender tells; never blocks."""
        self._news.put({"event": kind, "text": text})

    def finish(self, outcome: Outcome) -> None:
        """Tell all attached clients the outcome, then close."""
        self._news.put({"event": "outcome", "outcome": outcome.to_json()})
        self._ended.set()
        self._thread.join(2 * FAREWELL_LIMIT_S + STATUS_EVERY_S)

    def _serve(self) -> None:
        assert self._sender
        try:
            while not self._ended.is_set():
                self._turn()
        except BaseException:  # a machine that nobody can hold any more must not go on
            self._sender.stop()
            raise
        self._farewell()

    def _farewell(self) -> None:
        self._spread_news()
        end_s = time.monotonic() + FAREWELL_LIMIT_S
        while any(peer.outbox for peer in self._peers.values()) and time.monotonic() < end_s:
            self._turn()
        for peer in list(self._peers.values()):
            self._drop(peer)
        self._listener.close()
        self._selector.close()

    def _turn(self) -> None:
        for key, events in self._selector.select(STATUS_EVERY_S / 2):
            if key.fileobj is self._listener:
                self._accept()
            elif events & selectors.EVENT_READ:
                self._read(key.data)
        self._spread_news()
        self._spread_status()
        for peer in list(self._peers.values()):
            self._write(peer)
            if not peer.known and time.monotonic() - peer.since_s > SILENCE_LIMIT_S:
                self._drop(peer)

    def _accept(self) -> None:
        connection, _ = self._listener.accept()
        if len(self._peers) >= PEER_LIMIT:
            connection.close()
            return
        connection.setblocking(False)
        self._peers[connection] = peer = Peer(connection)
        self._selector.register(connection, selectors.EVENT_READ, peer)

    def _read(self, peer: Peer) -> None:
        try:
            data = peer.connection.recv(LINE_LIMIT_BYTES)
        except BlockingIOError:
            return
        except OSError:
            data = b""
        *lines, peer.inbox = (peer.inbox + data).split(b"\n")
        for line in lines:
            if peer.connection in self._peers:
                self._obey(peer, line)
        if not data or len(peer.inbox) > LINE_LIMIT_BYTES:
            self._drop(peer)

    def _obey(self, peer: Peer, line: bytes) -> None:
        try:
            request = json.loads(line)
            token, command = str(request["token"]), str(request["command"])
        except (ValueError, KeyError, TypeError, RecursionError):
            token, command = "", ""
        if not hmac.compare_digest(token.encode("utf-8", "replace"), self.token.encode("utf-8")):
            self._post(peer, {"event": "refused", "text": "a request without the session's token"})
            self._write(peer)
            self._drop(peer)
            return
        peer.known = True
        self._post(peer, self._answer(peer, command))

    def _answer(self, peer: Peer, command: str) -> dict[str, Any]:
        assert self._sender
        if command in ("hold", "resume", "stop"):
            getattr(self._sender, command)()
            return {"event": "accepted", "command": command}
        if command == "attach":
            peer.attached = True
            for event in self._history:
                self._post(peer, event)
        elif command != "status":
            return {"event": "refused", "text": f"there is no command '{command[:40]}'"}
        return {"event": "status", "status": self._sender.status().to_json()}

    def _spread_news(self) -> None:
        while not self._news.empty():
            event = self._news.get()
            self._history.append(event)
            self._spread(event)

    def _spread_status(self) -> None:
        """Post the status to all attached clients when more than the clock has changed, else once a second."""
        assert self._sender
        status = self._sender.status()
        mark = (replace(status, elapsed_s=0.0), int(status.elapsed_s))
        if mark != self._last_status:
            self._last_status = mark
            self._spread({"event": "status", "status": status.to_json()})

    def _spread(self, event: dict[str, Any]) -> None:
        for peer in list(self._peers.values()):
            if peer.attached:
                self._post(peer, event)

    def _post(self, peer: Peer, event: dict[str, Any]) -> None:
        peer.outbox += json.dumps(event).encode("ascii") + b"\n"
        if len(peer.outbox) > BACKLOG_LIMIT_BYTES:
            self._drop(peer)

    def _write(self, peer: Peer) -> None:
        if not peer.outbox:
            return
        try:
            peer.outbox = peer.outbox[peer.connection.send(peer.outbox) :]
        except BlockingIOError:
            return
        except OSError:
            self._drop(peer)

    def _drop(self, peer: Peer) -> None:
        if self._peers.pop(peer.connection, None):
            self._selector.unregister(peer.connection)
            peer.connection.close()
