# SPDX-License-Identifier: LGPL-2.1-or-later
"""A file of pulse letters as a job: checked whole, then sent as lines `$L=AAAB...` to a controller of ours.

    file      AAAAB s AAAA...          wire    $L=AAAAB    M3    $L=AAAA...

Letters have no time: the profile's interval (`interval_ms` of its signals) is that of all pulses.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from CNCStepper.control.program.certificate import digest_of_pieces
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl.settings import expected_settings
from CNCStepper.errors import JobError, MachineRefusal, Place, ProgramError, Text
from CNCStepper.job.planned_times import milestones
from CNCStepper.machine.controller_family import makes_pulses
from CNCStepper.machine.profile import AXIS_NAMES, Machine
from CNCStepper.machine.pulse_letters import COMMAND
from CNCStepper.motion.signals.pulse_stream import moves_of
from CNCStepper.motion.signals.step_letters import AXES, DEVICES, read_letters
from CNCStepper.units import mm_s_from_mm_min

LETTERS_A_LINE = 70
WORDS = {"spindle_cw": ("M3", "M5"), "mist": ("M7", "M9"), "flood": ("M8", "M9")}  # on, off
COOLANTS = ("mist", "flood")


@dataclass(frozen=True)
class LetterFile:
    """The motion of a file of letters. steps: its end, of X, Y and Z. least, most: its extent."""

    pulses: int
    steps: tuple[int, ...]
    least: tuple[int, ...]
    most: tuple[int, ...]


def letter_file(text: str, file: str = "") -> LetterFile:
    """Return what letters do; raises ProgramError, with the line, at the first byte that is no letter."""
    here = np.zeros(AXES, np.int64)
    least, most, pulses = here.copy(), here.copy(), 0
    for chunk in read_letters([text.encode("utf-8")], file=file):
        if len(chunk):
            places = here + np.cumsum(moves_of(chunk, AXES), axis=0)
            least, most = np.minimum(least, places.min(axis=0)), np.maximum(most, places.max(axis=0))
            here, pulses = places[-1], pulses + len(chunk)
    if not pulses:
        raise ProgramError("program-empty", "the file has no pulse letter", advice="choose another", place=Place(file))
    return LetterFile(pulses, tuple(here.tolist()), tuple(least.tolist()), tuple(most.tolist()))


def check_letters(letters: LetterFile, machine: Machine) -> None:
    """Refuse letters that a machine cannot play: another controller, an axis that is not there, its speed, its travel.

    Where it will stand is not known here: the whole way must fit into the travel. Raises MachineRefusal.
    """
    if not makes_pulses(machine):
        what = Text("{machine} accepts no pulse letters", machine=machine.name)
        advice = "send them to a machine whose pulses this computer makes"
        raise MachineRefusal("letters-machine", what, value=machine.controller, advice=advice)
    for number, name in enumerate(AXIS_NAMES):
        steps = letters.most[number] - letters.least[number]
        if steps:
            _check_axis(machine, name, steps)


def _check_axis(machine: Machine, name: str, steps: int) -> None:
    axis = machine.own_axes.get(name)
    if axis is None:
        what = Text("the letters move {axis}, which this machine does not have", axis=name.upper())
        raise MachineRefusal("letters-axis", what, advice="choose another file, or another machine")
    way_mm, travel_mm = steps / axis.steps_per_mm, axis.travel_max_mm - axis.travel_min_mm
    if way_mm > travel_mm:
        raise MachineRefusal(
            "letters-travel",
            Text("the letters go farther than {axis} can travel", axis=name.upper()),
            value=f"{way_mm:.3f} mm",
            limit=f"{travel_mm:.3f} mm",
            advice="choose another file, or another machine",
        )
    speed_mm_s, most_mm_s = (
        1.0 / (machine.signals.interval_s * axis.steps_per_mm),
        mm_s_from_mm_min(axis.max_rate_mm_min),
    )
    if speed_mm_s > most_mm_s * (1.0 + 1e-9):
        raise MachineRefusal(
            "letters-speed",
            Text("at the profile's interval the letters are too fast for {axis}", axis=name.upper()),
            value=f"{speed_mm_s:.3f} mm/s",
            limit=f"{most_mm_s:.3f} mm/s",
            advice="raise interval_ms of the profile's signals",
        )


def letter_job(text: str, machine: Machine, file: str = "") -> SendJob:
    """Return the job of sending pulse letters; raises ProgramError, MachineRefusal for what cannot be played."""
    letters = letter_file(text, file)
    check_letters(letters, machine)
    lines, numbers = map(list, zip(*_wire_lines(text), strict=True))
    pulses = np.cumsum([len(line) - len(COMMAND) if line.startswith(COMMAND) else 0 for line in lines])
    return SendJob(
        port="",
        lines=lines,
        file=file,
        file_lines=numbers,
        expected=expected_settings(machine),
        dialect=machine.wire_language(),
        machine=machine.name,
        program_sha256=digest_of_pieces([text]),
        plan=milestones(numbers, pulses * machine.signals.interval_s),
        inputs=[entry.model_dump(mode="json") for entry in machine.input],
        pulses_per_s=1.0 / machine.signals.interval_s,
    )


def _wire_lines(text: str) -> Iterator[tuple[str, int]]:
    """Yield the lines to send and the file's line of each; a device letter ends the line before it."""
    on: set[str] = set()
    for number, line in enumerate(text.splitlines(), start=1):
        waiting = ""
        for letter in "".join(line.split()):
            if letter in DEVICES:
                if waiting:
                    yield COMMAND + waiting, number
                waiting = ""
                yield from ((word, number) for word in _words(*DEVICES[letter], on))
                continue
            waiting += letter
            if len(waiting) == LETTERS_A_LINE:
                yield COMMAND + waiting, number
                waiting = ""
        if waiting:
            yield COMMAND + waiting, number


def _words(device: str, is_on: bool, on: set[str]) -> list[str]:
    """Return the words that switch a device; M9 switches both coolants off, so the other one comes on again."""
    (on.add if is_on else on.discard)(device)
    words = [WORDS[device][0 if is_on else 1]]
    if words == ["M9"]:
        words += [WORDS[other][0] for other in COOLANTS if other in on]
    return words


def read_letter_text(path: Path) -> str:
    """Return the text of a file of letters; raises JobError where it cannot be read."""
    try:
        return path.read_bytes().decode("latin-1")
    except OSError as error:
        what = Text("{path} cannot be read: {error}", path=path, error=error)
        raise JobError("file", what, advice="look at its name and rights") from error
