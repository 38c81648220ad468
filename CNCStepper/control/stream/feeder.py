# SPDX-License-Identifier: LGPL-2.1-or-later
"""The line that is sent next, the lines acknowledged, and the line that the controller executes."""

from __future__ import annotations

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.program.wire_line import changes_tool, dwell_s, is_move, needs_idle, only_pauses, pauses, stores
from CNCStepper.control.protocol.grbl.driver import Answered, Grbl
from CNCStepper.control.protocol.grbl.firmware import Firmware
from CNCStepper.control.stream.journal_protocol import ActiveJournal, NoJournal
from CNCStepper.control.stream.tool_power import ToolPower
from CNCStepper.errors import MachineRefusal, Place, ProgramError, Text


class Feeder:
    """Hands a job's lines to the driver as the window and the journal allow.

    Lines that write permanent memory, `$` commands and pauses go alone: they wait for every answer
    before them, and the lines after them wait for theirs. So nothing follows an M0 until it is over.

    An M0 on a line of its own is never sent: the sender itself pauses there, at an idle machine that may be jogged.
    by_line: so it does before every line. power: of the tool; one that cuts without turning has none at a stand.

    grblHAL answers an M6 and waits in its state Tool then: what follows waits until it was seen idle behind that.
    """

    def __init__(self, job: SendJob, journal: ActiveJournal | None = None):
        self.job = job
        self._journal = journal or NoJournal()
        self.by_line = job.by_line
        self.power = ToolPower()
        self.sent = 0
        self.acknowledged = 0
        self.total = len(job.lines)
        self._message = ""  # the program's last since its last pause
        self._released = -1  # the line that may go out by itself
        self._refused = False  # a line, with an error
        self._alone = False  # the last line sent must be answered before the next goes out
        self._changes_tool = False  # the last line sent was an M6
        self._tool_words = ""  # the program's, for that

    @property
    def complete(self) -> bool:
        """Whether every line was sent and acknowledged."""
        return self.acknowledged == self.total

    def feed(self, driver: Grbl, idle: bool) -> int:
        """Send what fits and return how many lines; `idle`: the machine was just reported idle."""
        before = self.sent
        permitted = self._journal.permitted
        while self.sent < self.total:
            text = self.job.lines[self.sent]
            special = not is_move(text)
            if (special or self.by_line) and self._stands(self.sent):
                self.power.stand(driver)
                break
            if self.sent >= permitted or (self._changes_tool and not idle):
                break
            self._set_power(text, special, driver)
            if not self._may_go(text, special, driver, idle):
                break
            if special and only_pauses(text):
                self._pass_pause()
            else:
                self._send(text, special, driver)
        driver.flush()
        return self.sent - before

    def take(self, answered: Answered) -> None:
        """Count the answer to a line of the job.

        No line after a refused one counts: the controller executes the others without it.
        """
        self._refused = self._refused or (answered.sent.index >= 0 and answered.error != 0)
        if answered.sent.index >= 0 and not self._refused:
            self.acknowledged += 1
            self._message = self.job.messages.get(answered.sent.index, self._message)
            if self._message and pauses(answered.sent.text):
                self._tool_words, self._message = self._message, ""

    def refusal(self, answered: Answered, firmware: Firmware) -> MachineRefusal:
        """Return the meaning of `error:n` for its line, in words and with its place in the file."""
        code = firmware.error(answered.error)
        return MachineRefusal(
            f"{firmware.key}-error-{answered.error}",
            Text(
                "the controller refused '{sent}': {meaning} (error:{error})",
                sent=answered.sent.text,
                meaning=code.meaning,
                error=answered.error,
            ),
            advice=code.advice,
            place=self.job.place(answered.sent.index),
        )

    def pause_message(self, driver: Grbl) -> str | None:
        """Return the program's words for the M0 that the controller is at; None when it is at none."""
        if driver.unanswered and pauses(driver.unanswered[0].text):
            return self.job.messages.get(driver.unanswered[0].index, self._message)
        return None

    def tool_message(self, driver: Grbl) -> str | None:
        """Return the program's words for the M6 that was answered; None where the last line is none, or is not."""
        return None if driver.unanswered or not self._changes_tool else self._tool_words

    def pause_text(self, driver: Grbl) -> str | None:
        """Return the message of a pause once all lines before it are answered; None without a pause."""
        if driver.unanswered or self.sent >= self.total or not self._stands(self.sent):
            return None
        text = self.job.lines[self.sent]
        if only_pauses(text):
            return self.job.messages.get(self.sent, self._message)
        return Text("next is line {line}: {text}", line=self.job.place(self.sent).line, text=text)

    def leave_pause(self) -> None:
        """Go on with the line that was waited before, as soon as the journal allows it."""
        self._released = self.sent

    def place_at_work(self) -> Place:
        """Return the place of the first line not acknowledged, or of the last one."""
        return self.job.place(min(self.acknowledged, self.total - 1))

    def dwell_s(self, driver: Grbl) -> float:
        """Return how long the oldest line under way may keep its answer back on purpose."""
        return dwell_s(driver.unanswered[0].text) if driver.unanswered else 0.0

    def _stands(self, index: int) -> bool:
        return self._released != index and (self.by_line or only_pauses(self.job.lines[index]))

    def _pass_pause(self) -> None:
        """Count an M0 that is over as a line that was sent and answered: all before it is cut."""
        self.sent += 1
        self.acknowledged += 1
        self._message = ""

    def _may_go(self, text: str, special: bool, driver: Grbl, idle: bool) -> bool:
        alone = special and (pauses(text) or stores(text) or needs_idle(text))
        if driver.unanswered and (alone or self._alone):
            return False
        if alone and needs_idle(text) and not idle:
            return False
        if not driver.fits(text):
            self._check_window(text, driver)
            return False
        self._alone = alone
        return True

    def _set_power(self, text: str, special: bool, driver: Grbl) -> None:
        """Stop the tool before it is changed, and give it the power back that it had before a stand."""
        if special and changes_tool(text):
            self.power.take(driver)
        elif self.power.is_taken and not only_pauses(text):
            self.power.give_back(driver, text)

    def _send(self, text: str, special: bool, driver: Grbl) -> None:
        driver.send(text, self.sent)
        self.sent += 1
        self._changes_tool = False
        if special:
            self.power.follow(text)
            self._changes_tool, self._tool_words = changes_tool(text), ""

    def _check_window(self, text: str, driver: Grbl) -> None:
        if not driver.unanswered:
            raise ProgramError(
                "line-too-long",
                "the line does not fit into the controller's buffer",
                value=f"{len(text) + 1} bytes",
                limit=f"{driver.window} bytes",
                advice="split that line",
                place=self.job.place(self.sent),
            )
