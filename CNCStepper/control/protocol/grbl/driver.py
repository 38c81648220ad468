# SPDX-License-Identifier: LGPL-2.1-or-later
"""The protocol driver of grbl 1.1: lines written, answers, and the number of bytes under way.

`character_counting.py` limits the lines under way.

Of these at most the link's `queue_bytes` wait in this computer; the others are kept here until there is room.

Real-time bytes are no lines: they are written at once, are never counted and may pass lines by.

Limits unsolicited lines: a damaged or hostile controller would keep the sender from its work.
"""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass

from CNCStepper.control.protocol.grbl import status_reports
from CNCStepper.control.protocol.grbl.character_counting import CharacterCounting, Sent
from CNCStepper.control.protocol.grbl.firmware import CANNOT, GRBL, Firmware, firmware_of_greeting, firmware_of_tag
from CNCStepper.control.protocol.grbl.motion_interlock import MotionInterlock
from CNCStepper.control.protocol.grbl.status_reports import (
    Answer,
    Damaged,
    Feedback,
    Greeting,
    Report,
    Setting,
    Status,
    Vector,
    sizes,
)
from CNCStepper.control.transport.link import Link
from CNCStepper.errors import LinkError, Text
from CNCStepper.safe_text import printable
from CNCStepper.units import mm_from_inch

LINES_PER_S = 50.0  # for good; controllers that report by themselves do so 20 times a second
MOST_LINES = 400  # at a time: FluidNC's start-up text is a quarter of that
MOST_OF_AN_ANSWER = 10_000  # to a `$` command, which may list all settings


class FloodLimit:
    """Counts lines: those of answers to `$` commands, and, apart from these, unsolicited ones; clock: in s."""

    def __init__(self, clock: Callable[[], float]):
        self._clock = clock
        self._lines = {True: 0.0, False: 0.0}  # whether asked for; less what was due since
        self._counted_s = clock()

    def check(self, lines: int, is_asked: bool, name: str) -> None:
        """Count lines; raises LinkError where they are too many. is_asked: a `$` command is under way."""
        now_s = self._clock()
        due = LINES_PER_S * (now_s - self._counted_s)
        self._lines = {asked: max(0.0, counted - due) for asked, counted in self._lines.items()}
        self._lines[is_asked] += lines
        self._counted_s = now_s
        most = MOST_OF_AN_ANSWER if is_asked else MOST_LINES
        if self._lines[is_asked] <= most:
            return
        self._lines[is_asked] = 0.0
        raise LinkError(
            "link-flood",
            Text("{name} sends more than was asked for", name=name),
            value=Text("more than {most} lines", most=most),
            limit=f"{LINES_PER_S:g} lines/s",
            advice="check the baud rate, and which reports the controller sends unasked",
        )


HOLD, RESUME, RESET, STATUS, JOG_CANCEL = b"!", b"~", b"\x18", b"?", b"\x85"
LONGEST_REST_S = 0.01
PLANNER_BLOCKS = 32  # of one that does not say it
NOISE_LIMIT_BYTES = 4096  # without a line end
MOST_ECHOES = 200  # that are waited for: no buffer holds more lines
REPORT_INCHES = 13  # the setting that switches reports to inches


@dataclass(slots=True)
class Answered:
    """The answer to one line; error 0 is `ok`."""

    sent: Sent
    error: int


Received = Report | Answered


class Grbl:
    """A conversation with one controller over `link`.

    listen: called after every `receive` with what came, on the same thread.
    interlock: asked before whatever may move the machine is written; the one of the default lets nothing pass.
    firmware: what answers there, grbl until it is known better.
    status: the last answer to `?`. status_asked_s: when it was asked for, by `clock`; a status may
    have been on its way before whatever was written later. mpos_mm, wpos_mm: None until reported, and
    until the controller has said whether it reports in mm or in inches.
    overrides: feed, rapid and spindle in percent, as last reported since the controller started.
    outputs: what was on then, as `Status` has it. planner_blocks: moves that it plans ahead.
    cannot: what it has said that it cannot do ([CANNOT:hold] of `$I`), empty for grbl.
    is_stopping: noise, floods and stray answers raise nothing, since they must not disturb the stopping.
    """

    def __init__(
        self,
        link: Link,
        clock: Callable[[], float] = time.monotonic,
        listen: Callable[[list[Received]], None] = lambda received: None,
        interlock: MotionInterlock | None = None,
    ):
        self.link = link
        self.clock = clock
        self.firmware: Firmware = GRBL
        self.cannot: frozenset[str] = frozenset()
        self.counting = CharacterCounting()
        self.planner_blocks = PLANNER_BLOCKS
        self.status: Status | None = None
        self.status_asked_s = float("-inf")
        self.settings: dict[int, float] = {}
        self.overrides: tuple[int, ...] | None = None
        self.outputs: str | None = None
        self.is_stopping = False
        self._listen = listen
        self._flood = FloodLimit(clock)
        self._questions = 0  # `?` written and not answered
        self._echoes = 0  # lines written that a firmware built with REPORT_ECHO_LINE_RECEIVED has yet to repeat
        self._damaged_s: float | None = None  # when the first status came damaged of which no whole one followed
        self._interlock = interlock or MotionInterlock()
        self._tail = b""
        self._asked_s: float | None = None
        self._spoken = False
        self._mpos: Vector | None = None
        self._wpos: Vector | None = None
        self._wco: Vector | None = None

    @property
    def unanswered(self) -> deque[Sent]:
        """The lines that were sent and not answered, in their order."""
        return self.counting.unanswered

    @property
    def window(self) -> int:
        """The bytes of lines that may be under way."""
        return self.counting.window

    # --- writing -------------------------------------------------------------------------------

    def fits(self, text: str) -> bool:
        """Return whether the receive buffer has room for one more line."""
        return self.counting.fits(text)

    def send(self, text: str, index: int = -1) -> None:
        """Count a line and queue it for `flush`; the caller has asked `fits`.

        Raises MachineRefusal for one that moves a machine whose position is lost.
        """
        self._interlock.check_line(text)
        self._spoken = True
        self.counting.add(text, index)
        self._echoes = min(self._echoes + 1, MOST_ECHOES)

    def flush(self) -> None:
        """Write of the queued lines what may wait before the line; `receive` writes the rest in time."""
        to_write = self.counting.to_write
        if to_write and (room := self.link.queue_bytes - self._waiting_bytes()) > 0:
            self.link.write(bytes(to_write[:room]))
            del to_write[:room]

    def realtime(self, byte: bytes) -> None:
        """Write a real-time byte now, before anything queued.

        Raises MachineRefusal for a cycle start of a machine whose position is lost.
        """
        self._interlock.check_realtime(byte)
        self.link.write(byte)

    def reset(self) -> None:
        """Soft reset: the controller forgets its lines, so nothing is under way any more."""
        self.realtime(RESET)
        self._forget_lines()
        self._spoken = False  # answers may be on their way still

    def ask_status(self) -> None:
        """Write `?`."""
        self.realtime(STATUS)
        self._questions += 1
        if self._asked_s is None:
            self._asked_s = self.clock()

    def question_age_s(self) -> float | None:
        """Return how long a `?` has been without answer, or None."""
        return None if self._asked_s is None else self.clock() - self._asked_s

    # --- reading -------------------------------------------------------------------------------

    def receive(self, wait_s: float) -> list[Received]:
        """Return the controller's messages, waiting up to `wait_s` for the first byte.

        Raises LinkError for a broken link, an answer without a line, or a flood of text.
        """
        questions, is_asked = self._questions, self._is_asked
        received = [self._taken(report) for report in map(status_reports.parse, self._lines(self._read(wait_s)))]
        self._listen(received)
        self._check_flood(received, questions - self._questions, is_asked)
        return received

    def damaged_s(self) -> float:
        """Return how long every status that came was damaged, in s; 0 where the last one was whole."""
        return 0.0 if self._damaged_s is None else self.clock() - self._damaged_s

    @property
    def mpos_mm(self) -> Vector | None:
        """The machine position last reported."""
        return self.mm(self._mpos or _sum(self._wpos, self._wco, 1))

    @property
    def wpos_mm(self) -> Vector | None:
        """The work position last reported: machine position minus the offset last reported."""
        return self.mm(self._wpos or _sum(self._mpos, self._wco, -1))

    @property
    def wco_mm(self) -> Vector | None:
        """The offset of the work zero last reported."""
        return self.mm(self._wco)

    @property
    def feed_mm_min(self) -> float | None:
        """The speed last reported."""
        feed = self.status.feed if self.status else None
        return None if feed is None or REPORT_INCHES not in self.settings else self._length_mm(feed)

    def mm(self, position: Vector | None) -> Vector | None:
        """Return a position in the controller's own units ($13) in mm; None before these units are known."""
        if position is None or REPORT_INCHES not in self.settings:
            return None
        return tuple(map(self._length_mm, position))

    def _waiting_bytes(self) -> int:
        """Return how many bytes wait before the line; what was answered does not."""
        return min(self.link.waiting_bytes(), self.counting.written())

    def _read(self, wait_s: float) -> bytes:
        """Return the text received, and write queued bytes as the line takes them."""
        end_s = self.clock() + wait_s
        if self.counting.bytes_under_way > self._rest_bytes():
            if not self._rested(min(self.link.leaving_s(self._rest_bytes()), LONGEST_REST_S, wait_s)):
                return b""
            if data := self.link.read(0.0):
                return data
        while self.counting.to_write and (left_s := end_s - self.clock()) > 0:
            if (data := self.link.read(min(self._filled_s(), left_s))) or self.link.woken:
                return data
        return self.link.read(max(end_s - self.clock(), 0.0))

    def _rested(self, wait_s: float) -> bool:
        """Let answers gather, so that they are taken together; return False when `wake` was called."""
        end_s = self.clock() + wait_s
        while (left_s := end_s - self.clock()) > 0:
            self.link.rest(min(self._filled_s(), left_s) if self.counting.to_write else left_s)
            if self.link.woken:
                return False
        return True

    def _filled_s(self) -> float:
        """Fill the queue before the line; return when it must be filled again."""
        self.flush()
        most = self.link.queue_bytes
        unread = self.counting.written() - most
        return self.link.leaving_s(most if 2 * unread > self.window else self.link.filling_bytes)

    def _rest_bytes(self) -> int:
        """Return how many bytes go out while answers gather: two fillings, the second of them with the next lines."""
        return 2 * self.link.filling_bytes

    def _lines(self, data: bytes) -> list[str]:
        """Return the whole lines that have come, safe to show: nothing behind this needs to know what came."""
        *lines, self._tail = (self._tail + data).replace(b"\r", b"\n").split(b"\n")
        if len(self._tail) > NOISE_LIMIT_BYTES:
            self._tail = b""
            if not self.is_stopping:
                advice = "check the baud rate and what is connected"
                raise LinkError("link-noise", Text("{link} sends no line ends", link=self.link.name), advice=advice)
        texts = b"\n".join(lines).decode("ascii", "replace").split("\n")
        return [printable(text) for text in (text.strip(" \t") for text in texts) if text]

    def _taken(self, report: Report) -> Received:
        if isinstance(report, Answer):
            return self._answered(report)
        if isinstance(report, Status):
            self._take_status(report)
        elif isinstance(report, Setting):
            self.settings[report.number] = report.value
        elif isinstance(report, Greeting):
            self._forget_lines()
            self._spoken = False  # what was under way may still be answered in part
            self.overrides = None
            self._recognise(firmware_of_greeting(report.text))
        elif isinstance(report, Feedback):
            self._take_feedback(report)
        elif isinstance(report, Damaged) and self._damaged_s is None:
            self._damaged_s = self.clock()
        return report

    @property
    def _is_asked(self) -> bool:
        """Whether a `$` command is under way, whose answer may be long."""
        return bool(self.unanswered) and self.unanswered[0].text.startswith("$")

    def _check_flood(self, received: list[Received], asked: int, is_asked: bool) -> None:
        """Raise LinkError where much more comes than the answers to lines and questions.

        is_asked: a `$` command was under way before these came; its answer may have come with its end.
        """
        echoes = min(self._echoes, sum(isinstance(report, Feedback) and report.tag == "echo" for report in received))
        self._echoes -= echoes
        unasked = len(received) - asked - echoes - sum(isinstance(report, Answered) for report in received)
        if unasked > 0 and not self.is_stopping:
            self._flood.check(unasked, is_asked or self._is_asked, self.link.name)

    def _take_feedback(self, report: Feedback) -> None:
        if firmware := firmware_of_tag(report.tag, report.text):
            self._recognise(firmware)
        elif report.tag == "OPT":
            self._take_options(report.text)
        elif report.tag == CANNOT:
            self.cannot |= {report.text.strip().lower()}

    def _recognise(self, firmware: Firmware) -> None:
        """Take over what answers there; a greeting that grblHAL or FluidNC shares with grbl changes nothing."""
        if firmware not in (self.firmware, GRBL):
            self.firmware = firmware

    def _answered(self, answer: Answer) -> Received:
        if not self._spoken:  # to a line of an earlier sender, or of before a reset
            return answer
        if not self.unanswered:
            self._spoken = False  # said once
            if self.is_stopping:
                return answer
            raise LinkError(
                "answer-stray",
                Text("{link} answered '{answer}' to no line", link=self.link.name, answer=answer.text),
                advice="close other programs on this port and check the cable; then set the zero again",
            )
        sent = self.counting.answered()
        error = self.firmware.error_number(answer.text) if answer.error < 0 else answer.error
        return Answered(sent, error)

    def _take_status(self, status: Status) -> None:
        self.status, self._damaged_s = status, None
        self._questions = max(0, self._questions - 1)
        if self._asked_s is not None:
            self.status_asked_s, self._asked_s = self._asked_s, None
        self._mpos, self._wpos = status.mpos, status.wpos
        self._wco = status.wco or self._wco
        self.overrides = status.overrides or self.overrides
        self.outputs = self.outputs if status.outputs is None else status.outputs
        if status.buffer:
            self.planner_blocks = max(self.planner_blocks, status.buffer[0])
            self.counting.see_free_bytes(status.buffer[1], keeps_window=not self.firmware.small_receive)

    def _take_options(self, text: str) -> None:
        """Take the sizes of planner and receive buffer from `[OPT:letters,blocks,bytes]`."""
        blocks, size = sizes(text)
        self.planner_blocks = blocks or self.planner_blocks
        self.counting.see_size(size)

    def _forget_lines(self) -> None:
        self.counting.forget()
        self._questions = 0
        self._asked_s = None

    def _length_mm(self, length: float) -> float:
        return mm_from_inch(length) if self.settings.get(REPORT_INCHES) else length


def _sum(first: Vector | None, second: Vector | None, sign: int) -> Vector | None:
    if first is None or second is None or len(first) != len(second):
        return None
    return tuple(a + sign * b for a, b in zip(first, second, strict=True))
