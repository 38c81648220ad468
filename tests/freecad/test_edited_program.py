# SPDX-License-Identifier: LGPL-2.1-or-later
"""An edited program in a document: kept beside its job's own, never written over, saved, undone, and proven."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD
import pytest

from CNCStepper.errors import JobError
from CNCStepper.job.proof_folder import read_question, write_question
from CNCStepper.workbench import api
from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.document.core_job import job_of, machine_of, proven_with
from CNCStepper.workbench.editor.model.line_status import clock, modes_text, place_text, time_text
from CNCStepper.workbench.editor.model.word_meanings import CODES, LETTERS, meaning_of
from CNCStepper.workbench.features.base import problem_of
from CNCStepper.workbench.features.program import job_behind


@pytest.fixture
def job(document: Any) -> Any:
    document.UndoMode = 1
    job = api.new_job(document, stock_size_mm=(100, 70, 20))
    api.add_tool(job, diameter_mm=6, feed_mm_min=800, plunge_mm_min=200, spindle_rpm=10000)
    api.add_elliptical_pocket(job, radius_x_mm=30, radius_y_mm=20, depth_mm=2)
    document.recompute()
    return job


def edited(job: Any) -> Any:
    obj = api.edit_program(job, "(à mão)\n" + api.program_text(job))
    job.Document.recompute()
    return obj


def test_no_recompute_writes_over_it(job: Any) -> None:
    obj = edited(job)
    text = program_file.load(obj)
    assert not obj.Note and not problem_of(obj) and text.startswith("(à mão)\n")
    api.edit(job.Operations[0], depth_mm=4)
    job.Document.recompute()
    assert program_file.load(obj) == text and "Z-4" in api.program_text(job)
    assert "has changed" in obj.Note
    job.Operations[0].Active = False
    job.Document.recompute()
    assert not program_file.load(job) and program_file.load(obj) == text


def test_it_stays_when_its_job_goes_and_says_what_it_lacks(job: Any) -> None:
    obj = edited(job)
    text, document = program_file.load(obj), job.Document
    document.removeObject(job.Name)
    document.recompute()
    assert program_file.load(obj) == text and "no job" in problem_of(obj)
    with pytest.raises(JobError, match="no job"):
        api.program_text(obj)


def test_undo_brings_the_text_before_back(job: Any) -> None:
    obj = edited(job)
    document, before = job.Document, program_file.load(obj)
    document.openTransaction("Edit")
    program_file.store(obj, "G21\nM2\n")
    document.commitTransaction()
    assert api.program_text(obj) == "G21\nM2\n"
    document.undo()
    assert program_file.load(obj) == before
    document.redo()
    assert program_file.load(obj) == "G21\nM2\n"


def test_it_is_saved_with_the_document_byte_for_byte(job: Any, tmp_path: Path) -> None:
    obj = edited(job)
    text, name = program_file.load(obj), obj.Name
    path = str(tmp_path / "peça.FCStd")
    job.Document.saveAs(path)
    FreeCAD.closeDocument(job.Document.Name)
    again = FreeCAD.openDocument(path)
    try:
        there = again.getObject(name)
        assert program_file.load(there) == text and job_behind(there).Label == "Job"
        assert api.program_text(there) == text
    finally:
        FreeCAD.closeDocument(again.Name)


def test_it_is_proven_with_what_its_job_says(job: Any, tmp_path: Path) -> None:
    obj = edited(job)
    behind = job_behind(obj)
    assert behind == job and job_behind(job) == job
    write_question(tmp_path, api.program_text(obj), job_of(behind), machine_of(behind))
    assert read_question(tmp_path)[0] == program_file.load(obj)


def test_what_the_status_line_says() -> None:
    state = {"units": "mm", "distance": "absolute", "plane": "XY", "feed_mode": "per_minute", "work_system": "G54"}
    state |= {"tool": 2, "spindle": "cw", "spindle_rpm": 9000.0, "feed": 254.0, "coolant": ["flood"]}
    answer = {"state": state, "work_mm": [25.4, None, -0.0], "time_s": 65.2}
    assert place_text(answer) == "X 25.400  Y ?  Z 0.000  mm"
    assert modes_text(answer) == "absolute · XY · G54 · F254 mm/min · S9000 clockwise · tool 2 · flood"
    inches = {**answer, "state": {**state, "units": "inch"}}
    assert place_text(inches) == "X 1.0000  Y ?  Z 0.0000  in" and "F10 in/min" in modes_text(inches)
    assert time_text(answer, 3725.0) == "1:05 of 1:02:05" and time_text(answer, None) == ""
    assert clock(59.7) == "1:00"


def test_what_words_mean() -> None:
    assert meaning_of("G01") == "G1: straight cut, at the feed F"
    assert meaning_of("G38.2").startswith("G38.2: probes") and meaning_of("G59.1") == "G59.1: work zero 7 of 9"
    assert meaning_of("X-1.5") == "X-1.5: place along X" and meaning_of("(a)") == "a comment"
    assert meaning_of("") == "" and meaning_of("?") == ""
    assert all(meaning_of(name) for name in (*CODES, *LETTERS))


def test_a_file_is_proven_with_machine_stock_and_tools_alone(job: Any, tmp_path: Path) -> None:
    file = tmp_path / "peça de fora.nc"
    file.write_text("G21 G90\nG0 Z5\nM30\n", "utf-8")
    api.add_tool(job, diameter_mm=3, feed_mm_min=300, plunge_mm_min=100, spindle_rpm=10000)
    loaded = api.load_program(job, file)
    job.Document.recompute()
    assert not problem_of(loaded) and not loaded.Note and loaded.Label == file.name
    model = proven_with(loaded)
    assert not model.operation and set(model.tools) == {1, 2} and model.stock == job_of(job).stock
    assert proven_with(job) == job_of(job) and proven_with(edited(job)).operation
    write_question(tmp_path, program_file.load(loaded), model, machine_of(job))
    assert not read_question(tmp_path)[1].operation
    file.write_text("G21 G90\nG0 Z7\nM30\n", "utf-8")
    assert api.load_program(job, file) is loaded and "Z7" in program_file.load(loaded)
    with pytest.raises(JobError, match="no such file"):
        api.load_program(job, tmp_path / "gone.nc")


def test_a_file_needs_a_job_without_operations_only(document: Any, tmp_path: Path) -> None:
    file = tmp_path / "a.nc"
    file.write_text("G21 G90\nG0 Z5\nM30\n", "utf-8")
    job = api.new_job(document, stock_size_mm=(100, 70, 20))
    api.add_tool(job)
    loaded = api.load_program(job, file)
    document.recompute()
    assert api.program_text(loaded) == "G21 G90\nG0 Z5\nM30\n" and not proven_with(loaded).operation
