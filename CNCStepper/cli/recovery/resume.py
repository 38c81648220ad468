# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper resume`: a job's journal after a crash, and the command that restarts it safely."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click

from CNCStepper.cli.common.language import show_text, translated
from CNCStepper.cli.common.options import FilePath, read_program
from CNCStepper.cli.common.verb import Verb
from CNCStepper.errors import ProgramError, Text

if TYPE_CHECKING:
    from CNCStepper.control.journal.progress_interval import ProgressInterval
    from CNCStepper.control.journal.replay import JobReplay


NOTHING_CUT, NOTHING_LEFT, WHOLE_ONLY = "restart-at-start", "restart-nothing-left", "restart-lathe"


@click.command("resume", cls=Verb)
@click.argument("journal", type=FilePath, required=False)
@click.option("--all", "is_list", is_flag=True, help="List every journal that is kept, the latest first.")
def command(journal: Path | None, is_list: bool) -> None:
    """Say how far the job of JOURNAL came, by default the latest that was not cut to its end.

    Every job that is sent has a journal, in which each line stands before it goes out. After a crash of the computer
    or of the sender, a cut cable or a power loss, it tells which lines are certainly cut, which may be, and which
    are certainly not, whether the machine must be homed, and the command that restarts the program. Nothing is sent
    from here. A job that still runs is refused.
    """
    from CNCStepper.control.journal.summary import check_ended

    if is_list:
        _list()
        return
    story = _story(journal)
    if story is None:
        show_text("no job is unfinished: every one whose journal is kept was cut to its end")
        return
    check_ended(story)
    for name, text in _told(story):
        click.echo(f"{name:<13}{translated(text)}")


def _story(journal: Path | None) -> JobReplay | None:
    from CNCStepper.control.journal.replay import read_replay
    from CNCStepper.control.journal.store import latest_unfinished

    return read_replay(journal) if journal else latest_unfinished()


def _list() -> None:
    from CNCStepper.control.journal.store import replays

    for story in replays():
        header = story.header
        click.echo(f"{header['begin']}  {story.end:<8} {header['file'] or 'a program'}  {story.path}")


def _told(story: JobReplay) -> Iterator[tuple[str, str]]:
    from CNCStepper.control.journal.summary import begun_as, summary_of

    yield "journal", str(story.path)
    yield from begun_as(story)
    yield from summary_of(story, _reached(story))
    if not story.is_done:
        yield from _restart(story)


def _reached(story: JobReplay) -> ProgressInterval | None:
    """Return the interval as places, None where the program is not there as it was sent."""
    from CNCStepper.control.journal.progress_interval import progress_interval
    from CNCStepper.control.journal.replay import text_sent

    text = text_sent(story) if story.first_line else None
    return None if text is None else progress_interval(story, text)


def _restart(story: JobReplay) -> Iterator[tuple[str, str]]:
    """Yield the command that restarts the program and what it lacks, or why there is none."""
    from CNCStepper.control.journal.summary import why_no_line

    name, sha256, line, _ = story.restarted
    file = Path(name)
    if why_not := why_no_line(story):
        yield "restart", why_not
    elif not file.is_file():
        yield (
            "restart",
            Text("from line {line} of the program, which is not a file here any more: {name}", line=line, name=name),
        )
    elif _was_changed(file, sha256):
        yield (
            "restart",
            Text(
                "none: {file} was changed since, so its lines are not those of the journal; bring the old text back",
                file=file,
            ),
        )
    else:
        yield from _offered(story, file, line)


def _offered(story: JobReplay, file: Path, line: int) -> Iterator[tuple[str, str]]:
    """Yield the command, and before it what it lacks."""
    from CNCStepper.cli.recovery.restart_command import RestartLine

    why_not = _no_entry(story, file, line)
    if why_not == NOTHING_LEFT:
        yield "restart", Text("none is needed: from there on the program cuts nothing")
        return
    offered = RestartLine(story, file, 0 if why_not else line)
    yield from offered.told
    if why_not:
        yield "whole", _why_whole(why_not, line)
    yield "restart", str(offered)


def _why_whole(code: str, line: int) -> Text:
    """Return why a program is sent from its beginning, where no entry at a line can be made."""
    if code == NOTHING_CUT:
        return Text("nothing is cut before line {line}, so the program is sent from its beginning", line=line)
    return Text(
        "the lathe's program has no entry in its middle: switch the lathe off and on, set its zero by hand, then send "
        "the program from its beginning"
    )


def _no_entry(story: JobReplay, file: Path, line: int) -> str:
    """Return NOTHING_CUT or NOTHING_LEFT where the program cuts nothing before a line, or from there on; else "".

    WHOLE_ONLY: its language has no entry.
    """
    from CNCStepper.recovery.restart.entry_point import entry_point_of
    from CNCStepper.recovery.restart.interrupted_program import read_program as read
    from CNCStepper.recovery.restart.restart_places import RequestedPlace, place_of

    try:
        program = read(read_program(file), story.header.get("dialect") or "grbl", None, str(file))
        entry_point_of(program, place_of(program, RequestedPlace(line=line)))
    except ProgramError as error:  # any other the command itself tells, which reads the program with all its options
        return error.code if error.code in (NOTHING_CUT, NOTHING_LEFT, WHOLE_ONLY) else ""
    return ""


def _was_changed(file: Path, sha256: str) -> bool:
    from CNCStepper.control.program.certificate import digest_of_text

    return bool(sha256) and digest_of_text(read_program(file)) != sha256
