# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that packs a strip with spyrrow: `python -m CNCStepper.workers.strip_packing`.

It is a process of its own because input that spyrrow does not bear ends it. One question on standard input, in JSON,
then one line on standard output for each shorter strip that is found:

    {"height_mm": 100.0, "explore_s": 40, "compress_s": 10, "seed": 1, "threads": 2,
     "parts": [{"points": [[x, y], ...], "count": 3, "rotations_deg": [0.0, 180.0]}, ...]}    null: any rotation

    {"length_mm": 81.5, "places": [[part, x_mm, y_mm, rotation_deg], ...]}
    {"done": true}                                                              no shorter one will come

When standard input is closed the process ends.
"""

from __future__ import annotations

import sys
from threading import Thread
from typing import Any

from CNCStepper.errors import MissingPackage
from CNCStepper.workers.json_lines import Questions, serve, tell

LOOK_EVERY_S = 0.1


def main() -> int:
    """Answer what standard input asks; return the exit status."""
    return serve(_answer, "strip-fault", "the packing of a strip")


def _answer(questions: Questions) -> None:
    while True:
        _pack(questions.get())
        tell({"done": True})


def _pack(question: dict[str, Any]) -> None:
    """Pack a strip; answer with each shorter one."""
    spyrrow = _library()
    items = [
        spyrrow.Item(str(number), [tuple(point) for point in part["points"]], part["count"], part["rotations_deg"])
        for number, part in enumerate(question["parts"])
    ]
    instance = spyrrow.StripPackingInstance("", question["height_mm"], items)
    config = spyrrow.StripPackingConfig(
        early_termination=False,
        total_computation_time=None,
        exploration_time=question["explore_s"],
        compression_time=question["compress_s"],
        num_workers=question["threads"],
        seed=question["seed"],
    )
    found, progress = list[Any](), spyrrow.ProgressQueue()
    worker = Thread(target=lambda: found.append(instance.solve(config, progress)), daemon=True)
    worker.start()
    best_mm = float("inf")
    while worker.is_alive():
        worker.join(LOOK_EVERY_S)
        sound = [strip for kind, strip in progress.drain() if kind in (0, 3, 4)]  # feasible, compressed, final
        best_mm = _tell_shorter([*sound, *found], best_mm)


def _tell_shorter(strips: list[Any], best_mm: float) -> float:
    """Answer with the shortest strip where it is shorter than the best; return the best length."""
    shortest = min(strips, key=lambda strip: strip.width, default=None)
    if shortest is None or not shortest.width < best_mm:
        return best_mm
    places = [[int(each.id), *each.translation, each.rotation] for each in shortest.placed_items]
    tell({"length_mm": shortest.width, "places": places})
    return float(shortest.width)


def _library() -> Any:
    try:
        import spyrrow
    except ImportError as error:
        what, advice = "spyrrow is not installed", "install it: python -m pip install spyrrow"
        raise MissingPackage("nest-spyrrow", what, advice=advice) from error
    return spyrrow


if __name__ == "__main__":
    sys.exit(main())
