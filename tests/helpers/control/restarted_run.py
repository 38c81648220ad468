# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a person does after a run that stopped: asks the journal, brings the machine back, sends the restart."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from shutil import copyfile

from CNCStepper.control.journal.replay import JobReplay, read_replay
from CNCStepper.control.journal.summary import summary_of
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.errors import ProgramError
from CNCStepper.job.make_certificate import certificate_of
from CNCStepper.machine.profile import load_machine
from CNCStepper.recovery.restart.prove_restart import restart_program
from CNCStepper.recovery.restart.restart_places import RequestedPlace
from CNCStepper.virtual.faults.plan import FaultPlan
from CNCStepper.virtual.grbl.machine import Grbl
from CNCStepper.virtual.grbl.settings import HOMING
from CNCStepper.virtual.grbl.states import State
from helpers.control.fault_bench import FILE, STEP_S, FaultBench, job_of
from helpers.control.fault_judge import Claim, Row, Run
from helpers.control.restart_judge import Interval

NOTHING_CUT, NOTHING_LEFT = "restart-at-start", "restart-nothing-left"
RESET, UNLOCK = b"\x18", b"$X\n"
SETTLED_S = 0.5


class SecondGo:
    """The restart after `first`; `said` is what the journal and the restart state.

    seen_line: from which on a person sees that the part is not cut, where the machine was not where it counted.

    homes: whether the machine homes itself first, since its place is not known. is_well_advised: whether the journal
    says so too.
    """

    def __init__(self, bench: FaultBench, first: Run, seen_line: int | None = None):
        story = story_of(bench)
        has_switches = bench.board.memory.settings.on(HOMING)
        self.homes = has_switches and not is_known(first)
        self.is_well_advised = story is None or ("home it" in dict(summary_of(story))["position"]) == has_switches
        lines = bench.lines
        self.said = Interval(story.finished, story.may_be_sent, story.finished) if story else Interval(0, 0, 0)
        if seen_line is not None:
            self.said = Interval(seen_line, self.said.last, seen_line)
        self.rows: list[Row] = []
        self.claim: Claim | None = None
        if job := self._job(lines):
            bring_back(bench.board, first)
            job = replace(job, home_first=self.homes)
            again = FaultBench(lines, FaultPlan(), switches=bench.switches, board=bench.board, job=job)
            run = again.run()
            self.rows, self.claim, self.at_rest = run.trace.rows, run.claim, run.trace.at_rest

    def _job(self, lines: tuple[str, ...]) -> SendJob | None:
        """Return the job of the restart from the first line that is not certainly cut; None where nothing is left."""
        if self.said.first == len(lines):
            return None
        text, where = "".join(f"{line}\n" for line in lines), RequestedPlace(line=self.said.first + 1)
        try:
            proven = restart_program(text, load_machine("table-a"), where, file=FILE)
        except ProgramError as error:
            if error.code == NOTHING_LEFT:
                return None
            if error.code != NOTHING_CUT:
                raise
            self.said = replace(self.said, entrance=0)
            return job_of(lines)
        entrance = proven.restart.program.file_line(proven.restart.entrance.row) - 1
        self.said = replace(self.said, entrance=min(entrance, self.said.first))
        certificate = certificate_of(proven.proof)
        certificate.check_clean()
        return replace(certificate.send_job(), port="simulated", zero_confirmed=True)


def story_of(bench: FaultBench) -> JobReplay | None:
    """Return what the journal tells once the sender's process has ended; None for a job that was refused."""
    journal = bench.journal
    if journal is None or journal.path is None or not journal.path.exists():
        return None
    return read_replay(Path(copyfile(journal.path, journal.path.with_suffix(".left"))))  # no process locks the copy


def is_known(first: Run) -> bool:
    """Return whether a person trusts the position: who sees the supply fail does not."""
    return first.claim.position_known and not first.trace.lost


def bring_back(board: Grbl, first: Run) -> None:
    """Bring a machine back: reset and unlocked, and with its zero set again where it is said to be unknown.

    One with switches is left locked then: its job homes it.
    """
    known = is_known(first)
    if not known or board.state is not State.IDLE:  # some alarms are locked until a reset; at rest it loses nothing
        board.receive(RESET)
        pass_time(board)
    if not known and board.memory.settings.on(HOMING):
        board.take_output()
        return
    if board.state is State.ALARM:
        board.receive(UNLOCK)
        pass_time(board)
    if not known:
        set_zero(board, first)
    board.take_output()


def set_zero(board: Grbl, first: Run) -> None:
    """Measure where the tool truly stands from the work zero, and tell it to the controller."""
    zero, axes = first.reference[0].place, board.axes
    steps = zip(axes.position_steps, axes.lost_steps, zero, strict=True)
    words = (
        f"{axis}{(here + lost - at) * axes.step_mm(number):.4f}"
        for (number, axis), (here, lost, at) in zip(enumerate("XYZ"), steps, strict=True)
    )
    board.receive(f"G10L20P1{''.join(words)}\n".encode("ascii"))
    pass_time(board)


def pass_time(board: Grbl) -> None:
    """Let a machine carry out what it was told by hand."""
    end_s = board.time_s + SETTLED_S
    while board.time_s < end_s:
        board.advance(STEP_S)
