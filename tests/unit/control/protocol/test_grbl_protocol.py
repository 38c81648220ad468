# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of grbl 1.1, the checks on lines, the codes, and the opening of ports."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
import threading
import time

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from CNCStepper.control.program.wire_line import (
    check_length,
    check_line,
    dwell_s,
    is_move,
    is_plain,
    needs_idle,
    pauses,
    stores,
)
from CNCStepper.control.protocol.grbl.firmware import GRBL
from CNCStepper.control.protocol.grbl.readiness import check_offsets, offset_differences
from CNCStepper.control.protocol.grbl.settings import differences
from CNCStepper.control.protocol.grbl.status_reports import (
    Alarm,
    Answer,
    Damaged,
    Feedback,
    Greeting,
    Setting,
    StartupLine,
    Status,
    Unknown,
    parse,
)
from CNCStepper.control.session.status import error_from_json, error_to_json
from CNCStepper.control.transport.link import Link, open_link, port_names
from CNCStepper.errors import LinkError, MachineRefusal, Place, ProgramError


@pytest.mark.parametrize(
    ("line", "report"),
    [
        ("ok", Answer()),
        ("error:20", Answer(20, "error:20")),
        ("error: Bad number format", Answer(-1, "error: Bad number format")),
        ("ALARM:2", Alarm(2)),
        ("[MSG:Pgm End]", Feedback("MSG", "Pgm End")),
        ("[MSG:'$H'|'$X' to unlock]", Feedback("MSG", "'$H'|'$X' to unlock")),
        ("[G54:-1.000,2.000,3.000]", Feedback("G54", "-1.000,2.000,3.000")),
        ("[GC:G0 G54 G17]", Feedback("GC", "G0 G54 G17")),
        ("$110=5000.000", Setting(110, 5000.0)),
        ("$13=0 (report inches, bool)", Setting(13, 0.0)),
        (">G54G20:ok", StartupLine("G54G20:ok")),
        ("Grbl 1.1h ['$' for help]", Greeting("Grbl 1.1h ['$' for help]", "1.1h")),
        ("GrblHAL 1.1f ['$' or '$HELP' for help]", Greeting("GrblHAL 1.1f ['$' or '$HELP' for help]", "1.1f")),
        ("okok", Unknown("okok")),
        ("rbl 1.1h", Unknown("rbl 1.1h")),
        ("<Idle|MPos:1,2", Damaged("<Idle|MPos:1,2")),
        ("<Idle|MPos:1,x,3>", Damaged("<Idle|MPos:1,x,3>")),
        ("<Idle|MPos:nan,1,3>", Damaged("<Idle|MPos:nan,1,3>")),
        ("<>", Damaged("<>")),
        ("<", Damaged("<")),
        ("$x=1", Unknown("$x=1")),
        ("$5=1.2.3", Unknown("$5=1.2.3")),
    ],
)
def test_every_kind_of_line_is_told_apart(line, report):
    assert parse(line) == report


FIELDS = {
    "MPos:1.000,-2.500,3.000": ("mpos", (1.0, -2.5, 3.0)),
    "Bf:15,128": ("buffer", (15, 128)),
    "FS:500,8000": ("feed", 500.0),
    "WCO:0.000,1.000,2.000": ("wco", (0.0, 1.0, 2.0)),
    "Ov:100,50,110": ("overrides", (100, 50, 110)),
    "Pn:XYZ": ("pins", "XYZ"),
    "Ln:17": None,
    "A:SFM": None,
    "Later:1|2": None,
}


@given(st.permutations(list(FIELDS)), st.sampled_from(["Idle", "Run", "Hold:0", "Door:3"]))
def test_fields_of_a_status_come_in_any_order(order, state):
    status = parse("<" + "|".join([state, *order]) + ">")
    assert isinstance(status, Status) and status.name == state
    for expected in filter(None, FIELDS.values()):
        assert getattr(status, expected[0]) == expected[1]


@settings(max_examples=50)
@given(st.text(max_size=40))
def test_no_line_breaks_the_parser(text):
    parse(text)
    parse("<" + text + ">")


@pytest.mark.parametrize(
    "line", ["$100=80", "$I=name", "$N0=G54", "$RST=*", "G10L20P1X0", "g10 l2 p1 x1", "G28.1", "N5G30.1"]
)
def test_lines_that_write_permanent_memory_are_known(line):
    assert stores(line)


@pytest.mark.parametrize("line", ["$J=G91X1F100", "$$", "G28", "G30X0", "G1X10", "G100", "M10", "G92X0", "G43.1Z1"])
def test_lines_that_do_not_write_are_not_sent_alone(line):
    assert not stores(line)


@pytest.mark.parametrize("line", ["X1.5", "G1X-3Y.5F600", "G00Z5", "G2X1Y1I.5J0", "N10G3X0R4", "Y-12.345"])
def test_moves_are_known_at_once(line):
    assert is_move(line)


@pytest.mark.parametrize(
    "line", ["M0", "X1M0", "$H", "G28.1", "G30", "G10L20P1X0", "G0X1M6", "G4P1", "G1X1G28.1", "M3S100"]
)
def test_no_line_that_may_have_to_be_waited_for_is_a_mere_move(line):
    assert not is_move(line)


@given(
    st.lists(st.sampled_from(["G0", "G1", "G10", "G28.1", "G2", "8.1", "M0", "M6", "$", "X1", "Y-2.", "P1", "N3", "0"]))
)
def test_a_mere_move_neither_pauses_nor_stores_nor_waits(words):
    line = "".join(words)
    assert not is_move(line) or not (pauses(line) or stores(line) or needs_idle(line))


def test_pauses_dwells_and_system_lines_are_known():
    assert pauses("M0") and pauses("G0X0 M00") and not pauses("M03") and not pauses("M30")
    assert dwell_s("G4P2.5") == dwell_s("g04 p2.5") == 2.5
    assert dwell_s("G43.1P2") == dwell_s("G4") == dwell_s("G4P.") == dwell_s("G1X4") == 0.0
    assert needs_idle("$H") and needs_idle("$100=80") and not needs_idle("G0X0")


@given(st.text(alphabet=st.characters(max_codepoint=0x2FF), max_size=10))
def test_only_bytes_that_do_not_act_pass(text):
    harmless = all(" " <= character <= "}" and character not in "!?" for character in text)
    if harmless:
        check_line(text)
    else:
        with pytest.raises(ProgramError, match="act"):
            check_line(text)


@given(text=st.text(st.characters(max_codepoint=300), max_size=90))
def test_plain_lines_are_those_that_need_no_further_check(text):
    try:
        check_line(text)
    except ProgramError:
        assert not is_plain(text)


@pytest.mark.parametrize("byte", [*range(32), *b"!?~", *range(127, 256)])
def test_no_byte_that_acts_is_plain(byte):
    assert not is_plain(f"G1X1{chr(byte)}")


def test_line_check_names_place_and_column_and_the_limit():
    with pytest.raises(ProgramError, match=r"a\.nc:7:5"):
        check_line("G1X1!", Place("a.nc", 7))
    check_length("X" * 79, GRBL, 127)
    with pytest.raises(ProgramError, match="79"):
        check_length("X" * 80, GRBL, 127, Place("a.nc", 7))
    with pytest.raises(ProgramError, match="126"):
        check_length("G1" + " " * 125, GRBL, 127)


def test_settings_are_compared_to_the_printed_digits():
    assert differences({100: 80.0004, 110: 5000}, {100: 80, 110: 5000, 120: 250}) == []
    assert str(differences({100: 80.001}, {100: 80})[0]) == "$100 is 80.001, wanted 80"


def test_error_survives_its_way_through_json():
    error = LinkError("c", "what", advice="do", value="1 s", limit="2 s", place=Place("f", 3, 4))
    again = error_from_json(error_to_json(error))
    assert type(again) is LinkError and str(again) == str(error)


@pytest.mark.parametrize(
    ("name", "code"),
    [
        ("/dev/ttyNOTTHERE", "port-missing"),
        ("socket://127.0.0.1:1", "port-silent"),
        ("socket://nowhere", "port-name"),
        ("socket://", "port-name"),
        ("rfc2217://127.0.0.1:1", "port-silent"),
        ("gopher://x", "port-name"),
        ("", "port-missing"),
        (os.devnull, "port-unusable"),
    ],
)
def test_port_that_cannot_be_opened_is_refused_with_advice(name, code):
    with pytest.raises(LinkError) as refusal:
        open_link(name)
    assert refusal.value.code == code and refusal.value.advice


def test_port_without_the_right_to_it_says_how_to_get_it(monkeypatch):
    import serial

    def forbidden(*arguments, **options):
        raise serial.SerialException(13, "could not open port")

    monkeypatch.setattr(serial, "serial_for_url", forbidden)
    with pytest.raises(LinkError, match="dialout" if sys.platform.startswith("linux") else "right") as refusal:
        open_link("/dev/ttyUSB0")
    assert refusal.value.code == "port-forbidden"


def test_port_in_use_is_refused():
    import pty

    _, second = pty.openpty()
    name = os.ttyname(second)
    link = open_link(name)
    try:
        with pytest.raises(LinkError, match="in use"):
            open_link(name)
    finally:
        link.close()


def test_closed_terminal_is_a_lost_link():
    import pty

    first, second = pty.openpty()
    link = open_link(os.ttyname(second))
    os.close(second)
    os.write(first, b"ok\r\n")
    assert link.read(1.0) == b"ok\r\n"
    os.close(first)
    with pytest.raises(LinkError, match="broke"):
        link.read(1.0)
    link.close()


def test_closed_connection_is_a_lost_link():
    with socket.create_server(("127.0.0.1", 0)) as listener:
        link = open_link(f"socket://127.0.0.1:{listener.getsockname()[1]}")
        listener.accept()[0].close()
        with pytest.raises(LinkError, match="broke"):
            link.read(1.0)
        link.close()


@pytest.mark.parametrize("make", ["loop", "socket"])
def test_wake_ends_a_read_at_once(make):
    with socket.create_server(("127.0.0.1", 0)) as listener:
        link = open_link("loop://" if make == "loop" else f"socket://127.0.0.1:{listener.getsockname()[1]}")
        threading.Timer(0.05, link.wake).start()
        begin_s = time.monotonic()
        assert link.read(5.0) == b""
        assert time.monotonic() - begin_s < 1.0
        link.close()


def test_loop_gives_back_what_is_written():
    link = open_link("loop://")
    link.write(b"?")
    assert link.read(1.0) == b"?"
    assert link.read(0.01) == b""
    link.close()
    link.wake()


def test_write_that_is_cut_short_is_a_lost_link():
    class Short:
        def write(self, data: bytes) -> int:
            return len(data) - 1

        def close(self) -> None:
            pass

    link = Link(Short(), "short")
    with pytest.raises(LinkError, match="only 1 of 2"):
        link.write(b"ab")
    link.close()


def test_ports_are_listed():
    assert all(isinstance(device, str) for device, _ in port_names())


def test_room_imports_without_unix_modules_and_without_heavy_packages():
    script = (
        "import sys\n"
        "blocked = 'pty tty termios fcntl FreeCAD numpy pydantic serial'\n"
        "sys.modules.update(dict.fromkeys(blocked.split()))\n"
        "import CNCStepper.workers.sender, CNCStepper.control.session.client\n"
    )
    subprocess.run([sys.executable, "-c", script], check=True)


def test_offsets_are_compared_to_the_printed_digits():
    offsets = {"G54": (-200.0, -150.0, -40.0), "G92": (0.0, 0.0, 0.0)}
    modes = "G0 G54 G17 G21"
    assert not offset_differences(offsets, modes, {"G54": (-200.0004, -150, -40), "G92": (0, 0, 0)}, "G54")
    assert not offset_differences({}, "", {"G54": (1, 2, 3)}, "G54")
    found = offset_differences(offsets, modes, {"G54": (-200, -150, -40.01)}, "G55")
    assert found == [
        "G55 is not the work system in force",
        "G54 is -200.000,-150.000,-40.000, wanted -200.000,-150.000,-40.010 mm",
    ]
    with pytest.raises(MachineRefusal, match="not where the program was proven: G55"):
        check_offsets(found)
