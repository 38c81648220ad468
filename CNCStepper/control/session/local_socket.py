# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a session listens: on a Unix socket in a folder of its owner's, where there are such; else on the loopback.

NAME.sock beside the session's file, or, where that path is too long for a socket, in
$XDG_RUNTIME_DIR/cncstepper-UID or TEMP/cncstepper-UID, which is closed to others

Lines of JSON over the socket of a session, without ever waiting: for a thread that draws windows.
"""

from __future__ import annotations

import os
import select
import socket
import stat
import struct
import sys
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from CNCStepper import text_json

SOCKET = ".sock"
TRANSPORT = "CNCSTEPPER_SESSION_TRANSPORT"  # an environment variable: LOOPBACK where Unix sockets are not wanted
LOOPBACK = "loopback"
HOST = "127.0.0.1"
PATH_LIMIT_BYTES = 100  # of a socket: 104 on macOS, 108 on Linux
UNREAD_BYTES = 65_536  # that the system keeps of each way of a connection: what is older than that is of no use
BACKLOG = 1024  # connections that wait to be taken, as far as the system allows
LARGEST_PROCESS = 1 << 32
MAC_PEER_CREDENTIALS, MAC_CREDENTIALS_BYTES = 1, 76  # LOCAL_PEERCRED of <sys/un.h>, struct xucred


@dataclass(frozen=True)
class Address:
    """How to reach a session, as its file says it: by `path`, or at a `port` of the loopback where that is empty."""

    token: str
    process: int
    path: str = ""
    port: int = 0

    @classmethod
    def of(cls, content: Mapping[str, Any]) -> Address:
        """Return the address of a session file's content; raises ValueError where it is none."""
        token, process = content.get("token"), content.get("process", 0)
        path, port = content.get("socket", ""), content.get("port", 0)
        if not (isinstance(token, str) and isinstance(path, str) and "\0" not in path):
            raise ValueError("no token, or no path of a socket")
        if not (_is_between(process, 1, LARGEST_PROCESS) and (path or _is_between(port, 1, 1 << 16))):
            raise ValueError("no process, or no port")
        if not path and content.get("host") != HOST:
            raise ValueError("its host is not this computer")
        return cls(token, process, path, 0 if path else port)

    @property
    def target(self) -> Any:
        """What `connect` of `new_socket` takes."""
        return self.path or (HOST, self.port)

    def new_socket(self) -> socket.socket:
        """Return a socket that is not connected yet; raises OSError where this system has none of that kind."""
        if self.path and not _has_unix_sockets():
            raise OSError("this system has no Unix sockets")
        made = socket.socket(socket.AF_UNIX if self.path else socket.AF_INET, socket.SOCK_STREAM)
        if not self.path:
            made.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        made.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, UNREAD_BYTES)
        return made

    def connect(self, limit_s: float) -> socket.socket:
        """Return a connection to the session; raises OSError where there is none within `limit_s`."""
        made = self.new_socket()
        try:
            made.settimeout(limit_s)
            made.connect(self.target)
            if not is_own_peer(made):
                raise PermissionError("another user listens there")
        except OSError:
            made.close()
            raise
        return made


class Listener:
    """A socket that listens for the clients of one session; `address` is for the session's file."""

    def __init__(self, session_file: Path):
        self.socket, self._path = _listening(session_file)
        port = {} if self._path else {"host": HOST, "port": self.socket.getsockname()[1]}
        self.address: dict[str, Any] = port or {"socket": str(self._path)}

    def accept(self) -> socket.socket:
        """Return a connection of this user's that waits, or of one who must show the token; raises OSError for none."""
        connection, _ = self.socket.accept()
        try:
            if not is_own_peer(connection):
                raise ConnectionRefusedError("another user's")
            connection.setblocking(False)
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, UNREAD_BYTES)
        except OSError:  # or it has closed again
            connection.close()
            raise
        return connection

    def close(self) -> None:
        """Listen no more, and leave nothing."""
        self.socket.close()
        if self._path:
            self._path.unlink(missing_ok=True)


def is_own_peer(connection: socket.socket) -> bool:
    """Return whether the other end of a connection is a process of this user's or of the system's administrator's.

    True where the system does not say, as on the loopback: there the token decides.
    """
    if not _has_unix_sockets() or connection.family != socket.AF_UNIX:
        return True
    if sys.platform == "linux":
        size = struct.calcsize("3i")
        _, user, _ = struct.unpack("3i", connection.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, size))
    elif sys.platform == "darwin":
        found = connection.getsockopt(0, MAC_PEER_CREDENTIALS, MAC_CREDENTIALS_BYTES)
        _, user = struct.unpack("=II", found[:8])
    else:  # the folder is closed to others
        return True
    return user in (0, os.geteuid())


def close_in_order(connection: socket.socket) -> None:
    """Close a connection so that bytes sent before still arrive; waits for the other end up to its timeout."""
    with suppress(OSError):  # nothing left to read, or no connection
        connection.shutdown(socket.SHUT_WR)
        while connection.recv(UNREAD_BYTES):  # unread bytes would make a reset of it, which discards the rest
            pass
    connection.close()


def socket_paths(session_file: Path) -> list[Path]:
    """Return where the Unix socket of a session may be, the best first; none where no path is short enough."""
    if not _has_unix_sockets():
        return []
    short = Path(os.environ.get("XDG_RUNTIME_DIR") or tempfile.gettempdir()) / f"cncstepper-{os.geteuid()}"
    paths = [session_file.absolute().with_suffix(SOCKET), short / f"{session_file.stem}{SOCKET}"]
    return [path for path in paths if len(os.fsencode(path)) <= PATH_LIMIT_BYTES]


def is_abandoned(path: Path) -> bool:
    """Return whether a Unix socket is there at which no process listens; one that is busy has a listener."""
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as probe:
        probe.setblocking(False)
        try:
            probe.connect(str(path))
        except ConnectionRefusedError:
            return path.is_socket()
        except OSError:
            return False
    return False


def make_private(folder: Path) -> None:
    """Close a folder to other users, made where it is not there; raises OSError where it is not this user's own."""
    with suppress(FileExistsError):
        os.mkdir(folder, 0o700)
    if os.name == "nt":  # the profile of a user is closed to others
        return
    found = os.stat(folder)
    if found.st_uid != os.geteuid():
        raise PermissionError("the folder belongs to another user")
    if stat.S_IMODE(found.st_mode) & 0o077:
        os.chmod(folder, 0o700)


def _listening(session_file: Path) -> tuple[socket.socket, Path | None]:
    """Return a listening socket and its path, None on the loopback."""
    if os.environ.get(TRANSPORT) != LOOPBACK:
        for path in socket_paths(session_file):
            with suppress(OSError):  # a folder that is not ours, a disk without sockets: the next place serves
                return _listening_at(path), path
    return socket.create_server((HOST, 0), backlog=BACKLOG), None


def _listening_at(path: Path) -> socket.socket:
    """Return a socket that nobody could reach before it was closed to others."""
    if path.parent.is_symlink():
        raise PermissionError("the folder is a link")
    make_private(path.parent)
    made = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    try:
        made.bind(str(path))
        os.chmod(path, 0o600)
        made.listen(BACKLOG)
    except OSError:
        made.close()
        path.unlink(missing_ok=True)
        raise
    return made


def _has_unix_sockets() -> bool:
    return os.name == "posix" and hasattr(socket, "AF_UNIX")


def _is_between(value: Any, least: int, end: int) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and least <= value < end


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
        """Return the lines received; raises ValueError for a line that is no JSON."""
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
        """Return whether the connection is open; a refused one is closed."""
        if not self._made:
            _, writable, failed = select.select([], [self._socket], [self._socket], 0)
            if failed or (writable and self._socket.getsockopt(socket.SOL_SOCKET, socket.SO_ERROR)):
                self.close()
            else:
                self._made = bool(writable)
        return self._made
