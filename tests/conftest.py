# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all tests share: golden files (written anew with --update-golden), and how property tests choose their cases.

At a desk every run tries new cases and prints how to repeat one that fails; in CI the cases are the same each
time, so that a change is judged by what it changed.
"""

from __future__ import annotations

import io
import os
import secrets
import subprocess
import sys
from collections import Counter
from collections.abc import Callable
from contextlib import redirect_stdout
from pathlib import Path

import numpy as np
import platformdirs
import pytest
from hypothesis import settings

from CNCStepper import kernel_cache

pytest.register_assert_rewrite("helpers")
ROOT = Path(__file__).parents[1]
GOLDEN = Path(__file__).parent / "golden"
PICTURES = GOLDEN / "pictures"
# With a cold cache these compile what the others call: in turn one for each of two workers, the geometry for the one,
# the planner and the simulation for the other, so that none compiles what the other one is compiling.
FIRST = (
    "unit/geometry/test_offset.py",
    "unit/motion/planner/test_plan.py",
    "unit/geometry/fitting/test_point_fit.py",
    "unit/simulation/removal/test_removal_three_ways.py",
    "unit/job/test_make_certificate.py",
    "unit/motion/signals/test_pulse_player.py",
)
PIXEL_DIFFERS = 32  # of 255, in any colour
PIXELS_DIFFER = 0.001  # share of all pixels

os.environ.setdefault("CNCSTEPPER_LANGUAGE", "en")  # what tests compare is English, whatever the desk speaks
settings.register_profile("desk", deadline=None, print_blob=True)
settings.register_profile("ci", deadline=None, print_blob=True, derandomize=True)
settings.load_profile("ci" if os.environ.get("CI") else "desk")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--update-golden", action="store_true", help="write the golden files anew")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Let these files be first: with a cold cache all workers would compile the same kernels at the same time."""
    places = {Path(__file__).parent / name: place for place, name in enumerate(FIRST)}
    items.sort(key=lambda item: places.get(item.path, len(places)))


def _updates(request: pytest.FixtureRequest) -> bool:
    return bool(request.config.getoption("--update-golden") or os.environ.get("UPDATE_GOLDEN") == "1")


@pytest.fixture(autouse=True)
def own_state(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let no test find what another has left of a machine: ports of this computer are used again."""
    base: Path = request.getfixturevalue("tmp_path_factory").getbasetemp()
    for variable in ("XDG_STATE_HOME", "XDG_CONFIG_HOME"):  # sessions, and machine profiles of a person's own
        monkeypatch.setenv(variable, str(base / f"{variable.lower()}-{secrets.token_hex(8)}"))
    monkeypatch.setenv("CNCSTEPPER_KEEP_OPEN", "0")  # no connection outlives its verb, but where a test says so


@pytest.fixture
def printed_three_ways() -> Callable[[str], list[str]]:
    """Return what a script prints with its kernels compiled, compiled with checked bounds, and as plain Python.

    Compiled it runs in this process, which has the kernels already. The checked ones have a cache of their own: numba
    takes what is compiled without the checks from a shared one. Checkouts share it: to compile the kernels takes many
    times as long as to run them, and so they are hardly optimised.
    """
    from CNCStepper import kernels  # loads numba, which many tests inside FreeCAD must not

    assert kernels.COMPILED
    kernels.load()  # a verb of the command line that ran in this process may have postponed it
    cache = kernel_cache.cache_folder(platformdirs.user_cache_path("cncstepper-checked", appauthor=False))
    checked = {"NUMBA_BOUNDSCHECK": "1", "NUMBA_OPT": "1", "NUMBA_CACHE_DIR": str(cache)}

    def compiled(script: str) -> str:
        with redirect_stdout(io.StringIO()) as out:
            exec(script, {"__name__": "__main__"})
        return out.getvalue()

    def printed(script: str, more: dict[str, str]) -> str:
        environment = {**os.environ, "PYTHONPATH": str(ROOT), **more}
        run = subprocess.run([sys.executable, "-c", script], env=environment, cwd=ROOT, capture_output=True, text=True)
        assert run.returncode == 0, run.stderr
        return run.stdout

    uncompiled = {"NUMBA_DISABLE_JIT": "1"}
    return lambda script: [compiled(script), printed(script, checked), printed(script, uncompiled)]


@pytest.fixture
def golden(request: pytest.FixtureRequest) -> Callable[[str, str], None]:
    """Return check(name, text): `text` must equal tests/golden/NAME (UPDATE_GOLDEN=1 or --update-golden writes it)."""
    update = _updates(request)

    def check(name: str, text: str) -> None:
        path = GOLDEN / name
        if update:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, "utf-8", newline="\n")
        assert text == path.read_text("utf-8"), f"{path} differs; look at it, then run with --update-golden"

    return check


@pytest.fixture
def differs() -> Callable[[str, np.ndarray], bool]:
    """Return whether a picture, uint8[rows, columns, 3], is another than tests/golden/pictures/NAME.png.

    Both are compared at half their size; a few pixels may differ, for fonts and edges are not drawn alike everywhere.
    """

    def answer(name: str, picture: np.ndarray) -> bool:
        from matplotlib.image import imread

        stored = np.rint(imread(PICTURES / f"{name}.png")[..., :3] * 255)
        seen = halved(picture)
        if stored.shape != seen.shape:
            return True
        return float((np.abs(stored - seen).max(axis=2) > PIXEL_DIFFERS).mean()) > PIXELS_DIFFER

    return answer


@pytest.fixture
def stored_picture(
    request: pytest.FixtureRequest, differs: Callable[[str, np.ndarray], bool]
) -> Callable[[str, np.ndarray], None]:
    """Return check(name, picture): it must look as the stored one does (--update-golden stores it anew)."""

    def check(name: str, picture: np.ndarray) -> None:
        if _updates(request):
            from matplotlib.image import imsave

            PICTURES.mkdir(parents=True, exist_ok=True)
            imsave(PICTURES / f"{name}.png", halved(picture))
        assert not differs(name, picture), f"{name} looks different; look at it, then run with --update-golden"

    return check


def halved(picture: np.ndarray) -> np.ndarray:
    """Return a picture at half its size, uint8[rows, columns, 3]."""
    rows, columns = picture.shape[0] // 2, picture.shape[1] // 2
    return picture[: 2 * rows, : 2 * columns].reshape(rows, 2, columns, 2, 3).mean(axis=(1, 3)).astype(np.uint8)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Print what tests have counted (`record_property` with a dictionary), summed over the tests and the workers."""
    sums: dict[str, Counter[str]] = {}
    for report in terminalreporter.getreports("passed") + terminalreporter.getreports("failed"):
        for name, counts in report.user_properties:
            if isinstance(counts, dict):
                sums.setdefault(name, Counter()).update(counts)
    for name, counts in sums.items():
        told = ", ".join(f"{kind} {count}" for kind, count in sorted(counts.items()))
        terminalreporter.write_line(f"{name}: {told}")
