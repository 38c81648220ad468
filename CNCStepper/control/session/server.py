# SPDX-License-Identifier: LGPL-2.1-or-later
"""The server of a sender or connection service: a socket for clients that show the token.

One JSON object a line, both ways:

    -> {"token": ..., "command": "attach" | "status" | "leave" | one of `Served.commands`, its values...}
       "attach" with "keep_s": how long the connection stays open after this client leaves
    <- {"event": "status", "status": {...}}      {"event": "accepted", "command": ...}
       {"event": "message" | "warning" | "phase" | "job", "text": ...}
       {"event": "refused", "text": ..., "command": ..., "error": {...}}
       {"event": "outcome", "outcome": {...}}

An attached client receives all events since the session's start that a `Backlog` keeps. The thread of
this server never touches the machine's port, so that a slow or dead client cannot delay the cut.

Where peers that have not shown the token fill all places, the oldest of them makes room for the next. One that has
shown it keeps its place, also when it does not read: it gets the latest state then, not all that was before.
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
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from math import inf
from pathlib import Path
from typing import Any, Protocol

from CNCStepper.control.processes.thread_priority import go_first
from CNCStepper.control.session.command import Command, read_command
from CNCStepper.control.session.event_queue import Backlog, EventQueue, line_of
from CNCStepper.control.session.local_socket import Listener
from CNCStepper.control.session.status import Outcome, SenderStatus, error_to_json
from CNCStepper.errors import CNCStepperError, Text

STATUS_EVERY_S = 0.1
LOOK_AT_STATUS_S = 0.02
LINE_LIMIT_BYTES = 4096
SEND_BYTES = 16_384  # at once, so that newer events can still replace those behind it
UNAUTHENTICATED_LIMIT = 64  # peers that have not shown the token
KNOWN_LIMIT = 128  # peers that have
ACCEPT_LIMIT = 64  # connections taken in one turn, so that a flood of them keeps no command waiting
NO_ROOM_PAUSE_S = 0.01  # where the system gives this process no further socket
SILENCE_LIMIT_S = 5.0  # of a peer that has not shown the token
CLOSE_LIMIT_S = 1.0
LONGEST_KEEP_S = 86_400.0  # that a client can ask for


class Served(Protocol):
    """The interface that a server serves: its commands and its status; thread-safe, without waiting."""

    commands: tuple[str, ...]

    def ask(self, command: Command) -> None:
        """Take a command."""

    def stop(self) -> None:
        """End all work safely."""

    def status(self) -> SenderStatus:
        """Return the present status."""


class Peer:
    """One connection; `known` after it has shown the token, `attached` when it wants all events.

    keep_s: for how long it wants the connection to the machine to outlive it; None: it leaves that to the others.
    """

    def __init__(self, connection: socket.socket):
        self.connection = connection
        self.since_s = time.monotonic()
        self.known = False
        self.attached = False
        self.keep_s: float | None = None
        self.inbox = b""
        self.backlog = Backlog()
        self.sending = memoryview(b"")
        self.is_behind = False  # its socket takes no more for now

    @property
    def has_more(self) -> bool:
        """Whether something is still to be sent to it."""
        return bool(self.sending or self.backlog)

    def drop_output(self) -> None:
        """Discard the bytes that are still to be sent to it."""
        self.sending, self.backlog = memoryview(b""), Backlog()


class SessionServer:
    """Listens where `Listener` says for the session of a file; `address` is for that file.

    each_turn: called by the server's thread about ten times a second.
    """

    def __init__(self, session_file: Path, each_turn: Callable[[], None] = lambda: None) -> None:
        self._token = secrets.token_urlsafe(32)
        self._listener = Listener(session_file)
        self._each_turn = each_turn
        self._served: Served | None = None
        self._news = EventQueue()
        self._history = Backlog()
        self._peers: dict[socket.socket, Peer] = {}  # the oldest first
        self._alone_since_s = time.monotonic()  # of no use while a client is attached
        self._left = False  # by the client that was attached last, for good
        self._keep_s = 0.0  # as the last client requested it
        self._kept_until_s = -inf  # nobody is missed before
        self._selector = selectors.DefaultSelector()
        self._ended = threading.Event()
        self._last_status: Any = None
        self._looked_s = -inf  # at the status
        self._thread = threading.Thread(target=self._serve, name="session", daemon=True)

    def address(self, machine_port: str, file: str = "") -> dict[str, object]:
        """Return the content of the session file: this process's address and its service."""
        return {
            **self._listener.address,
            "token": self._token,
            "process": os.getpid(),
            "machine_port": machine_port,
            "file": file,
            "begin": time.strftime("%Y-%m-%d %H:%M:%S"),
        }

    def start(self, served: Served) -> None:
        """Begin to listen for `served`."""
        self._served = served
        self._listener.socket.setblocking(False)
        self._selector.register(self._listener.socket, selectors.EVENT_READ)
        self._thread.start()

    def tell(self, kind: str, text: str) -> None:
        """Send an event of the served process to all clients, from any thread; never blocks."""
        self._news.put({"event": kind, "text": text})

    def refuse(self, command: Command, error: CNCStepperError) -> None:
        """Pass on why a command was not obeyed; never blocks."""
        why = {"text": error.text, "error": error_to_json(error)}
        self._news.put({"event": "refused", "command": command.name, **why})

    def notify_outcome(self, outcome: Outcome) -> None:
        """Pass on a job's outcome; never blocks. The time for which the connection is kept starts again."""
        if self._keep_s:
            self._keep_for(self._keep_s)
        self._news.put({"event": "outcome", "outcome": outcome.to_json()})

    def alone_s(self) -> float:
        """Return how long no client has been attached; infinite when the last one has left for good.

        While a client that has left keeps the connection open, it is 0.
        """
        if self._is_attended() or time.monotonic() < self._kept_until_s:
            return 0.0
        return inf if self._left else time.monotonic() - self._alone_since_s

    def _keep_for(self, keep_s: float) -> None:
        self._kept_until_s = max(self._kept_until_s, time.monotonic() + keep_s)

    def _is_attended(self) -> bool:
        return any(peer.attached for peer in list(self._peers.values()))

    def finish(self) -> None:
        """Send pending events to all attached clients, then close."""
        self._ended.set()
        self._thread.join(2 * CLOSE_LIMIT_S + STATUS_EVERY_S)

    def _serve(self) -> None:
        assert self._served
        go_first()
        try:
            while not self._ended.is_set():
                self._turn()
        except BaseException:  # a machine that no client can hold must not keep moving
            self._served.stop()
            raise
        self._close_peers()

    def _close_peers(self) -> None:
        self._spread_news()
        end_s = time.monotonic() + CLOSE_LIMIT_S
        while any(peer.has_more for peer in self._peers.values()) and time.monotonic() < end_s:
            self._turn()
        for peer in list(self._peers.values()):
            self._drop(peer)
        self._listener.close()
        self._selector.close()

    def _turn(self) -> None:
        for key, events in self._selector.select(STATUS_EVERY_S / 2):
            if key.fileobj is self._listener.socket:
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

    # --- who is let in -------------------------------------------------------------------------

    def _accept(self) -> None:
        """Take the connections that wait, and at once what each has to say."""
        for _ in range(ACCEPT_LIMIT):
            try:
                connection = self._listener.accept()
            except BlockingIOError:
                return
            except ConnectionError:  # another user's, or closed again
                continue
            except OSError:  # this process has all the sockets that it may have
                self._drop_oldest_unauthenticated()
                time.sleep(NO_ROOM_PAUSE_S)
                return
            self._admit(connection)

    def _admit(self, connection: socket.socket) -> None:
        if self._strangers() >= UNAUTHENTICATED_LIMIT:
            self._drop_oldest_unauthenticated()
        self._peers[connection] = peer = Peer(connection)
        self._selector.register(connection, selectors.EVENT_READ, peer)
        self._read(peer)

    def _strangers(self) -> int:
        return sum(not peer.known for peer in self._peers.values())

    def _drop_oldest_unauthenticated(self) -> None:
        """Drop the oldest peer that has not shown the token, after a last look whether it just did."""
        for peer in list(self._peers.values()):
            if not peer.known:
                self._read(peer)
            if not peer.known:
                self._drop(peer)
                return

    def _is_known(self, peer: Peer, token: str) -> bool:
        """Return whether a peer has shown the token; another one gets a refusal and is dropped."""
        why = ""
        if not hmac.compare_digest(token.encode("utf-8", "replace"), self._token.encode("utf-8")):
            why = "a request without the session's token"
        elif not peer.known and len(self._peers) - self._strangers() >= KNOWN_LIMIT:
            why = Text("one more client beside {known_limit}", known_limit=KNOWN_LIMIT)
        peer.known = not why
        if why:
            with suppress(OSError):  # it does not even read that
                peer.connection.send(line_of({"event": "refused", "text": why}))
            self._drop(peer)
        return peer.known

    # --- what they ask -------------------------------------------------------------------------

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
                self._execute_command(peer, line)
        if not data or len(peer.inbox) > LINE_LIMIT_BYTES:
            self._drop(peer)

    def _execute_command(self, peer: Peer, line: bytes) -> None:
        try:
            request = json.loads(line)
            token = str(request["token"])
        except (ValueError, KeyError, TypeError, RecursionError):
            request, token = {}, ""
        if self._is_known(peer, token):
            self._answer(peer, request)

    def _answer(self, peer: Peer, request: dict[str, Any]) -> None:
        assert self._served
        command = request.get("command")
        if command == "leave":
            self._leave(peer)
        elif command == "attach":
            peer.attached, self._left = True, False
            peer.keep_s = _keep_s(request)
            self._keep_s = self._keep_s if peer.keep_s is None else peer.keep_s
            peer.backlog.add_all(self._history)
            peer.backlog.add("attached", self._status_line())  # of another kind: no later status takes its place
        elif command == "status":
            peer.backlog.add("status", self._status_line())
        else:
            answer = self._asked(request)
            peer.backlog.add(answer["event"], line_of(answer))

    def _leave(self, peer: Peer) -> None:
        """Let a client go for good; one that keeps nothing, as a window that disconnects, ends what others kept."""
        self._drop(peer)
        self._left = not self._is_attended()
        if self._left and peer.keep_s is None:
            self._keep_s, self._kept_until_s = 0.0, -inf

    def _asked(self, request: dict[str, Any]) -> dict[str, Any]:
        assert self._served
        try:
            command = read_command(request, self._served.commands)
        except (ValueError, KeyError) as error:
            return {"event": "refused", "text": error.args[0] if isinstance(error.args[0], Text) else str(error)}
        self._served.ask(command)
        return {"event": "accepted", "command": command.name}

    # --- what they hear ------------------------------------------------------------------------

    def _spread_news(self) -> None:
        news = self._news.take()
        self._history.add_all(news)
        self._history.left_out = 0  # later clients cannot have read them
        for peer in self._peers.values():
            if peer.attached:
                peer.backlog.add_all(news)
                peer.backlog.left_out += news.left_out

    def _spread_status(self) -> None:
        """Post the status to all attached clients when more than the clock has changed, else once a second."""
        assert self._served
        now_s = time.monotonic()
        if now_s - self._looked_s < LOOK_AT_STATUS_S:
            return
        self._looked_s = now_s
        status = self._served.status()
        mark = (replace(status, elapsed_s=0.0), int(status.elapsed_s))
        if mark != self._last_status:
            self._last_status = mark
            line = self._status_line(status)
            for peer in self._peers.values():
                if peer.attached:
                    peer.backlog.add("status", line)

    def _status_line(self, status: SenderStatus | None = None) -> bytes:
        assert self._served
        return line_of({"event": "status", "status": (status or self._served.status()).to_json()})

    def _write(self, peer: Peer) -> None:
        """Send what the peer's socket takes, and wait for more room in it where something is left."""
        try:
            while peer.has_more:
                peer.sending = peer.sending or memoryview(peer.backlog.take(SEND_BYTES))
                peer.sending = peer.sending[peer.connection.send(peer.sending) :]
        except BlockingIOError:
            pass
        except OSError:  # it has closed: what it asked before that is still to be read, and `_read` finds the end
            peer.drop_output()
        if peer.is_behind != peer.has_more:
            peer.is_behind = peer.has_more
            events = selectors.EVENT_READ | (selectors.EVENT_WRITE if peer.is_behind else 0)
            self._selector.modify(peer.connection, events, peer)

    def _drop(self, peer: Peer) -> None:
        if peer.connection not in self._peers:
            return
        if peer.attached:  # before it is gone: `alone_s` is asked by another thread
            self._alone_since_s = time.monotonic()
            self._left = False  # one that crashed may come back
            if peer.keep_s:
                self._keep_for(peer.keep_s)
        del self._peers[peer.connection]
        self._selector.unregister(peer.connection)
        peer.connection.close()


def _keep_s(request: dict[str, Any]) -> float | None:
    """Return for how long a client wants the connection kept, within bounds; None where it does not say."""
    keep_s = request.get("keep_s")
    if not isinstance(keep_s, (int, float)) or isinstance(keep_s, bool) or not keep_s >= 0:
        return None
    return float(min(keep_s, LONGEST_KEEP_S))
