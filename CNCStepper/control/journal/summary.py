# SPDX-License-Identifier: LGPL-2.1-or-later
"""The summary of a journal for people: how the job ended, which lines are finished, where the machine was."""

from __future__ import annotations

import time
from collections.abc import Iterator
from typing import TYPE_CHECKING

from CNCStepper.control.journal.replay import KILLED, RUNNING, JobReplay
from CNCStepper.errors import MachineRefusal, Place, Text

if TYPE_CHECKING:
    from CNCStepper.control.journal.progress_interval import ProgressInterval

UNTIL_HOMED = "until then nothing but homing, jogging and setting the zero is safe"


def check_ended(story: JobReplay) -> None:
    """Raise MachineRefusal where the job still runs."""
    if story.end == RUNNING:
        raise MachineRefusal(
            "job-runs",
            Text("the job still runs, on {port}", port=story.header["port"]),
            advice="hold or stop it where it was started, or wait until it has ended",
            place=Place(str(story.path)),
        )


def begun_as(story: JobReplay) -> Iterator[tuple[str, str]]:
    """Yield the inputs of the job, each as a short name and a text."""
    header, first = story.header, story.first_program
    file, total = header["file"], story.total
    yield (
        "program",
        Text("{file}, {total} lines to send", file=file, total=total)
        if file
        else Text("without a file, {total} lines to send", total=total),
    )
    if first:
        yield (
            "goes on with",
            Text("{first_file}: restart that one again; its restart's cuts count as cut", first_file=first.file),
        )
    machine, port, firmware, begin = (header[name] for name in ("machine", "port", "firmware", "begin"))
    if machine:
        yield (
            "machine",
            Text(
                "{machine} at {port}, grbl {firmware}, begun {begin}",
                machine=machine,
                port=port,
                firmware=firmware,
                begin=begin,
            ),
        )
    else:
        yield "machine", Text("{port}, grbl {firmware}, begun {begin}", port=port, firmware=firmware, begin=begin)


def summary_of(story: JobReplay, reached: ProgressInterval | None = None) -> Iterator[tuple[str, str]]:
    """Yield what is known of a job that has ended: a short name, and the words. reached: where on its path it was."""
    yield story.end, why_it_ended(story)
    if story.end == KILLED:
        yield "outputs", "spindle, torch or beam may still be on: look, and switch them off at the machine"
    for fault in story.faults:
        yield "damaged", fault
    yield from _lines(story)
    yield from _places(story, reached)
    if story.zero:
        yield "work zero", _zero(story)
    yield "position", _position(story)


def why_it_ended(story: JobReplay) -> str:
    """Return why the job ended as it did."""
    if story.end == KILLED:
        return "the sender or its computer stopped suddenly; the controller may have executed the lines in its buffer"
    return story.why


def why_no_line(story: JobReplay) -> str:
    """Return why the job names no line from which its program can be restarted, "" where it does."""
    if not story.first_line:
        return "every line is cut, only the program's end was not seen"
    _, _, line, goes_back = story.restarted
    if goes_back:
        return Text(
            "choose the pass yourself: the program sends lines again, so line {line} alone is no place", line=line
        )
    return ""


def _lines(story: JobReplay) -> Iterator[tuple[str, str]]:
    """Yield which of the program's lines are certainly cut, and which are not."""
    if not story.first_line:
        yield "certain", "every line is cut"
        return
    yield (
        "certain",
        Text("all before line {first_line} is cut", first_line=story.first_line)
        if story.finished
        else "nothing is certainly cut",
    )
    if story.may_be_sent > story.finished:
        last = max(story.last_line, story.first_line)
        yield (
            "not certain",
            Text(
                "line {first_line} may not have been begun, line {last} may have been sent",
                first_line=story.first_line,
                last=last,
            ),
        )
    if story.may_be_sent < story.total:
        yield "not sent", "the lines after it"


def _places(story: JobReplay, reached: ProgressInterval | None) -> Iterator[tuple[str, str]]:
    """Yield the interval as places on the path, and where the machine was last seen."""
    if reached:
        begin, end = _place(reached.begin_mm), _place(reached.end_mm)
        interval = Text(
            "from {begin} at line {first_line}, to {end} at line {last_line}",
            begin=begin,
            first_line=reached.first_line,
            end=end,
            last_line=reached.last_line,
        )
        yield "on the path", Text("{interval} (work, mm)", interval=interval)
    group = story.group
    if group.wpos_mm and group.mpos_mm:
        moment = time.strftime("%Y-%m-%d %H:%M:%S", time.localtime(group.time_s))
        work, machine = _place(group.wpos_mm), _place(group.mpos_mm)
        yield (
            "last seen",
            Text(
                "{state} at work {work}, machine {machine} mm, {moment}",
                state=group.state,
                work=work,
                machine=machine,
                moment=_beside(moment, reached),
            ),
        )


def _beside(moment: str, reached: ProgressInterval | None) -> str:
    if reached is None:
        return moment
    if reached.seen_line:
        return Text("{moment}, on the path at line {seen_line}", moment=moment, seen_line=reached.seen_line)
    return Text("{moment}, OFF the path of these lines", moment=moment)


def _zero(story: JobReplay) -> str:
    """Return a text on a work zero that was set during the job, and its position."""
    before, now = story.header["offsets_mm"], story.zero["offsets_mm"]
    changed = [f"{name} {_place(now[name])}" for name in now if now[name] and now[name] != before.get(name)]
    places = ", ".join(changed) or "place not known"
    return Text(
        "set again at the pause at line {line}: {places} (machine, mm); later lines use this zero, earlier ones "
        "the old one",
        line=story.zero["line"],
        places=places,
    )


def _position(story: JobReplay) -> str:
    home = "home it" if story.header["homing"] else "set its zero again"
    if not story.position_known:  # of a killed job nobody has seen the end
        return Text("unknown: {home} before the restart; {until_homed}", home=home, until_homed=UNTIL_HOMED)
    return Text(
        "kept only if the controller stayed powered and was not reset in motion; a greeting, an alarm or a wrong "
        "position shows that it was: then {home}; {until_homed}",
        home=home,
        until_homed=UNTIL_HOMED,
    )


def _place(position_mm: tuple[float, ...]) -> str:
    return " ".join(f"{axis}{value:.3f}" for axis, value in zip("XYZABC", position_mm, strict=False))
