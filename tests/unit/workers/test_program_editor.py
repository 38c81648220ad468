# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that reads while one types: refusals, times, lines, what lies under the pointer, the newest text."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from queue import SimpleQueue
from typing import Any

import numpy as np
import pytest

from CNCStepper.control.processes.python_finder import command, environment
from CNCStepper.job.editing.path_segments import read_lines
from CNCStepper.machine.profile import load_machine
from CNCStepper.workers.program_editor import Answers

LIMIT_S = 120
TEXT = "G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F200\nG1 X40\nG2 X60 Y20 J20\nG1 X\nG0 Z5 (up)\nM2\n"
FROM_ABOVE = np.diag([1 / 100, 1 / 100, -1 / 100, 1]).tolist()


class Here:
    """The worker in this process, asked and heard in turn."""

    def __init__(self, folder: Path, text: str = TEXT):
        (folder / "machine.json").write_text(load_machine("table-a").model_dump_json(), encoding="utf-8")
        (folder / "program.nc").write_text(text, encoding="utf-8")
        self.questions: SimpleQueue[dict[str, Any]] = SimpleQueue()
        self.told: list[dict[str, Any]] = []
        self.answers = Answers(folder, self.questions, self.told.append)
        self.folder = folder
        self.put({"as": {"dialect": "grbl", "file": "", "machine": True}}, {"text": "program.nc", "mark": 1})

    def put(self, *questions: dict[str, Any]) -> None:
        for question in questions:
            self.questions.put(question)

    def on_message(self, steps: int = 1) -> list[dict[str, Any]]:
        """Let it work and return what it told meanwhile."""
        self.told.clear()
        for _ in range(steps):
            self.answers.step()
        return list(self.told)


@pytest.fixture
def here(tmp_path: Path) -> Here:
    return Here(tmp_path)


def test_refusals_come_first_then_times_and_lines(here: Here) -> None:
    read, timed = here.on_message(2)
    assert (read["read"], read["lines"], read["refused"]) == (1, 8, 1)
    refusal = read["refusals"][0]
    assert (refusal["place"]["line"], refusal["place"]["column"], refusal["length"]) == (6, 4, 1)
    assert timed["timed"] == 1 and timed["duration_s"] > 5
    rapids, feeds = read_lines(here.folder / timed["path"])
    assert feeds.counts.sum() == len(feeds.points) > 10 and len(rapids.points)


def test_what_only_fails_when_it_is_sent_is_told_last(tmp_path: Path) -> None:
    here = Here(tmp_path, "\n".join(["G21", *["G0 X1"] * 5000, "G1 F100 X1." + "1" * 90, "M2"]))
    read, timed, sendable = here.on_message(3)
    assert read["refused"] == 0 and timed["duration_s"] >= 0
    (refusal,) = sendable["refusals"]
    assert (refusal["code"], refusal["place"]["line"]) == ("line-too-long", 5002)


def test_a_change_is_only_its_lines_and_answers_about_the_text_before_are_not_told(here: Here) -> None:
    here.on_message(2)
    here.put({"change": [5, 1, ["G1 X70", "G1 Y30"]], "mark": 2}, {"change": [0, 1, ["G21"]], "mark": 3})
    read, timed = here.on_message(2)
    assert (read["read"], read["lines"], read["refused"], timed["timed"]) == (3, 9, 0, 3)
    assert here.answers._text.lines[5:7] == ["G1 X70", "G1 Y30"]


def test_of_several_lines_that_are_asked_for_the_newest_is_answered(here: Here) -> None:
    here.on_message(2)
    here.put({"line": 1}, {"line": 2}, {"line": 5})
    (told,) = here.on_message()
    assert told["line"] == 5 and told["work_mm"] == [60, 20, -1]
    assert told["state"]["feed"] == 200 and told["time_s"] > 0
    way = np.array(told["way"])
    assert len(way) > 10 and way[0, 0].tolist() == [40, 0, -1] and way[-1, 1].tolist() == [60, 20, -1]


def test_a_new_text_ends_the_work_on_the_one_before(here: Here) -> None:
    here.put({"text": "program.nc", "mark": 2})
    here.answers._take()
    newest = here.answers._newest()
    assert newest()
    here.put({"change": [0, 0, ["(first)"]], "mark": 3})
    assert not newest() and not newest()
    assert [told.get("read", told.get("timed")) for told in here.on_message(2)] == [3, 3]


@pytest.mark.parametrize(("at", "line"), [((70, 50), 4), ((80.3, 59.9), 5), ((90, 90), None)])
def test_the_line_under_the_pointer(here: Here, at: tuple[float, float], line: int | None) -> None:
    here.on_message(2)
    here.put({"pick": {"matrix": FROM_ABOVE, "size": [100, 100], "at": [at[0], at[1]]}})
    (told,) = here.on_message()
    assert told == {"pick": line}


def test_of_two_ways_one_above_the_other_the_one_in_front_is_meant(tmp_path: Path) -> None:
    here = Here(tmp_path, "G21 G90\nG0 X0 Y0 Z5\nG1 X40 F100\nG1 Z-5\nG1 X0\nM2\n")
    here.on_message(3)
    here.put({"pick": {"matrix": FROM_ABOVE, "size": [100, 100], "at": [60, 50]}})
    assert here.on_message() == [{"pick": 3}]


def test_the_place_of_the_cuts_under_the_pointer(here: Here) -> None:
    here.on_message(2)
    question = {"matrix": FROM_ABOVE, "size": [100, 100]}
    for at, place in (((65, 50.4), [30, 0, -1]), ((80.3, 59.9), [60, 20, -1]), ((90, 90), None)):
        here.put({"place": {**question, "at": list(at)}})
        (told,) = here.on_message()
        assert told["place"] == (place and pytest.approx(place, abs=0.5))


def test_a_rapid_is_no_place_to_restart_at(tmp_path: Path) -> None:
    here = Here(tmp_path, "G21 G90\nG0 X0 Y0 Z5\nG0 X40\nG1 Z-5 F100\nM2\n")
    here.on_message(3)
    here.put({"place": {"matrix": FROM_ABOVE, "size": [100, 100], "at": [60, 50]}})
    assert here.on_message() == [{"place": None}]


def test_the_places_of_a_restart_are_listed(tmp_path: Path) -> None:
    text = "G21 G90 F200\n(operation: slot)\nG0 X0 Y0 Z5\nG1 Z-1\nX40\nG0 Z5\nY20\nG1 Z-1\nX0\nG0 Z5\nM2\n"
    here = Here(tmp_path, text)
    here.on_message(3)
    here.put({"contours": True})
    (told,) = here.on_message()
    told = json.loads(json.dumps(told))
    assert [(number, line, round(length_mm)) for number, line, *_, length_mm in told["contours"]] == [
        (1, 4, 46),
        (2, 8, 46),
    ]
    assert told["more"] == 0 and "error_of_contours" not in told


def test_of_a_program_that_cannot_be_read_no_places_are_listed(here: Here) -> None:
    here.on_message(2)
    here.put({"contours": True})
    (told,) = here.on_message()
    assert told["contours"] == [] and told["error_of_contours"]["place"]["line"] == 6


def test_what_a_refusal_means_of_its_line_is_measured(tmp_path: Path) -> None:
    here = Here(tmp_path, "G21\nG1 X1 Y1 Q12.5 F10\nX1 $22\n")
    (read,) = here.on_message()
    lengths = [(each["place"]["line"], each["place"]["column"], each["length"]) for each in read["refusals"]]
    assert lengths == [(2, 10, 5), (3, 4, 3)]


@pytest.fixture
def process(tmp_path: Path) -> Iterator[subprocess.Popen[str]]:
    (tmp_path / "program.nc").write_text(TEXT, encoding="utf-8")
    words = command(sys.executable, "CNCStepper.workers.program_editor", str(tmp_path))
    worker = subprocess.Popen(words, env=environment(), stdin=subprocess.PIPE, stdout=subprocess.PIPE, encoding="utf-8")
    yield worker
    worker.kill()
    worker.wait()


def test_a_process_of_its_own_answers_and_ends_with_its_input(process: subprocess.Popen[str]) -> None:
    assert process.stdin and process.stdout
    process.stdin.write(
        '{"as": {"dialect": "grbl", "file": "", "machine": false}}\n{"text": "program.nc", "mark": 1}\n'
    )
    process.stdin.flush()
    read, timed = (json.loads(process.stdout.readline()) for _ in range(2))
    assert read["refused"] == 1 and timed["duration_s"] is None
    process.stdin.close()
    assert process.wait(LIMIT_S) == 0


def test_what_cannot_be_asked_is_an_error_and_the_end(process: subprocess.Popen[str]) -> None:
    assert process.stdin and process.stdout
    process.stdin.write('{"weather": 1}\n')
    process.stdin.flush()
    assert json.loads(process.stdout.readline())["error"]["code"] == "editor-question"
    assert process.wait(LIMIT_S) == 1
