# SPDX-License-Identifier: LGPL-2.1-or-later
"""Back along the cut in a job of a service, judged by the machine's own trace, and what it knows afterwards."""

from __future__ import annotations

import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from CNCStepper.control.program.send_job import write_job
from CNCStepper.control.service.connection_service import ConnectionService
from CNCStepper.control.session.command import Command
from CNCStepper.control.session.status import DONE, STOPPED, Outcome
from helpers.control.retract_bench import ROUNDING_MM, STANDS, STEP_MM, Cut, path_of, polyline, worst_distance_mm
from helpers.control.service_bench import Person, Visit

PROGRAM = (
    "G21 G90\nG0 Z-2\nG0 X-5 Y-5\nM3 S8000\nG1 Z-5 F600\nG1 X-15 F1200\nG2 X-17 Y-7 I0 J-2\nG1 Y-15\nX-5\nY-5\n"
    "G0 Z-2\nM5\nM2\n"
)


class ServiceCut(Cut):
    """The job of a `Cut`, run by a service over its open link; `again` runs it once more."""

    def __init__(self, folder: Path, program: str, **table: Any):
        super().__init__(folder, program, **table)
        self.outcomes: list[Outcome] = []
        self._job_file = folder / "a job ç.json"
        write_job(self._job_file, self.job)
        self.sender = ConnectionService(
            "table",
            job_file=folder / "service.wire",
            opener=lambda name, baud: self.table,
            clock=self.table.clock,
            tell=self._on_message,
            refuse=lambda command, error: self.refused.append(error),
            ended=self.outcomes.append,
        )

    def visit(self, person: Callable[[], Person]) -> None:
        """Let a person come once the service is connected, who tells it to end."""

        def visit() -> Person:
            yield lambda: self.phase == "idle"
            yield from person()
            self.sender.stop()

        self.table.person = visit()
        self.sender.run()

    def cut(self, person: Callable[[], Person] = lambda: iter(())) -> Person:
        """Run the job, let a person do as it likes, and wait for the job's end."""
        before = len(self.outcomes)
        values = {"file": str(self._job_file), "zero_confirmed": True, "allow_differences": False}
        self.sender.ask(Command("run", values))
        yield lambda: self.phase == "running" or len(self.outcomes) > before
        yield from person()
        yield lambda: len(self.outcomes) > before and self.phase == "idle"


def moved(cut: ServiceCut, ways: list[Callable[[Any], dict[str, Any]]]) -> Person:
    """Hold now, and go each of these ways from where the tool then stands."""
    yield from cut.hold()
    for way in ways:
        yield lambda: cut.phase in STANDS
        found: list[Any] = []
        yield from cut.find(found)
        yield from cut.go(way(found[0]))


@pytest.mark.slow
def test_way_back_and_forward_again_is_exact_in_a_job_of_the_service(tmp_path: Path) -> None:
    line, rng = polyline(path_of(PROGRAM)), random.Random(8)
    begins_mm = [rng.uniform(-14.0, -6.0) for _ in range(2)]
    print("holds at", begins_mm)
    cut = ServiceCut(tmp_path, PROGRAM)

    def person() -> Person:
        yield lambda: cut.trace[-1][0] < begins_mm[0] and cut.trace[-1][2] < -4.9
        yield from moved(cut, [lambda held: held.along(held.back_by(4.0)), lambda held: held.along(held.forward_by())])
        yield from moved(cut, [lambda held: held.along(held.back_to_entry()), lambda held: held.rest()])
        yield lambda: cut.trace[-1][1] < begins_mm[1]
        yield from moved(cut, [lambda held: held.along(held.back_to_line(7)), lambda held: held.rest()])

    def zeroed() -> Person:
        cut.sender.ask(Command("set_zero", {"axes": "XYZ"}))
        yield lambda: cut.sender.status().position_known is True
        yield from cut.cut(person)

    cut.visit(zeroed)
    (outcome,) = cut.outcomes
    assert outcome.kind == DONE and not cut.refused, (outcome.text, cut.refused)
    assert outcome.status.total == outcome.status.acknowledged == PROGRAM.count("\n")
    assert np.allclose(cut.trace[-1], line[-1], atol=STEP_MM)
    assert worst_distance_mm(cut.trace, line) <= STEP_MM + ROUNDING_MM


@pytest.mark.slow
def test_retreat_leaves_what_the_service_knew_of_the_position(tmp_path: Path) -> None:
    cut, known = ServiceCut(tmp_path, PROGRAM), []

    def person() -> Person:
        yield lambda: cut.trace[-1][0] < -8.0
        known.append(cut.sender.status().position_known)
        yield from moved(cut, [lambda held: held.along(held.back_by(1.0))])
        known.append(cut.sender.status().position_known)
        yield from moved(cut, [lambda held: held.rest()])

    def twice() -> Person:
        cut.sender.ask(Command("set_zero", {"axes": "XYZ"}))
        yield lambda: cut.sender.status().position_known is True
        yield from cut.cut(person)
        known.append(cut.sender.status().position_known)
        yield from cut.cut()

    cut.visit(twice)
    assert [outcome.kind for outcome in cut.outcomes] == [DONE, DONE]
    assert known == [True, True, True]


def test_job_that_was_stopped_may_run_again_from_the_same_zero(tmp_path: Path) -> None:
    visit = Visit(tmp_path)
    lines = ("G21G90G94", "G1X-20F1500", "G1X0")

    def person() -> Person:
        for ends, zeroed in ((lambda: visit.ask("stop"), True), (lambda: None, False)):
            visit.job(*lines, zeroed=zeroed)
            yield visit.at("running")
            yield 0.5
            ends()
            yield visit.ended(len(visit.outcomes) + 1)

    visit.receive(person)
    assert [outcome.kind for outcome in visit.outcomes] == [STOPPED, DONE]


def test_service_without_a_job_has_no_way_back(tmp_path: Path) -> None:
    visit = Visit(tmp_path)

    def person() -> Person:
        for name in ("tell_place", "retrace"):
            visit.ask(name, file=str(tmp_path / "none.json"))
        yield lambda: len(visit.refused) == 2

    visit.receive(person)
    assert visit.refusals() == ["not-held", "not-held"] and visit.phase == "idle"
