# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that tells of a job that did not end: what is certain, where on its path, and from which line again."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from CNCStepper.control.journal import store
from CNCStepper.control.journal.journal_records import Group
from CNCStepper.control.journal.replay import FORMAT, VERSION
from CNCStepper.control.journal.writer import JournalFile
from CNCStepper.control.processes.python_finder import command, environment
from CNCStepper.control.program.certificate import digest_of_text
from CNCStepper.workers.unfinished_job import answered

LIMIT_S = 120
TEXT = "G21 G90\nG1 X10 F600\nG1 X20\n"
HEADER = {
    "format": FORMAT, "version": VERSION, "begin": "2026-11-22 08:00:00", "machine": "table-a", "port": "COM3",
    "firmware": "1.1h", "lines": 300, "last_line": 301, "homing": True, "goes_back": False, "file": "Plate",
    "program_sha256": digest_of_text(TEXT),
}  # fmt: skip
GROUP = Group(1.8e9, 97, 60, 41, 43, 98, "Run", (-90.0, -40.0, -10.0), (10.0, 10.0, 10.0))
SHORT = {
    "lines": 3, "last_line": 3, "dialect": "grbl", "modes": "G0 G54 G17 G21 G90 G94", "mpos_mm": [0.0, 0.0, 0.0],
    "offsets_mm": {"G54": [0.0, 0.0, 0.0]},
}  # fmt: skip
ON_LINE_2 = Group(1.8e9, 3, 2, 1, 2, 3, "Run", (5.0, 0.0, 0.0), (5.0, 0.0, 0.0))


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where the journals are."""
    monkeypatch.setattr(store, "session_folder", lambda: tmp_path)
    return tmp_path


def journal(folder: Path, group: Group = GROUP, end: dict[str, Any] | None = None, **header: Any) -> JournalFile:
    file = JournalFile(folder / "1.journal")
    file.append(HEADER | header)
    file.append(group.to_content() | (end or {}))
    return file


def told_of(folder: Path, *programs: Path, port: str = "COM3", **known: Any) -> dict[str, Any]:
    journal(folder, **known).close()
    return answered({"port": port, "programs": [str(program) for program in programs]})["job"]


def written(folder: Path, text: str, name: str = "peça 1.nc") -> Path:
    path = folder / name
    path.write_bytes(text.encode("utf-8"))
    return path


@pytest.mark.parametrize("port", ["COM3", ""])
def test_the_line_is_the_first_that_is_not_certainly_cut(folder: Path, port: str) -> None:
    job = told_of(folder, port=port)
    assert (job["line"], job["file"], job["sha256"]) == (43, "Plate", digest_of_text(TEXT))
    names = ["program", "machine", "killed", "outputs", "certain", "not certain", "not sent", "last seen", "position"]
    assert [name for name, _ in job["told"]] == names


def test_the_interval_is_told_as_places_where_the_program_is_there_as_it_was_sent(folder: Path) -> None:
    others = written(folder, "G21\n", "outra.nc"), folder / "closed meanwhile.nc"
    told = dict(told_of(folder, *others, written(folder, TEXT), group=ON_LINE_2, **SHORT)["told"])
    assert told["on the path"].startswith("from X0.000 Y0.000 Z0.000 at line 2, to X20.000")
    assert told["last seen"].endswith("on the path at line 2")


def test_without_its_program_no_place_is_told(folder: Path) -> None:
    assert "on the path" not in dict(told_of(folder, written(folder, "G21\n"), group=ON_LINE_2, **SHORT)["told"])


def test_the_program_in_its_own_file_counts_while_it_is_the_same(folder: Path) -> None:
    file = written(folder, TEXT)
    assert "on the path" in dict(told_of(folder, group=ON_LINE_2, **SHORT, file=str(file))["told"])
    written(folder, TEXT.replace("X20", "X21"))
    answer = answered({"port": "COM3", "programs": []})
    assert "on the path" not in dict(answer["job"]["told"])


def test_how_it_ended_and_why(folder: Path) -> None:
    stopped = {"end": "stopped", "why": "stopped as asked after 60 lines", "position_known": True}
    assert dict(told_of(folder, end=stopped)["told"])["stopped"] == "stopped as asked after 60 lines"


def test_a_zero_that_was_set_within_the_job_is_told(folder: Path) -> None:
    zero = {"zero": {"line": 12, "offsets_mm": {"G54": [1.0, 2.0, 3.0]}}}
    assert "line 12" in dict(told_of(folder, end=zero, offsets_mm={})["told"])["work zero"]


@pytest.mark.parametrize(
    "unclear", [{"goes_back": True}, {"group": Group(1.0, 300, 300, 300, 0, 301)}], ids=["loops", "all cut"]
)
def test_where_a_line_would_be_wrong_none_is_proposed_and_it_is_said(folder: Path, unclear: dict[str, Any]) -> None:
    job = told_of(folder, **unclear)
    assert job["line"] == 0 and "restart" in dict(job["told"])


def test_a_restart_that_did_not_end_itself_leads_to_the_first_program_and_its_line(folder: Path) -> None:
    first = {"file": "First", "program_sha256": digest_of_text("G21\n"), "lines": [[40, 812]]}
    job = told_of(folder, restart_of=first, file="First-restart")
    assert (job["file"], job["sha256"], job["line"]) == ("First", digest_of_text("G21\n"), 815)
    assert "the program's 815" in dict(job["told"])["restart"]


def test_a_job_that_was_cut_to_its_end_or_runs_is_none(folder: Path) -> None:
    assert told_of(folder, end={"end": "done", "why": "", "position_known": True}) is None
    (folder / "1.journal").unlink()
    file = journal(folder)
    try:
        assert answered({"port": "", "programs": []})["refused"]["code"] == "job-runs"
        assert answered({"port": "COM3", "programs": []}) == {"job": None}
    finally:
        file.close()


def test_the_process_answers_and_ends_when_nobody_asks() -> None:
    question = json.dumps({"port": "a machine that never was", "programs": []}).encode("ascii") + b"\n"
    words = command(sys.executable, "CNCStepper.workers.unfinished_job")
    with subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment()) as process:
        assert process.stdin is not None and process.stdout is not None
        process.stdin.write(question)
        process.stdin.flush()
        assert json.loads(process.stdout.readline()) == {"job": None}
        process.stdin.close()
        assert process.wait(LIMIT_S) == 0
