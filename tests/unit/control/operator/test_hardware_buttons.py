# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine's own buttons: from pins to commands, and a virtual table that is worked from them alone.

The debouncer: what bounces, what was held at the begin, and that nothing steady is lost.
"""

from __future__ import annotations

import threading
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from CNCStepper.control.operator.hardware_buttons import POLL_S, Buttons, Debouncer, buttons_of, quicker
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl.status_reports import Greeting, parse
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.control.service.sender import Sender
from CNCStepper.control.session.command import Command
from CNCStepper.control.session.status import DONE, STOPPED
from CNCStepper.errors import JobError, LinkError
from CNCStepper.machine.wiring import BOARDS_ACTS, Act, Input
from helpers.control.fake_controller import FakeClock, FakeController, FakeLink
from helpers.control.service_bench import Visit

LIMIT_S = 20.0
LINE = ("G21G90G94", "G1X-20F1500")
TAP_S = 0.4


def inputs(*told: dict) -> list[dict]:
    """Return the buttons of a profile as a job carries them."""
    return [Input.model_validate(entry).model_dump(mode="json") for entry in told]


PANEL = inputs(
    {"pin": "P", "act": "pause"},
    {"pin": "X", "act": "start"},
    {"pin": "Y", "act": "stop"},
    {"pin": "Z", "act": "flood"},
)


class Ear:
    """Buttons, and what they ask and tell, looked at every 10 ms."""

    def __init__(self, *told: dict, **options):
        self.clock = FakeClock()
        self.asked: list[Command] = []
        self.told: list[tuple[str, str]] = []
        self.buttons = Buttons(self.asked.append, lambda *words: self.told.append(words), self.clock, **options)
        self.buttons.wire(buttons_of(inputs(*told)))

    def show(self, pins: str, seconds: float = 0.1) -> None:
        status = parse(f"<Run|MPos:0.000,0.000,0.000|FS:0,0{'|Pn:' + pins if pins else ''}>")
        for _ in range(round(seconds / 0.01)):
            self.clock.now_s += 0.01
            self.buttons.on_message([status])

    def names(self) -> list[str]:
        return [command.name for command in self.asked]


# --- from pins to commands -------------------------------------------------------------------------


def test_every_act_of_a_profile_asks_for_something():
    for act in set(Act.__args__) - set(BOARDS_ACTS):
        line = {"line": "M8"} if act == "switch" else {}
        (button,) = buttons_of(inputs({"pin": "P", "act": act, **line}))
        assert button.command(pressed=True) is not None and button.command(pressed=False) is None


def test_press_asks_once_and_is_told():
    ear = Ear({"pin": "P", "act": "pause"})
    ear.show("")
    ear.show("P", seconds=2.0)
    ear.show("")
    assert ear.names() == ["hold"] and ear.told == [("message", "pause by the button on pin P")]


def test_pins_do_not_disturb_each_other():
    ear = Ear({"pin": "P", "act": "pause"}, {"pin": "X", "act": "stop"}, {"pin": "S", "act": "start"})
    for pins in ("", "P", "PX", "X", "", "S"):
        ear.show(pins)
    assert ear.names() == ["hold", "stop", "resume"]


def test_contact_that_opens_when_pressed():
    ear = Ear({"pin": "P", "act": "pause", "level": "low"})
    ear.show("P")
    assert ear.names() == []
    ear.show("")
    assert ear.names() == ["hold"]


def test_button_held_at_connection_does_nothing_until_released():
    ear = Ear({"pin": "P", "act": "pause"})
    ear.show("P", seconds=3.0)
    assert ear.names() == []
    ear.show("")
    ear.show("P")
    assert ear.names() == ["hold"]


def test_button_held_while_the_controller_restarts_does_nothing():
    ear = Ear({"pin": "P", "act": "start"})
    ear.show("")
    ear.buttons.on_message([Greeting("Grbl 1.1h", "1.1h")])
    ear.show("P", seconds=1.0)
    assert ear.names() == []


def test_switch_follows_its_contact():
    ear = Ear({"pin": "X", "act": "switch", "line": "M64P0", "release_line": "M65P0"})
    ear.show("")
    ear.show("X")
    ear.show("")
    assert [command.values["line"] for command in ear.asked] == ["M64P0", "M65P0"]


def test_button_back_wants_its_own_distance():
    ear = Ear({"pin": "P", "act": "back", "back_mm": 2.5})
    ear.show("")
    ear.show("P")
    assert [(command.name, dict(command.values)) for command in ear.asked] == [("want_back", {"distance_mm": 2.5})]


def test_same_buttons_again_are_not_learnt_anew():
    ear = Ear({"pin": "P", "act": "pause"})
    ear.show("")
    ear.buttons.wire(buttons_of(inputs({"pin": "P", "act": "pause"})))
    ear.show("P")
    assert ear.names() == ["hold"]


@pytest.mark.parametrize("content", [{"pin": "P"}, {"pin": "P", "act": "fly"}, {"pin": "P", "act": "stop", "x": 1}])
def test_buttons_of_a_forged_job_are_refused(content):
    with pytest.raises(JobError):
        buttons_of([content])


# --- a port of its own -----------------------------------------------------------------------------


class Pins:
    """A port whose pins a test sets; None: it is gone."""

    def __init__(self):
        self.on: set[int] | None = set()
        self.looks = threading.Semaphore(0)

    def high(self):
        self.looks.release()
        if self.on is None:
            raise LinkError("input-port", "it is gone")
        return frozenset(self.on)

    def show(self, *on: int) -> None:
        self.on = set(on)
        self.look(3)

    def look(self, times: int) -> None:
        while self.looks.acquire(blocking=False):
            pass
        for _ in range(times):
            assert self.looks.acquire(timeout=LIMIT_S)


def test_pins_of_a_port_ask_the_same_and_a_lost_port_holds():
    pins, lost = Pins(), threading.Event()
    told = [{"pin": 11, "port": "/dev/parport0", "act": act, "debounce_ms": 0} for act in ("pause",)]
    ear = Ear(*told, opener=lambda port: pins)
    pins.look(2)
    pins.show(11)
    pins.show()
    ear.buttons._ask = lambda command: (ear.asked.append(command), lost.set())
    pins.on = None
    assert lost.wait(LIMIT_S)
    ear.buttons.close()
    assert ear.names() == ["hold", "hold"]
    assert ear.told[0] == ("message", "pause by the button on pin 11 of /dev/parport0")
    assert ear.told[1][0] == "warning" and "it is gone" in ear.told[1][1]


# --- a session of one job ---------------------------------------------------------------------------


def test_session_is_paused_and_started_by_buttons():
    clock = FakeClock()
    controller = FakeController(clock)
    told: list[str] = []

    def tell(kind: str, text: str) -> None:
        told.append(text)
        controller.report_extra = {"held": "|Pn:X", "start by the button on pin X": ""}.get(
            text, controller.report_extra
        )

    lines = [f"G1X{number}F600" for number in range(400)]
    job = SendJob("fake", lines, zero_confirmed=True, inputs=PANEL)
    controller.actions[100] = lambda: setattr(controller, "report_extra", "|Pn:P")
    sender = Sender(job, opener=lambda name, baud: FakeLink(controller, clock), clock=clock, tell=tell)
    assert sender.run().kind == DONE and controller.lines == lines
    first = told.index("pause by the button on pin P")
    assert told[first + 1 : first + 5] == ["holding", "held", "start by the button on pin X", "running"]


def test_pins_of_the_controller_are_looked_at_more_often_those_of_a_port_are_not():
    assert quicker(Timing(), PANEL).poll_s == POLL_S
    assert quicker(Timing(), inputs({"pin": 10, "port": "/dev/parport0", "act": "stop"})) == Timing()
    assert quicker(Timing(), ()) == Timing()


# --- the table, worked from its own buttons ---------------------------------------------------------


@pytest.fixture
def visit(tmp_path):
    return Visit(tmp_path)


def tap(visit: Visit, pin: str):
    """Press a button of the table for a while, as a finger does."""
    board = visit.table.board
    board.press(pin)
    yield TAP_S
    board.release(pin)
    yield TAP_S


def test_table_is_paused_started_and_started_again_from_its_buttons(visit):
    seen = {}

    def person():
        visit.job(*LINE, inputs=PANEL)
        yield lambda: visit.table.x_mm() < -2
        yield from tap(visit, "P")
        yield visit.at("held")
        seen["held"] = visit.table.x_mm()
        yield from tap(visit, "Z")
        seen["flood"] = visit.table.board.flood
        yield from tap(visit, "Z")
        yield from tap(visit, "X")
        yield visit.ended(1)
        seen["end"] = visit.table.x_mm()
        yield from tap(visit, "X")
        yield visit.ended(2)

    visit.receive(person)
    assert -19 < seen["held"] < -2 and seen["flood"] and seen["end"] == pytest.approx(-20, abs=0.02)
    assert [outcome.kind for outcome in visit.outcomes] == [DONE, DONE]
    told = [text for kind, text in visit.told if "by the button" in text]
    pressed = (("pause", "P"), ("flood coolant", "Z"), ("flood coolant", "Z"), ("start", "X"), ("start", "X"))
    assert told == [f"{what} by the button on pin {pin}" for what, pin in pressed]


def test_stop_button_ends_the_job_and_start_does_not_repeat_it(visit):
    def person():
        visit.job(*LINE, inputs=PANEL)
        yield lambda: visit.table.x_mm() < -2
        yield from tap(visit, "Y")
        yield visit.ended()
        yield from tap(visit, "X")

    visit.receive(person)
    assert [outcome.kind for outcome in visit.outcomes] == [STOPPED] and visit.outcomes[0].position_known
    assert visit.refusals() == ["nothing-to-resume"]


def test_button_held_when_the_job_begins_does_not_pause_it(visit):
    def person():
        visit.table.board.press("P")
        visit.job(*LINE, inputs=PANEL)
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].kind == DONE and not [text for _, text in visit.told if "by the button" in text]


def test_switch_is_sent_while_the_machine_is_idle_and_refused_while_it_cuts(visit):
    switch = inputs({"pin": "P", "act": "switch", "line": "M8", "release_line": "M9"})
    seen = []

    def person():
        visit.job("G4P0.01", inputs=switch)
        yield visit.ended(1)
        visit.table.board.press("P")
        yield lambda: visit.table.board.flood
        visit.table.board.release("P")
        yield lambda: not visit.table.board.flood
        visit.job(*LINE, inputs=switch)
        yield lambda: visit.table.x_mm() < -2
        yield from tap(visit, "P")
        seen.append(visit.table.board.flood)
        yield visit.ended(2)

    visit.receive(person)
    assert set(visit.refusals()) == {"job-runs"} and seen == [False]


def test_port_that_cannot_be_read_refuses_the_job(visit, tmp_path):
    missing = inputs({"pin": 10, "port": str(tmp_path / "none"), "act": "stop"})

    def person():
        visit.job(*LINE, inputs=missing)
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].kind == "refused" and visit.outcomes[0].error.code == "input-port"
    assert visit.table.x_mm() == 0


DEBOUNCE_S = 0.03


def edges(looks, debounce_s=DEBOUNCE_S):
    """Return (time, level) of each edge for looks (time, level)."""
    contact = Debouncer(debounce_s)
    found = [(now_s, contact.look(level, now_s)) for now_s, level in looks]
    return [(now_s, edge) for now_s, edge in found if edge is not None]


def samples(levels: str, step_s: float = 0.01):
    return [(number * step_s, letter == "1") for number, letter in enumerate(levels)]


def test_press_and_release_are_one_edge_each_however_they_bounce():
    assert [level for _, level in edges(samples("00000" + "1011011111" + "0100000"))] == [True, False]


def test_edge_comes_when_the_level_has_lasted():
    assert edges(samples("00000" + "1111111")) == [(0.08, True)]


def test_glitch_is_no_edge():
    assert edges(samples("000001100000011100000")) == []


def test_button_held_at_the_begin_does_nothing_until_it_was_released():
    assert edges(samples("111111")) == []
    assert [level for _, level in edges(samples("111111" + "00000" + "11111"))] == [False, True]


def test_without_debouncing_every_look_counts():
    assert [level for _, level in edges(samples("0101"), 0.0)] == [True, False, True]
    assert edges(samples("11"), 0.0) == []


@pytest.mark.slow
@given(st.lists(st.tuples(st.booleans(), st.floats(0.001, 0.2)), max_size=60))
def test_edges_alternate_and_each_level_had_lasted(steps):
    looks, now_s = [], 0.0
    for level, wait_s in steps:
        now_s += wait_s
        looks.append((now_s, level))
    found = edges(looks)
    assert all(one[1] != other[1] for one, other in pairwise(found))
    for time_s, level in found:
        recent = [seen for seen_s, seen in looks if time_s - DEBOUNCE_S < seen_s <= time_s]
        assert set(recent) == {level}
