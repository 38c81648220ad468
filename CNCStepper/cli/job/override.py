# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper override`: feed, rapid, spindle and coolant of a job that runs, from any terminal.

The words by which a person changes feed, rapid, spindle and coolant of a machine that runs: "feed +10", "flood".
"""

from __future__ import annotations

import re

import click

from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.job.running_job import follow, session_file, session_option
from CNCStepper.cli.job.status_text import overrides_changed, overrides_in_words, overrides_known
from CNCStepper.errors import Text

TENS_AND_ONES = {"+10": "10", "-10": "-10", "+1": "1", "-1": "-1", "100": "reset"}
STEPS: dict[str, dict[str, str]] = {  # of each kind: what is typed, and the step of the session's command
    "feed": TENS_AND_ONES,
    "rapid": {"100": "100", "50": "50", "25": "25"},
    "spindle": TENS_AND_ONES | {"stop": "stop"},
}
COOLANTS = ("flood", "mist")
HELP = "; ".join([*(f"{kind} {' '.join(steps)}" for kind, steps in STEPS.items()), *COOLANTS])
_WORDS = re.compile(f"({'|'.join(STEPS)}) *([^ ]*)")


def read_override(text: str) -> dict[str, str] | None:
    """Return the values of the command "override" that a text asks for; None where it asks for something else.

    Raises ValueError with words for a step that there is not.
    """
    words = text.lower().strip()
    if words in COOLANTS:
        return {"kind": "coolant", "step": words}
    found = _WORDS.fullmatch(words)
    if found is None:
        return None
    kind, step = found.groups()
    if step not in STEPS[kind]:
        raise ValueError(Text("there is no override '{words}'; there are: {known}", words=words, known=HELP))
    return {"kind": kind, "step": STEPS[kind][step]}


@click.command("override", context_settings={"ignore_unknown_options": True})  # of which -10 would be one
@click.argument("what", nargs=-1, required=True)
@session_option
def command(what: tuple[str, ...], session: str | None) -> None:
    """Change the speeds or the coolant of the job that runs, while it moves or stands, and print what is in force.

    \b
    cncstepper override feed +10       10 % of the programmed feed more; also -10 +1 -1
    cncstepper override feed 100       the programmed feed again
    cncstepper override rapid 50       rapid moves at half their speed; also 25 and 100
    cncstepper override spindle -10    as with the feed
    cncstepper override spindle stop   stop the spindle of a held machine, and start it again
    cncstepper override flood          switch flood coolant on, or off; also mist

    The mini-lathe takes none of them. On a parallel port or USB board the spindle is a relay, whose speed no share
    changes, and a feed above 100 % counts from behind the pulses that are queued (0.3 s).

    Printed are feed/rapid/spindle in percent, and what is on: S or C for the spindle's sense, F flood, M mist. The job
    is one that `cncstepper send` sent from any terminal, or that was sent from FreeCAD's window.
    """
    from CNCStepper.control.service.connection_session import attach

    values = _values(" ".join(what))
    with attach(session_file(session)) as client:
        known = follow(client, client.status(), overrides_known(), "override")
        client.ask("override", **values)
        shown = follow(client, known, overrides_changed(known), "override")
    show_text(overrides_in_words(shown) or Text("the controller does not tell its overrides"))


def _values(text: str) -> dict[str, str]:
    """Return the values of the command; raises a usage error."""
    try:
        values = read_override(text)
    except ValueError as error:
        raise click.UsageError(Text("{error}", error=error)) from error
    if values is None:
        raise click.UsageError(Text("'{text}' is no override: write for example feed +10, or flood", text=text))
    return values
