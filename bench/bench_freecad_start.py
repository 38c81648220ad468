# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's start with and without our workbench, and how soon it opens beside FreeCAD's own Part workbench.

Both sides take turns in the same run; the medians are told. A start is the time from the command to the first event
that FreeCAD's window handles; an opening that from asking for the workbench to the window at rest.
"""

from __future__ import annotations

import json
import statistics
import subprocess
import sys
import tempfile
import time
import uuid
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "tests"))
from window_helpers import start_window  # noqa: E402

RUNS = 7
LIMIT_S = 60
SCRIPT = """
import json, os, time
from PySide import QtCore, QtGui
import FreeCADGui

def opening(name):
    begun = time.perf_counter()
    FreeCADGui.activateWorkbench(name)
    QtGui.QApplication.processEvents()
    return time.perf_counter() - begun

def up():
    told = {"up": time.monotonic()}
    for name in os.environ["BENCH_OPEN"].split():
        told[name] = opening(name)
    with open(os.environ["BENCH_TOLD"], "w") as file:
        json.dump(told, file)
    FreeCADGui.getMainWindow().close()

QtCore.QTimer.singleShot(0, up)
"""


def start(display: str, ours: bool) -> dict[str, float]:
    """Return the seconds of one start, and of opening workbenches in it."""
    with tempfile.TemporaryDirectory(prefix="cncstepper-bench-") as folder:
        home = Path(folder)
        start_window.make_home(home, autoload="NoneWorkbench")
        (home / "up.py").write_text(SCRIPT, "utf-8")
        wanted = "PartWorkbench CNCStepperWorkbench" if ours else "PartWorkbench"
        variables = {"BENCH_TOLD": str(home / "told.json"), "BENCH_OPEN": wanted}
        mark = uuid.uuid4().hex
        begun = time.monotonic()
        freecad = start_window.start(
            "host", display, home, home / "up.py", variables, mark, ROOT if ours else None, output=subprocess.DEVNULL
        )
        try:
            freecad.wait(LIMIT_S)
        finally:
            start_window.end_all(mark)
        told = json.loads((home / "told.json").read_text("utf-8"))
    return {"start": told.pop("up") - begun, **told}


def main() -> None:
    """Measure and print."""
    start_window.compile_package("host")
    sides: dict[bool, list[dict[str, float]]] = {True: [], False: []}
    with start_window.screen() as display:
        for ours in (True, False):
            start(display, ours)  # both warm
        for _ in range(RUNS):
            for ours in (True, False):
                sides[ours].append(start(display, ours))

    def median_ms(ours: bool, name: str) -> float:
        return 1e3 * statistics.median(run[name] for run in sides[ours])

    def spread_ms(ours: bool, name: str) -> float:
        return 1e3 * statistics.pstdev(run[name] for run in sides[ours])

    print(f"{RUNS} starts of FreeCAD's window each, taking turns; medians (standard deviation)")
    for words, ours in (("without the workbench", False), ("with the workbench", True)):
        print(f"  {words:24}{median_ms(ours, 'start'):7.0f} ms ({spread_ms(ours, 'start'):.0f})")
    print(f"  {'difference':24}{median_ms(True, 'start') - median_ms(False, 'start'):7.0f} ms")
    for name in ("CNCStepperWorkbench", "PartWorkbench"):
        print(f"  opening {name:24}{median_ms(True, name):7.0f} ms ({spread_ms(True, name):.0f})")


if __name__ == "__main__":
    main()
