# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a sender is given: the wire lines, where they come from, and what must hold before the first goes out."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

from CNCStepper.control.program.bundle import (
    LINE_MAP,
    WIRE,
    Bundle,
    array_bytes,
    head_bytes,
    line_bytes,
    read_bundle,
    write_private,
)
from CNCStepper.control.program.program_columns import Messages, message_members, messages_of
from CNCStepper.control.program.wire_line import check_length, check_line, is_plain
from CNCStepper.control.protocol.grbl.firmware import Firmware
from CNCStepper.errors import JobError, Place, ProgramError, Text
from CNCStepper.machine.controller_family import BAUD

JOB = "job.json"


@dataclass(frozen=True)
class SendJob:
    """A job for one port.

    lines: wire lines without line ends. file_lines: the file's line of each, from 1 (empty: they are
    the file's own lines). messages: what to show at a pause, by index of the wire line, from 0.
    expected: grbl settings that must hold, by number; differences are only told when
    `allow_differences`. zero_confirmed: somebody said that the work zero is right. work_offsets_mm, work_system:
    where the program was proven to begin (G54..G59.3 and G92 by name); empty: nobody knows, so nothing is compared.
    dialect: in which the lines were read; empty: nobody has read them, so that it is not compared. program_dialect: of
    the program, where that is another one.
    machine, program_sha256, certificate_sha256: for the journal, empty where there is none.
    retrace: what a way back along the cut is proven with (dialect, start, machine: `job.make_certificate`); empty: not
    known.
    plan: lines of the file in rising order, each with the planned time by its end, s; empty: not known.
    by_line: wait before each line until somebody resumes. inputs: the machine's own buttons, as
    `machine.input_pins.Input`
    has them. home_first: let the machine find its own zero before.
    restart_of: the program that a restart goes on with, as `journal.first_program` has it; empty: it is none.
    lift: where a restart goes first, straight up (`control.preflight.restart_height`); empty: it is none, or has no Z.
    made_with: the options of the command line that made it, for the journal; empty: not known
    (`cli.common.reproduce_options`).
    profile: name or path of the profile whose controller is a process of this computer; empty: the port has its own.
    pulses_per_s: its fastest rate of pulses, which such a controller tries before the first line; 0: nothing is tried.
    """

    port: str
    lines: Sequence[str]
    file: str = ""
    file_lines: Sequence[int] = ()
    messages: Mapping[int, str] = field(default_factory=dict)
    zero_confirmed: bool = False
    expected: Mapping[int, float] = field(default_factory=dict)
    allow_differences: bool = False
    baud: int = BAUD
    work_offsets_mm: Mapping[str, Sequence[float]] = field(default_factory=dict)
    work_system: str = ""
    dialect: str = ""
    machine: str = ""
    program_sha256: str = ""
    certificate_sha256: str = ""
    retrace: Mapping[str, Any] = field(default_factory=dict)
    plan: Sequence[Sequence[float]] = ()
    by_line: bool = False
    inputs: Sequence[Mapping[str, Any]] = ()
    restart_of: Mapping[str, Any] = field(default_factory=dict)
    home_first: bool = False
    lift: Mapping[str, Any] = field(default_factory=dict)
    made_with: Mapping[str, Any] = field(default_factory=dict)
    profile: str = ""
    pulses_per_s: float = 0.0
    program_dialect: str = ""

    def __post_init__(self) -> None:
        if len(self.file_lines) not in (0, len(self.lines)):
            raise JobError(
                "line-map",
                "the line map does not fit the lines",
                value=f"{len(self.file_lines)} entries",
                limit=f"{len(self.lines)} lines",
                advice="prepare the program again",
            )

    def place(self, index: int) -> Place:
        """Return the place in the file of wire line `index` (from 0)."""
        return Place(self.file, int(self.file_lines[index]) if len(self.file_lines) else index + 1)

    def last_line(self, count: int) -> int:
        """Return the file's line of the last of so many wire lines, 0 for none."""
        return self.place(count - 1).line if count else 0

    def known_line(self, count: int) -> int:
        """Return the result of `last_line`, and 0 where the line map cannot be read: a status always has a line."""
        try:
            return self.last_line(count)
        except JobError:  # the sender ends the job with the reason
            return 0

    def check(self) -> None:
        """Check every line before any is sent; raises ProgramError naming the file's line and column."""
        if not self.lines:
            raise ProgramError(
                "program-empty", "the program has no line to send", advice="choose another", place=Place(self.file)
            )
        for index, text in enumerate(self.lines):
            if not is_plain(text):
                check_line(text, self.place(index))

    def check_lengths(self, firmware: Firmware, window_bytes: int) -> None:
        """Check that the controller can read every line; raises ProgramError as `check` does."""
        surely_fits = min(firmware.line_characters, window_bytes - 1)
        for index, text in enumerate(self.lines):
            if len(text) > surely_fits:
                check_length(text, firmware, window_bytes, self.place(index))

    def to_content(self) -> dict[str, Any]:
        """Return the job as plain data, without its lines and messages."""
        columns = ("lines", "file_lines", "messages")
        return {entry.name: getattr(self, entry.name) for entry in fields(self) if entry.name not in columns} | {
            "expected": {str(number): value for number, value in self.expected.items()},
            "work_offsets_mm": {name: list(offset) for name, offset in self.work_offsets_mm.items()},
            "inputs": [dict(entry) for entry in self.inputs],
        }

    @classmethod
    def of_bundle(cls, bundle: Bundle, **instead: Any) -> SendJob:
        """Return the job of a bundle, with other values for some fields; raises JobError when it is not one."""
        columns = {"lines": bundle.lines, "file_lines": bundle.file_lines, "messages": messages_of(bundle.columns)}
        return cls.from_content({**columns, **bundle.head, **instead})

    @classmethod
    def from_content(cls, content: Mapping[str, Any]) -> SendJob:
        """Return the job of `to_content`, its lines and messages; raises JobError when it is not one."""
        try:
            unknown = set(content) - {entry.name for entry in fields(cls)}
            if unknown:
                raise ValueError(Text("unknown keys {unknown}", unknown=sorted(unknown)))
            known = dict(content)
            messages = content.get("messages", {})
            if not isinstance(messages, Messages):
                known["messages"] = {int(key): str(value) for key, value in messages.items()}
            known["expected"] = {int(key): float(value) for key, value in content.get("expected", {}).items()}
            known["plan"] = tuple((int(line), float(end_s)) for line, end_s in content.get("plan", ()))
            return cls(**known)
        except (ValueError, TypeError, AttributeError) as error:
            if isinstance(error, JobError):
                raise
            raise _no_job(error) from error


def write_job(path: Path, job: SendJob) -> None:
    """Write a job to a bundle that only its owner can read.

    Raises ProgramError for a line that holds the end of one, OSError.
    """
    write_private(path, {JOB: head_bytes(job.to_content())} | program_members(job))


def program_members(job: SendJob) -> dict[str, Iterable[bytes]]:
    """Return lines, their places and messages of a job as members of a bundle; writing raises as `write_job` does."""
    columns = {WIRE: line_bytes(job.lines, job.place), LINE_MAP: array_bytes(job.file_lines)}
    return columns | message_members(job.messages)


def read_job(path: Path) -> SendJob:
    """Return the job of `write_job`, whose lines are read when they are asked for; raises JobError, OSError."""
    try:
        return SendJob.of_bundle(read_bundle(path, private=True))
    except ValueError as error:
        raise _no_job(error) from error


def _no_job(error: Exception) -> JobError:
    return JobError("send-job", Text("not a job to send: {error}", error=error), advice="start it with cncstepper send")
