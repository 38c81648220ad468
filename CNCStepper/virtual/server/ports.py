# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ends that a client connects to: a TCP port, or a pseudo-terminal behind a link in the file system."""

from __future__ import annotations

import contextlib
import os
import select
import socket
import time
from pathlib import Path
from typing import Protocol

from CNCStepper.errors import LinkError, Text

PTY_POLL_S = 0.02  # a terminal that nobody has open cannot be waited for


class Port(Protocol):
    """One client at a time; it connects to `address`."""

    address: str

    @property
    def connected(self) -> bool:
        """Whether a client is there."""

    def wait(self, timeout_s: float) -> bool:
        """Wait for a byte, at most `timeout_s`; return whether there is one. Clients come and go here."""

    def read(self, count: int) -> bytes:
        """Return at most `count` bytes that are there; never waits."""

    def write(self, data: bytes) -> None:
        """Send bytes to the client; without one, or when it does not read, they are lost."""

    def hang_up(self) -> None:
        """Break the connection with the client, as a pulled cable does; another may come."""

    def close(self) -> None:
        """Give everything back."""


class TcpPort:
    """A listening socket; a second client is turned away, a new one after the first has gone is welcome."""

    def __init__(self, host: str, port: int):
        self._client: socket.socket | None = None
        try:
            self._listener = socket.create_server((host, port))
        except (OSError, OverflowError) as error:
            raise LinkError(
                "port-not-free",
                Text("the virtual machine cannot listen on {host}:{port}: {error}", host=host, port=port, error=error),
                advice="choose another port, or 0 for any that is free",
            ) from error
        self._listener.setblocking(False)
        self.address = "socket://{}:{}".format(*self._listener.getsockname()[:2])

    @property
    def connected(self) -> bool:
        return self._client is not None

    def wait(self, timeout_s: float) -> bool:
        readers = [self._listener] + ([self._client] if self._client else [])
        ready = select.select(readers, [], [], timeout_s)[0]
        if self._client in ready:
            return True
        if ready:
            self._accept()
        return False

    def read(self, count: int) -> bytes:
        if not self._client or not count:
            return b""
        try:
            data = self._client.recv(count)
        except BlockingIOError:
            return b""
        except OSError:
            data = b""
        if not data:
            self._drop()
        return data

    def write(self, data: bytes) -> None:
        if self._client:
            with contextlib.suppress(BlockingIOError):
                try:
                    self._client.send(data)
                except (ConnectionError, TimeoutError):
                    self._drop()

    def hang_up(self) -> None:
        self._drop()

    def close(self) -> None:
        self._drop()
        self._listener.close()

    def _accept(self) -> None:
        try:
            client, _ = self._listener.accept()
        except OSError:  # it went away before it was let in
            return
        if self._client:
            client.close()
            return
        client.setblocking(False)
        client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._client = client

    def _drop(self) -> None:
        if self._client:
            self._client.close()
            self._client = None


class PtyPort:
    """A pseudo-terminal; `path` becomes a link to it and is removed at the end."""

    def __init__(self, path: str):
        self._path = Path(path)
        self.address = path
        self._open()

    @property
    def connected(self) -> bool:
        return not self._events() & select.POLLHUP

    def wait(self, timeout_s: float) -> bool:
        events = self._events()
        if events & select.POLLIN:
            return True
        if events & select.POLLHUP:
            time.sleep(min(timeout_s, PTY_POLL_S))
            return False
        select.select([self._master], [], [], timeout_s)
        return bool(self._events() & select.POLLIN)

    def read(self, count: int) -> bytes:
        try:
            return os.read(self._master, count) if count else b""
        except OSError:  # nothing there, or nobody
            return b""

    def write(self, data: bytes) -> None:
        if self.connected:
            with contextlib.suppress(OSError):
                os.write(self._master, data)

    def hang_up(self) -> None:
        self.close()
        self._open()

    def close(self) -> None:
        if self._path.is_symlink() and os.readlink(self._path) == self._target:
            self._path.unlink()
        os.close(self._master)

    def _open(self) -> None:
        self._master, slave = _open_pty()
        self._target = os.ttyname(slave)
        os.close(slave)  # so that the master can tell whether a client has it open
        os.set_blocking(self._master, False)
        self._make_link()
        self._poll = select.poll()
        self._poll.register(self._master, select.POLLIN)

    def _events(self) -> int:
        found = self._poll.poll(0)
        return found[0][1] if found else 0

    def _make_link(self) -> None:
        """Link `path` to the terminal; what a killed virtual machine left there is replaced, a file never."""
        self._check_free()
        try:
            if self._path.is_symlink() and os.readlink(self._path).startswith("/dev/pts/"):
                self._path.unlink()
            self._path.symlink_to(self._target)
        except OSError as error:
            os.close(self._master)
            raise LinkError(
                "pty-path",
                Text("no link can be made at '{path}': {error}", path=self._path, error=error.strerror),
                advice="give a path in a folder that exists, where nothing stands yet",
            ) from error

    def _check_free(self) -> None:
        """Refuse a path that leads to the terminal of another program, which still runs."""
        there = os.readlink(self._path) if self._path.is_symlink() else ""
        if there.startswith("/dev/pts/") and there != self._target and os.path.exists(there):
            os.close(self._master)
            raise LinkError(
                "pty-busy",
                Text("'{path}' leads to a terminal that is in use", path=self._path),
                value=there,
                advice="end the virtual machine that is there, or give another path; remove the link if it was killed",
            )


def _open_pty() -> tuple[int, int]:
    """Return master and slave of a new raw pseudo-terminal; refused where the system has none."""
    try:
        import pty
        import tty
    except ImportError as error:
        raise LinkError(
            "no-pty", "this system has no pseudo-terminals", advice="use --tcp 127.0.0.1:PORT instead of --pty"
        ) from error
    master, slave = pty.openpty()
    tty.setraw(slave)
    return master, slave
