# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof by a process of its own: its answer, its refusals, and nothing left behind."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from PySide import QtCore

from CNCStepper.control.processes import python_finder
from CNCStepper.control.program.certificate import sendable
from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench import api
from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.proving.proof_process import ProofResult, ProofRun

LIMIT_S = 240  # with kernels to compile on a busy machine


class Heard:
    """What a run said; `wait` lets FreeCAD's events run until it has ended."""

    def __init__(self, run: ProofRun):
        self.run = run
        self.results: list[ProofResult] = []
        self.errors: list[CNCStepperError] = []
        self.stages: list[str] = []
        self.parts: list[tuple[Any, Any, bool]] = []  # part, work zero, whether all was proven before
        run.part.connect(lambda part, zero_mm: self.parts.append((part, zero_mm, bool(self.results))))
        run.finished.connect(self.results.append)
        run.failed.connect(self.errors.append)
        run.progress.connect(self.stages.append)
        run.start()

    def wait(self) -> Heard:
        end_s = time.monotonic() + LIMIT_S
        while not self.results and not self.errors and time.monotonic() < end_s:
            QtCore.QCoreApplication.processEvents()
            time.sleep(0.005)
        return self


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Where runs keep their folders, with a name that is not easy."""
    path = tmp_path / "peças à parte"
    path.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(path))
    application = QtCore.QCoreApplication.instance() or QtCore.QCoreApplication([])
    ProofRun._last = None
    yield path
    ProofRun._last = None
    assert application is not None


@pytest.fixture
def job(document: Any) -> Any:
    job = api.new_job(document, machine="table-a", stock_size_mm=(60, 50, 12), work_origin_mm=(5, 6, 7))
    cutter = api.add_tool(job, diameter_mm=6, feed_mm_min=800, plunge_mm_min=200, spindle_rpm=10000)
    api.add_elliptical_pocket(job, tool=cutter, radius_x_mm=20, radius_y_mm=14, depth_mm=4, stepdown_mm=2)
    document.recompute()
    return job


def test_a_clean_job_is_proven_from_its_text(job: Any, folder: Path) -> None:
    heard = Heard(ProofRun(job)).wait()
    assert not heard.errors, heard.errors
    (result,) = heard.results
    assert not result.refused and result.time_s == pytest.approx(result.report["time_s"])
    assert result.program_lines == api.program_text(job).splitlines()
    assert result.part.heights_mm.min() == pytest.approx(-4)
    assert tuple(result.work_origin_mm) == (5, 6, 7) and result.tools[1][0].max(axis=0)[0] == 3
    assert len(heard.stages) >= 2
    ((part, zero_mm, late),) = heard.parts
    assert (part.heights_mm == result.part.heights_mm).all() and tuple(zero_mm) == (5, 6, 7) and not late
    sent = sendable(result.send_file)
    sent.check()
    assert sent.port == "" and not sent.zero_confirmed and sent.expected[100] > 0
    assert sent.file == job.Label and sent.file_lines[-1] <= len(result.program_lines)


def test_the_text_is_proven_and_not_what_the_cycles_meant(job: Any, folder: Path) -> None:
    text = api.program_text(job)
    program_file.store(job, text.replace("Z-4", "Z-40"))
    job.purgeTouched()
    (result,) = Heard(ProofRun(job)).wait().results
    assert result.refused and result.part.heights_mm.min() < -30
    assert any(finding.severity == "error" and finding.place.line > 1 for finding in result.findings)


def test_an_unchanged_program_is_not_proven_again(job: Any, folder: Path) -> None:
    (first,) = Heard(ProofRun(job)).wait().results
    (again,) = Heard(ProofRun(job)).wait().results
    assert again is first
    api.edit(job.Operations[0], depth_mm=3)
    job.Document.recompute()
    (other,) = Heard(ProofRun(job)).wait().results
    assert other.part.heights_mm.min() == pytest.approx(-3)


def test_a_clamp_of_the_document_is_in_the_proof(job: Any, folder: Path) -> None:
    clamp = job.Document.addObject("Part::Box", "Clamp")
    clamp.Placement.Base = (5, 6, 0)  # beside the work zero, and 3 mm above it
    api.edit(job, clamps=[clamp])
    job.Document.recompute()
    (result,) = Heard(ProofRun(job)).wait().results
    assert result.refused and [finding.text for finding in result.findings if finding.code == "clamp"] == [
        "the tool goes into clamp 1"
    ]
    clamp.Placement.Base = (80, 6, 0)
    job.Document.recompute()
    (result,) = Heard(ProofRun(job)).wait().results
    assert not result.refused


def test_a_stale_or_missing_program_is_refused(job: Any, folder: Path) -> None:
    api.edit(job.Operations[0], depth_mm=3)
    assert [error.code for error in Heard(ProofRun(job)).wait().errors] == ["program-stale"]
    api.edit(job.Operations[0], active=False)
    job.Document.recompute()
    (error,) = Heard(ProofRun(job)).wait().errors
    assert error.code == "program-missing" and "no operations" in error.what
    assert not list(folder.iterdir())


def test_a_program_that_cannot_be_read_is_refused_with_its_line(job: Any, folder: Path) -> None:
    program_file.store(job, "G21 G90\nG0 X1 X2\n")
    job.purgeTouched()
    (error,) = Heard(ProofRun(job)).wait().errors
    assert error.place is not None and error.place.line == 2 and error.code and error.what
    assert not list(folder.iterdir())


def test_cancel_ends_the_process_and_leaves_nothing(job: Any, folder: Path) -> None:
    run = ProofRun(job)
    heard = Heard(run)
    end_s = time.monotonic() + LIMIT_S
    while run._process is None and time.monotonic() < end_s:
        QtCore.QCoreApplication.processEvents()
        time.sleep(0.005)
    process = run._process
    assert process.running and list(folder.iterdir())
    run.cancel()
    assert not process.running
    assert not run.running and not list(folder.iterdir()) and not heard.results and not heard.errors


def test_a_missing_python_is_said(job: Any, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    python_finder.find_python.cache_clear()
    monkeypatch.setenv(python_finder.VARIABLE, "/no/such/python")
    (error,) = Heard(ProofRun(job)).wait().errors
    assert error.code == "python-missing" and "shapely" in error.what + error.advice
    assert not list(folder.iterdir())
    python_finder.find_python.cache_clear()


def test_the_folder_goes_with_its_result(job: Any, folder: Path) -> None:
    heard = Heard(ProofRun(job)).wait()
    assert sendable(heard.results[0].send_file).port == ""
    heard.results.clear()
    ProofRun._last = None
    assert not list(folder.iterdir())
