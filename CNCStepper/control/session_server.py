# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ear of a sender's or a desk's process: a loopback port where clients that know the token watch and command.

One JSON object a line, both ways:

    -> {"token": ..., "command": "attach" | "status" | "leave" | one of `Served.commands`, its values...}
    <- {"event": "status", "status": {...}}      {"event": "accepted", "command": ...}
       {"event": "message" | "warning" | "phase" | "job", "text": ...}
       {"event": "refused", "text": ..., "command": ..., "error": {...}}
       {"event": "outcome", "outcome": {...}}

An attached client hears everything from the session's beginning on. The thread of this server never
touches the machine's port, so that a slow or dead client cannot delay the cut.
"""

from __future__ import annotations

import hmac
import json
import os
import secrets
import selectors
import socket
import threading
import time
from collections import deque
from collections.abc import Callable
from dataclasses import replace
from math import inf
from queue import SimpleQueue
from typing import Any, Protocol

from CNCStepper.control.command import Command, read_command
from CNCStepper.control.outcome import Outcome, SenderStatus, error_to_json
from CNCStepper.errors import CNCStepperError

STATUS_EVERY_S = 0.1
LINE_LIMIT_BYTES = 4096
BACKLOG_LIMIT_BYTES = 1_000_000  # of a client that does not read
STATUS_BACKLOG_BYTES = 20_000  # a client that is behind with reading gets no further status until it has read
PEER_LIMIT = 32
SILENCE_LIMIT_S = 5.0  # of a peer that has not shown the token
FAREWELL_LIMIT_S = 1.0
HISTORY = 500


class Served(Protocol):
    """What a server serves: commands that it knows, and a status; both from any thread, at once."""

    commands: tuple[str, ...]

    def ask(self, command: Command) -> None:
        """Take a command."""

    def stop(self) -> None:
        """End all work safely."""

    def status(self) -> SenderStatus:
        """Return this moment."""


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
    """Serves on 127.0.0.1; `address` is for the session file.

    each_turn: called by the server's thread about ten times a second.
    """

    def __init__(self, each_turn: Callable[[], None] = lambda: None) -> None:
        self._token = secrets.token_urlsafe(32)
        self._listener = socket.create_server(("127.0.0.1", 0))
        self._each_turn = each_turn
        self._served: Served | None = None
        self._news: SimpleQueue[dict[str, Any]] = SimpleQueue()
        self._history: deque[dict[str, Any]] = deque(maxlen=HISTORY)
        self._peers: dict[socket.socket, Peer] = {}
        self._alone_since_s = time.monotonic()  # of no use while a client is attached
        self._left = False  # by the client that was attached last, for good
        self._selector = selectors.DefaultSelector()
        self._ended = threading.Event()
        self._last_status: Any = None
        self._thread = threading.Thread(target=self._serve, name="session", daemon=True)

    def address(self, machine_port: str, file: str = "") -> dict[str, object]:
        """Return what the session file says: how to reach this process, and what it serves."""
        return {
            "host": "127.0.0.1",
            "port": self._listener.getsockname()[1],
            "token": self._token,
            "process": os.getpid(),
            "machine_port": machine_port,
            "file": file,
            "begin": time.strftime("%Y-%m-%d %H:%M:%S"),
        }

    def start(self, served: Served) -> None:
        """Begin to listen for `served`."""
        self._served = served
        self._listener.setblocking(False)
        self._selector.register(self._listener, selectors.EVENT_READ)
        self._thread.start()

    def tell(self, kind: str, text: str) -> None:
        """Pass on what the served one tells; never blocks."""
        self._news.put({"event": kind, "text": text})

    def refuse(self, command: Command, error: CNCStepperError) -> None:
        """Pass on why a command was not obeyed; never blocks."""
        self._news.put({"event": "refused", "text": str(error), "command": command.name, "error": error_to_json(error)})

    def tell_outcome(self, outcome: Outcome) -> None:
        """Pass on how a job ended; never blocks."""
        self._news.put({"event": "outcome", "outcome": outcome.to_json()})

    def alone_s(self) -> float:
        """Return how long no client has been attached; infinite when the last one has left for good."""
        if any(peer.attached for peer in list(self._peers.values())):
            return 0.0
        return inf if self._left else time.monotonic() - self._alone_since_s

    def finish(self) -> None:
        """Tell all attached clients what is still to be told, then close."""
        self._ended.set()
        self._thread.join(2 * FAREWELL_LIMIT_S + STATUS_EVERY_S)

    def _serve(self) -> None:
        assert self._served
        try:
            while not self._ended.is_set():
                self._turn()
        except BaseException:  # a machine that nobody can hold any more must not go on
            self._served.stop()
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
        self._each_turn()

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
            token = str(request["token"])
        except (ValueError, KeyError, TypeError, RecursionError):
            request, token = {}, ""
        if not hmac.compare_digest(token.encode("utf-8", "replace"), self._token.encode("utf-8")):
            self._post(peer, {"event": "refused", "text": "a request without the session's token"})
            self._write(peer)
            self._drop(peer)
            return
        peer.known = True
        self._answer(peer, request)

    def _answer(self, peer: Peer, request: dict[str, Any]) -> None:
        assert self._served
        command = request.get("command")
        if command == "leave":
            self._drop(peer)
            self._left = True
        elif command == "attach":
            peer.attached, self._left = True, False
            for event in self._history:
                self._post(peer, event)
        if command in ("attach", "status"):
            self._post(peer, {"event": "status", "status": self._served.status().to_json()})
        elif command != "leave":
            self._post(peer, self._asked(request))

    def _asked(self, request: dict[str, Any]) -> dict[str, Any]:
        assert self._served
        try:
            command = read_command(request, self._served.commands)
        except (ValueError, KeyError) as error:
            return {"event": "refused", "text": str(error)}
        self._served.ask(command)
        return {"event": "accepted", "command": command.name}

    def _spread_news(self) -> None:
        while not self._news.empty():
            event = self._news.get()
            self._history.append(event)
            self._spread(event)

    def _spread_status(self) -> None:
        """Post the status to all attached clients when more than the clock has changed, else once a second."""
        assert self._served
        status = self._served.status()
        mark = (replace(status, elapsed_s=0.0), int(status.elapsed_s))
        if mark != self._last_status:
            self._last_status = mark
            self._spread({"event": "status", "status": status.to_json()}, STATUS_BACKLOG_BYTES)

    def _spread(self, event: dict[str, Any], backlog_bytes: float = inf) -> None:
        for peer in list(self._peers.values()):
            if peer.attached and len(peer.outbox) < backlog_bytes:
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
            if peer.attached:
                self._alone_since_s = time.monotonic()
