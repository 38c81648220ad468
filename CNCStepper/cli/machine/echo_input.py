# SPDX-License-Identifier: LGPL-2.1-or-later
"""Controller messages while a console line is typed: printed at once, above that line.

One thread waits for the line, as it can on every system; another one hears the desk meanwhile, and only meanwhile.
"""

from __future__ import annotations

from collections.abc import Iterator
from threading import Event, Thread
from types import TracebackType

import click

from CNCStepper.cli.machine.service_client import LOOK_EVERY_S, ServiceClient, place
from CNCStepper.control.session.status import SenderStatus

TOLD_EVENTS = ("message", "warning", "refused", "console")
TOLD_PHASES = ("alarm", "held", "door")


class EchoInput:
    """Used as a context while a line is typed after `prompt`, again and again."""

    def __init__(self, talk: ServiceClient, prompt: str):
        self._talk = talk
        self._prompt = prompt
        self._over = Event()
        self._listener: Thread | None = None
        self._phase, self._reason = talk.status.phase, ""  # last told

    def __enter__(self) -> None:
        if self._talk.status.phase != "alarm":  # of an alarm the line before has not told the reason
            self._phase = self._talk.status.phase
        self._over.clear()
        self._listener = Thread(target=self._listen, name="overheard", daemon=True)
        self._listener.start()

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self._over.set()
        if self._listener:
            self._listener.join()

    def _listen(self) -> None:
        while not self._over.wait(LOOK_EVERY_S) and not self._talk.is_over:
            for text in self._heard():
                self._show(text)
        if self._talk.is_over:
            self._show(f"{self._talk.client.error or 'the desk has ended'} (Enter ends the console)")

    def _heard(self) -> Iterator[str]:
        """Yield what the desk has told since the last look, in words."""
        yield from (event["text"] for event in self._talk.heard() if event["event"] in TOLD_EVENTS)
        status = self._talk.status
        if (status.phase, _reason(status)) != (self._phase, self._reason):
            self._phase, self._reason = status.phase, _reason(status)
            if status.phase in TOLD_PHASES:
                yield "  ".join(filter(None, (place(status), status.message)))

    def _show(self, text: str) -> None:
        """Put a line above the one that is typed, and that one below again, as far as it is known."""
        typed = _typed()
        begin, known = ("\n", "") if typed is None else ("\r", typed)
        click.echo(f"{begin}{text:<{len(self._prompt) + len(known)}}\n{self._prompt}{known}", nl=False)


def _reason(status: SenderStatus) -> str:
    return status.message if status.phase == "alarm" else ""


def _typed() -> str | None:
    """Return what stands after the prompt by now, None where this Python cannot tell: then it stays where it is."""
    try:
        import readline
    except ImportError:  # on Windows
        return None
    return readline.get_line_buffer()
