# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every panel and dialog, the cut view, the restart and the connected dock have names that a screen reader says."""

from __future__ import annotations

from typing import Any

import FreeCADGui
from test_dock import connected, dock, own_sessions  # noqa: F401
from test_simulation_view import job, no_restart, opened  # noqa: F401
from test_spoken_names import nameless
from test_whole_texts import every_dialog, every_panel

from CNCStepper.workbench import restart
from window_helpers import screen_places as places
from window_helpers.hand import Hand


def test_every_panel_and_dialog_has_names(hand: Hand) -> None:
    found = {f"{panel}: {name}" for panel in every_panel(hand) for name in hand.main(nameless)}
    found |= {f"{dialog}: {name}" for dialog, _ in every_dialog(hand) for name in hand.main(nameless)}
    assert not found, "\n".join(sorted(found))


def test_the_cut_view_and_the_restart_have_names(hand: Hand, job: Any) -> None:  # noqa: F811
    opened(hand, job)
    found = hand.main(nameless)
    hand.main(FreeCADGui.Control.closeDialog)
    hand.main(restart.open_restart, job, no_restart)
    hand.wait(lambda: places.find("CNCStepper_Restart_places").rows, 60, "the places")
    hand.settle()
    found += hand.main(nameless)
    hand.main(FreeCADGui.Control.closeDialog)
    assert not found


def test_the_connected_dock_has_names(hand: Hand, dock: Any) -> None:  # noqa: F811
    connected(hand)
    assert not hand.main(nameless)
