# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edge of DTR that restarts a board: taken away for later openings where the port allows it."""

from __future__ import annotations

import os
from collections.abc import Iterator

import pytest

from CNCStepper.control.transport.link import open_link, restart_text
from helpers.control.fake_controller import FakeServer

termios = pytest.importorskip("termios")  # no serial port of Windows has the flag
CONTROL_FLAGS = 2


@pytest.fixture
def terminal() -> Iterator[tuple[int, str]]:
    """Yield the open end of a pseudo-terminal and its name; it hangs up at the last close, as a serial port does."""
    import pty
    import tty

    master, slave = pty.openpty()
    tty.setraw(slave)
    set_hangup(slave)
    yield slave, os.ttyname(slave)
    os.close(master)
    os.close(slave)


def set_hangup(slave: int) -> None:
    attributes = termios.tcgetattr(slave)
    attributes[CONTROL_FLAGS] |= termios.HUPCL
    termios.tcsetattr(slave, termios.TCSANOW, attributes)
    assert hangs_up(slave)


def hangs_up(slave: int) -> bool:
    return bool(termios.tcgetattr(slave)[CONTROL_FLAGS] & termios.HUPCL)


def opened(name: str) -> tuple[bool, str]:
    """Open a port; return whether that has spared later openings, and what is said of a restart."""
    link = open_link(name)
    try:
        return link.spares_board, restart_text(link)
    finally:
        link.close()


def test_first_opening_clears_the_flag_and_says_so_once(terminal):
    slave, name = terminal
    spares, told = opened(name)
    assert spares and "no later opening restarts it" in told
    assert not hangs_up(slave)
    assert opened(name) == (
        False,
        "the controller restarted when its port was opened; it counts from its present position",
    )
    set_hangup(slave)  # plugged in anew
    assert opened(name)[0]


def test_a_controller_of_ours_has_been_started_not_restarted(terminal):
    _, name = terminal
    link = open_link(name)
    try:
        link.machine = "thesis-table"
        assert "has been started" in restart_text(link) and "restarted" not in restart_text(link)
    finally:
        link.close()


def test_a_port_that_refuses_it_is_opened_all_the_same(terminal, monkeypatch):
    slave, name = terminal
    before = termios.tcgetattr(slave)
    real = termios.tcsetattr

    def refuses(descriptor: int, when: int, attributes: list) -> None:
        if not attributes[CONTROL_FLAGS] & termios.HUPCL:
            raise termios.error(22, "Invalid argument")
        real(descriptor, when, attributes)

    monkeypatch.setattr(termios, "tcsetattr", refuses)
    assert opened(name)[0] is False
    assert hangs_up(slave) and before[CONTROL_FLAGS] & termios.HUPCL


def test_a_network_port_has_no_such_line():
    with FakeServer() as server:
        assert opened(server.url)[0] is False
