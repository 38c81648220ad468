# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random clicks, keys and values over every panel: no traceback, no frozen window, no bad program, undo gives all back.

A walk has 100 steps; `make monkey` takes 200 of them. A failed walk has its seed in its name: `make monkey STEPS=100
SEED=n` takes it again.
"""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path
from typing import Any

import FreeCADGui
import pytest

from CNCStepper.errors import CNCStepperError
from CNCStepper.gcode.wire.read_back import refused_lines
from CNCStepper.workbench import api
from CNCStepper.workbench.document.core_job import language_of
from CNCStepper.workbench.features.base import is_job, problem_of, proxy_type, value_of
from window_helpers import macros, monkey_documents
from window_helpers import screen_places as places
from window_helpers.hand import Hand
from window_helpers.monkey import Monkey, close_windows

STEPS = int(os.environ.get("CNCSTEPPER_MONKEY_STEPS", "1000"))
FIRST_SEED = int(os.environ.get("CNCSTEPPER_MONKEY_SEED", "1"))
STEPS_A_WALK = 100
COMPUTED = {"program"}
pytestmark = pytest.mark.window("monkey")
WALKS = range(FIRST_SEED, FIRST_SEED + max(1, STEPS // STEPS_A_WALK))


def held(document: Any) -> dict[str, Any]:
    """Return what every object of ours holds but what is computed of it."""
    ours = [obj for obj in document.Objects if proxy_type(obj) and hasattr(obj.Proxy, "PROPERTIES")]
    values = {
        f"{obj.Name}.{entry.key}": value_of(obj, entry)
        for obj in ours
        for entry in obj.Proxy.PROPERTIES
        if entry.key not in COMPUTED
    }
    return {"objects": sorted(obj.Name for obj in document.Objects), **values} | {
        f"{obj.Name}.problem": problem_of(obj) for obj in ours
    }


def not_undone(document: Any, before: dict[str, Any]) -> dict[str, Any]:
    """Return what differs from the beginning where no panel is open and nothing is left to undo."""
    if FreeCADGui.Control.activeDialog() or document.UndoCount:
        return {}
    return {key: value for key, value in held(document).items() if before.get(key) != value}


def unreadable(document: Any) -> list[str]:
    """Return why lines of the job's program are refused, none where it has no program that could be saved or sent."""
    found = []
    for job in (obj for obj in document.Objects if is_job(obj)):
        with suppress(CNCStepperError):
            found += [str(error) for error in refused_lines(api.program_text(job), None, language_of(job), "program")]
    return found


@pytest.mark.parametrize("seed", WALKS)
def test_a_walk_of_random_steps(hand: Hand, seed: int, tmp_path: Path) -> None:
    kind = tuple(monkey_documents.KINDS)[seed % len(monkey_documents.KINDS)]
    document = hand.main(monkey_documents.draw, kind, tmp_path, limit_s=300)
    hand.main(FreeCADGui.SendMsgToActiveView, "ViewFit")
    before, copy = hand.main(held, document), tmp_path / f"{document.Name}.FCStd"
    hand.main(document.saveCopy, str(copy))
    monkey = Monkey(hand, seed)
    hand.expect_report("")  # refusals are said there too: what may not be is a traceback
    recorded = macros.begin_recording(hand, f"walk-{seed}")
    try:
        while monkey.steps < STEPS_A_WALK:
            monkey.step()
            assert hand.main(not_undone, document, before) == {}
        monkey.leave()
        hand.main(close_windows)
        hand.main(places.hide_our_windows)  # docks: Ctrl+Z is the document's again
        macro = macros.end_recording(hand, recorded)
        traces = [line.text for line in hand.report() if "Traceback" in line.text or line.text.startswith("  File ")]
        assert not traces, traces
        assert hand.main(unreadable, document, limit_s=120) == []
        made = hand.main(macros.state, document)
        monkey.undo_all(document)
        assert hand.main(held, document) == before
        if not ("Std_Delete" in macro and "macro.undo()" in macro):  # FreeCAD's deletion may be several undo steps
            macros.run_on_copy(hand, macro, copy, made)
    except BaseException:
        print(f"walk {seed} over {kind}, the last steps: {list(monkey.done)}", flush=True)
        macros.stop_recording(hand)
        raise
    finally:
        while hand.main(places.close_one_popup):
            hand.settle()
        hand.main(close_windows)
