# SPDX-License-Identifier: LGPL-2.1-or-later
"""The journal of a job that runs: nothing goes out before it is on the disk, and a full disk ruins no cut."""

from __future__ import annotations

import errno
import shutil
import tracemalloc
from collections.abc import Sequence
from concurrent.futures import Executor, Future

import pytest

from CNCStepper.control.journal import writer
from CNCStepper.control.journal.replay import read_replay
from CNCStepper.control.journal.writer import LEAST, MENDED, MOST, Journal, JournalFile, WriteAhead
from CNCStepper.control.processes import file_lock
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl.connect import ControllerInfo
from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.status_reports import Status
from CNCStepper.control.service.sender import Sender
from CNCStepper.control.session.status import DONE, FAILED, REFUSED, STOPPED
from CNCStepper.control.stream.feeder import Feeder
from CNCStepper.control.stream.journal_protocol import NoJournal
from CNCStepper.errors import JobError
from helpers.control.fake_controller import FakeClock, FakeController, FakeLink
from helpers.control.fault_disk import AtOnce

LINES = tuple(f"G1X{number}Y{number % 7}F600" for number in range(400))
SLOW_BAUD = 1200  # at which a journal is as little ahead as it ever is


class Bench:
    """A sender with a journal and a controller, all in memory but the journal's file."""

    def __init__(self, folder, lines=LINES, **job):
        self.clock = FakeClock()
        self.controller = FakeController(self.clock)
        self.told: list[str] = []
        self.journal = Journal(folder, executor=AtOnce(), clock=self.clock)
        self.on_text: dict[str, object] = {}
        self.refused: list[str] = []
        self.on_refused = lambda: None
        self.sender = Sender(
            SendJob("fake", lines, **{"zero_confirmed": True, "file": "part.nc", "baud": SLOW_BAUD} | job),
            opener=lambda name, baud: FakeLink(self.controller, self.clock),
            clock=self.clock,
            tell=self.tell,
            refuse=self.refuse,
            journal=self.journal,
        )

    def tell(self, kind, text):
        self.told.append(text)
        if action := self.on_text.get(text):
            action()

    def refuse(self, command, error):
        self.refused.append(error.code)
        self.on_refused()

    def run(self):
        return self.sender.run()

    def story(self):
        return read_replay(self.journal.path)


@pytest.fixture
def disk(monkeypatch):
    """A disk that takes `disk["left"]` writes more."""
    state = {"left": 10**9}
    write = JournalFile._write

    def limited(file, line):
        state["left"] -= 1
        if state["left"] < 0:
            file._file.write(line[: len(line) // 2])  # as a full disk does
            raise OSError(errno.ENOSPC, "No space left on device")
        write(file, line)

    monkeypatch.setattr(writer.JournalFile, "_write", limited)
    return state


def test_a_job_that_is_cut_is_told_so_with_all_it_began_with(tmp_path):
    bench = Bench(tmp_path, machine="table-a", program_sha256="12ab", certificate_sha256="cd")
    assert bench.run().kind == DONE
    story = bench.story()
    assert story.is_done and story.position_known and story.finished == story.may_be_sent == len(LINES)
    assert story.first_line == 0 and story.last_line == len(LINES)
    told = {key: story.header[key] for key in ("file", "machine", "program_sha256", "certificate_sha256", "port")}
    assert list(told.values()) == ["part.nc", "table-a", "12ab", "cd", "fake"]
    assert story.header["firmware"] == "1.1h.20190830" and story.header["offsets_mm"]["G54"] == [-100, -50, -20]


def test_every_line_is_on_the_disk_before_it_is_sent(tmp_path):
    bench = Bench(tmp_path)
    replays = []

    def look(number):
        story = bench.story()
        replays.append(story)
        assert story.may_be_sent >= bench.sender.status().sent > number
        assert story.finished <= number and story.group.acknowledged <= number

    bench.controller.actions = {number: lambda number=number: look(number) for number in range(len(LINES))}
    assert bench.run().done
    assert len({story.may_be_sent for story in replays}) > 3 and max(story.finished for story in replays) > 100


def test_a_pause_that_is_not_sent_waits_for_the_disk_and_counts_as_cut(tmp_path):
    clock = FakeClock()
    journal = NoJournal()
    journal.permitted = 1
    driver = Grbl(FakeLink(FakeController(clock), clock), clock)
    feeder = Feeder(SendJob("fake", ("M0", "G1X1")), journal)
    assert feeder.pause_text(driver) == "" and feeder.feed(driver, True) == 0
    journal.permitted = 0
    feeder.leave_pause()
    assert feeder.feed(driver, True) == feeder.sent == feeder.acknowledged == 0 and feeder.pause_text(driver) is None
    journal.permitted = 1
    assert feeder.feed(driver, True) == feeder.sent == feeder.acknowledged == 1 and not driver.unanswered


def test_interval_is_true_around_a_pause(tmp_path):
    lines = (*LINES[:100], "M0", *LINES[101:])
    bench = Bench(tmp_path, lines)
    replays = []

    def look():
        status = bench.sender.status()
        replays.append((bench.story(), status.sent, status.acknowledged))
        bench.sender.resume()

    bench.on_text["paused"] = look
    bench.controller.actions[200] = lambda: replays.append((bench.story(), 201, 201))
    assert bench.run().done and len(replays) == 2
    assert replays[0][1:] == (100, 100)
    for story, sent, acknowledged in replays:
        assert story.may_be_sent >= sent and story.finished <= acknowledged
    assert replays[1][0].finished >= 101  # all before the pause, and the pause
    assert bench.story().finished == len(lines)


def test_a_job_that_is_stopped_tells_its_interval_and_its_reason(tmp_path):
    bench = Bench(tmp_path, file_lines=tuple(range(1001, 1401)))
    bench.controller.actions[150] = bench.sender.stop
    outcome = bench.run()
    story = bench.story()
    assert story.end == outcome.kind == STOPPED and story.position_known and story.why == outcome.text
    assert story.finished <= 150 < story.may_be_sent == outcome.status.sent
    assert (story.first_line, story.last_line) == (1001 + story.finished, 1000 + story.may_be_sent)


def test_a_job_that_fails_with_its_position_tells_that(tmp_path):
    bench = Bench(tmp_path)
    bench.controller.on_line[90] = "brownout"
    assert bench.run().kind == FAILED
    assert bench.story().end == FAILED and bench.story().position_known is False


def test_a_refused_job_leaves_no_journal(tmp_path):
    bench = Bench(tmp_path)
    bench.controller.state = "Alarm"
    assert bench.run().kind == REFUSED
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("left", [0, 1])
def test_a_disk_that_takes_nothing_refuses_the_job_before_its_start(tmp_path, disk, left):
    disk["left"] = left
    bench = Bench(tmp_path)
    outcome = bench.run()
    assert outcome.kind == REFUSED and outcome.error.code == "journal-unwritable"
    assert "No space left" in outcome.text and not bench.controller.lines and not list(tmp_path.iterdir())


def test_a_disk_that_is_nearly_full_refuses_the_job_before_its_start(tmp_path, monkeypatch):
    monkeypatch.setattr(shutil, "disk_usage", lambda folder: shutil._ntuple_diskusage(10**9, 10**9, 5000))
    outcome = Bench(tmp_path).run()
    assert outcome.error.code == "journal-unwritable" and "only 5 kB are free" in outcome.text


def test_a_job_that_is_held_for_its_disk_does_not_go_on_before_there_is_room(tmp_path, disk):
    bench = Bench(tmp_path)
    bench.controller.actions[100] = lambda: disk.update(left=0)
    bench.on_text["held"] = bench.sender.resume
    bench.on_refused = lambda: disk.update(left=10**9)
    bench.on_text[MENDED] = bench.sender.resume
    assert bench.run().kind == DONE
    assert bench.refused == ["journal-unwritable"] and bench.controller.realtime.count("~") == 1


def test_a_folder_that_is_not_there_refuses_the_job(tmp_path):
    assert Bench(tmp_path / "gone").run().error.code == "journal-unwritable"


def test_a_disk_full_in_the_middle_holds_at_the_end_of_what_is_durable_and_goes_on_when_there_is_room(tmp_path, disk):
    bench = Bench(tmp_path)
    bench.controller.actions[100] = lambda: disk.update(left=0)
    durable = []

    def make_room():
        durable.append(bench.sender.status().sent)
        assert 100 < durable[-1] <= bench.story().may_be_sent and durable[-1] < len(LINES)
        disk["left"] = 10**9

    bench.on_text["held"] = make_room
    bench.on_text[MENDED] = bench.sender.resume
    assert bench.run().kind == DONE
    assert len(durable) == 1 and bench.controller.lines == list(LINES)
    assert [text for text in bench.told if "No space left" in text and f"part.nc:{durable[0]}" in text]
    assert bench.story().is_done and not bench.story().faults


def test_who_resumes_with_the_disk_still_full_is_refused_and_the_machine_stays(tmp_path, disk):
    bench = Bench(tmp_path)
    bench.controller.actions[100] = lambda: disk.update(left=0)
    held = []

    def go_on_or_stop():
        held.append(bench.sender.status().sent)
        bench.sender.resume() if len(held) < 3 else bench.sender.stop()

    bench.on_text["held"] = bench.on_refused = go_on_or_stop
    assert bench.run().kind == STOPPED
    assert held == [held[0]] * 3 and "~" not in bench.controller.realtime
    assert bench.refused == ["journal-unwritable"] * 2
    assert [text for text in bench.told if "could not be closed" in text]
    story = bench.story()  # as of a killed job, and true
    assert story.end != STOPPED and story.finished <= 100 <= held[0] <= story.may_be_sent


class Program(Sequence):
    """A million lines that take no memory."""

    def __init__(self, count):
        self.count = count

    def __len__(self):
        return self.count

    def __getitem__(self, index):
        return f"G1X{index % 900}"


def begun(folder, clock, lines, baud=SLOW_BAUD):
    driver = Grbl(FakeLink(FakeController(clock), clock), clock)
    driver.status = Status("Run", mpos=(1.0, 2.0, 3.0))
    journal = Journal(folder, executor=AtOnce(), clock=clock)
    journal.begin(SendJob("fake", lines, baud=baud), driver, ControllerInfo("1.1h"))
    return journal


@pytest.mark.slow
def test_a_million_lines_need_a_small_file_and_no_memory(tmp_path, monkeypatch):
    monkeypatch.setattr(writer.os, "fsync", lambda descriptor: None)
    clock = FakeClock()
    lines = Program(1_000_000)
    journal = begun(tmp_path, clock, lines)
    tracemalloc.start()
    sent, starved = 0, 0
    while sent < len(lines):
        sent = min(sent + 250, journal.permitted)  # 5000 lines a second, looked at every 50 ms
        starved += sent == journal.permitted < len(lines)
        clock.now_s += 0.05
        journal.keep(sent, max(sent - 20, 0), False)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 2_000_000 and journal.path.stat().st_size < 100_000
    assert starved < 12  # only until the rate is known


def test_a_slow_job_on_a_slow_line_is_known_within_a_few_lines():
    ahead, sent, permitted = WriteAhead(0.0, SLOW_BAUD), 0, LEAST
    for second in range(1, 60):
        sent += 40 if second == 1 else 1
        permitted = ahead.next_range(sent, permitted, float(second))
    assert permitted - sent == LEAST


def test_a_disk_too_slow_for_the_range_gets_a_longer_one():
    ahead = WriteAhead(0.0, SLOW_BAUD)
    ranges = [ahead.next_range(sent := LEAST * (k + 1), sent, 0.001 * k) - sent for k in range(12)]
    assert ranges[0] >= 2 * LEAST and ranges[-1] == MOST


class SlowDisk(Executor):
    """A disk of which every write takes so long, by a clock."""

    def __init__(self, clock, write_s):
        self.clock, self.write_s = clock, write_s
        self.waiting: list[tuple[float, Future]] = []

    def submit(self, function, /, *arguments, **words):
        function(*arguments, **words)
        self.waiting.append((self.clock() + self.write_s, Future()))
        return self.waiting[-1][1]

    def turn(self):
        while self.waiting and self.waiting[0][0] <= self.clock():
            self.waiting.pop(0)[1].set_result(None)


@pytest.mark.parametrize(("baud", "lines_s"), [(115_200, 500), (115_200, 760), (1_000_000, 4000), (1_000_000, 6600)])
@pytest.mark.parametrize("slow_lines", [0, 20])
def test_a_disk_that_takes_an_eighth_of_a_second_never_keeps_a_stream_waiting(tmp_path, baud, lines_s, slow_lines):
    """From the first line on, and where many short lines come after a few slow ones."""
    clock = FakeClock()
    journal = begun(tmp_path, clock, Program(100_000), baud)
    journal._executor = disk = SlowDisk(clock, 0.125)
    sent = 0.0
    while sent < 20_000:
        clock.now_s += 0.002
        sent += 0.002 * (lines_s if sent >= slow_lines else 4)
        disk.turn()
        journal.keep(int(sent), max(int(sent) - 20, 0), False)
        assert journal.permitted > sent, f"waits at line {sent:.0f}"


def test_a_range_is_taken_back_before_it_is_on_the_disk(tmp_path):
    clock = FakeClock()
    journal = begun(tmp_path, clock, Program(10_000))
    for sent in (200, 210):
        clock.now_s += 5
        journal.keep(sent, sent, True)
    before = journal.permitted
    journal._executor = SlowDisk(clock, 1.0)
    clock.now_s += 5
    journal.keep(220, 220, True)
    assert journal.permitted == 220 + LEAST < before


def test_a_fault_of_the_writer_is_not_swallowed(tmp_path):
    journal = begun(tmp_path, FakeClock(), LINES)
    journal._writing = Future()
    journal._writing.set_exception(ZeroDivisionError())
    with pytest.raises(ZeroDivisionError):
        journal.keep(0, 0, False)


def test_a_journal_that_cannot_be_locked_is_refused(tmp_path, monkeypatch):
    def refuse(file, shared=False):
        raise OSError(errno.ENOLCK, "No locks available")

    monkeypatch.setattr(file_lock, "take_lock", refuse)
    with pytest.raises(JobError, match="No locks available"):
        begun(tmp_path, FakeClock(), LINES)
    assert not list(tmp_path.iterdir())
