# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every kind of link carries a conversation with a controller: serial, socket, telnet, RFC 2217; all on loopback."""

from __future__ import annotations

import os
import select
import socket
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import pytest
from fake_controller import FakeServer
from hypothesis import given
from hypothesis import strategies as st

from CNCStepper.control.protocol.grbl.connect import handshake
from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.motion_interlock import MotionInterlock
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.control.transport.link import open_link
from CNCStepper.control.transport.telnet import DO, DONT, IAC, SB, SE, WILL, WONT, plain_bytes, socket_url
from CNCStepper.errors import LinkError

OFFERS = bytes([IAC, WILL, 1, IAC, DO, 34, IAC, SB, 34, 1, 2, IAC, SE])
Pump = Callable[[socket.socket, socket.socket], None]


@contextmanager
def in_front_of(server: FakeServer, pump: Pump) -> Iterator[int]:
    """Listen before a controller's port and let `pump` carry one connection; yield the port's number."""
    listener = socket.create_server(("127.0.0.1", 0))

    def serve() -> None:
        with listener.accept()[0] as client, socket.create_connection(address_of(server)) as behind:
            pump(client, behind)

    thread = threading.Thread(target=serve, daemon=True)
    thread.start()
    yield listener.getsockname()[1]
    thread.join(10)
    listener.close()


def address_of(server: FakeServer) -> tuple[str, int]:
    host, _, port = server.url.removeprefix("socket://").partition(":")
    return host, int(port)


def telnet_pump(client: socket.socket, behind: socket.socket) -> None:
    """Be a telnet server: offer options, and take the client's answers out of what it says."""
    client.sendall(OFFERS)
    carry(client, behind, lambda data: plain_bytes(data)[0])


def carry(client: socket.socket, behind: socket.socket, of_client: Callable[[bytes], bytes]) -> None:
    """Carry bytes both ways until one side closes."""
    while True:
        for end in select.select([client, behind], [], [])[0]:
            data = end.recv(4096)
            if not data:
                return
            if end is client:
                behind.sendall(of_client(data))
            else:
                client.sendall(data)


class PortBehind:
    """The serial port that an RFC 2217 server has: its settings, and the controller's socket as its wire."""

    def __init__(self) -> None:
        self.baudrate, self.bytesize, self.parity, self.stopbits = 9600, 8, "N", 1
        self.rtscts = self.xonxoff = self.dtr = self.rts = False
        self.cts = self.dsr = self.ri = self.cd = True
        self.break_condition = False

    def reset_input_buffer(self) -> None: ...

    def reset_output_buffer(self) -> None: ...


class Connection:
    """What pyserial's PortManager writes to."""

    def __init__(self, client: socket.socket):
        self.write = client.sendall


def rfc2217_pump(client: socket.socket, behind: socket.socket) -> None:
    """Be an RFC 2217 server, as pyserial's own example is."""
    from serial.rfc2217 import PortManager

    manager = PortManager(PortBehind(), Connection(client))
    carry(client, behind, lambda data: b"".join(manager.filter(data)))


def talk(url: str) -> None:
    """Meet a controller, send a line and a real-time byte, and part from it."""
    link = open_link(url)
    try:
        driver = Grbl(link, interlock=MotionInterlock(lambda: False))
        assert handshake(driver, Timing()).version == "1.1h.20190830"
        assert driver.settings[110] == 5000 and driver.mpos_mm == (-90.0, -40.0, -10.0)
        driver.send("G1X1")
        driver.flush()
        driver.realtime(b"\x91")
        while driver.unanswered:
            driver.receive(0.1)
    finally:
        link.close()


def test_socket_carries_a_conversation():
    with FakeServer() as server:
        talk(server.url)
        assert server.controller.lines == ["G1X1"] and "\x91" in server.controller.realtime


def test_telnet_carries_a_conversation_and_declines_what_is_offered():
    with FakeServer() as server, in_front_of(server, telnet_pump) as port:
        talk(f"telnet://127.0.0.1:{port}")
        assert server.controller.lines == ["G1X1"] and "\x91" in server.controller.realtime


def test_rfc2217_carries_a_conversation():
    with FakeServer() as server, in_front_of(server, rfc2217_pump) as port:
        talk(f"rfc2217://127.0.0.1:{port}")
        assert server.controller.lines == ["G1X1"] and "\x91" in server.controller.realtime


@pytest.mark.skipif(os.name != "posix", reason="a serial port without hardware is a pseudo-terminal")
def test_serial_port_carries_a_conversation():
    import pty
    import tty

    master, slave = pty.openpty()
    tty.setraw(slave)
    with FakeServer() as server, socket.create_connection(address_of(server)) as behind:
        ended = threading.Event()

        def pump() -> None:
            while not ended.is_set():
                for end in select.select([master, behind], [], [], 0.05)[0]:
                    if end is behind:
                        os.write(master, behind.recv(4096))
                    else:
                        behind.sendall(os.read(master, 4096))

        thread = threading.Thread(target=pump, daemon=True)
        thread.start()
        talk(os.ttyname(slave))
        ended.set()
        thread.join(10)
        assert server.controller.lines == ["G1X1"] and "\x91" in server.controller.realtime
    os.close(master)
    os.close(slave)


def test_commands_of_telnet_are_declined_and_left_out():
    plain, answers, rest = plain_bytes(b"ok\r\n" + OFFERS + b"<Idle>" + bytes([IAC, IAC, IAC]))
    assert plain == b"ok\r\n<Idle>\xff" and rest == bytes([IAC])
    assert answers == bytes([IAC, DONT, 1, IAC, WONT, 34])


@given(st.lists(st.sampled_from([b"ok\n", OFFERS, bytes([IAC, IAC]), bytes([IAC, 241]), b"<Idle>"])), st.data())
def test_telnet_bytes_may_come_in_any_pieces(parts, data):
    whole = b"".join(parts)
    cut = data.draw(st.integers(0, len(whole)))
    first, answers, held = plain_bytes(whole[:cut])
    second, more, rest = plain_bytes(held + whole[cut:])
    assert (first + second, answers + more, rest) == plain_bytes(whole)


@pytest.mark.parametrize(
    ("url", "opened"),
    [
        ("telnet://fluidnc.local", "socket://fluidnc.local:23"),
        ("telnet://10.0.0.7:8023/", "socket://10.0.0.7:8023"),
    ],
)
def test_telnet_has_its_own_port(url, opened):
    assert socket_url(url) == opened


@pytest.mark.parametrize("kind", ["socket", "telnet", "rfc2217"])
def test_nothing_behind_an_address_is_said(kind):
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    with pytest.raises(LinkError) as refused:
        open_link(f"{kind}://127.0.0.1:{port}")
    assert refused.value.code == "port-silent"
