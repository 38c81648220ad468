# SPDX-License-Identifier: LGPL-2.1-or-later
"""Between two lines of a job at a virtual table: jogged, zeroed, back to the place, on; and a job line by line."""

from __future__ import annotations

import pytest

from CNCStepper.control.journal.replay import RUNNING, read_replay
from CNCStepper.control.session.status import DONE, FAILED
from CNCStepper.control.stream.program_pause import way_back
from CNCStepper.virtual.grbl.states import State
from helpers.control.service_bench import Visit

BEFORE = ("G21G90G94", "M3S9000", "G1Z-4F400", "G1X-20F1500", "G0Z-1", "M5")
AFTER = ("M3S9000", "G1X-30F1500", "G1Z-6F400", "M2")
CHANGE = (*BEFORE, "M0", *AFTER)
WORDS = {6: "change to tool 2"}


@pytest.fixture
def visit(tmp_path):
    return Visit(tmp_path)


def places(visit: Visit) -> list[tuple[float, ...]]:
    """Note from now on every place in which the table stands, in turn."""
    seen: list[tuple[float, ...]] = []

    def note(board) -> None:
        here = tuple(round(value, 3) for value in board.axes.position_mm)
        if not seen or seen[-1] != here:
            seen.append(here)

    visit.table.board.on_step = note
    return seen


def jogged(visit: Visit, **way: float):
    """Jog once and wait for its end."""
    visit.ask("jog", **way)
    yield lambda: visit.table.board.state is State.JOG
    yield lambda: visit.service.status().machine_state == "Idle" and visit.table.board.state is State.IDLE


# --- the way back ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("here", "there", "lines"),
    [
        ((0, 0, 0), (0, 0, 0), []),
        ((5, 0, -3), (0, 0, -1), ["Z-1.0000F1000.0", "X0.0000Y0.0000F1000.0"]),
        ((5, 0, 3), (0, 2, -1), ["X0.0000Y2.0000F1000.0", "Z-1.0000F100.0"]),
        ((0, 0, 3), (0, 0, -1), ["Z-1.0000F100.0"]),
    ],
)
def test_way_back_goes_up_over_and_slowly_down(here, there, lines):
    assert [way.line() for way in way_back(here, there)] == [f"$J=G90G21{line}" for line in lines]


# --- a change of tools -----------------------------------------------------------------------------


def test_job_without_anybody_at_its_pause_goes_on_where_it_was(visit):
    def person():
        visit.job(*CHANGE, messages=WORDS)
        yield visit.at("paused")
        assert visit.service.status().machine_state == "Idle" and visit.service.status().message == "change to tool 2"
        assert visit.table.board.state is State.IDLE and visit.table.board.axes.idle
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].kind == DONE and visit.outcomes[0].status.acknowledged == len(CHANGE)
    assert visit.table.board.axes.position_mm == pytest.approx((-30, 0, -6), abs=0.01)


def test_who_jogged_away_is_taken_back_before_the_job_goes_on(visit):
    seen = []

    def person():
        visit.job(*CHANGE)
        yield visit.at("paused")
        yield from jogged(visit, x_mm=7.0, z_mm=-2.0)
        seen.extend([visit.table.board.axes.position_mm, places(visit)])
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    away, path = seen
    assert away == pytest.approx((-13, 0, -3), abs=0.01)
    up, over = path.index((-13.0, 0.0, -1.0)), path.index((-20.0, 0.0, -1.0))
    assert up < over
    assert all(z == -1.0 for _, _, z in path[up : over + 1]) and all(x == -13.0 for x, _, _ in path[:up])
    assert visit.outcomes[0].kind == DONE
    assert visit.table.board.axes.position_mm == pytest.approx((-30, 0, -6), abs=0.01)


def test_zero_touched_off_at_the_pause_moves_what_follows(visit):
    def person():
        visit.job(*CHANGE)
        yield visit.at("paused")
        yield from jogged(visit, x_mm=5.0)
        yield from jogged(visit, z_mm=-2.0)
        visit.ask("set_zero", axes="Z")
        yield lambda: ("message", "zero of Z set in G54") in visit.told
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    assert visit.refused == [] and visit.outcomes[0].kind == DONE
    assert visit.table.board.axes.position_mm == pytest.approx((-30, 0, -9), abs=0.01)


def test_resume_waits_for_a_jog_and_then_takes_it_back(visit):
    furthest = []

    def person():
        visit.job(*CHANGE)
        yield visit.at("paused")
        visit.ask("jog", x_mm=8.0, feed_mm_min=600.0)
        yield lambda: visit.table.board.state is State.JOG
        visit.ask("resume")
        path = places(visit)
        yield visit.ended()
        furthest.append(max(x for x, _, _ in path))

    visit.receive(person)
    assert visit.outcomes[0].kind == DONE and visit.refused == []
    assert furthest == [pytest.approx(-12, abs=0.02)]
    assert visit.table.board.axes.position_mm == pytest.approx((-30, 0, -6), abs=0.01)


@pytest.mark.slow
def test_way_back_can_be_held_and_taken_up_again(visit):
    def person():
        visit.job(*CHANGE)
        yield visit.at("paused")
        yield from jogged(visit, x_mm=15.0)
        visit.ask("resume")
        yield lambda: visit.table.x_mm() < -8
        visit.ask("hold")
        yield lambda: visit.service.status().machine_state == "Idle"
        assert visit.phase == "paused" and -20 < visit.table.x_mm() < -8
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].kind == DONE and visit.refused == []
    assert visit.table.board.axes.position_mm == pytest.approx((-30, 0, -6), abs=0.01)


def test_way_back_out_of_the_travel_is_refused_and_the_job_stays_paused(tmp_path):
    visit = Visit(tmp_path, settings={20: 1, 22: 1})
    lines = ("G21G90G94", "G1Z-10F700", "G10L20P1Z0", "G0Z8", "M0", "G1X-5F1000", "M2")

    def person():
        visit.job(*lines)
        yield visit.at("paused")
        visit.ask("set_zero", axes="Z")
        yield lambda: ("message", "zero of Z set in G54") in visit.told
        visit.ask("resume")
        yield lambda: bool(visit.refused)
        assert visit.phase == "paused" and visit.table.x_mm() == 0
        visit.ask("stop")
        yield visit.ended()

    visit.receive(person)
    assert visit.refused[0][0] == "resume" and "15" in visit.refused[0][1].code


@pytest.mark.slow
def test_controller_that_restarts_at_the_pause_ends_the_job(visit):
    def person():
        visit.job(*CHANGE)
        yield visit.at("paused")
        visit.table.board.receive(b"\x18")
        yield visit.ended()

    visit.receive(person)
    outcome = visit.outcomes[0]
    assert outcome.kind == FAILED and outcome.error.code == "controller-restarted" and not outcome.position_known


@pytest.mark.slow
def test_hold_at_the_machine_during_the_pause_needs_two_resumes(visit):
    def person():
        visit.job(*CHANGE)
        yield visit.at("paused")
        yield from jogged(visit, x_mm=7.0)
        visit.table.board.receive(b"!")
        yield visit.at("held")
        visit.ask("resume")
        yield visit.at("paused")
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].kind == DONE
    assert visit.table.board.axes.position_mm == pytest.approx((-30, 0, -6), abs=0.01)


def test_pause_within_a_line_is_the_controllers_own(visit):
    def person():
        visit.job("G21G90G94", "G1X-5F1500M0", "G1X-6", "M2")
        yield visit.at("paused")
        assert visit.service.status().machine_state == "Hold:0"
        visit.ask("jog", x_mm=1.0)
        yield lambda: bool(visit.refused)
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    assert visit.refusals() == ["held-jog"] and visit.outcomes[0].kind == DONE


# --- the path, the way back and the clock beside it -------------------------------------------------


def damage(visit: Visit, line: bytes, by: bytes) -> None:
    """Let a line arrive as another one, as noise on the link makes it."""
    write = visit.table.write
    visit.table.write = lambda data: write(data.replace(line, by))


@pytest.mark.slow
@pytest.mark.parametrize("zero", ["", "Z", "XZ"])
def test_path_is_compared_again_after_the_stand(visit, zero):
    def person():
        visit.job(*CHANGE)
        yield visit.at("paused")
        yield from jogged(visit, x_mm=5.0, z_mm=-2.0)
        if zero:
            visit.ask("set_zero", axes=zero)
            yield lambda: ("message", f"zero of {zero} set in G54") in visit.told
        damage(visit, b"X-30", b"X-33")
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].kind == FAILED and visit.outcomes[0].error.code == "path-left"
    assert visit.outcomes[0].error.place.line == 1 + CHANGE.index("G1X-30F1500")


@pytest.mark.slow
def test_path_that_was_given_up_before_the_stand_is_told_of_once(visit):
    def person():
        visit.job("G21G90G94", "$G", *CHANGE[1:])
        yield visit.at("paused")
        yield from jogged(visit, x_mm=5.0)
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    told = [text for kind, text in visit.told if kind == "warning" and "not compared" in text]
    assert visit.outcomes[0].kind == DONE and len(told) == 1


@pytest.mark.slow
def test_time_at_a_stand_does_not_count_as_cutting(visit):
    remaining_s = []

    def person():
        visit.job(*CHANGE)
        yield visit.at("paused")
        yield 1.0
        remaining_s.append(visit.service.status().remaining_s)
        yield from jogged(visit, x_mm=5.0)
        yield 10.0
        remaining_s.append(visit.service.status().remaining_s)
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].kind == DONE and remaining_s[0] == remaining_s[1] > 0


def test_service_without_a_job_goes_nowhere_line_by_line(visit):
    def person():
        visit.ask("by_line", on=True)
        yield lambda: bool(visit.refused)

    visit.receive(person)
    assert visit.refusals() == ["not-running"]


# --- line by line ----------------------------------------------------------------------------------


def test_each_resume_sends_one_line_and_waits_until_it_is_done(visit):
    lines = ("G21G90G94", "G1X-2F1500", "G1X-4", "M0", "G1X-6")
    seen = []

    def person():
        visit.job(*lines, by_line=True)
        for _ in lines:
            yield visit.at("paused")
            seen.append((visit.service.status().message, round(visit.table.x_mm(), 2)))
            visit.ask("resume")
            yield lambda: visit.phase != "paused" or visit.service.status().message != seen[-1][0]
        yield visit.ended()

    visit.receive(person)
    assert seen == [
        ("next is line 1: G21G90G94", 0.0),
        ("next is line 2: G1X-2F1500", 0.0),
        ("next is line 3: G1X-4", -2.0),
        ("", -4.0),
        ("next is line 5: G1X-6", -4.0),
    ]
    assert visit.outcomes[0].kind == DONE and visit.table.x_mm() == pytest.approx(-6, abs=0.01)


def test_a_window_asks_for_line_by_line_when_it_starts_a_job(visit):
    def person():
        visit.job("G21G90G94", "G1X-2F1500")
        yield visit.ended()
        visit.ask("run", file=str(visit._file), zero_confirmed=True, allow_differences=False, by_line=True)
        yield visit.at("paused")
        visit.ask("by_line", on=False)
        visit.ask("resume")
        yield visit.ended(2)

    visit.receive(person)
    assert [outcome.kind for outcome in visit.outcomes] == [DONE, DONE]


def test_stepping_can_begin_and_end_in_the_middle(visit):
    lines = ("G21G90G94", *(f"G1X-{number}F1500" for number in range(1, 60)))
    seen = []

    def person():
        visit.job(*lines)
        yield lambda: visit.table.x_mm() < -3
        visit.ask("by_line", on=True)
        yield visit.at("paused")
        seen.append(visit.service.status().sent)
        visit.ask("by_line", on=False)
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    assert 3 < seen[0] < len(lines) and visit.outcomes[0].kind == DONE


@pytest.mark.slow
@pytest.mark.parametrize("zero", ["", "Z"])
def test_journal_knows_the_zero_that_was_set_at_the_pause_before_the_next_line_goes_out(tmp_path, zero):
    visit = Visit(tmp_path, journals=tmp_path)
    seen = []

    def person():
        visit.job(*CHANGE)
        yield visit.at("paused")
        yield from jogged(visit, z_mm=-2.0)
        if zero:
            visit.ask("set_zero", axes=zero)
            yield lambda: ("message", f"zero of {zero} set in G54") in visit.told
        (journal,) = tmp_path.glob("*.journal")
        visit.table.on_write = lambda data: seen.append(read_replay(journal)) if data.startswith(b"M3") else None
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    story = seen[0]
    assert visit.outcomes[0].kind == DONE and story.end == RUNNING
    assert bool(story.zero) == bool(zero)
    if zero:
        assert story.zero["line"] == CHANGE.index("M0") + 1 and story.finished == CHANGE.index("M0")
        assert story.zero["offsets_mm"]["G54"] == pytest.approx([0, 0, -3], abs=0.01)
        assert story.header["offsets_mm"]["G54"] == pytest.approx([0, 0, 0])
