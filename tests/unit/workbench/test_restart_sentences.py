# SPDX-License-Identifier: LGPL-2.1-or-later
"""All that is said of a restart, and of a job that did not end, is in the catalogue to its last word."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from CNCStepper.control.journal.journal_records import Group
from CNCStepper.control.journal.progress_interval import ProgressInterval
from CNCStepper.control.journal.replay import KILLED, FirstProgram, JobReplay
from CNCStepper.errors import ProgramError
from CNCStepper.recovery.restart.approach import Options
from CNCStepper.recovery.restart.description import words_of
from CNCStepper.recovery.restart.restart_places import RequestedPlace
from CNCStepper.recovery.restart.restart_program import restart
from CNCStepper.workbench.services import message_translation
from CNCStepper.workers.unfinished_job import job_summary
from helpers.tools import load

tool = load("translations")
ROOMS = ("job", "recovery", "workers", "control/journal")
CORE = Path(message_translation.__file__).parents[2]
SMALL = re.compile(r"[a-zà-ÿ]{2,}")
MILLED = (
    "(BEGIN OPERATION: POCKET)\nG21 G90\nT1\n{0}\nG4 P3\nG0 Z10\nX0 Y0\nG1 Z-2 F200\n{1}\nY20\nX0\nG0 Z10\nM5\nM2\n"
)


def shouted(text: str) -> str:
    """Return a text in capitals, but not the names of its values."""
    return "".join(part if part.startswith("{") else part.upper() for part in re.split(r"(\{[^}]*\})", text))


@pytest.fixture(scope="module")
def catalogue(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The sentences that the collector finds in the source."""
    path = tmp_path_factory.mktemp("catalogue") / "CNCStepper.ts"
    modules = (module for room in ROOMS for module in (CORE / room).rglob("*.py"))
    found = {sentence for module in modules for sentence, _ in tool.sentences_of(module.read_text("utf-8"))}
    tool.write(path, "en", {tool.Text(message_translation.CONTEXT, sentence): "" for sentence in sorted(found)})
    return path


@pytest.fixture(autouse=True)
def shouting(monkeypatch: pytest.MonkeyPatch, catalogue: Path) -> Iterator[None]:
    """FreeCAD speaks a language in which every word that was translated stands in capitals."""
    known = {text.source for text in tool.read(catalogue)}
    speech = SimpleNamespace(translate=lambda _, text: shouted(text) if text in known else text)
    monkeypatch.setitem(sys.modules, "FreeCAD", SimpleNamespace(Qt=speech))
    monkeypatch.setattr(message_translation, "CATALOGUE", catalogue)
    message_translation._catalogue.cache_clear()
    yield
    message_translation._catalogue.cache_clear()


def left_english(english: str) -> list[str]:
    return SMALL.findall(message_translation.translated(english))


def milled(spindle: str = "M3 S12000", cut: str = "X40 F800") -> str:
    return MILLED.format(spindle, cut)


@pytest.mark.parametrize(
    ("text", "where", "options", "words"),
    [
        (
            milled(),
            RequestedPlace(line=10),
            Options(overlap_mm=5.0),
            ("TURNING CLOCKWISE (M3)", "WAITS FOR 3 S", "CUTS 5 MM"),
        ),
        (
            milled(),
            RequestedPlace(line=9),
            Options(overlap_mm=99.0),
            ("ENTERS THERE BECAUSE", "IN THE OPERATION POCKET"),
        ),
        (
            milled("M4 S900\nM8"),
            RequestedPlace(line=12),
            Options(),
            ("TURNING COUNTER-CLOCKWISE (M4)", "THE COOLANT ON"),
        ),
        (milled("M5\nM7"), RequestedPlace(line=12), Options(), ("LEAVES THE SPINDLE OFF", "THE COOLANT ON")),
        (milled(), RequestedPlace(line=11), Options(laser=True), ("SWITCHES THE BEAM ON AT S12000",)),
        (milled(cut="G92 X5\nX40 F800"), RequestedPlace(line=12), Options(), ("SETS G92 AS IT WAS", "GOES TO Z")),
        (milled(cut="G91\nX40 F800\nG90"), RequestedPlace(at_mm=(30.0, 0.0)), Options(), ("OF ITS MOVE DONE",)),
    ],
)
def test_what_a_restart_does_is_said_to_its_last_word(
    text: str, where: RequestedPlace, options: Options, words: tuple[str, ...]
) -> None:
    english = list(words_of(restart(text, where, options=options)))
    said = "\n".join(map(message_translation.translated, english))
    assert [word for word in words if word not in said] == [], said
    assert [left for left in map(left_english, english) if left] == []


@pytest.mark.parametrize(
    "where",
    [
        RequestedPlace(line=3, time=9),
        RequestedPlace(contour=9),
        RequestedPlace(operation="X"),
        RequestedPlace(line=99),
        RequestedPlace(line=1),
    ],
)
def test_why_there_is_none_is_said_to_its_last_word(where: RequestedPlace) -> None:
    with pytest.raises(ProgramError) as refused:
        restart(milled(), where)
    error = refused.value
    assert [text for text in (error.what, error.limit, error.advice) if left_english(text)] == []


HEADER = {
    "lines": 300, "last_line": 301, "homing": True, "goes_back": False, "port": "COM3", "file": "PLATE", "machine": "A",
    "firmware": "1.1H", "begin": "2026-11-22 08:00:00", "program_sha256": "", "offsets_mm": {},
}  # fmt: skip
GROUP = Group(1.8e9, 97, 60, 41, 43, 98, "RUN", (-90.0, -40.0, -10.0), (10.0, 10.0, 10.0))
REACHED = ProgressInterval((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), 43, 98, 44)
ZERO = {"line": 12, "offsets_mm": {"G54": None}}


@pytest.mark.parametrize("reached", [None, REACHED, replace(REACHED, seen_line=0)], ids=["no path", "on it", "off it"])
@pytest.mark.parametrize("known", [{"position_known": False}, {"zero": ZERO}, {"end": "failed"}], ids=str)
@pytest.mark.parametrize("goes_back", [True, False])
def test_what_is_told_of_a_job_is_said_to_its_last_word(
    known: dict[str, Any], reached: ProgressInterval | None, goes_back: bool
) -> None:
    first = FirstProgram("PLATE", "", [[40, 812]]).to_content()
    header = HEADER | {"restart_of": first, "goes_back": goes_back}
    story = replace(JobReplay(Path("1.journal"), header, GROUP, KILLED, why="every line is cut"), **known)
    assert [text for _, text in job_summary(story, reached) if left_english(text)] == []
