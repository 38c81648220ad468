# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of pulse letters as jobs: checked whole, sent as lines whose way the sender can follow."""

from __future__ import annotations

import random

import numpy as np
import pytest

from CNCStepper.control.program.wire_line import needs_idle, stores
from CNCStepper.control.protocol.grbl.motion_interlock import moves
from CNCStepper.control.stream.planned_path import PlannedPath
from CNCStepper.errors import MachineRefusal, ProgramError
from CNCStepper.job.letter_file import LETTERS_A_LINE, letter_file, letter_job
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.machine.pulse_letters import MOVES, letter_steps
from CNCStepper.state import Start


def board(**signals: object) -> Machine:
    content = load_machine("usb-board").model_dump()
    return Machine.model_validate(content | {"signals": content["signals"] | signals})


@pytest.mark.parametrize("letter", MOVES)
def test_steps_of_each_letter_are_those_of_its_axes(letter: str) -> None:
    wanted = [0, 0, 0]
    for sign, axis in zip(MOVES[letter][::2], MOVES[letter][1::2], strict=True):
        wanted["XYZ".index(axis)] = 1 if sign == "+" else -1
    assert letter_steps(letter) == tuple(wanted)


def test_letters_become_lines_with_the_lines_of_the_file() -> None:
    job = letter_job("AAAAB s AADD\n\nBBBt EE\n", board(), "way.letters")
    assert list(job.lines) == ["$L=AAAAB", "M3", "$L=AADD", "$L=BBB", "M5", "$L=EE"]
    assert list(job.file_lines) == [1, 1, 1, 3, 3, 3]
    assert (job.pulses_per_s == 500.0 and job.plan[-1] == (3, 0.028)) or list(job.plan[-1]) == [3, 0.028]
    assert job.dialect == "grbl:outputs=pins" and job.machine == "USB board"


def test_other_coolant_stays_on_when_one_goes_off() -> None:
    assert list(letter_job("mfAn", board()).lines) == ["M7", "M8", "$L=A", "M9", "M8"]


@pytest.mark.parametrize("seed", range(8))
def test_random_letters_keep_their_pulses_their_end_and_the_length_of_a_line(seed: int) -> None:
    rng = random.Random(seed)
    text = "".join(rng.choice([*MOVES, *"stmnfg", " ", "\n"]) for _ in range(900))
    print(f"seed {seed}")
    assert any(len(line) > LETTERS_A_LINE for line in text.replace(" ", "").split()), "a line must be cut"
    found, job = letter_file(text), letter_job(text, board())
    played = "".join(line[3:] for line in job.lines if line.startswith("$L="))
    steps = np.array([letter_steps(letter) for letter in played])
    assert found.pulses == len(played) == sum(letter in MOVES for letter in text)
    assert found.steps == tuple(steps.sum(axis=0).tolist())
    assert all(len(line) <= len("$L=") + LETTERS_A_LINE for line in job.lines)


def test_sender_follows_the_way_of_letters() -> None:
    lines = ["$L=AAB", "M3", "$L=C", "$L=DD"]
    path = PlannedPath(lines, Start.at_zero(), step_mm=(0.05, 0.05, 0.05))
    path.read(1)
    assert path.end_mm == pytest.approx((0.1, 0.05, 0.0))
    path.read(4)
    assert path.refused is None and path.end_mm == pytest.approx((0.0, 0.05, 0.05))
    path.drop_to((0.05, 0.05, 0.05), (0.01, 0.01, 0.01))
    assert path.line == 3, "in the middle of a line is on its way"


def test_line_of_letters_moves_and_need_not_wait_for_rest() -> None:
    assert moves("$L=A") and not needs_idle("$L=A") and not stores("$L=A")
    assert needs_idle("$$") and stores("$100=5")


@pytest.mark.parametrize(
    ("text", "code"),
    [("AAB4A", "letter"), ("  \n s \n", "program-empty"), ("A\nAé", "letter")],
)  # fmt: skip
def test_what_is_no_letter_is_refused_with_its_line(text: str, code: str) -> None:
    with pytest.raises(ProgramError) as refusal:
        letter_job(text, board(), "way.letters")
    assert refusal.value.code == code and refusal.value.place.file == "way.letters"


@pytest.mark.parametrize(
    ("text", "machine", "code"),
    [
        ("A" * 7000, board(), "letters-travel"),
        ("A", board(interval_ms=0.5), "letters-speed"),
        ("C", load_machine("thesis-table"), "letters-axis"),
        ("A", load_machine("table-a"), "letters-machine"),
    ],
)
def test_what_the_machine_cannot_play_is_refused(text: str, machine: Machine, code: str) -> None:
    with pytest.raises(MachineRefusal) as refusal:
        letter_job(text, machine)
    assert refusal.value.code == code and refusal.value.advice
