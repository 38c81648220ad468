# SPDX-License-Identifier: LGPL-2.1-or-later
"""Dwells, stops and messages of a long program are not kept, and what is found of them is that of the whole text."""

from __future__ import annotations

import gc
import random
import tracemalloc
from collections import Counter
from pathlib import Path

import pytest

from CNCStepper.control.program.certificate import Certificate
from CNCStepper.gcode.interpreter import program_file
from CNCStepper.gcode.interpreter.fast_path import compiled_reader  # noqa: F401  before CHUNK_ROWS is set
from CNCStepper.job import prove_file as prove_file_module
from CNCStepper.job.make_certificate import certificate_of
from CNCStepper.job.prove_file import prove_file
from CNCStepper.motion.planner.standstills import RUNNING_EVENTS, EventsAsOne, StopEvents, Stops, dwell_ticks
from CNCStepper.simulation import finding
from CNCStepper.toolpath import Event
from helpers.job.prove_runs import TABLE, assert_same, both, pieces  # noqa: F401  a fixture

LISTED = 5
STILL = ("G4 P0.013", "G4 P1.21", "M0", "M0", "(MSG, look {k})", "M1", "M8", "M9", "(nothing)")


def program(seed: int) -> str:
    """Return a program of long stretches without a move, some of them long at its begin and end."""
    draw = random.Random(seed)
    lines = ["G21 G90", "M3 S9000"]
    for stretch in range(6):
        lines += [draw.choice(STILL).format(k=k) for k in range(draw.choice((0, 7, 60)))]
        lines += [f"G1 X{stretch + k * 0.1:.1f} F300" for k in range(draw.choice((1, 4)))]
        lines += [draw.choice(("M5", "M3 S9000", "S8000", "M0"))]
    return "\n".join([*lines, "G4 P0.2", "G4 P0.013", "M0", "M0", "M2"]) + "\n"


@pytest.mark.usefixtures("pieces")
@pytest.mark.parametrize("pieces", [pytest.param((3, 200), id="few-rows")], indirect=True)
def test_what_is_found_is_that_of_the_whole_text(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for module in (finding, prove_file_module):
        monkeypatch.setattr(module, "MOST_LISTED", LISTED)
    found: Counter[str] = Counter()
    for seed in range(1, 9):
        whole, parts = both(tmp_path, program(seed), TABLE)
        print(f"seed {seed}: {len(whole.findings)} findings")
        assert_same(whole, parts)
        found["not listed"] += any("not listed" in one.text for one in whole.findings)
        found["waits"] += any(one.code == "spin-up" for one in whole.findings)
        found["messages"] += len(whole.wire.messages) > 1
    assert min(found.values()) >= 1 and found["not listed"] >= 3 and len(found) == 3, found


def test_three_times_the_lines_keep_no_more(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("CNCStepper.toolpath.CHUNK_ROWS", 50)
    monkeypatch.setattr(prove_file_module, "PART_ROWS", 100)
    monkeypatch.setattr(program_file, "PIECE", 4000)
    held: Counter[str] = Counter()
    append, before = StopEvents.append, Stops.before

    def appended(self: StopEvents, event: Event) -> None:
        append(self, event)
        held["read"] = max(held["read"], len(self))

    def stopped(self: Stops, chunk: object) -> object:
        held["planned"] = max(held["planned"], len(self.events))
        return before(self, chunk)  # type: ignore[arg-type]

    monkeypatch.setattr(StopEvents, "append", appended)
    monkeypatch.setattr(Stops, "before", stopped)
    most = []
    for lines in (1200, 3600):
        held.clear()
        moving = "".join(f"G1 X{k % 9} F300\nG4 P0.1\nM0\n(MSG, {k})\n" for k in range(lines))
        still = "".join(f"G4 P0.1\nM0\n(MSG, {k})\n" for k in range(lines))
        file = tmp_path / f"{lines}.nc"
        file.write_text(f"G21 G90\n{moving}{still}M2\n", "ascii")
        proof = prove_file(file, TABLE)
        assert proof.wire.messages == {}
        most.append(dict(held))
    assert most[0]["read"] > 100 and most[0]["planned"] > 0
    assert most[1]["planned"] <= most[0]["planned"] + 300, most  # what is read ahead begins elsewhere in the file
    assert most[1]["read"] <= most[0]["read"] + 300, most


def test_messages_of_a_certificate_are_not_held(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(program_file, "PIECE", 10_000)
    held = []
    for count in (50, 200, 1000):  # the first loads what is loaded once
        file, sent = tmp_path / f"{count}.zip", tmp_path / str(count)
        sent.mkdir()
        told = [f"turn the part over and put the long clamp on, {k}" for k in range(count)]
        (tmp_path / "p.nc").write_text("".join(f"(MSG, {text})\nG4 P0.1\n" for text in told), "ascii")
        last = told.pop()
        del told
        tracemalloc.start()
        proof = prove_file(tmp_path / "p.nc", TABLE, sent=sent)
        certificate_of(proof).write(file)
        read = Certificate.read(file).send_job().messages
        gc.collect()
        held.append(tracemalloc.get_traced_memory()[0])
        tracemalloc.stop()
        assert len(proof.wire.messages) == len(read) == count and read[count - 1] == last
        assert file.stat().st_size > 50 * count
    assert held[2] < held[1] + 800 * 60, held  # a dict of them takes 200 bytes for each


def test_events_before_a_row_are_summed_up() -> None:
    draw = random.Random(7)
    every = [
        Event(draw.choice((3, 4)), draw.choice(("dwell", "pause", "output", *RUNNING_EVENTS)), draw.random(), state=s)
        for s in (0, 1)
        for _ in range(500)
    ]
    every.sort(key=lambda event: event.index)
    some = StopEvents(LISTED)
    for event in every:
        some.append(event)
    assert len(some) <= 4 * (1 + 2 * (LISTED + 1))
    for index, state in ((index, state) for index in (3, 4) for state in (0, 1)):
        whole, few = (
            [one for one in events if (one.index, one.state) == (index, state) and one.kind not in RUNNING_EVENTS]
            for events in (every, some)
        )
        assert sum(map(dwell_ticks, few)) == sum(map(dwell_ticks, whole)) > 0
        waits = [sum(one.value for one in events if one.kind == "dwell") for events in (few, whole)]
        assert waits[0] == pytest.approx(waits[1])
        counts = Counter({one.kind: 0 for one in whole})
        for one in few:
            counts[one.kind] += one.count if isinstance(one, EventsAsOne) else 1
        assert counts == Counter(one.kind for one in whole)
