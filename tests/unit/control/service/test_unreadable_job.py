# SPDX-License-Identifier: LGPL-2.1-or-later
"""The file of a running job cannot be read any more: the job ends with the reason, and nothing else is lost."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from CNCStepper.control.journal.store import replays
from CNCStepper.control.program import bundle
from CNCStepper.control.program.bundle import BLOCK
from CNCStepper.control.session.status import DONE, FAILED
from helpers.control.service_bench import Visit

LINES = ("G21G90G94F5000", *(f"G1X-{number * 0.02:.2f}" for number in range(3 * BLOCK)))
FILE_LINES = range(1, len(LINES) + 1)


class FailingReads:
    """Lets `_Member.read` raise as a disk does, from its n-th call on while `running`."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, fails_at: float):
        self.calls, self.running, self._fails_at = 0, False, fails_at
        self._open = open
        monkeypatch.setattr(bundle, "open", self.open, raising=False)

    def open(self, *args, **how):
        self.calls += self.running
        if self.running and self.calls >= self._fails_at:
            raise OSError(5, "Input/output error")
        return self._open(*args, **how)


def cut(visit: Visit, reads: FailingReads):
    def person():
        visit.job(*LINES, file_lines=FILE_LINES)
        yield visit.at("running")
        reads.running = True
        yield visit.ended()
        reads.running = False
        visit.ask("jog", x_mm=-1.0)
        yield visit.at("jogging")
        yield visit.at("idle")

    visit.receive(person)
    (outcome,) = visit.outcomes
    return outcome


@pytest.mark.parametrize("fails_at", [1, 2, 3, 4, 5, 7, 9])
def test_job_ends_with_the_reason_and_the_machine_keeps_its_position(fails_at, monkeypatch, tmp_path: Path):
    reads, visit = FailingReads(monkeypatch, fails_at), Visit(tmp_path, journals=tmp_path)
    outcome = cut(visit, reads)
    (story,) = replays(tmp_path)
    if outcome.kind == DONE:  # it needed no further block
        assert story.is_done
    else:
        assert outcome.kind == FAILED and "Input/output error" in outcome.text and outcome.position_known
        assert story.end == FAILED and story.finished <= outcome.status.acknowledged


def test_some_of_the_reads_that_fail_end_the_job(monkeypatch, tmp_path: Path):
    reads, visit = FailingReads(monkeypatch, 2), Visit(tmp_path)
    assert cut(visit, reads).kind == FAILED and reads.calls >= 2


def test_a_private_copy_whose_time_stamp_changes_is_cut_to_its_end(tmp_path: Path):
    visit = Visit(tmp_path)

    def person():
        visit.job(*LINES)
        yield visit.at("running")
        os.utime(tmp_path / "service ç.wire")
        yield visit.ended()

    visit.receive(person)
    assert [outcome.kind for outcome in visit.outcomes] == [DONE]
