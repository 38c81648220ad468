# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every way to a first move of a machine whose position is lost asks the same question, by whatever way it comes."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import pytest

import CNCStepper
from CNCStepper.control.operator.hardware_buttons import COMMANDS
from CNCStepper.control.protocol.grbl.driver import HOLD, RESUME
from CNCStepper.control.protocol.grbl.driver import Grbl as Driver
from CNCStepper.control.protocol.grbl.motion_interlock import UNKNOWN, MotionInterlock, moves
from CNCStepper.control.service.connection_service import ConnectionService
from CNCStepper.control.service.position_trust_file import PositionTrustFile
from CNCStepper.control.session.status import DONE
from CNCStepper.control.stream.position_trust import LOST
from CNCStepper.errors import MachineRefusal
from CNCStepper.machine.profile import load_machine
from CNCStepper.virtual.grbl.machine import Grbl
from helpers.control.service_bench import Person, Visit

STEP = {"x_mm": -1.0, "y_mm": 0.0, "z_mm": 0.0, "feed_mm_min": 3000.0}
ASKS, JOGS, STAYS = "asks for the position", "moves by a jog or by homing", "does not move"


class Way(NamedTuple):
    """One command with its values; held: a motion that an earlier sender began waits at the controller."""

    command: str
    values: dict[str, Any]
    does: str
    held: bool = False


WAYS = (
    Way("run", {"file": "", "zero_confirmed": True, "allow_differences": False}, ASKS),  # send, restart, unfinished job
    Way("run", {"file": "", "zero_confirmed": True, "allow_differences": True}, ASKS),
    Way("send", {"file": "", "zero_confirmed": True, "allow_differences": False}, ASKS),  # of a terminal
    Way("again", {}, ASKS),  # the start button of the machine
    Way("resume", {"stand": None}, ASKS, held=True),
    Way("line", {"text": "G0 X-6"}, ASKS),
    Way("line", {"text": "X-6"}, ASKS),  # by the modes that are in force
    Way("line", {"text": "$J=G90 G21 X-6 F1000"}, ASKS),
    Way("line", {"text": "$J=X-6F1000"}, ASKS),
    Way("line", {"text": "$J=G91 G53 X-6 F1000"}, ASKS),
    Way("line", {"text": "G28"}, ASKS),
    Way("line", {"text": "G38.2 Z-5 F50"}, ASKS),
    Way("switch", {"line": "G0X-6"}, ASKS),  # a button's line that is none
    Way("line", {"text": "$J=G91 G21 X-1 F1000"}, JOGS),
    Way("jog", STEP, JOGS),
    Way("jog_on", STEP | {"press": "one"}, JOGS),
    Way("home", {}, JOGS),
    Way("line", {"text": "$H"}, JOGS),
    Way("line", {"text": "$$"}, STAYS),
    Way("switch", {"line": "M8"}, STAYS),
    Way("hold", {}, STAYS),
    Way("stop", {}, STAYS, held=True),
    Way("jog_cancel", {}, STAYS),
    Way("set_zero", {"axes": "X"}, STAYS),
    Way("unlock", {}, STAYS),
    Way("override", {"kind": "feed", "step": "10"}, STAYS),
    Way("by_line", {"on": True}, STAYS),  # these need a job that runs, and so a position that is known
    Way("tell_place", {"file": "place.json"}, STAYS),
    Way("retrace", {"file": "leg.json"}, STAYS),
    Way("want_back", {"distance_mm": 1.0}, STAYS),
    Way("end", {}, STAYS),
    Way("disconnect", {}, STAYS),
)


def names(ways: tuple[Way, ...]) -> list[str]:
    return [f"{way.command} {' '.join(map(str, way.values.values()))}".strip() for way in ways]


def lost(folder: Path, board: Grbl) -> Visit:
    """Return a visit to a machine whose position was lost in an earlier connection."""
    kept = PositionTrustFile(folder / "table.position")
    kept.keep(LOST)
    return Visit(folder, kept=kept, board=board)


def table(homing: bool) -> Grbl:
    board = Grbl(load_machine("table-a"), homing=homing)
    board.advance(0.1)
    if homing:
        board.receive(b"$X\n")
        board.advance(0.1)
    board.take_output()
    return board


def begun_and_held(board: Grbl) -> None:
    """Let an earlier sender have begun a motion that is held now."""
    board.receive(b"G1X-20F1000\n")
    board.advance(0.2)
    board.receive(HOLD)
    board.advance(1.0)
    board.take_output()


def taken(visit: Visit, way: Way) -> Iterator[Any]:
    """Ask for a way, and wait a while."""
    if way.command in ("run", "send"):
        visit.job("G21G90G54", "G1X-4Y-3F1000", zeroed=False, command=way.command)
    elif way.command == "again":
        yield from done_and_restarted(visit)
        visit.ask("again")
    else:
        visit.ask(way.command, **way.values)
    yield 0.5


def done_and_restarted(visit: Visit) -> Person:
    """Cut a job, which the start button would cut again, then let the controller restart."""
    visit.job("G21G90G54", "G1X-4F3000")
    yield visit.ended()
    visit.table.board.power_up()
    yield lambda: visit.service.status().position_known is False
    yield 0.5


@pytest.mark.parametrize("way", WAYS, ids=names(WAYS))
def test_each_way_asks_for_the_position_or_does_not_need_it(tmp_path, way):
    board = table(homing="$H" in way.values.values() or way.command == "home")
    if way.held:
        begun_and_held(board)
    visit = lost(tmp_path, board)
    moved: list[bool] = []

    def person() -> Person:
        written = len(visit.table.written)
        asked = taken(visit, way)
        if way.command == "again":
            yield from asked
            moved.append(visit.table.board.axes.position_mm[0] != 0)  # the restart counts from here
            return
        before = tuple(board.axes.position_mm)
        yield from asked
        moved.append(tuple(board.axes.position_mm) != before)
        sent = b"".join(data for _, data in visit.table.written[written:])
        assert way.does != ASKS or (RESUME not in sent and b"X-" not in sent and b"G28" not in sent), sent

    visit.receive(person)
    asked = [*visit.refusals(), *(outcome.error.code for outcome in visit.outcomes if outcome.error)]
    assert (UNKNOWN in asked) == (way.does == ASKS), (asked, visit.refused, visit.outcomes)
    if way.command == "disconnect":  # the service ends before anybody looks
        moved.append(any(board.axes.position_mm))
    assert moved == [way.does == JOGS]


def test_the_table_names_every_command_that_a_service_takes(tmp_path):
    visit = lost(tmp_path, table(homing=False))
    seen: list[str] = []

    def person() -> Person:
        seen.extend(visit.service._idle._does)
        yield 0.0

    visit.receive(person)
    buttons = {command.name for command in COMMANDS.values()}
    assert {way.command for way in WAYS} == {*ConnectionService.commands, *seen, *buttons, "again"}


def test_the_service_lets_all_of_it_go_when_the_zero_is_set(tmp_path):
    visit = lost(tmp_path, table(homing=False))

    def person() -> Person:
        visit.ask("set_zero", axes="XYZ")
        yield lambda: visit.service.status().position_known is True
        visit.job("G21G90G54", "G1X-4Y-3F1000")
        yield visit.ended()
        visit.ask("line", text="G0 X-6")
        yield lambda: ("answer", "ok") in visit.told

    visit.receive(person)
    assert visit.outcomes[0].kind == DONE and not visit.refused


def test_no_module_but_the_driver_writes_to_a_controllers_link():
    """What goes past the driver goes past the interlock."""
    root = Path(CNCStepper.__file__).parent
    writers = [path.relative_to(root).as_posix() for path in root.rglob("*.py") if writes_to_link(path)]
    assert writers == ["control/protocol/grbl/driver.py"]


def writes_to_link(path: Path) -> bool:
    """Return whether a module calls `write` of something that is named a link."""
    source = path.read_text("utf-8")
    if "link" not in source or ".write(" not in source:
        return False
    calls = (node.func for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Call))
    written = (call.value for call in calls if isinstance(call, ast.Attribute) and call.attr == "write")
    return any(getattr(value, "attr", getattr(value, "id", "")).strip("_") == "link" for value in written)


def test_a_driver_to_which_nobody_has_told_the_position_moves_nothing():
    sent: list[bytes] = []

    class Port:
        def write(self, data: bytes) -> None:
            sent.append(data)

    driver = Driver(Port())
    for send in (lambda: driver.send("G0X1"), lambda: driver.realtime(RESUME)):
        with pytest.raises(MachineRefusal) as refused:
            send()
        assert refused.value.code == UNKNOWN and "set the zero of all axes" in refused.value.advice
    driver.realtime(b"!")
    assert sent == [b"!"] and not driver.unanswered


def test_the_interlock_holds_from_the_moment_of_the_loss():
    is_lost = False
    interlock = MotionInterlock(lambda: is_lost)
    interlock.check_line("G0X1")
    is_lost = True
    with pytest.raises(MachineRefusal):
        interlock.check_line("G0X1")


@pytest.mark.parametrize(
    "line",
    ["$", "$$", "$#", "$H", "$X", "$110=500", "$J=G91G21X1.5Y-.5F100", "$j=g91 x1", "G10L20P1X0Y0Z0", "M3S1000", "M5",
     "G4P0.5", "M8", "N10M9", "", "$Report/Inches"],
)  # fmt: skip
def test_lines_that_move_to_no_place_pass(line):
    assert not moves(line)


@pytest.mark.parametrize(
    "line",
    ["x1", "G1 Z-1 F100", "G2X1I1", "G28", "G30", "G53G0Z0", "G38.2Z-1F10", "M3S1000X5", "G4P1X1", "G91", "T1M6",
     "$J=G90X1F100", "$J=X1F100", "$J=G91.1X1F100", "$J=G91G53X1F100", "$J=G91G90X1F100", "G10L2P1X5", "%", "M30"],
)  # fmt: skip
def test_any_other_line_counts_as_a_move(line):
    assert moves(line)
