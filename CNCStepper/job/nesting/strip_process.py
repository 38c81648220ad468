# SPDX-License-Identifier: LGPL-2.1-or-later
"""Packs strips by spyrrow in a process of its own: `CNCStepper.workers.strip_packing`.

The process gives each shorter strip as it finds it. It is ended with the budget; the last strip is the answer.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Sequence
from contextlib import suppress
from importlib.util import find_spec
from queue import Empty, SimpleQueue
from threading import Thread
from typing import Any

import numpy as np

from CNCStepper.control.processes.python_finder import command, environment, find_python
from CNCStepper.nesting.nesting_model import Budget
from CNCStepper.nesting.strips import StripPacker, StripPart, StripPlace

NEEDS = ("spyrrow",)
MODULE = "CNCStepper.workers.strip_packing"
COMPRESS_SHARE = 0.2  # of the time, as spyrrow itself divides it; the rest explores
LEAST_S = 1  # of each phase: spyrrow counts whole seconds
LATE_S = 0.3  # of the budget, for the start of the process and its last answer
LOOK_EVERY_S = 0.1


def strip_packer() -> StripPacker | None:
    """Return the packer of strips; None where spyrrow is not installed."""
    return pack_strip if find_spec("spyrrow") else None


def pack_strip(parts: Sequence[StripPart], height_mm: float, budget: Budget, seed: int) -> list[StripPlace] | None:
    """Return the shortest strip found until the budget ends; None where the process found none or was ended."""
    explore_s, compress_s = phases_s(budget.left_s - LATE_S)
    question = {
        "height_mm": height_mm,
        "explore_s": explore_s,
        "compress_s": compress_s,
        "seed": seed,
        "threads": os.cpu_count() or 1,
        "parts": [_part(part) for part in parts],
    }
    answer = _last_answer(question, budget)
    if answer is None:
        return None
    return [StripPlace(parts[number].item, x, y, _allowed(parts[number], turn)) for number, x, y, turn in answer]


def phases_s(time_s: float) -> tuple[int, int]:
    """Return the whole seconds of exploration and compression; what is left of a second explores."""
    compress_s = max(LEAST_S, int(time_s * COMPRESS_SHARE))
    return max(LEAST_S, int(time_s) - compress_s), compress_s


def _part(part: StripPart) -> dict[str, Any]:
    points = np.asarray(part.outline.exterior.coords)[:-1].tolist()
    angles = part.rotations_deg and list(part.rotations_deg)
    return {"points": points, "count": part.count, "rotations_deg": angles}


def _allowed(part: StripPart, rotation_deg: float) -> float:
    """Return the allowed rotation that is meant: spyrrow calculates in single precision."""
    if part.rotations_deg is None:
        return rotation_deg % 360.0
    return min(part.rotations_deg, key=lambda angle: abs((angle - rotation_deg + 180.0) % 360.0 - 180.0))


def _last_answer(question: dict[str, Any], budget: Budget) -> list[list[Any]] | None:
    """Return the places of the last answer before the process ends or has to."""
    with _started() as process:
        assert process.stdin and process.stdout
        lines: SimpleQueue[bytes] = SimpleQueue()
        output = process.stdout
        reader = Thread(target=_forward, args=(output, lines), daemon=True)
        reader.start()
        with suppress(OSError):  # it may have ended at its start
            process.stdin.write(json.dumps(question).encode("utf-8") + b"\n")
            process.stdin.flush()
        found = None
        while not budget.over:
            with suppress(Empty):
                answer = _told(lines.get(timeout=LOOK_EVERY_S))
                if "places" not in answer:
                    break
                found = answer["places"]
        process.kill()
        reader.join()
        while not lines.empty():
            found = _told(lines.get()).get("places", found)
        return found


def _forward(output: Any, lines: SimpleQueue[bytes]) -> None:
    """Hand on each line, and an empty one at the end."""
    while line := output.readline():
        lines.put(line)
    lines.put(b"")


def _told(line: bytes) -> dict[str, Any]:
    """Return an answer, {} for the end of the process and for what is none."""
    with suppress(ValueError):
        answer = json.loads(line)
        return answer if isinstance(answer, dict) else {}
    return {}


def _started() -> subprocess.Popen[bytes]:
    return subprocess.Popen(
        command(find_python(NEEDS), MODULE),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,  # what a Rust library prints when it ends
        env=environment(),
        **_apart(),
    )


def _apart() -> dict[str, Any]:
    """Return what keeps Ctrl+C of our terminal from it: this process ends it, once it has its answer."""
    if sys.platform == "win32":
        return {"creationflags": subprocess.CREATE_NEW_PROCESS_GROUP | subprocess.CREATE_NO_WINDOW}
    return {"start_new_session": True}
