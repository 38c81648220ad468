# SPDX-License-Identifier: LGPL-2.1-or-later
"""These tests run inside FreeCAD's window (see run.py); `tools/window.sh VERSION FILES` starts them there."""

from __future__ import annotations

import os

INSIDE = "CNCSTEPPER_WINDOW_STATUS" in os.environ
collect_ignore_glob = [] if INSIDE else ["test_*.py", "*/test_*.py"]

if INSIDE:
    from collections.abc import Iterator
    from typing import Any

    import FreeCAD
    import kinds
    import pytest
    from hand import Hand

    from CNCStepper.workbench.calculation import kernel_warmup

    def pytest_configure(config: pytest.Config) -> None:
        config.addinivalue_line("markers", "window(*kinds): the kinds of window (kinds.py) that a test runs in")

    def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
        """Keep the tests of this kind of window."""
        kind = os.environ.get(kinds.VARIABLE, "plain")
        wanted = {item: (item.get_closest_marker("window") or pytest.mark.window("plain")).args for item in items}
        config.hook.pytest_deselected(items=[item for item in items if kind not in wanted[item]])
        items[:] = [item for item in items if kind in wanted[item]]

    @pytest.fixture(scope="session")
    def the_hand() -> Hand:
        """The one hand of this window, when FreeCAD has opened the workbench and no kernel is being compiled."""
        hand = Hand(*FreeCAD.__cncstepper_window__)
        if kinds.AUTOLOAD not in os.environ:
            hand.wait(hand.workbench_is_open, 60)
            hand.wait(lambda: kernel_warmup.running() is None, 300, "the kernels")
        hand.settle()
        ours = [line.text for line in hand.report() if line.bad and "CNCStepper" in line.text]
        assert not ours, f"FreeCAD's start has put into the report view: {ours}"
        return hand

    @pytest.fixture
    def hand(the_hand: Hand) -> Hand:
        """A person's hand at the mouse and the keys."""
        return the_hand

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
