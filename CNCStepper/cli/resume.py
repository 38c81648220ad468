# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper resume`: what the journal of a job says after a crash, and the command that restarts it safely."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click

from CNCStepper.cli.options import FilePath, read_program

if TYPE_CHECKING:
    from CNCStepper.control.journal.reached import Reached
    from CNCStepper.control.journal.story import Story

START_SYSTEM = "G54"  # of which --work-zero tells


@click.command("resume")
@click.argument("journal", type=FilePath, required=False)
@click.option("--all", "is_list", is_flag=True, help="List every journal that is kept, the latest first.")
def command(journal: Path | None, is_list: bool) -> None:
    """Say how far the job of JOURNAL came, by default the latest that was not cut to its end.

    Every job that is sent has a journal, in which each line stands before it goes out. After a crash of the computer
    or of the sender, a cut cable or a power loss, it tells which lines are certainly cut, which may be, and which
    are certainly not, whether the machine must be homed, and the command that restarts the program. Nothing is sent
    from here. A job that still runs is refused.
    """
    from CNCStepper.control.journal.told import check_ended

    if is_list:
        _list()
        return
    story = _story(journal)
    if story is None:
        click.echo("no job is unfinished: every one whose journal is kept was cut to its end")
        return
    check_ended(story)
    for name, text in _told(story):
        click.echo(f"{name:<13}{text}")


def _story(journal: Path | None) -> Story | None:
    from CNCStepper.control.journal.store import latest_unfinished
    from CNCStepper.control.journal.story import read_story

    return read_story(journal) if journal else latest_unfinished()


def _list() -> None:
    from CNCStepper.control.journal.store import stories

    for story in stories():
        header = story.header
        click.echo(f"{header['begin']}  {story.end:<8} {header['file'] or 'a program'}  {story.path}")


def _told(story: Story) -> Iterator[tuple[str, str]]:
    from CNCStepper.control.journal.told import begun_as, told_of

    yield "journal", str(story.path)
    yield from begun_as(story)
    yield from told_of(story, _reached(story))
    if not story.is_done:
        yield "restart", _restart(story)


def _reached(story: Story) -> Reached | None:
    """Return the interval as places, None where the program is not there as it was sent."""
    from CNCStepper.control.journal.reached import reached
    from CNCStepper.control.journal.sent_text import text_sent

    text = text_sent(story) if story.first_line else None
    return None if text is None else reached(story, text)


def _restart(story: Story) -> str:
    """Return the command that restarts the program, or why there is none."""
    from CNCStepper.control.journal.told import why_no_line

    if why_not := why_no_line(story):
        return why_not
    name, sha256, line, _ = story.restarted
    file = Path(name)
    if not file.is_file():
        return f"from line {line} of the program, which is not a file here any more: {name}"
    if _was_changed(file, sha256):
        return f"none: {file} was changed since, so its lines are not those of the journal; bring the old text back"
    words = ["cncstepper", "restart", str(file), "--line", str(line), *_machine(story), *_work_zero(story)]
    return subprocess.list2cmdline(words) if sys.platform == "win32" else _quoted(words)


def _work_zero(story: Story) -> list[str]:
    """Return the option by which a restart is made and compared with a zero that was set again within the job.

    Of a machine that cannot home itself machine coordinates mean nothing after a loss: the zero is said in words only.
    """
    zero_mm = story.zero.get("offsets_mm", {}).get(START_SYSTEM)
    if not zero_mm or not story.header["homing"] or START_SYSTEM not in story.zero["modes"].split():
        return []
    return ["--work-zero", ",".join(f"{value:.3f}" for value in zero_mm[:3])]


def _machine(story: Story) -> list[str]:
    """Return the option that names the machine; of a profile of one's own only the machine's name is known."""
    from CNCStepper.machine.profile import load_machine, profile_names

    name = story.header["machine"]
    shipped = (key for key in profile_names() if load_machine(key).name == name)
    return ["--machine", next(shipped, f"PROFILE OF {name or 'THE MACHINE'}.toml")]


def _was_changed(file: Path, sha256: str) -> bool:
    from CNCStepper.control.certificate import digest_of_text

    return bool(sha256) and digest_of_text(read_program(file)) != sha256


def _quoted(words: list[str]) -> str:
    import shlex

    return shlex.join(words)
