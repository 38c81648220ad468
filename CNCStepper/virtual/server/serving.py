# SPDX-License-Identifier: LGPL-2.1-or-later
"""The frame of every virtual machine as a program: one port, and an end by a signal."""

from __future__ import annotations

import contextlib
import signal
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

from CNCStepper.errors import LinkError, Text
from CNCStepper.virtual.server.ports import Port, PtyPort, TcpPort

LOOPBACK = ("127.0.0.1", "localhost", "")
FASTEST = 1000.0


def check_port_choice(speed: float, pty: object, tcp: object) -> None:
    """Raise LinkError where there is not one port, or the speed makes no sense."""
    if (pty is None) == (tcp is None):
        raise LinkError("port-choice", "the virtual machine needs one port", advice="give either --pty or --tcp")
    if not 0 < speed <= FASTEST:
        what, advice = "the speed is out of range", "give a speed within the limit"
        raise LinkError("speed", what, value=f"{speed:g}", limit=f"above 0, up to {FASTEST:g}", advice=advice)


def open_server_port(pty: str | Path | None, tcp: str | None) -> Port:
    """Return the end that clients connect to: a pseudo-terminal at the path `pty`, or a TCP port "HOST:PORT".

    Raises LinkError where it cannot be had, and for a host that others could reach.
    """
    return PtyPort(str(pty)) if pty else _tcp_port(str(tcp))


def _tcp_port(address: str) -> TcpPort:
    host, _, port = address.rpartition(":")
    if not port.isdecimal() or int(port) > 65535:
        raise LinkError(
            "tcp-address",
            Text("'{address}' is not an address", address=address),
            advice="write HOST:PORT, as 127.0.0.1:2300",
        )
    if host not in LOOPBACK:
        raise LinkError(
            "tcp-address",
            Text("the virtual machine asks nobody for a password, so it does not listen on '{host}'", host=host),
            advice=Text("give one of: {addresses}", addresses=", ".join(LOOPBACK[:2])),
        )
    return TcpPort(host or "127.0.0.1", int(port))


@contextlib.contextmanager
def stopped_by_signals(stop: Callable[[], None]) -> Iterator[None]:
    """Let SIGTERM and SIGINT call `stop`; signals reach only the main thread."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = {number: signal.signal(number, lambda *_: stop()) for number in (signal.SIGTERM, signal.SIGINT)}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
