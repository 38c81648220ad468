# SPDX-License-Identifier: LGPL-2.1-or-later
"""The link: bytes to and from a controller over anything that pyserial opens by name or URL.

pyserial is imported inside functions only: its backend needs termios and fcntl, which Windows lacks.

Opens a link without being deaf meanwhile: names are looked up and hosts called for seconds.

The serial ports of this computer, as a person chooses among them.
"""

from __future__ import annotations

import errno
import os
import re
import select
import socket
import sys
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from typing import Any

from CNCStepper.control.transport.controller_link import LINE_BAUD, has_no_controller, open_controller
from CNCStepper.control.transport.output_queue import WireQueue
from CNCStepper.control.transport.telnet import TelnetPort, socket_url
from CNCStepper.errors import CNCStepperError, LinkError, Text, missing_package
from CNCStepper.machine.controller_family import BAUD
from CNCStepper.safe_text import printable

READ_BYTES = 4096
WRITE_LIMIT_S = 1.0
SLICE_S = 0.001  # how long a port that cannot be waited on sleeps between two looks
BUSY = (errno.EBUSY, errno.EAGAIN)
FORBIDDEN = (errno.EACCES, errno.EPERM)
PARALLEL_PORT = re.compile(r"/dev/(parport|lp)[0-9]+$")
ERROR_NUMBER = re.compile(r"\[(?:Errno|WinError) -?\d+\] ?")
NETWORK = ("socket://", "telnet://", "rfc2217://")


class Link:
    """An open port; reads wait at most their limit and end early when `wake` is called.

    `port` is a pyserial port, or anything with its read, write and close, opened with timeout 0. baud: the rate of
    the line that the bytes take. woken: whether `wake` ended the last `read`. spares_board: whether this opening was
    the first of its port, and has seen to it that no later one restarts the board. queue_bytes: how many bytes may wait
    before the line. filling_bytes: how many of them are written at a time. machine: the profile whose controller is a
    process of this computer; "" at a controller with a firmware of its own.
    Every failure of the port is a LinkError with code "link-lost".
    """

    def __init__(
        self, port: Any, name: str, baud: int = BAUD, clock: Callable[[], float] = time.monotonic, machine: str = ""
    ):
        self.name, self.machine = name, machine
        self.spares_board = False
        self.woken = False
        self._is_lost = False
        self._port = port
        self._queue = WireQueue(port, baud, clock)
        self.queue_bytes = self._queue.most_bytes
        self.filling_bytes = self._queue.filling_bytes
        self._descriptor = _descriptor(port)
        self._alarm_clock, self._bell = socket.socketpair()
        for end in (self._alarm_clock, self._bell):
            end.setblocking(False)

    def waiting_bytes(self) -> int:
        """Return how many bytes written wait in this computer, so that a real-time byte would go out after them."""
        try:
            return self._queue.waiting_bytes()
        except (OSError, ValueError) as error:
            raise self._lost(error) from error

    def leaving_s(self, count: int) -> float:
        """Return how long the line takes for so many bytes, in s."""
        return self._queue.leaving_s(count)

    def read(self, wait_s: float) -> bytes:
        """Return what has arrived, waiting up to `wait_s` for the first byte; b"" when nothing came."""
        self.woken = False
        try:
            if wait_s > 0.0:
                self._wait(wait_s)
            return self._port.read(READ_BYTES)
        except (OSError, ValueError) as error:
            raise self._lost(error) from error

    def rest(self, wait_s: float) -> None:
        """Wait so long whatever arrives; `wake` ends it."""
        self.woken = False
        if select.select([self._alarm_clock], [], [], wait_s)[0]:
            self._clear_wake_up()

    def write(self, data: bytes) -> None:
        """Write all of `data`; the caller keeps within the controller's buffer, so this never waits long."""
        self._queue.take(len(data))
        try:
            written = self._port.write(data)
        except (OSError, ValueError) as error:
            raise self._lost(error) from error
        if written is not None and written != len(data):
            raise self._lost(
                OSError(Text("only {written} of {data} bytes were accepted", written=written, data=len(data)))
            )

    def wake(self) -> None:
        """End a `read` that waits; may be called from any thread and from a signal handler."""
        try:
            self._bell.send(b"!")
        except OSError:  # the bell is full (it will ring) or the link is closed (nobody waits)
            return

    def close(self) -> None:
        """Close the port; a port that has disappeared is no error."""
        try:
            if self._is_lost:
                self._drop_output()
            self._port.close()
        except OSError:
            pass
        finally:
            self._alarm_clock.close()
            self._bell.close()

    def _drop_output(self) -> None:
        """Discard the bytes that a blocked line has not taken; closing would wait for them."""
        drop = getattr(self._port, "reset_output_buffer", None)
        if drop:
            with suppress(Exception):  # termios' own errors are no OSError; the port may have disappeared
                drop()

    def _wait(self, wait_s: float) -> None:
        if self._descriptor is None:
            self._wait_in_slices(wait_s)
            return
        waited: list[Any] = [self._descriptor, self._alarm_clock]
        ready, _, _ = select.select(waited, [], [], wait_s)
        if self._alarm_clock in ready:
            self._clear_wake_up()

    def _wait_in_slices(self, wait_s: float) -> None:
        """Look again and again at a port that `select` does not know (Windows' serial ports, loop://)."""
        end_s = time.monotonic() + wait_s
        while not getattr(self._port, "in_waiting", 1) and time.monotonic() < end_s:
            time.sleep(SLICE_S)  # finer than `select` on Windows
            if select.select([self._alarm_clock], [], [], 0)[0]:
                self._clear_wake_up()
                return

    def _clear_wake_up(self) -> None:
        self._alarm_clock.recv(READ_BYTES)
        self.woken = True

    def _lost(self, error: Exception) -> LinkError:
        self._is_lost = True
        return LinkError(
            "link-lost",
            Text("the link to {name} broke: {error}", name=self.name, error=cause_of(error)),
            advice="check cable and power; home the machine or set its zero again before the next cut",
        )


def cause_of(error: Exception) -> str:
    """Return what the operating system says of a failed port, without its number."""
    return printable(ERROR_NUMBER.sub("", getattr(error, "strerror", None) or str(error)))


def open_link(name: str, baud: int = BAUD, machine: str = "") -> Link:
    """Open a port by device name or URL (`socket://host:port`, `telnet://host`, `rfc2217://host:port`, `loop://`).

    machine: the profile, by name or file, of what is there; where it has no controller of its own, ours is started at
    that port. Raises LinkError that says what to do when the port is missing, busy, forbidden or silent, and
    MissingPackage without pyserial.
    """
    if machine and has_no_controller(machine):
        return Link(open_controller(name, machine), name, LINE_BAUD, machine=machine)
    if PARALLEL_PORT.match(name):
        raise LinkError(
            "port-parallel",
            Text("{name} is a parallel port, on which there is no controller", name=name),
            advice='name the machine profile of the table that is wired to it (controller = "thesis-a")',
        )
    serial = load_pyserial()
    is_telnet = name.startswith("telnet://")
    try:
        port = serial.serial_for_url(
            socket_url(name) if is_telnet else name,
            baudrate=baud,
            timeout=0,
            write_timeout=None if name.startswith("rfc2217://") else WRITE_LIMIT_S,  # which that one does not know
            exclusive=True,
            do_not_open=True,
        )
        port.open()
    except (OSError, ValueError, TypeError, AttributeError) as error:  # a bad URL ends in any of these
        raise port_refusal(name, error) from error
    _send_at_once(port)
    link = Link(TelnetPort(port) if is_telnet else port, name, baud)
    link.spares_board = _keep_dtr(port)
    return link


Opener = Callable[[str, int], Link]


def opener_of(machine: str) -> Opener:
    """Return what opens the port of a profile's machine, by name or file; "" has a controller of its own."""
    return partial(open_link, machine=machine) if machine else open_link


def restart_text(link: Link) -> str:
    """Return what to say of a controller that restarted, or of ours that started, when its port was opened."""
    if link.machine:
        return "the controller of this machine has been started; it counts from the present position"
    if getattr(link, "spares_board", False):
        return Text(
            "the controller restarted when its port was opened; it counts from its present position. Until it is "
            "unplugged no later opening restarts it"
        )
    return "the controller restarted when its port was opened; it counts from its present position"


def port_names() -> list[tuple[str, str]]:
    """Return (device name, description) of the serial ports of this computer."""
    load_pyserial()
    from serial.tools.list_ports import comports

    return [(port.device, port.description or "") for port in sorted(comports())]


def load_pyserial() -> Any:
    """Return pyserial; raises MissingPackage without it."""
    try:
        import serial
    except ImportError as error:
        raise missing_package("pyserial") from error
    return serial


def _descriptor(port: Any) -> int | None:
    """Return the number that `select` can wait on, or None where there is none."""
    try:
        return port.fileno()
    except (AttributeError, OSError):
        return None


def _send_at_once(port: Any) -> None:
    """Switch off the gathering of small packets: a real-time byte must not wait for the last answer."""
    connection = getattr(port, "_socket", None)
    if connection is not None:
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        if (connection.gettimeout() or 0.0) > WRITE_LIMIT_S:  # rfc2217 waits longer for a far end that takes nothing
            connection.settimeout(WRITE_LIMIT_S)


def _keep_dtr(port: Any) -> bool:
    """Let the closing of a serial port leave DTR as it is, so that the next opening makes no edge of it (HUPCL).

    The edge restarts boards that have DTR wired to their reset. Return whether closing would have changed it; False
    for another kind of port, or one that does not take it.
    """
    try:
        import termios
    except ImportError:  # Windows
        return False
    descriptor = _descriptor(port)
    if descriptor is None:
        return False
    try:
        attributes = termios.tcgetattr(descriptor)
        if not attributes[2] & termios.HUPCL:
            return False
        attributes[2] &= ~termios.HUPCL
        termios.tcsetattr(descriptor, termios.TCSANOW, attributes)
    except (OSError, termios.error):  # a socket, or a pseudo-terminal that refuses it
        return False
    return True


def port_refusal(name: str, error: Exception) -> CNCStepperError:
    """Return what to do about a port that could not be opened."""
    cause = _system_error(error)
    number, text, said = cause and cause.errno, str(error), cause_of(cause or error)
    if name.startswith(("socket://", "rfc2217://")) and not re.match(r"\w+://[^/:]+:\d+", name):
        return LinkError(
            "port-name", Text("'{name}' names no port number", name=name), advice="write socket://host:port"
        )
    if name.startswith(NETWORK):
        return LinkError(
            "port-silent",
            Text("nothing answers at {name}: {text}", name=name, text=said),
            advice="start it, or correct the URL",
        )
    if "://" in name:
        return LinkError(
            "port-name",
            Text("{name} is no port: {text}", name=name, text=said),
            advice="give a device name or socket://host:port",
        )
    if number == errno.ENOENT or "FileNotFoundError" in text:
        return LinkError("port-missing", Text("there is no port {name}", name=name), advice=_plug_in())
    if number in FORBIDDEN and os.name == "posix":
        return LinkError(
            "port-forbidden", Text("{name} may not be opened by this user", name=name), advice=_permission()
        )
    if number in BUSY or "exclusively lock" in text or "PermissionError" in text:
        return LinkError(
            "port-busy", Text("{name} is in use", name=name), advice="close the other program that holds it"
        )
    return LinkError(
        "port-unusable", Text("{name} cannot be used as a serial port: {text}", name=name, text=said), advice=_plug_in()
    )


def _system_error(error: BaseException | None) -> OSError | None:
    """Return the operating system's own error with its number: this one, or the one that it covers."""
    while error is not None:
        if isinstance(error, OSError) and error.errno:
            return error
        error = error.__context__
    return None


def _plug_in() -> str:
    names = ", ".join(device for device, _ in port_names()) or "none"
    return Text("plug the controller in, or give one of the ports that are there: {names}", names=names)


def _permission() -> str:
    if sys.platform.startswith("linux"):
        return "add yourself to its group (sudo usermod -aG dialout $USER) and log in again"
    return "ask for the right to use it"


LOOK_EVERY_S = 0.02


def open_unless(stopped: Callable[[], bool], opener: Callable[[str, int], Link], port: str, baud: int) -> Link | None:
    """Return the result of `opener` or raise its error; return None as soon as `stopped` returns True."""
    opening = _Opening(opener, port, baud)
    opening.thread.start()
    while not opening.done.wait(LOOK_EVERY_S):
        if stopped():
            opening.give_up()
            return None
    if opening.error:
        raise opening.error
    return opening.link


class _Opening:
    """The opening of one link, in a thread of its own."""

    def __init__(self, opener: Callable[[str, int], Link], port: str, baud: int):
        self.link: Link | None = None
        self.error: BaseException | None = None
        self.done = threading.Event()
        self.thread = threading.Thread(target=self._open, args=(opener, port, baud), name="open-link", daemon=True)
        self._lock = threading.Lock()
        self._given_up = False

    def give_up(self) -> None:
        """Close the link as soon as it is open: the caller waits no more."""
        with self._lock:
            self._given_up = True
            if self.link:
                self.link.close()

    def _open(self, opener: Callable[[str, int], Link], port: str, baud: int) -> None:
        try:
            link = opener(port, baud)
        except BaseException as error:  # raised where it is waited for
            self.error = error
        else:
            with self._lock:
                self.link = link
                if self._given_up:
                    link.close()
        self.done.set()


@dataclass(frozen=True)
class PortChoice:
    """A port: its name for `open_link`, and the text that a person recognizes it by."""

    name: str
    text: str


def port_list() -> list[PortChoice]:
    """Return the serial ports, sorted by name; raises MissingPackage without pyserial."""
    return [PortChoice(name, _text(name, description)) for name, description in port_names()]


def _text(name: str, description: str) -> str:
    known = description not in ("", "n/a", name)
    return f"{name} – {description}" if known else name
