# SPDX-License-Identifier: LGPL-2.1-or-later
"""Installs what a FreeCAD without our packages lacks, by the button: `install_and_work.py 0.20.2|1.0.0|1.1.3|host`.

From an empty home, with a copy of the project that has no packages beside it: FreeCAD's window opens the workbench, and
names what is missing. The zip of `make installer` is made for that FreeCAD's Python. In a new window the button of the
message opens the dialog, which installs from the zip; the same window then makes a job and connects to the virtual
controller. Nothing else may be found: neither .venv nor the packages for tests. The FreeCADs of `make matrix` have no
pip in their folder: the zip's does it there.
"""

from __future__ import annotations

import json
import shutil
import sys
import tempfile
import uuid
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path += [str(ROOT / "tests"), str(ROOT / "tools")]
import installer  # noqa: E402

from window_helpers import start_window  # noqa: E402

SCRIPT = Path(__file__).with_name("empty_home.py")
PARTS = ("CNCStepper", "resources", "Init.py", "InitGui.py", "package.xml", "LICENSE", "pyproject.toml")
START_S = 400.0


def main(version: str) -> int:
    """Return 0 when the button is all that it takes."""
    with tempfile.TemporaryDirectory(prefix="cncstepper-empty-", dir="/tmp", ignore_cleanup_errors=True) as folder:
        work = Path(folder)
        project = copy_project(work / "project")
        archive = work / "packages.zip"
        with start_window.screen() as display:
            asked = step(version, "ask", display, work, project, archive)
            print(asked, flush=True)
            make_zip(archive, asked["python"], work / "wheels")
            done = step(version, "work", display, work, project, archive)
    print(done, flush=True)
    return int(not (done.get("program", 0) > 0 and done.get("phase")))


def make_zip(path: Path, python: str, wheels: Path) -> None:
    """Write the zip for that Python as `make installer` does, for this system only."""
    wheels.mkdir()
    installer.download(wheels, python, "Linux")
    installer.write_zip(path, wheels)


def copy_project(folder: Path) -> Path:
    """Return a copy of what FreeCAD reads of the project, without .venv."""
    folder.mkdir()
    for name in PARTS:
        copy = shutil.copytree if (ROOT / name).is_dir() else shutil.copy2
        copy(ROOT / name, folder / name)
    return folder


def step(version: str, name: str, display: str, work: Path, project: Path, archive: Path) -> dict[str, Any]:
    """Return what FreeCAD's window answers in one step; raises RuntimeError with what went wrong."""
    answer, home, mark = work / f"{name}.json", work / "home", uuid.uuid4().hex
    start_window.make_home(home, autoload="NoneWorkbench")
    environment = {
        "CNCSTEPPER_STEP": name,
        "CNCSTEPPER_ANSWER": str(answer),
        "CNCSTEPPER_ZIP": str(archive),
        "CNCSTEPPER_PACKAGES": "",
        "CNCSTEPPER_PYTHON": "",
        "PATH": "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin",
        "PYTHONPATH": "",
        "PYTHONNOUSERSITE": "1",
        "NUMBA_DISABLE_JIT": "1",  # compiling takes minutes, and is not what is judged
    }
    freecad = start_window.start(version, display, home, SCRIPT, environment, mark, project)
    try:
        freecad.wait(START_S)
    finally:
        start_window.end_all(mark)
    result = json.loads(answer.read_text("utf-8")) if answer.exists() else {"error": f"no answer to '{name}'"}
    if "error" in result:
        raise RuntimeError(result["error"])
    return dict(result)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
