# SPDX-License-Identifier: LGPL-2.1-or-later
"""These tests run inside FreeCAD's window: `tools/window.sh VERSION FILES` (see window_helpers/run_tests.py)."""

from __future__ import annotations

import math
import os
import sys

INSIDE = "CNCSTEPPER_WINDOW_STATUS" in os.environ
collect_ignore_glob = [] if INSIDE else ["test_*.py", "*/test_*.py"]

if INSIDE:
    from collections.abc import Iterator
    from pathlib import Path
    from typing import Any

    import FreeCAD
    import FreeCADGui
    import pytest

    from CNCStepper.workbench.calculation import kernel_warmup
    from window_helpers import touches, window_kinds
    from window_helpers.hand import PICTURES, Hand
    from window_helpers.interface import LONGEST_MS, ControlOfFreeCAD
    from window_helpers.twin import Twin

    WATCHED = {
        "test_assistant.py",
        "test_comparison.py",
        "test_first_evening.py",
        "test_first_run.py",
        "test_language.py",
        "test_lathe.py",
        "test_libraries.py",
        "test_machines.py",
    }  # test_preferences.py times its page itself: FreeCAD makes its whole dialog in one event
    # A share that samples have told, and a processor's speed, are so much off. In FreeCAD 1.1 it is only printed:
    # PySide6 takes 50 to 97 ms for the fields of the controller dock and of a lathe's job.
    ROUGHLY = 1.3 if sys.version_info < (3, 14) else math.inf
    KERNELS_S = 540  # so long may the kernels take to be compiled, on a busy machine

    def pytest_configure(config: pytest.Config) -> None:
        config.addinivalue_line("markers", "window(*kinds): the kinds of window (window_kinds.py) that a test runs in")

    def pytest_ignore_collect(collection_path: Path) -> bool | None:
        """Leave files without a test for missing packages out where they are missing: others may import them."""
        if window_kinds.WITHOUT not in os.environ or not collection_path.is_file():
            return None
        return '"bare"' not in collection_path.read_text("utf-8") or None

    def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
        """Keep the tests of this kind of window; what a start costs is measured first."""
        kind = os.environ.get(window_kinds.VARIABLE, "plain")
        kind = "plain" if kind in window_kinds.AS_PLAIN else kind
        wanted = {item: (item.get_closest_marker("window") or pytest.mark.window("plain")).args for item in items}
        config.hook.pytest_deselected(items=[item for item in items if kind not in wanted[item]])
        items[:] = [item for item in items if kind in wanted[item]]
        items.sort(key=lambda item: item.path.name != "test_start_cost.py")

    @pytest.fixture(scope="session")
    def the_hand() -> Iterator[Hand]:
        """The one hand of this window, when FreeCAD has opened the workbench and no kernel is being compiled."""
        hand = Hand(*FreeCAD.__cncstepper_window__)
        FreeCADGui.Control = ControlOfFreeCAD(FreeCADGui.Control, FreeCAD.__cncstepper_window__[0])
        if window_kinds.AUTOLOAD not in os.environ:
            hand.wait(hand.workbench_is_open, 60)
            hand.wait(lambda: kernel_warmup.running() is None, KERNELS_S, "the kernels")
        hand.settle()
        ours = [line.text for line in hand.report() if line.bad and "CNCStepper" in line.text]
        assert not ours, f"FreeCAD's start has put into the report view: {ours}"
        Path(os.environ["CNCSTEPPER_WINDOW_STATUS"]).with_name(window_kinds.READY).touch()
        yield hand
        hand.main(hand.touches.save, PICTURES / touches.FILE)

    @pytest.fixture
    def twins(tmp_path: Path) -> Iterator[Any]:
        """What starts a virtual machine of a kind; all are ended."""
        started: list[Twin] = []

        def start(kind: str, *options: str) -> Twin:
            started.append(Twin(kind, tmp_path, *options))
            return started[-1]

        yield start
        for twin in started:
            twin.end()

    @pytest.fixture
    def hand(the_hand: Hand) -> Hand:
        """A person's hand at the mouse and the keys."""
        return the_hand

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol() -> Iterator[None]:
        """Keep what a test leaves behind, until the interface thread deletes it."""
        with FreeCAD.__cncstepper_window__[1].watching():
            return (yield)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_makereport(item: pytest.Item, call: Any) -> Any:
        """Keep a picture of the screen when a test fails."""
        result = yield
        if result.failed and call.when == "call" and "the_hand" in item.funcargs:
            picture = item.funcargs["the_hand"].shot(f"failed-{item.name}")
            result.sections.append(("picture", str(picture)))
        return result

    @pytest.fixture(autouse=True)
    def quiet_and_tidy(the_hand: Hand) -> Iterator[None]:
        """After each test all is closed, and the report view holds nothing bad that the test did not ask for."""
        the_hand.begin()
        yield
        the_hand.tidy()
        bad = the_hand.unexpected()
        assert not bad, "the report view holds:\n" + "\n".join(f"{line.kind}: {line.text}" for line in bad)

    @pytest.fixture(autouse=True)
    def never_busy(the_hand: Hand, request: pytest.FixtureRequest) -> Iterator[None]:
        """In the files of `WATCHED` no event of the window takes our package longer than it may."""
        if request.path.name not in WATCHED:
            yield
            return
        with the_hand.event_watchdog() as watch:
            yield
        if watch.longest.ours_ms > 0.8 * LONGEST_MS:
            print(watch.longest, flush=True)
        assert watch.longest.ours_ms < ROUGHLY * LONGEST_MS, str(watch.longest)
