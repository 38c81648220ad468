# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper console`: lines typed to a controller, each waited for, with history.

Controller messages while a console line is typed: printed at once, above that line.

One thread waits for the line, as it can on every system; another one reads the service's events, until the line comes.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from threading import Event, Thread
from types import TracebackType

import click

from CNCStepper.cli.common.language import show_text, translated
from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.job.override import read_override
from CNCStepper.cli.job.status_text import overrides_in_words
from CNCStepper.cli.machine.jog import FEED_MM_MIN, jog_line
from CNCStepper.cli.machine.service_client import LOOK_EVERY_S, ServiceClient, ServicePort, place, port_options
from CNCStepper.control.session.job_phase import Phase
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.errors import CNCStepperError, LinkError, Text

TOLD_EVENTS = ("message", "warning", "refused", "console")
TOLD_PHASES = (Phase.ALARM, Phase.HELD, Phase.DOOR)


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
            why = self._talk.client.error or Text("the connection service has ended")
            self._show(translated(Text("{why} (Enter ends the console)", why=why)))

    def _heard(self) -> Iterator[str]:
        """Yield the service's events since the last look, in words."""
        yield from (translated(event["text"]) for event in self._talk.heard() if event["event"] in TOLD_EVENTS)
        status = self._talk.status
        if (status.phase, _reason(status)) != (self._phase, self._reason):
            self._phase, self._reason = status.phase, _reason(status)
            if status.phase in TOLD_PHASES:
                yield "  ".join(filter(None, (place(status), translated(status.message))))

    def _show(self, text: str) -> None:
        """Put a line above the one that is typed, and that one below again, as far as it is known."""
        typed = _typed()
        begin, known = ("\n", "") if typed is None else ("\r", typed)
        click.echo(f"{begin}{text:<{len(self._prompt) + len(known)}}\n{self._prompt}{known}", nl=False)


def _reason(status: SenderStatus) -> str:
    return status.message if status.phase == "alarm" else ""


def _typed() -> str | None:
    """Return the text after the prompt, None where this Python cannot read it: then it stays where it is."""
    try:
        import readline
    except ImportError:  # on Windows
        return None
    return readline.get_line_buffer()


PROMPT = "> "
STANDING = ("Hold:0", "Idle", "Alarm", "Tool", "Door:0", "Door:1")
HISTORY_LINES = 1000
MOST_MM_MIN = 100_000.0
HELP = Text("""\
?                      where the machine stands
!  ~                   hold; go on
feed +10  rapid 50     overrides in %: also spindle -10, feed 100; flood, mist switch the coolant
stop                   bring it to rest: hold, standstill, reset; spindle and outputs off
home  unlock           $H and $X
zero [XYZ]             make this place the work zero
jog X10 Y-2.5 [F1000]  move by that way in mm
$$ $# $G $I $N         settings, offsets, modes, what it is, start-up lines
$110=500               change a setting
G0 X10, M3 S1000 ...   any line that the controller knows, while its position is not unknown
history  help  quit    (Ctrl-D quits; Ctrl-C holds a move)""")


@click.command("console", cls=Verb)
@port_options
def command(at: ServicePort) -> None:
    """Type lines to the controller at --port; the next is asked for when the last is done and the machine is at rest.

    Beside the controller's own lines it knows: ? ! ~ stop home unlock zero jog feed rapid spindle flood mist history
    help quit; help says what each does. Lines with bytes that act at once (! ? ~ and what is not ASCII) are refused.
    While the position is unknown, after a restart or an alarm that lost it, in an earlier connection too, only homing,
    jog, unlock, questions and settings are accepted; zero of all axes makes it known too. What the controller says by
    itself, an alarm for example, is shown as it comes.

    Lines also come from a pipe or a file; then the first refusal ends it with exit status 1.
    """
    with ServiceClient(at) as talk:
        click.echo(place(talk.status))
        if sys.stdin.isatty():
            with _history():
                converse(talk)
        else:
            _follow(talk)


class Session:
    """The actions of the console's words."""

    def __init__(self, talk: ServiceClient):
        self._talk = talk
        self._words: dict[str, Callable[[list[str]], None]] = {
            "?": lambda _: self._show(),
            "!": lambda _: self._realtime(talk.client.hold, Phase.HELD),
            "~": lambda _: self._go_on(),
            "stop": lambda _: self._realtime(talk.client.stop, "idle", "alarm"),
            "home": lambda _: talk.home(),
            "$h": lambda _: talk.home(),
            "unlock": lambda _: self._type("$X"),
            "zero": lambda words: talk.set_zero(words[0] if words else "XYZ"),
            "jog": self._jog,
            "help": lambda _: show_text(HELP),
        }

    def do(self, line: str) -> None:
        """Execute a line and wait until it is done; raises what is refused."""
        first, *words = line.split() or [""]
        if first.lower() in self._words:
            self._words[first.lower()](words)
        elif override := _override(line):
            self._talk.override(override)
            click.echo(overrides_in_words(self._talk.status) or "ok")
        elif line:
            self._type(line)

    def _show(self) -> None:
        click.echo(place(self._talk.ask_status()))

    def _go_on(self) -> None:
        stand = self._talk.status.stand  # that of which was told
        self._realtime(lambda: self._talk.client.resume(stand), "busy", "idle", "door")

    def _realtime(self, ask: Callable[[], None], *phases: str) -> None:
        ask()
        while self._talk.status.phase not in phases:
            self._talk.look()
        click.echo(place(self._talk.status))

    def _jog(self, words: list[str]) -> None:
        feeds = [word for word in words if word[:1] in "Ff"]
        self._type(jog_line(tuple(word for word in words if word not in feeds), _feed_mm_min(feeds)))

    def _type(self, line: str) -> None:
        """Type a line; while it is not done Ctrl-C holds, so that `~` or `stop` can follow."""
        answer = self._talk.type(line)
        if answer != "ok":
            raise click.ClickException(answer)
        click.echo(answer)


def _follow(talk: ServiceClient) -> None:
    """Do the lines of a pipe or a file; Ctrl-C holds what moves and ends it."""
    try:
        for line in map(str.strip, sys.stdin):
            if line == "quit":
                return
            Session(talk).do(line)
    except KeyboardInterrupt:
        talk.client.hold()
        raise


def _override(line: str) -> dict[str, str] | None:
    """Return the override that a line asks for, None where it asks for none; raises a usage error."""
    try:
        return read_override(line)
    except ValueError as error:
        raise click.UsageError(Text("{error}", error=error)) from error


def _feed_mm_min(words: list[str]) -> float:
    """Return the speed of a word as F500, or the usual one where there is none; raises a usage error."""
    try:
        feed_mm_min = float(words[0][1:]) if words else FEED_MM_MIN
    except ValueError:
        feed_mm_min = 0.0
    if not 0 < feed_mm_min < MOST_MM_MIN:
        raise click.UsageError(Text("'{words}' is no speed: write for example F500 (mm/min)", words=words[0]))
    return feed_mm_min


def converse(talk: ServiceClient) -> None:
    """Ask for line after line until quit; a refusal is printed, a lost link ends it."""
    session, typed = Session(talk), list[str]()
    for line in _lines(talk):
        if line == "quit":
            return
        if line == "history":
            click.echo("\n".join(typed))
            continue
        typed.append(line)
        try:
            _try(session, line)
        except KeyboardInterrupt:
            _hold(talk)


def _try(session: Session, line: str) -> None:
    """Execute a line; print a refusal."""
    try:
        session.do(line)
    except click.ClickException as error:
        show_text(error.message)
    except CNCStepperError as error:
        if isinstance(error, LinkError):
            raise
        show_text("{error}", error=error)


def _lines(talk: ServiceClient) -> Iterator[str]:
    """Yield the lines that are typed and show the controller's messages meanwhile. Raises the error of a lost link."""
    overheard = EchoInput(talk, PROMPT)
    while True:
        try:
            with overheard:
                line = input(PROMPT)
            talk.check()
            yield line.strip()
        except KeyboardInterrupt:
            click.echo()
        except EOFError:
            click.echo()
            return


def _hold(talk: ServiceClient) -> None:
    """Hold the machine and wait until it stops; a machine that is held already is no error."""
    talk.client.hold()
    with suppress(CNCStepperError):
        while talk.ask_status().machine_state not in STANDING:
            pass
    show_text("{status}   ~ goes on, stop ends it", status=place(talk.status))


@contextmanager
def _history() -> Iterator[None]:
    """Let the arrow keys bring back lines of this and earlier consoles, where this Python has readline."""
    try:
        import readline
    except ImportError:  # Windows' own console keeps the lines of one run
        yield
        return
    path = _history_file()
    with suppress(OSError):
        readline.read_history_file(path)
    readline.set_history_length(HISTORY_LINES)
    try:
        yield
    finally:
        with suppress(OSError):
            readline.write_history_file(path)


def _history_file() -> Path:
    from CNCStepper.control.session.files import session_folder

    return session_folder().parent / "console_history"
