# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random clicks, keys and values over every panel: no traceback, no frozen window, no bad program, undo gives all back.

A walk has 100 steps; `make monkey` takes 200 of them. A failed walk has its seed in its name: `make monkey STEPS=100
SEED=n` takes it again.
"""

from __future__ import annotations

import os
from typing import Any

import FreeCAD
import FreeCADGui
import Part
import pytest

from CNCStepper.errors import CNCStepperError
from CNCStepper.gcode.wire.read_back import refused_lines
from CNCStepper.workbench import api
from CNCStepper.workbench.features.base import problem_of, proxy_type, value_of
from CNCStepper.workbench.features.catalogue import OPERATIONS
from window_helpers.hand import Hand
from window_helpers.monkey import Monkey

STEPS = int(os.environ.get("CNCSTEPPER_MONKEY_STEPS", "1000"))
FIRST_SEED = int(os.environ.get("CNCSTEPPER_MONKEY_SEED", "1"))
STEPS_A_WALK = 100
COMPUTED = {"program"}
pytestmark = pytest.mark.window("monkey")
WALKS = range(FIRST_SEED, FIRST_SEED + max(1, STEPS // STEPS_A_WALK))


def draw() -> Any:
    """Return a document with a job of milling and every operation of it, texts and shapes; nothing to undo."""
    document = FreeCAD.newDocument("Monkey")
    document.UndoMode = 1
    # No object of Draft: its editor, which a double click opens, crashes FreeCAD 1.1.3 when the document is closed.
    outline = document.addObject("Part::Feature", "Outline")
    outline.Shape = Part.makePolygon([(-30, -20, 0), (30, -20, 0), (30, 20, 0), (-30, 20, 0), (-30, -20, 0)])
    job = api.new_job(document)
    api.add_tool(job, diameter_mm=6)
    for cycle, kind in OPERATIONS.items():
        if "milling" in kind.BY:
            api.add_operation(job, cycle, outline)
    api.add_text(document, "ABC")
    api.add_shape(document, "flange")
    document.recompute()
    document.clearUndos()
    return document


def held(document: Any) -> dict[str, Any]:
    """Return what every object of ours holds but what is computed of it."""
    ours = [obj for obj in document.Objects if proxy_type(obj) and hasattr(obj.Proxy, "PROPERTIES")]
    values = {
        f"{obj.Name}.{entry.key}": value_of(obj, entry)
        for obj in ours
        for entry in obj.Proxy.PROPERTIES
        if entry.key not in COMPUTED
    }
    return {"objects": [obj.Name for obj in document.Objects], **values} | {
        f"{obj.Name}.problem": problem_of(obj) for obj in ours
    }


def not_undone(document: Any, before: dict[str, Any]) -> dict[str, Any]:
    """Return what differs from the beginning where no panel is open and nothing is left to undo."""
    if FreeCADGui.Control.activeDialog() or document.UndoCount:
        return {}
    return {key: value for key, value in held(document).items() if before.get(key) != value}


def unreadable(document: Any) -> list[str]:
    """Return why lines of the job's program are refused, none where it has no program that could be saved or sent."""
    (job,) = [obj for obj in document.Objects if proxy_type(obj) == "CNCStepper_Job"] or [None]
    try:
        text = api.program_text(job) if job is not None else ""
    except CNCStepperError:
        return []
    return [str(error) for error in refused_lines(text, None, "grbl", "program")]


@pytest.mark.parametrize("seed", WALKS)
def test_a_walk_of_random_steps(hand: Hand, seed: int) -> None:
    document = hand.main(draw, limit_s=300)
    hand.main(FreeCADGui.SendMsgToActiveView, "ViewFit")
    before = hand.main(held, document)
    monkey = Monkey(hand, seed)
    hand.expect_report("")  # refusals are said there too: what may not be is a traceback
    try:
        while monkey.steps < STEPS_A_WALK:
            monkey.step()
            assert hand.main(not_undone, document, before) == {}
        monkey.leave()
        traces = [line.text for line in hand.report() if "Traceback" in line.text or line.text.startswith("  File ")]
        assert not traces, traces
        assert hand.main(unreadable, document, limit_s=120) == []
        monkey.undo_all(document)
        assert hand.main(held, document) == before
    except BaseException:
        print(f"walk {seed}, the last steps: {list(monkey.done)}", flush=True)
        raise
