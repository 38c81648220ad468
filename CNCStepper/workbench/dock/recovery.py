# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the dock to a restart: of the program that is meant, or of a job that did not end."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from CNCStepper.control.journal.told import check_ended
from CNCStepper.workbench import program_file, tell
from CNCStepper.workbench.dock.recovery_view import RecoveryView
from CNCStepper.workbench.dock.unfinished import Reading, finder, line_of, name_of, program_of, reached_by, told
from CNCStepper.workbench.features.base import JOB, proxy_type
from CNCStepper.workbench.features.program import Program
from CNCStepper.workbench.sentences import translated
from CNCStepper.workbench.words import tr

if TYPE_CHECKING:
    from CNCStepper.control.journal.reached import Reached
    from CNCStepper.control.journal.story import Story
    from CNCStepper.workbench.dock.link import Link


class Recovery:
    """What the view's two buttons do; the offer is looked for whenever a controller was met."""

    def __init__(self, link: Link):
        self._link, self._reading = link, Reading()
        self._met = False
        self.view = RecoveryView(self._restart, self._ask)

    def advance(self) -> None:
        """Look for an offer once for every connection; called after every poll of the link."""
        met = self._link.moment.connected
        if met != self._met:
            self._met = met
            self.view.show_offer("")
            if met and not self._link.moment.job_runs:
                self._reading.ask(finder(self._link.address), self._offer)
        self._reading.poll()

    def _restart(self) -> None:
        """Choose the restart of the program that is meant."""
        from CNCStepper.workbench import restart
        from CNCStepper.workbench.commands import proving

        if why_not := proving.why_not():
            tell.notice(why_not)
            return
        program = proving.meant()
        proving.make(program)
        restart.open_restart(program)

    def _ask(self) -> None:
        """Look for the job that did not end, of this machine where there is one."""
        self._reading.ask(finder(self._link.address if self._met else ""), self._retrace)

    def _offer(self, story: Story | None) -> None:
        if story is not None:
            text = tr(
                "The last job of this machine, {0}, was not cut to its end. Unfinished job… says how far it came."
            )
            self.view.show_offer(text.format(_name(story)))

    def _retrace(self, story: Story | None) -> None:
        """Find out where on its path a job was, from the program as it was sent."""
        if story is None:
            tell.notice(tr("No job is unfinished."), tr("Every job whose journal is kept was cut to its end."))
            return
        check_ended(story)
        self.view.show_offer(tr("The path of the last job is read…"))
        texts = [text for _, text in _programs()]
        self._reading.ask(lambda: (story, reached_by(story, texts)), self._take_up)

    def _take_up(self, found: tuple[Story, Reached | None]) -> None:
        """Say what is certain of a job, and open its restart where its program is in an open document."""
        self.view.show_offer("")
        story, reached = found
        said = [(tr(name), translated(text)) for name, text in told(story, reached)]
        program = program_of(story, _programs())
        if program is None:
            text = tr("{0} was not cut to its end, and its program, as it was sent, is in no open document.")
            tell.notice(text.format(_name(story)), "\n".join(map(": ".join, said)))
            return
        from CNCStepper.workbench import restart

        restart.open_restart(program, line_of(story), said)


def _programs() -> Iterator[tuple[Any, str]]:
    """Yield the jobs and edited programs of all open documents with their texts."""
    import FreeCAD

    for document in FreeCAD.listDocuments().values():
        for obj in document.Objects:
            if proxy_type(obj) in (JOB, Program.Type):
                yield obj, program_file.load(obj)


def _name(story: Story) -> str:
    return name_of(story) or tr("a program")
