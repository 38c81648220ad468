# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper resume`: what the journal of a job says after a crash, and the command that restarts it safely."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click

from CNCStepper.cli.options import FilePath, read_program
from CNCStepper.errors import MachineRefusal, Place

if TYPE_CHECKING:
    from CNCStepper.control.journal.story import Story

UNTIL_HOMED = "until then nothing but homing, jogging and setting the zero is safe"


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
    if is_list:
        _list()
        return
    story = _story(journal)
    if story is None:
        click.echo("no job is unfinished: every one whose journal is kept was cut to its end")
        return
    _check_ended(story)
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


def _check_ended(story: Story) -> None:
    from CNCStepper.control.journal.story import RUNNING

    if story.end == RUNNING:
        raise MachineRefusal(
            "job-runs",
            f"the job still runs, on {story.header['port']}",
            advice="hold or stop it where it was started, or wait until it has ended",
            place=Place(str(story.path)),
        )


def _told(story: Story) -> Iterator[tuple[str, str]]:
    header, group = story.header, story.group
    machine = f"{header['machine']} at {header['port']}" if header["machine"] else header["port"]
    yield "journal", str(story.path)
    yield "program", f"{header['file'] or 'without a file'}, {story.total} lines to send"
    if story.first_program:
        yield (
            "goes on with",
            f"{story.first_program.file}: restart that one again, what its restart has cut counts as cut",
        )
    yield "machine", f"{machine}, grbl {header['firmware']}, begun {header['begin']}"
    yield "ended", _ended(story)
    for fault in story.faults:
        yield "damaged", fault
    yield from _lines(story)
    if group.wpos_mm and group.mpos_mm:
        moment = time.strftime("%Y-%m-%d %H:%M:%S", time.localtime(group.time_s))
        yield (
            "last seen",
            f"{group.state} at work {_place(group.wpos_mm)}, machine {_place(group.mpos_mm)} mm, {moment}",
        )
    yield "position", _position(story)
    if not story.is_done:
        yield "restart", _restart(story)


def _ended(story: Story) -> str:
    from CNCStepper.control.journal.story import KILLED

    if story.end == KILLED:
        return "killed: the sender or its computer stopped without a word; what the controller held it may have made"
    return f"{story.end}: {story.why}"


def _lines(story: Story) -> Iterator[tuple[str, str]]:
    """Yield what is certain of the program's lines, and what is not."""
    if not story.first_line:
        yield "certain", "every line is cut"
        return
    yield "certain", f"all before line {story.first_line} is cut" if story.finished else "nothing is certainly cut"
    if story.may_be_sent > story.finished:
        last = max(story.last_line, story.first_line)
        yield "not certain", f"line {story.first_line} may not have been begun, line {last} may have been sent"
    if story.may_be_sent < story.total:
        yield "not sent", "what comes after that"


def _position(story: Story) -> str:
    home = "home it" if story.header["homing"] else "set its zero again"
    if story.position_known is False:
        return f"unknown: {home} before the restart; {UNTIL_HOMED}"
    return (
        f"kept only if the controller has had power ever since and was not reset in motion; a greeting, an alarm or a "
        f"place that is not right says that it was: then {home}; {UNTIL_HOMED}"
    )


def _restart(story: Story) -> str:
    """Return the command that restarts the program, or why there is none."""
    if not story.first_line:
        return "every line is cut, only the program's end was not seen"
    name, sha256, line, goes_back = story.restarted
    if goes_back:
        return f"choose the pass yourself: the program sends lines again, so line {line} alone is no place"
    file = Path(name)
    if not file.is_file():
        return f"from line {line} of the program, which is not a file here any more: {name}"
    if _was_changed(file, sha256):
        return f"none: {file} was changed since, so its lines are not those of the journal; bring the old text back"
    words = ["cncstepper", "restart", str(file), "--line", str(line), *_machine(story)]
    return subprocess.list2cmdline(words) if sys.platform == "win32" else _quoted(words)


def _machine(story: Story) -> list[str]:
    """Return the option that names the machine; of a profile of one's own only the name is known."""
    from CNCStepper.machine.profile import profile_names

    name = story.header["machine"]
    return ["--machine", name if name in profile_names() else f"PROFILE-OF-{name or 'THE-MACHINE'}.toml"]


def _was_changed(file: Path, sha256: str) -> bool:
    from CNCStepper.control.certificate import digest_of_text

    return bool(sha256) and digest_of_text(read_program(file)) != sha256


def _quoted(words: list[str]) -> str:
    import shlex

    return shlex.join(words)


def _place(position_mm: tuple[float, ...]) -> str:
    return " ".join(f"{axis}{value:.3f}" for axis, value in zip("XYZABC", position_mm, strict=False))
