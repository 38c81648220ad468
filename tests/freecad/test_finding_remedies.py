# SPDX-License-Identifier: LGPL-2.1-or-later
"""The remedies of a proof's findings: each mends its finding, adds nothing worse, and is one undo step."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import Part
import pytest
from FreeCAD import Vector
from PySide import QtCore

from CNCStepper.errors import CNCStepperError
from CNCStepper.simulation.finding import SEVERITIES, Finding
from CNCStepper.workbench import api
from CNCStepper.workbench.proving.proof_process import ProofRun
from CNCStepper.workbench.simulation.finding_remedies import apply, change_for, of_proof
from CNCStepper.workbench.simulation.proven_job import Change, ProvenJob, value

LIMIT_S = 240  # with kernels to compile on a busy machine
POCKET = {"radius_x_mm": 16, "radius_y_mm": 12, "depth_mm": 4, "stepdown_mm": 2}


def proof_of(job: Any) -> Any:
    """Prove the program of a job object as it is now."""
    QtCore.QCoreApplication.instance() or QtCore.QCoreApplication([])
    run, found = ProofRun(job), []
    run.finished.connect(found.append)
    run.failed.connect(found.append)
    run.start()
    end_s = time.monotonic() + LIMIT_S
    while not found and time.monotonic() < end_s:
        QtCore.QCoreApplication.processEvents()
        time.sleep(0.005)
    assert not isinstance(found[0], Exception), found[0]
    return found[0]


def circle(document: Any, radius_mm: float, name: str = "Round") -> Any:
    drawing = document.addObject("Part::Feature", name)
    drawing.Shape = Part.Wire(Part.makeCircle(radius_mm, Vector(0, 0, 0)))
    return drawing


def new_job(document: Any, **tool: Any) -> tuple[Any, Any]:
    job = api.new_job(document, machine="table-a", stock_size_mm=(60, 50, 12))
    given = {"diameter_mm": 6, "feed_mm_min": 800, "plunge_mm_min": 200, "spindle_rpm": 10000, "flutes": 2}
    return job, api.add_tool(job, **{**given, **tool})


def pocketed(document: Any, pocket: dict[str, Any] | None = None, **tool: Any) -> Any:
    job, cutter = new_job(document, **tool)
    api.add_elliptical_pocket(job, tool=cutter, **{**POCKET, **(pocket or {})})
    return job


def with_coolant(document: Any) -> Any:
    job = pocketed(document)
    api.edit(job, coolant="mist")
    return job


def in_material(document: Any, **tool: Any) -> Any:
    job = pocketed(document, **tool)
    api.edit(job, material="plywood")
    return job


def freed(document: Any) -> Any:
    job, cutter = new_job(document)
    api.add_operation(job, "contour", circle(document, 18), tool=cutter, side="outside", depth_mm=12, stepdown_mm=3)
    return job


def plunged(document: Any) -> Any:
    job, cutter = new_job(document, feed_mm_min=1500, plunge_mm_min=1000)
    api.add_operation(job, "contour", circle(document, 18), tool=cutter, side="outside", depth_mm=4, stepdown_mm=2)
    return job


def outline_first(document: Any) -> Any:
    job, cutter = new_job(document)
    outline = circle(document, 18)
    api.add_operation(job, "contour", outline, tool=cutter, side="outside", depth_mm=12, stepdown_mm=3)
    api.add_operation(
        job,
        "contour",
        circle(document, 8, "Hole"),
        tool=cutter,
        side="inside",
        depth_mm=12,
        stepdown_mm=3,
    )
    return job


def beside(document: Any) -> Any:
    job, cutter = new_job(document)
    api.add_operation(job, "pocket", circle(document, 27), tool=cutter, depth_mm=2, stepdown_mm=2, stepover_mm=3)
    return job


def clamped(document: Any) -> Any:
    """Two holes with a clamp between them that is higher than the ways across."""
    job, cutter = new_job(document)
    bar = document.addObject("Part::Box", "Bar")
    bar.Length, bar.Width, bar.Height = 6, 80, 15
    bar.Placement.Base = Vector(-3, -40, 0)
    for x_mm in (-20, 20):
        api.add_operation(
            job,
            "circular_pocket",
            tool=cutter,
            centre_mm=(x_mm, 0),
            radius_mm=6,
            depth_mm=2,
            stepdown_mm=2,
            stepover_mm=2,
        )
    api.edit(job, clamps=[bar])
    return job


@dataclass(frozen=True)
class Case:
    """A job with a finding: its code, what makes the job, the value that is changed, and what it becomes."""

    code: str
    make: Callable[[Any], Any]
    changed: Callable[[Any], Any]
    wanted: Any


def of_tool(key: str) -> Callable[[Any], Any]:
    return lambda job: round(value(job.Tools[0], key), 3)


def of_operation(key: str) -> Callable[[Any], Any]:
    return lambda job: value(job.Operations[0], key)


DEEP = {"depth_mm": 9, "stepdown_mm": 4.5}
FAST = {"spindle_rpm": 24000, "feed_mm_min": 5000}
FEED, SPINDLE = of_tool("feed_mm_min"), of_tool("spindle_rpm")
CASES = {
    "fast spindle": Case("spindle-speed", lambda doc: pocketed(doc, spindle_rpm=30000), SPINDLE, 24000),
    "slow spindle": Case("spindle-speed", lambda doc: pocketed(doc, spindle_rpm=500), SPINDLE, 1000),
    "fast feed": Case("feed-above-rate", lambda doc: pocketed(doc, feed_mm_min=6000), FEED, 5000),
    "fast plunge": Case("feed-above-rate", plunged, of_tool("plunge_mm_min"), 800),
    "thick chips": Case("chip-load", lambda doc: pocketed(doc, chip_load_max_mm=0.03), FEED, 600),
    "thin chips": Case("chip-load", lambda doc: pocketed(doc, chip_load_min_mm=0.05), FEED, 1000),
    "fast rim": Case("feeds", lambda doc: in_material(doc, **FAST), SPINDLE, None),
    "short flutes": Case(
        "flute-length", lambda doc: pocketed(doc, DEEP, flute_length_mm=4), of_operation("stepdown_mm"), 4
    ),
    "deep pocket": Case("below-stock", lambda doc: pocketed(doc, {"depth_mm": 14}), of_operation("depth_mm"), 12),
    "small stock": Case("beside-stock", beside, lambda job: round(job.StockSize[1], 3), 74),
    "no tabs": Case("not-exact", freed, of_operation("tabs_by"), "count"),
    "outline first": Case("piece-loose", outline_first, lambda job: [each.Side for each in job.Operations],
                          ["inside", "outside"]),
    "no mist": Case("coolant", with_coolant, lambda job: job.Coolant, "flood"),
    "high clamp": Case("clamp", clamped, lambda job: job.Clearance.Value, 17),
}  # fmt: skip


def first(job: Any, code: str) -> tuple[Any, Finding, Change | None]:
    result = proof_of(job)
    finding = next((each for each in result.findings if each.code == code), None)
    assert finding is not None, [str(each) for each in result.findings]
    return result, finding, change_for(ProvenJob(job, result), finding)


def worst(result: Any) -> int:
    return min((SEVERITIES.index(each.severity) for each in result.findings), default=len(SEVERITIES))


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_a_remedy_mends_its_finding_and_nothing_becomes_worse(document: Any, case: Case) -> None:
    document.UndoMode = 1
    job = case.make(document)
    document.recompute()
    before = case.changed(job)
    result, finding, change = first(job, case.code)
    assert change is not None, str(finding)
    steps = document.UndoCount
    apply(job, change)
    assert document.UndoCount == steps + 1
    assert case.changed(job) != before and case.wanted in (None, case.changed(job))
    after = proof_of(job)
    assert not [each for each in after.findings if (each.code, each.text) == (finding.code, finding.text)]
    known = {(each.code, each.text) for each in result.findings}
    new = [each for each in after.findings if (each.code, each.text) not in known]
    assert all(SEVERITIES.index(each.severity) > SEVERITIES.index(finding.severity) for each in new), list(
        map(str, new)
    )
    assert worst(after) >= worst(result)
    document.undo()
    document.recompute()
    assert case.changed(job) == before
    assert finding.text in {each.text for each in proof_of(job).findings}


def test_what_needs_two_values_or_has_changed_has_no_remedy(document: Any) -> None:
    job = pocketed(document, feed_mm_min=6000)
    second = api.add_tool(job, diameter_mm=6, feed_mm_min=5500, plunge_mm_min=200, spindle_rpm=30000, flutes=2)
    api.add_elliptical_pocket(job, tool=second, **POCKET)
    document.recompute()
    result = proof_of(job)
    offered = {each.code: one for each, one in zip(result.findings, of_proof(job, result, list), strict=True)}
    assert offered["feed-above-rate"] is None and offered["spindle-speed"] is not None
    api.edit(job.Operations[0], depth_mm=3)
    document.recompute()
    assert set(of_proof(job, result, list)) == {None}


def test_a_change_that_an_operation_refuses_is_taken_back(document: Any) -> None:
    document.UndoMode = 1
    job = pocketed(document)
    document.recompute()
    program, steps = api.program_text(job), document.UndoCount
    with pytest.raises(CNCStepperError, match="stepover"):
        apply(job, Change(job.Operations[0], {"stepover_mm": 50.0}, "Stepover"))
    assert (api.program_text(job), document.UndoCount) == (program, steps)
