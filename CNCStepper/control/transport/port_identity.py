# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which port a name means: a port has many names, and one position, one session and one journal.

    /dev/ttyUSB0, /dev/serial/by-id/..., ./table -> ttyUSB0    resolved path; on USB the board and its serial number
    COM3, com3, \\\\.\\COM3                                      COM3
    socket://Localhost:2217/, telnet://[::1]:2217              resolved addresses and TCP port
    /dev/parport0, record:./writes.csv                         resolved path, of a record with its scheme

Boards of one kind without serial numbers look alike: they are told apart by the sockets that they are plugged into, and
`may_be` says where one may have moved. Hosts of different names are one where all their addresses are the same; with
only some in common they may be one, for an address goes from host to host.

Nothing here waits longer than `LOOK_UP_S`, and nothing fails without a network.
"""

from __future__ import annotations

import ipaddress
import os
import re
import socket
import sys
import threading
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass
from typing import Any, TypeVar
from urllib.parse import urlsplit

from CNCStepper.errors import Text

LOOK_UP_S = 1.0
DEFAULT_PORTS = {"telnet": 23}
NETWORK = ("socket", "telnet", "rfc2217")
WRAPPERS = ("spy", "alt")  # pyserial's: a name within
RECORD = "record:"  # a file that takes what would go to a port
THIS_COMPUTER = "localhost"
LINKS = ("/dev/serial/by-id", "/dev/serial/by-path")
SHORTEST_SERIAL = 6  # "0001" and the like stand in whole series of adapters
_COM = re.compile(r"(?:[\\/]{2}[.?][\\/])?(COM\d+)", re.IGNORECASE)
_Found = TypeVar("_Found")


@dataclass(frozen=True)
class PortIdentity:
    """What is known of a port.

    names: its paths, or the name and the addresses of its host. tcp_port: of a network port, else None. board: vendor
    and product of a USB adapter, "" where it is none. serial: its serial number and interface; "" without a number that
    no other has. location: of its USB socket, with the interface. unsure: no answer came, which addresses its host has.
    """

    names: frozenset[str]
    tcp_port: int | None = None
    board: str = ""
    serial: str = ""
    location: str = ""
    unsure: bool = False

    @property
    def hosts(self) -> frozenset[str]:
        """Its names, without the addresses that a name stands for."""
        return self.names - self.addresses or self.names

    @property
    def addresses(self) -> frozenset[str]:
        """The addresses of a network port, else none."""
        return frozenset() if self.tcp_port is None else frozenset(filter(_is_address, self.names))

    @property
    def key(self) -> str:
        """The name of its files: the same from one connection to the next, as far as that can be known."""
        if self.board and (self.serial or self.location):
            return f"{self.board} {self.serial or self.location}"
        name = min(self.hosts, key=lambda name: (name != THIS_COMPUTER, name))
        return name if self.tcp_port is None else f"{name}:{self.tcp_port}"

    def is_same(self, other: PortIdentity) -> bool:
        """Return whether both are one port."""
        if self.board and other.board and self.board != other.board:
            return False
        if self.serial and other.serial:
            return self.serial == other.serial
        if self.location and other.location:
            return self.location == other.location
        return self.has_host_of(other) or self._is_alias_of(other)

    def has_host_of(self, other: PortIdentity) -> bool:
        """Return whether both have a name in common, whatever addresses their hosts have."""
        return self.tcp_port == other.tcp_port and not self.hosts.isdisjoint(other.hosts)

    def is_near(self, other: PortIdentity) -> bool:
        """Return whether both are one port, or ports of hosts with an address in common."""
        shared = self.tcp_port == other.tcp_port and not self.addresses.isdisjoint(other.addresses)
        return shared or self.is_same(other)

    def may_be(self, other: PortIdentity) -> bool:
        """Return whether both may be one port: also two boards of a kind, one of them without a serial number.

        And two hosts with an address in common, or of which one did not get its addresses in time.
        """
        alike = self.board != "" and self.board == other.board and not (self.serial and other.serial)
        unsure = self.tcp_port is not None and self.tcp_port == other.tcp_port and (self.unsure or other.unsure)
        return alike or unsure or self.is_near(other)

    def now(self) -> PortIdentity:
        """Return the identity that its host's name has now; itself where it is no network port's."""
        return self if self.tcp_port is None else _host(min(self.hosts - {THIS_COMPUTER} or self.hosts), self.tcp_port)

    def _is_alias_of(self, other: PortIdentity) -> bool:
        """Return whether the hosts of both have all their addresses in common."""
        sure = not (self.unsure or other.unsure) and self.addresses != frozenset()
        return sure and self.tcp_port == other.tcp_port and self.addresses == other.addresses

    def to_json(self) -> dict[str, Any]:
        """Return it as plain values."""
        return {**asdict(self), "names": sorted(self.names)}

    @classmethod
    def from_json(cls, content: Mapping[str, Any]) -> PortIdentity:
        """Return the identity of `to_json`; raises ValueError, KeyError or TypeError where it is none."""
        tcp_port, names = content["tcp_port"], content["names"]
        if not names or not isinstance(names, list) or not isinstance(tcp_port, (int, type(None))):
            raise ValueError(Text("no identity of a port: {content}", content=str(content)[:80]))
        board, serial, location = (str(content[name]) for name in ("board", "serial", "location"))
        unsure = content.get("unsure") is True  # earlier versions do not say it
        return cls(frozenset(map(str, names)), tcp_port, board, serial, location, unsure)


def identify(name: str) -> PortIdentity:
    """Return the identity of a port's name or URL now; an unknown name identifies itself."""
    scheme, separator, rest = name.strip().partition("://")
    scheme = scheme.lower()
    if name.strip().startswith(RECORD):
        return PortIdentity(frozenset([RECORD + os.path.realpath(name.strip().removeprefix(RECORD))]))
    if not separator:
        return _device(name.strip())
    if scheme in WRAPPERS:
        return identify(rest.partition("?")[0])
    if scheme == "hwgrep":
        return _device(within(LOOK_UP_S, lambda: _first_like(rest), "") or name)
    if scheme in NETWORK:
        return _address(scheme, name)
    return PortIdentity(frozenset([name]))


def is_same_port(name: str, other: str) -> bool:
    """Return whether two names mean one port."""
    return name == other or identify(name).is_same(identify(other))


def read_identity(content: Mapping[str, Any], port: object) -> PortIdentity:
    """Return the identity in a file's "port_identity"; in older files that of their port's name."""
    try:
        return PortIdentity.from_json(content["port_identity"])
    except (ValueError, KeyError, TypeError):
        return identify(str(port))


def other_names(name: str, identity: PortIdentity) -> Iterator[str]:
    """Yield the spellings under which an earlier version has kept files of a port."""
    yield name
    if identity.tcp_port is None:
        yield from identity.names
        yield from (link for link in _links() if os.path.realpath(link) in identity.names)
        return
    hosts = identity.hosts
    if THIS_COMPUTER in hosts:
        hosts = identity.names | {"localhost", "127.0.0.1", "::1"}
    yield from _urls(hosts, identity.tcp_port)


def address_names(identity: PortIdentity) -> Iterator[str]:
    """Yield the spellings under which an earlier version has kept files of a host's addresses, perhaps another's."""
    if identity.tcp_port is not None and THIS_COMPUTER not in identity.names:
        yield from _urls(identity.addresses - identity.hosts, identity.tcp_port)


def _urls(hosts: Iterable[str], tcp_port: int) -> Iterator[str]:
    for host in hosts:
        for scheme in NETWORK:
            yield f"{scheme}://{f'[{host}]' if ':' in host else host}:{tcp_port}"
            if DEFAULT_PORTS.get(scheme) == tcp_port:
                yield f"{scheme}://{host}"


def within(limit_s: float, function: Callable[[], _Found], otherwise: _Found) -> _Found:
    """Return a function's result, or `otherwise` at a timeout or a failure of network or driver."""
    found: list[_Found] = []

    def work() -> None:
        try:
            found.append(function())
        except Exception:  # of the system's or pyserial's: without an answer the name alone counts
            return

    thread = threading.Thread(target=work, name="port-identity", daemon=True)
    thread.start()
    thread.join(limit_s)
    return found[0] if found else otherwise


# --- serial ports ------------------------------------------------------------------------------


def _device(name: str) -> PortIdentity:
    if com := _COM.fullmatch(name):
        paths = frozenset([com[1].upper()])
    else:
        given = _one_of_two(os.path.normcase(os.path.abspath(name)))
        paths = frozenset([given, _one_of_two(os.path.normcase(os.path.realpath(name)))])
    nothing: list[Any] = []
    ports = within(LOOK_UP_S, _ports, nothing)
    mine = next((port for port in ports if _port_path(port) in paths), None)
    if mine is None or mine.vid is None or mine.pid is None:
        return PortIdentity(paths)
    board = f"{mine.vid:04x}:{mine.pid:04x}"
    return PortIdentity(paths, None, board, _serial(mine, ports), mine.location or "")


def _port_path(port: Any) -> str:
    com = _COM.fullmatch(port.device)
    return com[1].upper() if com else _one_of_two(os.path.normcase(os.path.realpath(port.device)))


def _one_of_two(path: str) -> str:
    """Return a path by its one name on macOS, which has two devices for each serial port."""
    return path.replace("/dev/tty.", "/dev/cu.", 1) if sys.platform == "darwin" else path


def _serial(port: Any, ports: Iterable[Any]) -> str:
    """Return the unique identity of a USB port, "" where other ports may have its number."""
    number, interface = port.serial_number or "", _interface(port)
    if len(number) < SHORTEST_SERIAL or len(set(number)) < 3:
        return ""
    mine = (port.vid, port.pid, number, interface)
    if sum((other.vid, other.pid, other.serial_number, _interface(other)) == mine for other in ports) > 1:
        return ""
    return f"{number}:{interface}"


def _interface(port: Any) -> str:
    """Return which of its board's ports it is: "1.0" of the location "1-4.2:1.0"."""
    return (port.location or "").partition(":")[2] or port.interface or ""


def _ports() -> list[Any]:
    from serial.tools.list_ports import comports

    return list(comports())


def _first_like(expression: str) -> str:
    from serial.tools.list_ports import grep

    return next((port.device for port in grep(expression.partition("&")[0])), "")


def _links() -> Iterator[str]:
    for folder in LINKS:
        if os.path.isdir(folder):
            yield from (os.path.join(folder, link) for link in sorted(os.listdir(folder)))


# --- network ports -----------------------------------------------------------------------------


def _address(scheme: str, url: str) -> PortIdentity:
    try:
        parts = urlsplit(url.strip())
        host, port = (parts.hostname or "").rstrip("."), parts.port or DEFAULT_PORTS.get(scheme)
    except ValueError:
        host, port = "", None
    if not host or port is None:
        return PortIdentity(frozenset([url]))
    return _host(host, port)


def _host(host: str, port: int) -> PortIdentity:
    found = _addresses_of(host)
    addresses = set(map(_plain, found or []))
    here = {THIS_COMPUTER} if any(map(_is_here, addresses)) or host == THIS_COMPUTER else set()
    return PortIdentity(frozenset({_plain(host), *addresses, *here}), port, unsure=found is None)


def _addresses_of(host: str) -> list[str] | None:
    """Return the addresses of a host, none where there is no such host, and None without an answer in time."""
    if _is_address(host.partition("%")[0]):
        return [host]
    return within(LOOK_UP_S, lambda: _looked_up(host), None)


def _looked_up(host: str) -> list[str] | None:
    try:
        return [str(found[4][0]) for found in socket.getaddrinfo(host, None)]
    except socket.gaierror as error:
        return None if error.errno == socket.EAI_AGAIN else []


def _is_address(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True


def _plain(address: str) -> str:
    """Return an address in its one spelling; one of IPv4 within IPv6 as that."""
    try:
        found = ipaddress.ip_address(address.partition("%")[0])
    except ValueError:
        return address
    return str(getattr(found, "ipv4_mapped", None) or found)


def _is_here(address: str) -> bool:
    """Return whether an address is one of this computer's: only those can be bound to."""
    try:
        found = ipaddress.ip_address(address)
    except ValueError:
        return False
    if found.is_loopback or found.is_unspecified:
        return True
    if found.is_multicast:
        return False
    family = socket.AF_INET if found.version == 4 else socket.AF_INET6
    try:
        with socket.socket(family, socket.SOCK_DGRAM) as probe:
            probe.bind((address, 0))
    except OSError:
        return False
    return True
