# SPDX-License-Identifier: LGPL-2.1-or-later
"""A port is one port under all its names: for its position, its sessions and its journal."""

from __future__ import annotations

import hashlib
import os
import socket
import subprocess
import sys
import time
from types import SimpleNamespace

import pytest

from CNCStepper.control.processes.process_file import ProcessFile
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.service.port_owner import check_free
from CNCStepper.control.service.position_trust_file import POSITION, PositionTrustFile
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.files import service_at, session_at, session_near, write_private
from CNCStepper.control.session.status import DONE, REFUSED
from CNCStepper.control.stream.position_trust import AT_HOME, LOST, NOTHING_AGAINST
from CNCStepper.control.transport import port_identity
from CNCStepper.control.transport.port_identity import LOOK_UP_S, PortIdentity, identify, is_same_port
from CNCStepper.errors import MachineRefusal
from helpers.control.fake_controller import FakeServer

FROM_HERE = LOST._replace(counts_from_here=True)


def usb(device: str, serial: str | None = None, location: str | None = None, board=(0x1A86, 0x7523)) -> SimpleNamespace:
    return SimpleNamespace(
        device=device, vid=board[0], pid=board[1], serial_number=serial, location=location, interface=None
    )


@pytest.fixture
def plugged(monkeypatch):
    """What is plugged in, as pyserial lists it; empty at first."""
    ports = []
    monkeypatch.setattr("serial.tools.list_ports.comports", lambda: list(ports))
    return ports


def kept(folder, port: str) -> PositionTrustFile:
    return PositionTrustFile.of_port(folder, port)


# --- names ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "other"),
    [
        ("socket://localhost:2217", "socket://127.0.0.1:2217"),
        ("socket://LOCALHOST:2217/", "socket://[::1]:2217"),
        ("SOCKET://127.0.0.1:2217", "socket://127.0.0.1:2217?logging=debug"),
        ("socket://127.0.0.1:2217", "socket://127.0.1.1:2217"),
        ("socket://0.0.0.0:2217", "rfc2217://localhost:2217"),
        ("telnet://192.0.2.7", "telnet://192.0.2.7:23/"),
        ("telnet://192.0.2.7", "socket://192.0.2.7:23"),
        ("socket://[2001:DB8::0:1]:23", "socket://[2001:db8:0::1]:23"),
        ("socket://[::ffff:192.0.2.7]:23", "socket://192.0.2.7:23"),
        ("COM3", "com3"),
        ("COM3", "\\\\.\\COM3"),
        ("COM3", "//./com3"),
        ("spy://COM3?file=x.txt", "alt://COM3?class=PosixPollSerial"),
        ("spy:///dev/ttyUSB7", "/dev/../dev/ttyUSB7"),
        ("loop://", "loop://"),
        ("record:/tmp/writes.csv", "record:/tmp/../tmp/writes.csv"),
        ("/dev/parport7", "/dev/../dev/parport7"),
    ],
)
def test_one_port_under_two_names(name, other, plugged):
    assert is_same_port(name, other) and is_same_port(other, name)
    assert identify(name).key == identify(other).key


@pytest.mark.parametrize(
    ("name", "other"),
    [
        ("socket://127.0.0.1:2217", "socket://127.0.0.1:2218"),
        ("socket://192.0.2.7:23", "socket://192.0.2.8:23"),
        ("COM3", "COM33"),
        ("/dev/ttyUSB0", "/dev/ttyUSB1"),
        ("COM3", "socket://COM3:23"),
        ("socket://", "telnet://"),
        ("socket://a:b", "socket://a:c"),
        ("", "/dev/ttyUSB0"),
        ("record:/tmp/writes.csv", "/tmp/writes.csv"),
        ("record:/tmp/writes.csv", "record:/tmp/others.csv"),
        ("/dev/parport0", "/dev/parport1"),
    ],
)
def test_other_ports_stay_apart(name, other, plugged):
    assert not is_same_port(name, other) and not identify(name).may_be(identify(other))


def test_a_host_is_known_by_its_name_and_by_its_addresses(monkeypatch):
    found = {"table.local": "192.0.2.7", "fraese": "192.0.2.7", "other": "192.0.2.8"}

    def look_up(host, *_):
        if host not in found:
            raise socket.gaierror("offline")
        return [(0, 0, 0, "", (found[host], 0))]

    monkeypatch.setattr(socket, "getaddrinfo", look_up)
    known = identify("socket://table.local:23")
    assert known.is_same(identify("socket://Table.Local.:23")) and known.is_same(identify("socket://fraese:23"))
    assert known.is_same(identify("socket://192.0.2.7:23")) and not known.is_same(identify("socket://other:23"))
    found.clear()  # offline, or at another address since
    assert known.is_same(identify("socket://table.local:23"))


@pytest.fixture
def hosts(monkeypatch):
    """The addresses of hosts by name, as the system looks them up; None for one of which no answer comes."""
    found: dict[str, tuple[str, ...] | None] = {}

    def look_up(host, *_):
        if host not in found:
            raise socket.gaierror(socket.EAI_NONAME, "no such host")
        if found[host] is None:
            raise socket.gaierror(socket.EAI_AGAIN, "no answer")
        return [(0, 0, 0, "", (address, 0)) for address in found[host]]

    monkeypatch.setattr(socket, "getaddrinfo", look_up)
    return found


MILL, LATHE = "socket://mill.local:23", "socket://lathe.local:23"


def test_hosts_with_an_address_in_common_may_be_one(hosts):
    hosts.update({"mill.local": ("192.0.2.7", "192.0.2.8"), "lathe.local": ("192.0.2.8",), "far": ("192.0.2.9",)})
    mill, lathe = identify(MILL), identify(LATHE)
    for one, other in ((mill, lathe), (lathe, mill), (mill, identify("socket://192.0.2.7:23"))):
        assert not one.is_same(other) and one.may_be(other) and one.is_near(other)
    assert mill.key != lathe.key and not mill.may_be(identify("socket://far:23"))
    assert not mill.may_be(identify("socket://lathe.local:24"))
    assert lathe.is_same(identify("socket://192.0.2.8:23"))  # all its addresses


def test_a_host_without_an_answer_may_be_any(hosts):
    hosts.update({"mill.local": None, "lathe.local": ("192.0.2.8",)})
    mill, lathe = identify(MILL), identify(LATHE)
    assert mill.unsure and not lathe.unsure and not mill.is_same(lathe)
    assert mill.may_be(lathe) and lathe.may_be(mill) and not mill.is_near(lathe)
    assert not identify("socket://nowhere:23").unsure and not identify("socket://nowhere:23").may_be(lathe)
    assert mill.is_same(identify(MILL)) and PortIdentity.from_json(mill.to_json()) == mill


def test_an_identity_of_an_earlier_version_is_read(hosts):
    old = {"names": ["192.0.2.7", "mill.local"], "tcp_port": 23, "board": "", "serial": "", "location": ""}
    read = PortIdentity.from_json(old)
    assert not read.unsure and read.hosts == {"mill.local"} and read.addresses == {"192.0.2.7"}
    assert read.is_same(identify(MILL))


def test_a_look_up_that_hangs_is_not_waited_for(monkeypatch):
    monkeypatch.setattr(port_identity, "LOOK_UP_S", 0.1)
    monkeypatch.setattr(socket, "getaddrinfo", lambda *_: time.sleep(60))
    monkeypatch.setattr("serial.tools.list_ports.comports", lambda: time.sleep(60))
    begin_s = time.monotonic()
    assert is_same_port("socket://slow:23", "socket://SLOW:23") and is_same_port("/dev/ttyUSB0", "/dev//ttyUSB0")
    assert time.monotonic() - begin_s < LOOK_UP_S


def test_a_broken_list_of_ports_leaves_the_names(monkeypatch):
    def broken():
        raise RuntimeError("no registry")

    monkeypatch.setattr("serial.tools.list_ports.comports", broken)
    assert is_same_port("COM3", "com3") and not is_same_port("COM3", "COM4")


@pytest.mark.skipif(os.name != "posix", reason="symbolic links to devices")
def test_links_and_relative_names_lead_to_the_device(tmp_path, monkeypatch, plugged):
    device, folder = tmp_path / "ttyUSB0", tmp_path / "peça 1"
    device.touch()
    folder.mkdir()
    (folder / "table").symlink_to(device)
    monkeypatch.chdir(folder)
    assert is_same_port("table", str(device)) and is_same_port("../peça 1/table", str(device))
    told = PortIdentity.from_json(identify("table").to_json())
    (folder / "table").unlink()
    (folder / "table").symlink_to(tmp_path / "ttyUSB1")  # as udev does when it is plugged in again
    assert identify("table").is_same(told)


# --- USB -----------------------------------------------------------------------------------------


def test_a_board_with_a_serial_number_is_the_same_at_another_name(tmp_path, plugged):
    plugged[:] = [usb("/dev/ttyUSB0", "AB12CD34", "1-1:1.0")]
    kept(tmp_path, "/dev/ttyUSB0").keep(LOST)
    plugged[:] = [usb("/dev/ttyUSB1", "AB12CD34", "1-7:1.0"), usb("/dev/ttyUSB0", "EF56AB78", "1-1:1.0")]
    assert kept(tmp_path, "/dev/ttyUSB1").trust == LOST
    assert kept(tmp_path, "/dev/ttyUSB0").trust == NOTHING_AGAINST  # another board has that name now
    kept(tmp_path, "/dev/ttyUSB1").keep(AT_HOME)
    assert not list(tmp_path.glob(f"*{POSITION}"))


def test_two_interfaces_of_one_board_are_two_ports(plugged):
    plugged[:] = [usb("/dev/ttyUSB0", "AB12CD34", "1-1:1.0"), usb("/dev/ttyUSB1", "AB12CD34", "1-1:1.1")]
    assert not is_same_port("/dev/ttyUSB0", "/dev/ttyUSB1")


@pytest.mark.parametrize("serial", [None, "", "0001", "000000000", "AB12CD34"])
def test_boards_that_look_alike_are_never_mixed_up(tmp_path, plugged, serial):
    """Without a number of its own, or with one that two of them have."""
    first, second = usb("/dev/ttyUSB0", serial, "1-1:1.0"), usb("/dev/ttyUSB1", serial, "1-2:1.0")
    plugged[:] = [first, second]
    assert not is_same_port("/dev/ttyUSB0", "/dev/ttyUSB1")
    kept(tmp_path, "/dev/ttyUSB0").keep(FROM_HERE)
    assert kept(tmp_path, "/dev/ttyUSB0").trust == FROM_HERE
    assert kept(tmp_path, "/dev/ttyUSB1").trust == LOST  # it may be the one, moved; its zero is not the other's
    kept(tmp_path, "/dev/ttyUSB1").keep(AT_HOME)
    assert kept(tmp_path, "/dev/ttyUSB1").trust == NOTHING_AGAINST
    assert kept(tmp_path, "/dev/ttyUSB0").trust == FROM_HERE  # that one was not homed
    first.device, second.device = "/dev/ttyUSB1", "/dev/ttyUSB0"  # the computer has started anew
    assert kept(tmp_path, "/dev/ttyUSB1").trust == FROM_HERE
    assert kept(tmp_path, "/dev/ttyUSB0").trust == NOTHING_AGAINST
    plugged[:] = [usb("/dev/ttyUSB2", serial, "1-9:1.0")] * 2
    assert kept(tmp_path, "/dev/ttyUSB2").trust == LOST  # moved to where none was homed since


def test_what_a_board_loses_later_counts_again_for_one_that_was_homed(tmp_path, plugged):
    plugged[:] = [usb("/dev/ttyUSB0", None, "1-1:1.0"), usb("/dev/ttyUSB1", None, "1-2:1.0")]
    kept(tmp_path, "/dev/ttyUSB0").keep(LOST)
    kept(tmp_path, "/dev/ttyUSB1").keep(AT_HOME)
    again = kept(tmp_path, "/dev/ttyUSB0")
    again.keep(LOST)  # in another connection
    assert kept(tmp_path, "/dev/ttyUSB1").trust == LOST
    kept(tmp_path, "/dev/ttyUSB1").keep(AT_HOME)
    again.keep(LOST)  # as at each turn of that connection
    assert kept(tmp_path, "/dev/ttyUSB1").trust == NOTHING_AGAINST


def test_a_board_of_another_kind_at_the_same_name_is_another(tmp_path, plugged):
    plugged[:] = [usb("/dev/ttyUSB0", None, "1-1:1.0")]
    kept(tmp_path, "/dev/ttyUSB0").keep(LOST)
    plugged[:] = [usb("/dev/ttyUSB0", None, "1-1:1.0", board=(0x2341, 0x0043))]
    assert kept(tmp_path, "/dev/ttyUSB0").trust == NOTHING_AGAINST


def test_a_serial_number_that_is_not_read_this_time_changes_nothing(tmp_path, plugged):
    plugged[:] = [usb("COM3", "AB12CD34", None)]
    kept(tmp_path, "COM3").keep(LOST)
    plugged.clear()
    assert kept(tmp_path, "com3").trust == LOST


# --- hosts that share an address -----------------------------------------------------------------


SHARED = {"mill.local": ("192.0.2.7", "192.0.2.8"), "lathe.local": ("192.0.2.8",)}
MOVED = {"lathe.local": ("192.0.2.7",)}  # the mill is off, and its address was given to the lathe


@pytest.mark.parametrize("later", [SHARED, MOVED], ids=["at once", "one after the other"])
def test_what_one_host_has_lost_is_not_forgotten_at_another_of_its_address(tmp_path, hosts, later):
    hosts.update(SHARED if later is SHARED else {"mill.local": ("192.0.2.7",)})
    kept(tmp_path, MILL).keep(FROM_HERE)
    hosts.clear()
    hosts.update(later)
    assert kept(tmp_path, LATHE).trust == LOST  # it may be the mill
    kept(tmp_path, LATHE).keep(AT_HOME)
    assert kept(tmp_path, LATHE).trust == NOTHING_AGAINST
    assert kept(tmp_path, MILL).trust == FROM_HERE  # that one was not homed
    kept(tmp_path, MILL).keep(AT_HOME)
    assert not list(tmp_path.iterdir())


def test_a_loss_that_comes_later_counts_again_for_the_host_that_was_homed(tmp_path, hosts):
    hosts.update(SHARED)
    kept(tmp_path, MILL).keep(LOST)
    kept(tmp_path, LATHE).keep(AT_HOME)
    assert kept(tmp_path, LATHE).trust == NOTHING_AGAINST
    kept(tmp_path, MILL).keep(LOST)  # in another connection
    assert kept(tmp_path, LATHE).trust == LOST


def test_each_host_of_an_address_has_a_file_of_its_own(tmp_path, hosts):
    hosts.update(SHARED)
    for url in (MILL, LATHE, "socket://192.0.2.7:23"):
        kept(tmp_path, url).keep(LOST)
    assert len(list(tmp_path.iterdir())) == 3
    kept(tmp_path, LATHE).keep(AT_HOME)
    assert len(list(tmp_path.iterdir())) == 2 and kept(tmp_path, MILL).trust == LOST


def test_a_file_of_an_earlier_version_under_a_shared_address_is_not_overwritten(tmp_path, hosts):
    """Earlier versions have named a host's file after its address."""
    hosts.update({"mill.local": ("192.0.2.7", "192.0.2.8")})
    kept(tmp_path, "socket://192.0.2.7:23").keep(LOST)
    (path,) = tmp_path.iterdir()
    identity = {"names": ["192.0.2.7", "mill.local"], "tcp_port": 23, "board": "", "serial": "", "location": ""}
    path.unlink()
    write_private(path, {"port_identity": identity, "counts_from_here": True, "zeroed": ""})
    kept(tmp_path, "socket://192.0.2.7:23").keep(LOST)
    kept(tmp_path, "socket://192.0.2.7:23").keep(AT_HOME)
    assert list(tmp_path.iterdir()) == [path] and kept(tmp_path, MILL).trust == FROM_HERE


def test_an_older_file_of_an_address_alone_is_in_doubt_for_its_host(tmp_path, hosts):
    hosts.update({"mill.local": ("192.0.2.7",)})
    url = "socket://192.0.2.7:23"
    path = tmp_path / _old_name(url, hashlib.sha256(url.encode("utf-8")).hexdigest()[:16])
    write_private(path, {"counts_from_here": True, "zeroed": ""})
    assert kept(tmp_path, MILL).trust == LOST
    kept(tmp_path, MILL).keep(AT_HOME)
    assert kept(tmp_path, MILL).trust == NOTHING_AGAINST and kept(tmp_path, url).trust == FROM_HERE


def test_names_of_one_host_share_what_is_known(tmp_path, hosts):
    hosts.update({"mill.local": ("192.0.2.7", "fe80::1"), "fraese": ("fe80::1", "192.0.2.7")})
    kept(tmp_path, MILL).keep(LOST)
    hosts.update(dict.fromkeys(hosts, ("192.0.2.9",)))  # both have moved
    fraese = kept(tmp_path, "socket://fraese:23")
    assert fraese.trust == LOST
    fraese.keep(LOST._replace(zeroed=frozenset("XY")))
    assert kept(tmp_path, MILL).trust == LOST._replace(zeroed=frozenset("XY")) and len(list(tmp_path.iterdir())) == 1
    kept(tmp_path, MILL).keep(AT_HOME)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("silent", ["mill.local", "lathe.local"])
def test_without_an_answer_nothing_is_forgotten(tmp_path, hosts, silent):
    hosts.update(SHARED)
    kept(tmp_path, MILL).keep(FROM_HERE)
    hosts[silent] = None
    assert kept(tmp_path, LATHE).trust == LOST
    kept(tmp_path, LATHE).keep(AT_HOME)
    assert kept(tmp_path, MILL).trust == FROM_HERE and kept(tmp_path, LATHE).trust == NOTHING_AGAINST


def test_a_job_at_a_host_of_the_same_address_is_not_taken_for_ones_own(tmp_path, hosts):
    hosts.update(SHARED)
    running = ProcessFile(tmp_path / "one.session")
    running.write({"machine_port": MILL, "port_identity": identify(MILL).to_json()})
    assert session_at(MILL, tmp_path) and not session_at(LATHE, tmp_path)
    assert session_near(LATHE, tmp_path) == tmp_path / "one.session"  # so that the port is not opened twice
    assert session_near("socket://far:23", tmp_path) is None
    running.remove()


# --- files ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("socket://localhost:2217", "socket://127.0.0.1:2217"),
        ("socket://127.0.0.1:2217", "socket://[::1]:2217/"),
        ("telnet://192.0.2.7", "socket://192.0.2.7:23"),
        ("COM3", "\\\\.\\com3"),
        ("/dev/ttyUSB0", "/dev/../dev/ttyUSB0"),
    ],
)
def test_files_of_earlier_versions_are_found_under_other_names(tmp_path, plugged, old, new):
    digest = hashlib.sha256(old.encode("utf-8")).hexdigest()[:16]
    write_private(tmp_path / f"old-{digest}{POSITION}", {"counts_from_here": False, "zeroed": "XY"})
    (tmp_path / f"old-{digest}{POSITION}").rename(tmp_path / _old_name(old, digest))
    assert kept(tmp_path, new).trust == LOST._replace(zeroed=frozenset("XY"))
    assert kept(tmp_path, "socket://192.0.2.99:4").trust == NOTHING_AGAINST
    kept(tmp_path, new).keep(AT_HOME)
    assert not list(tmp_path.iterdir())


def _old_name(port: str, digest: str) -> str:
    readable = "".join(character if character.isalnum() and character.isascii() else "-" for character in port)
    while "--" in readable:
        readable = readable.replace("--", "-")
    return f"{readable.strip('-')[:40]}-{digest}{POSITION}"


def test_what_was_lost_under_several_names_is_known_under_all(tmp_path, plugged):
    for name in ("socket://localhost:2217", "socket://127.0.0.1:2217"):
        kept(tmp_path, name).keep(LOST)
    kept(tmp_path, "telnet://[::1]:2217").keep(AT_HOME)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("known_at", [1, None, ["x"], [{}], {}])
def test_a_damaged_list_of_boards_homed_since_says_nothing(tmp_path, plugged, known_at):
    plugged[:] = [usb("/dev/ttyUSB0", None, "1-1:1.0"), usb("/dev/ttyUSB1", None, "1-2:1.0")]
    kept(tmp_path, "/dev/ttyUSB0").keep(LOST)
    (path,) = tmp_path.iterdir()
    path.unlink()
    content = {"port_identity": identify("/dev/ttyUSB0").to_json(), "counts_from_here": False, "zeroed": ""}
    write_private(path, content | {"known_at": known_at})
    assert kept(tmp_path, "/dev/ttyUSB1").trust == LOST
    kept(tmp_path, "/dev/ttyUSB1").keep(AT_HOME)
    assert kept(tmp_path, "/dev/ttyUSB1").trust == NOTHING_AGAINST


@pytest.mark.parametrize(
    ("folder", "find"), [("one.session", session_at), ("one.service", service_at)], ids=["session", "service"]
)
def test_sessions_and_services_are_found_by_any_name(tmp_path, folder, find, plugged):
    running = ProcessFile(tmp_path / folder)
    running.write({"machine_port": "socket://localhost:2217", "port": 9, "token": ""})
    assert find("socket://127.0.0.1:2217", tmp_path) == tmp_path / folder
    assert find("socket://127.0.0.1:2218", tmp_path) is None
    identity = PortIdentity(frozenset(["/dev/ttyUSB0"]), None, "1a86:7523", "AB12CD34:1.0").to_json()
    running.remove()
    running = ProcessFile(tmp_path / folder)
    running.write({"machine_port": "/dev/ttyUSB0", "port_identity": identity})
    plugged[:] = [usb("/dev/ttyUSB3", "AB12CD34", "1-1:1.0")]
    assert find("/dev/ttyUSB3", tmp_path) == tmp_path / folder
    running.remove()


# --- real processes ------------------------------------------------------------------------------


def send(folder, port: str, lines=("G1X1F600", "G1X2")) -> SessionClient:
    return SessionClient.start(SendJob(port, list(lines), zero_confirmed=True), python=sys.executable, folder=folder)


@pytest.mark.slow
def test_what_one_name_has_lost_is_refused_at_another_name(tmp_path):
    with FakeServer() as server:
        server.controller.on_line = {0: "ALARM:1"}
        assert send(tmp_path, server.url).wait(limit_s=20).position_known is False
        server.controller.state, server.controller.on_line = "Idle", {}
        other = server.url.replace("127.0.0.1", "LocalHost") + "/"
        outcome = send(tmp_path, other).wait(limit_s=20)
        assert outcome.kind == REFUSED and outcome.error.code == "position-unknown"
        kept(tmp_path, server.url.replace("127.0.0.1", "[::1]")).keep(AT_HOME)
        assert send(tmp_path, server.url).wait(limit_s=20).kind == DONE


@pytest.mark.slow
def test_a_job_is_found_and_held_under_another_name_of_its_port(tmp_path):
    with FakeServer() as server:
        client = send(tmp_path, server.url, ["G1X1F600", "M0", "G1X2"])
        other = server.url.replace("127.0.0.1", "localhost")
        try:
            with pytest.raises(MachineRefusal, match="held by a job of yours"):
                check_free(other, tmp_path)
            with SessionClient.attach(session_at(other, tmp_path)) as second:
                second.stop()
                second.wait(limit_s=20)
        finally:
            client._process.terminate()
            client._process.wait()


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="pseudo-terminals")
def test_a_machine_that_is_lost_at_its_link_is_lost_at_its_device(tmp_path):
    link = tmp_path / "table ç"
    words = ["-m", "CNCStepper.cli", "virtual", "grbl", "--pty", str(link), "--speed", "5"]
    with subprocess.Popen([sys.executable, *words], stdout=subprocess.DEVNULL) as machine:
        try:
            end_s = time.monotonic() + 60
            while not link.exists() and time.monotonic() < end_s:
                time.sleep(0.05)
            kept(tmp_path, os.path.relpath(link)).keep(LOST)
            outcome = send(tmp_path, os.path.realpath(link)).wait(limit_s=30)
            assert outcome.kind == REFUSED and outcome.error.code == "position-unknown"
            kept(tmp_path, os.path.realpath(link)).keep(AT_HOME)
            assert send(tmp_path, str(link)).wait(limit_s=30).kind == DONE
        finally:
            machine.terminate()
