# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a job stands no beam and no torch is on, by the virtual machine's own trace, and the cut after it is exact."""

from __future__ import annotations

import pytest

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.session.status import DONE, FAILED
from CNCStepper.control.stream.feeder import Feeder
from CNCStepper.control.stream.journal_protocol import NoJournal
from CNCStepper.control.stream.tool_power import ToolPower
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.virtual.grbl.firmware import GRBLHAL
from CNCStepper.virtual.grbl.states import State
from helpers.control.service_bench import Visit

LASER = {32: 1.0}
TURN_S = 0.02  # from a line that switches on to the move behind it
CUT = ("G21G90G94", "M3S9000", "G1X-5F1500", "M0", "G1X-10", "S4000", "G1X-15", "G0X-16", "M5", "M2")


class Trace:
    """What the tool's power was at each moment: (state, x in mm, rpm, s)."""

    def __init__(self, visit: Visit):
        self.moments: list[tuple[State, float, float, float]] = []
        self._last_s = 0.0
        self._visit = visit
        visit.table.board.on_step = self._note

    def _note(self, board) -> None:
        moment = board.state, board.axes.position_mm[0], board.spindle.rpm, board.time_s - self._last_s
        self.moments.append(moment)
        self._last_s = board.time_s

    def standing_s(self) -> float:
        """How long the power was on while the machine did not cut."""
        return sum(s for state, _, rpm, s in self.moments if rpm and state is not State.RUN)

    def on_way(self, begin_mm: float, end_mm: float) -> set[float]:
        """The powers on a stretch of the cut, its ends left out."""
        return {rpm for state, x, rpm, _ in self.moments if state is State.RUN and end_mm + 0.1 < x < begin_mm - 0.1}


def machine_with(**changes) -> Machine:
    machine = load_machine("table-a")
    retreat = machine.retreat.model_copy(update={"outputs": changes.get("outputs")})
    spindle = machine.spindle.model_copy(update={"laser": changes.get("laser", False), "spin_up_s": 1.0})
    return machine.model_copy(update={"retreat": retreat, "spindle": spindle})


def place(visit: Visit) -> tuple[str, int]:
    return visit.phase, visit.service.status().sent


def run(visit: Visit, *lines: str, jogs: bool = True, **job) -> Trace:
    """Cut lines, and jog away at each stand."""
    trace, stands = Trace(visit), []

    def person():
        visit.job(*lines, **job)
        while True:
            yield lambda: visit.phase == "paused" or len(visit.outcomes) == 1
            if visit.outcomes:
                return
            stands.append(visit.table.board.spindle.rpm)
            if jogs:
                visit.ask("jog", x_mm=2.0, z_mm=1.0)
                yield lambda: visit.table.board.state is State.JOG
                yield lambda: visit.service.status().machine_state in ("Idle", "Tool")
            here = place(visit)
            visit.ask("resume")
            yield lambda here=here: place(visit) != here

    visit.receive(person)
    trace.stands = stands
    return trace


def wire(visit: Visit) -> list[str]:
    return b"".join(data for _, data in visit.table.written if data.endswith(b"\n")).decode("ascii").split("\n")


# --- a beam -----------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("word", ["M3", "M4"])
def test_beam_is_off_at_a_pause_and_cuts_on_with_its_power(tmp_path, word):
    visit = Visit(tmp_path, settings=LASER)
    trace = run(visit, *(line.replace("M3", word) for line in CUT))
    assert visit.outcomes[0].kind == DONE and visit.refused == []
    assert trace.stands == [0.0] and trace.standing_s() < TURN_S
    assert trace.on_way(0, -5) == trace.on_way(-5, -10) == {9000.0} and trace.on_way(-10, -15) == {4000.0}
    assert visit.table.x_mm() == pytest.approx(-16, abs=0.02)


def test_beam_is_off_before_each_line_of_a_job_that_is_stepped(tmp_path):
    visit = Visit(tmp_path, settings=LASER)
    trace = run(visit, *CUT, jogs=False, by_line=True)
    assert visit.outcomes[0].kind == DONE
    assert len(trace.stands) == len(CUT) and not any(trace.stands) and trace.standing_s() < 4 * TURN_S
    assert trace.on_way(0, -5) == trace.on_way(-5, -10) == {9000.0} and trace.on_way(-10, -15) == {4000.0}


@pytest.mark.slow
def test_beam_that_the_program_switches_itself_is_not_switched_on_before(tmp_path):
    visit = Visit(tmp_path, settings=LASER)
    run(visit, "G21G90G94", "M3S9000", "G1X-2F1500", "M0", "M0", "M5", "M3S700", "G1X-3", "M2")
    sent = wire(visit)
    assert visit.outcomes[0].kind == DONE
    assert [line for line in sent if line.startswith("M")] == ["M3S9000", "M5", "M5", "M3S700", "M2"]


def test_power_that_cannot_be_switched_ends_the_job(tmp_path):
    visit = Visit(tmp_path, settings=LASER)
    write = visit.table.write
    visit.table.write = lambda data: write(data.replace(b"M5\n", b"M99\n"))
    run(visit, *CUT)
    assert visit.outcomes[0].kind == FAILED and visit.outcomes[0].error.code == "power-refused"


# --- a torch, a spindle -----------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize(("outputs", "laser"), [("off", False), (None, True), ("keep", True)])
def test_profile_says_that_a_tool_cuts_standing(tmp_path, outputs, laser):
    visit = Visit(tmp_path)
    profile = machine_with(outputs=outputs, laser=laser).model_dump(mode="json")
    trace = run(visit, *CUT, retrace={"machine": profile})
    sent = wire(visit)
    assert visit.outcomes[0].kind == DONE and trace.stands == [0.0]
    on = sent.index("M3S9000", sent.index("M5"))
    assert sent[on + 1] == ("G1X-10" if laser else "G4P1")  # a torch pierces


@pytest.mark.slow
def test_spindle_goes_on_turning_at_a_pause(tmp_path):
    visit = Visit(tmp_path)
    trace = run(visit, *CUT, retrace={"machine": machine_with().model_dump(mode="json")})
    assert visit.outcomes[0].kind == DONE and trace.stands == [9000.0]
    assert wire(visit).count("M5") == 1


@pytest.mark.slow
def test_spindle_is_stopped_for_a_new_tool_and_waited_for_behind_it(tmp_path):
    visit = Visit(tmp_path, firmware=GRBLHAL)
    lines = ("G21G90G94", "M3S9000", "G1X-5F1500", "T2M6", "G1X-10", "M2")
    trace = run(visit, *lines, retrace={"machine": machine_with().model_dump(mode="json")})
    sent = wire(visit)
    assert visit.outcomes[0].kind == DONE and trace.stands == [0.0]
    assert sent.index("M5") == sent.index("T2M6") - 1
    assert trace.on_way(-5, -10) == {9000.0} and "G4P1" in sent


# --- what is followed -------------------------------------------------------------------------------


class Room:
    """A controller with room for so many lines."""

    unanswered = ()

    def __init__(self, lines: int = 9):
        self.lines = lines
        self.sent: list[str] = []

    def fits(self, text: str) -> bool:
        return len(self.sent) < self.lines

    def send(self, text: str, index: int = -1) -> None:
        self.sent.append(text)

    def flush(self) -> None:
        """Nothing waits."""


@pytest.mark.parametrize(
    ("modes", "lines", "on"),
    [
        ("", ["M03 S500"], "M3S500"),
        ("", ["s20", "N5 m4"], "M4S20"),
        ("G1 M3 S800. M9", [], "M3S800."),
        ("", ["M3S1", "M30"], None),
        ("", ["M3S1", "M5"], None),
        ("", ["M3S1", "M7", "M60", "G1X1S2"], "M3S2"),
    ],
)
def test_last_words_of_the_program_are_what_is_on(modes, lines, on):
    power, room = ToolPower(True, 0.0, modes), Room()
    for line in lines:
        power.follow(line)
    power.stand(room)
    power.stand(room)
    assert room.sent == (["M5"] if on else [])
    power.give_back(room, "G1X5")
    assert room.sent == (["M5", on] if on else [])


def test_power_is_taken_once_there_is_room():
    power, room = ToolPower(True, 0.0, "M3"), Room(0)
    power.stand(room)
    assert not power.is_taken
    room.lines = 1
    power.stand(room)
    assert power.is_taken and room.sent == ["M5"]


def test_power_is_taken_where_the_next_line_is_not_permitted_yet():
    journal = NoJournal()
    feeder, room = Feeder(SendJob("fake", ("G1X1", "M0", "G1X2")), journal), Room()
    feeder.power, journal.permitted = ToolPower(True, 0.0, "M3"), 1
    assert feeder.feed(room, idle=True) == 1
    assert room.sent == ["G1X1", "M5"]
