# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares how fast we are beside other programs with what was recorded last, and names what fell by more than 10 %.

Only ratios of processor time of two sides in one run are compared, so that the computer hardly matters. What has fallen
is measured once more; the better one counts. Each bench has a process of its own, so that none finds another's caches.

    python bench/guard.py             compare; exit 1 where something fell or is missing
    python bench/guard.py --record    write bench/recorded_ratios.json anew
"""

from __future__ import annotations

import importlib
import json
import subprocess
import sys
import tempfile
from pathlib import Path

GUARDED = (
    "interpreter",
    "offset",
    "removal",
    "motion",
    "pocket",
    "drawings",
    "check",
)  # bench_NAME.py has a function `guarded`
MOST_LOST = 0.10  # of a recorded ratio
RECORDED = Path(__file__).with_name("recorded_ratios.json")

Ratios = dict[str, float]


def measured(name: str) -> Ratios:
    """Return what a bench measures, in a process of its own; a bench that fails raises CalledProcessError."""
    with tempfile.TemporaryDirectory() as folder:
        answer = Path(folder) / "ratios.json"
        subprocess.run([sys.executable, __file__, name, str(answer)], check=True)
        return json.loads(answer.read_text("utf-8"))


def fallen(recorded: Ratios, now: Ratios) -> list[str]:
    """Return the names of those recorded ratios that are missing now, or fell by more than MOST_LOST."""
    return [name for name, ratio in recorded.items() if now.get(name, 0.0) < (1.0 - MOST_LOST) * ratio]


def better(one: Ratios, other: Ratios) -> Ratios:
    """Return the better ratio of each name."""
    return {key: max(one.get(key, 0.0), other.get(key, 0.0)) for key in one | other}


def compared(name: str, recorded: Ratios) -> Ratios:
    """Return what a bench measures; where something fell, the better of two runs."""
    now = measured(name)
    return better(now, measured(name)) if fallen(recorded, now) else now


def compare(every: dict[str, Ratios]) -> int:
    """Print each ratio beside the recorded one; return the exit code."""
    lost = []
    for name, recorded in every.items():
        now = compared(name, recorded)
        lost += fallen(recorded, now)
        for key in recorded | now:
            then_words = f"{recorded[key]:8.2f}" if key in recorded else "     new"
            print(f"{key:32} recorded {then_words}, now {now.get(key, 0.0):8.2f}", flush=True)
    for key in lost:
        print(f"bench-guard: {key} fell by more than {MOST_LOST:.0%}", file=sys.stderr)
    return 1 if lost else 0


def record() -> int:
    """Write the better of two runs of all benches: the first one may compile kernels."""
    runs = {name: better(measured(name), measured(name)) for name in GUARDED}
    found = {name: {key: round(ratio, 3) for key, ratio in ratios.items()} for name, ratios in runs.items()}
    RECORDED.write_text(json.dumps(found, indent=2) + "\n", "utf-8")
    return 0


def main(arguments: list[str]) -> int:
    """Compare, record, or measure one bench for the process that compares."""
    if arguments == ["--record"]:
        return record()
    if arguments:
        name, answer = arguments
        found = importlib.import_module(f"bench_{name}").guarded()
        Path(answer).write_text(json.dumps(found), "utf-8")
        return 0
    every = json.loads(RECORDED.read_text("utf-8"))
    return compare({name: every.get(name, {}) for name in GUARDED})


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
