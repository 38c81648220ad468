# SPDX-License-Identifier: LGPL-2.1-or-later
"""Installs what a FreeCAD without our packages lacks, by the button: `install_and_work.py 0.20.2|1.0.0|1.1.3|host`.

From an empty home, with a copy of the project that has no packages beside it: FreeCAD's window opens the workbench, and
names what is missing. The zip of `make installer` is made for that FreeCAD's Python. In a new window a hand at the
mouse and the keys installs from the zip by the button of the message, and in the same window goes the tour of the first
steps until a part is cut on the virtual machine. Whoever has FreeCAD in Portuguese goes the same way in a third window.
CLICKS and MINUTES bound each of the two from the choice of the workbench on, the installation with it. Nothing else may
be found: neither .venv nor the packages for tests, but for what the hand needs. The FreeCADs of `make matrix` have no
pip in their folder: the zip's does it there.
"""

from __future__ import annotations

import importlib.util
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

from window_helpers import start_window, window_kinds  # noqa: E402

SCRIPT = Path(__file__).with_name("empty_home.py")
PARTS = ("CNCStepper", "resources", "Init.py", "InitGui.py", "package.xml", "LICENSE", "pyproject.toml")
START_S = 900.0
CLICKS, MINUTES = 25, 10.0
LANGUAGES = {"install": "English", "work": window_kinds.KINDS["portuguese"][window_kinds.LANGUAGE]}
HAND = ("Xlib", "six")


def main(version: str) -> int:
    """Return 0 when the button is all that it takes."""
    with tempfile.TemporaryDirectory(prefix="cncstepper-empty-", dir="/tmp", ignore_cleanup_errors=True) as folder:
        work = Path(folder)
        project = copy_project(work / "project")
        archive = work / "packages.zip"
        copy_hand(work / "hand")
        with start_window.screen() as display:
            asked = step(version, "ask", display, work, project, archive)
            print(asked, flush=True)
            make_zip(archive, asked["python"], work / "wheels")
            english, portuguese = (step(version, name, display, work, project, archive) for name in LANGUAGES)
    return int(not (is_good("English", english, {}) & is_good("Portuguese", portuguese, english)))


def is_good(language: str, told: dict[str, Any], installation: dict[str, Any]) -> bool:
    """Print what a first part has taken, with the installation of another window; return whether it is little."""
    clicks = told["clicks"] + installation.get("install_clicks", 0)
    seconds = told["seconds"] + installation.get("installed_s", 0)
    print(f"{language}: {clicks} clicks, {seconds} s to the first part: {told}", flush=True)
    return bool(clicks <= CLICKS and seconds <= 60.0 * MINUTES and told["lines"] > 0)


def copy_hand(folder: Path) -> None:
    """Copy what the hand needs to reach the X server."""
    folder.mkdir()
    for name in HAND:
        found = importlib.util.find_spec(name)
        assert found is not None and found.origin is not None, f"{name} is missing"
        origin = Path(found.origin)
        if found.submodule_search_locations:
            shutil.copytree(origin.parent, folder / name)
        else:
            shutil.copy2(origin, folder)


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
    language = LANGUAGES.get(name, "English")
    language = window_kinds.RENAMED.get(version, {}).get(language, language)
    start_window.make_home(home, language, autoload="PartWorkbench", knows_first_steps=False)
    pictures = start_window.pictures_of(version, "empty-home")
    pictures.mkdir(parents=True, exist_ok=True)
    environment = {
        "CNCSTEPPER_HAND": str(work / "hand"),
        "CNCSTEPPER_WINDOW_PICTURES": str(pictures),
        "CNCSTEPPER_STEP": name,
        "CNCSTEPPER_ANSWER": str(answer),
        "CNCSTEPPER_ZIP": str(archive),
        "CNCSTEPPER_PACKAGES": "",
        "CNCSTEPPER_PYTHON": "",
        "PATH": "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin",
        "PYTHONPATH": "",
        "PYTHONNOUSERSITE": "1",
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
