# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job that did not end, as its journal tells it: no Qt, and nothing is waited for.

Journals may be long, so a thread reads them; whoever asked looks at `poll` now and then.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future
from typing import TYPE_CHECKING, Any

from CNCStepper.control.background import in_background
from CNCStepper.control.certificate import digest_of_text
from CNCStepper.control.journal.store import latest_unfinished, unfinished_at
from CNCStepper.control.journal.story import KILLED, Story
from CNCStepper.control.journal.told import begun_as, told_of, why_no_line
from CNCStepper.control.outcome import DONE, FAILED, STOPPED
from CNCStepper.workbench.dock.state import Moment
from CNCStepper.workbench.words import later

if TYPE_CHECKING:
    from CNCStepper.control.journal.reached import Reached

NAMES = {
    "program": later("Program"),
    "goes on with": later("Goes on with"),
    "machine": later("Machine"),
    KILLED: later("Killed"),
    STOPPED: later("Stopped"),
    FAILED: later("Failed"),
    DONE: later("Done"),
    "damaged": later("Damaged"),
    "certain": later("Certain"),
    "not certain": later("Not certain"),
    "not sent": later("Not sent"),
    "on the path": later("On the path"),
    "last seen": later("Last seen"),
    "work zero": later("Work zero"),
    "position": later("Position"),
    "restart": later("Restart"),
}
Found = Callable[[Any], None]


class Reading:
    """At most one question at a time; the newest counts."""

    def __init__(self) -> None:
        self._answer: Future[Any] | None = None
        self._found: Found | None = None

    def ask(self, find: Callable[[], Any], found: Found) -> None:
        """Let a thread find something; `poll` hands it to `found`."""
        self._answer, self._found = in_background(find), found

    def poll(self) -> None:
        """Hand out what was found; raises what the finding raised."""
        answer, found = self._answer, self._found
        if answer is not None and found is not None and answer.done():
            self._answer = self._found = None
            found(answer.result())


def finder(port: str) -> Callable[[], Story | None]:
    """Return what finds the last job of the machine at a port where it did not end; of any machine without a port."""
    return (lambda: unfinished_at(port)) if port else latest_unfinished


def why_not_now(moment: Moment) -> str:
    """Return why no restart can be chosen now, "" when one can."""
    return later("A job is being cut: wait for its end, or stop it.") if moment.job_runs else ""


def reached_by(story: Story, texts: Iterable[str]) -> Reached | None:
    """Return where on its path a job was, as `reached` does; None where its program is none of these texts, nor a file.

    Takes long for long programs.
    """
    from CNCStepper.control.journal.reached import reached
    from CNCStepper.control.journal.sent_text import text_sent

    text = text_sent(story, texts) if story.first_line else None
    return None if text is None else reached(story, text)


def told(story: Story, reached: Reached | None = None) -> Iterator[tuple[str, str]]:
    """Yield what is known of a job, a name to be translated and a sentence of the core each."""
    for name, text in (*begun_as(story), *told_of(story, reached)):
        yield NAMES[name], text
    if story.first_program and not why_no_line(story):
        yield (
            NAMES["restart"],
            f"it was a restart itself: the first line not certainly cut is the program's {line_of(story)}",
        )
    if why_not := why_no_line(story):
        yield NAMES["restart"], why_not


def line_of(story: Story) -> int:
    """Return the program's first line that is not certainly cut; 0 where the job names none."""
    _, _, line, _ = story.restarted
    return 0 if why_no_line(story) else line


def program_of(story: Story, programs: Iterable[tuple[Any, str]]) -> Any:
    """Return the object whose text the job, or the restart that it was, has cut; None where there is none.

    programs: objects with their texts.
    """
    _, sha256, _, _ = story.restarted
    return next((obj for obj, text in programs if digest_of_text(text) == sha256), None)


def name_of(story: Story) -> str:
    """Return what the program of a job is called, "" where it has no name."""
    name, _, _, _ = story.restarted
    return name
