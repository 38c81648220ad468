# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kernels are compiled ahead in a process of its own; meanwhile nothing is compiled here.

The last test leaves word that all are compiled: windows that `make matrix` opens later need not look once more.
"""

from __future__ import annotations

import gc
import time
from collections.abc import Iterator
from typing import Any

import Part
import pytest
from FreeCAD import Vector
from PySide import QtCore

from CNCStepper import kernel_cache, kernels
from CNCStepper.control.processes import python_finder
from CNCStepper.workbench import api
from CNCStepper.workbench.calculation import kernel_warmup
from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.features.base import problem_of
from CNCStepper.workbench.services import jit_guard

LIMIT_S = 240  # with all kernels to compile on a busy machine
BEND = ((-25, -20), (25, -20), (25, 20), (5, 14), (-25, 20), (-25, -20))


@pytest.fixture(autouse=True)
def cold(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """No kernel is loaded, and nobody has said yet that all are compiled."""
    application = QtCore.QCoreApplication.instance() or QtCore.QCoreApplication([])
    kernel_cache.stamp().unlink(missing_ok=True)
    for kernel in ours():
        kernel._reset_overloads()
    monkeypatch.setattr(kernel_warmup, "_run", None)
    python_finder.find_python.cache_clear()
    yield
    if run := kernel_warmup.running():
        run.cancel()
    python_finder.find_python.cache_clear()
    assert application is not None


@pytest.fixture
def job(document: Any) -> Any:
    job = api.new_job(document, machine="table-a", stock_size_mm=(60, 50, 12))
    api.add_tool(job, diameter_mm=6, feed_mm_min=800, plunge_mm_min=200, spindle_rpm=10000)
    return job


def ours() -> list[Any]:
    dispatcher = type(kernels.njit(ours))
    return [kernel for kernel in gc.get_objects() if isinstance(kernel, dispatcher) and _is_ours(kernel)]


def _is_ours(kernel: Any) -> bool:
    return str(kernel.__module__).startswith("CNCStepper.")


def pocket(document: Any, job: Any, **values: Any) -> Any:
    drawing = document.addObject("Part::Feature", "Bend")
    drawing.Shape = Part.Wire(Part.makePolygon([Vector(x, y, 0) for x, y in BEND]))
    made = api.add_operation(job, "pocket", drawing, depth_mm=2, stepdown_mm=2, stepover_mm=2.4, **values)
    document.recompute()
    return made


def wait() -> None:
    end_s = time.monotonic() + LIMIT_S
    while kernel_warmup.running() and time.monotonic() < end_s:
        QtCore.QCoreApplication.processEvents()
        time.sleep(0.005)
    assert kernel_warmup.running() is None


def test_a_pocket_is_cut_without_compiling_anything(document: Any, job: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(jit_guard, "PATIENCE_S", LIMIT_S)
    assert kernel_warmup.begin() is not None
    made = pocket(document, job)
    assert problem_of(made) == "" and made.Passes > 0
    assert [kernel for kernel in ours() if kernel.signatures] == []
    plain = api.program_text(job)
    kernel_warmup.running().cancel()  # type: ignore[union-attr]
    made.Proxy.last_cut = None
    made.touch()
    document.recompute()
    assert [kernel for kernel in ours() if kernel.signatures] != []
    assert api.program_text(job) == plain


def test_nothing_is_started_where_all_is_compiled() -> None:
    kernel_cache.stamp().touch()
    assert kernel_warmup.begin() is None and kernel_warmup.running() is None


def test_without_a_python_for_it_all_goes_on(document: Any, job: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(python_finder.VARIABLE, "/no/such/python")
    monkeypatch.setattr(jit_guard, "PATIENCE_S", 0.0)
    assert kernel_warmup.begin() is not None
    made = pocket(document, job)
    assert "once after an installation" in problem_of(made)
    wait()
    assert problem_of(made) == "" and not kernel_cache.stamp().exists()


def test_what_takes_long_waits_and_is_then_made_by_itself(
    document: Any, job: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(jit_guard, "PATIENCE_S", 0.0)
    run = kernel_warmup.begin()
    assert run is not None and kernel_warmup.begin() is run
    told: list[int] = []
    run.ended.connect(lambda: told.append(1))
    made = pocket(document, job)
    assert "once after an installation" in problem_of(made) and program_file.load(job) == ""
    wait()
    assert kernel_cache.stamp().exists() and told == [1]
    assert problem_of(made) == "" and api.program_text(job)
    assert kernel_warmup.begin() is None
