# SPDX-License-Identifier: LGPL-2.1-or-later
"""What no test of the window has touched: the runs of several kinds count together."""

from __future__ import annotations

import json
from pathlib import Path

from window_helpers import touches


def test_what_another_kind_of_window_touched_is_not_left(tmp_path: Path) -> None:
    runs = {"plain": (["field", "button", "list"], ["field"]), "scaled": (["button"], ["button"])}
    for kind, (seen, touched) in runs.items():
        (tmp_path / kind).write_text(json.dumps({"seen": seen, "touched": touched}), "utf-8")
    assert touches.untouched([tmp_path / "plain"]) == ["button", "list"]
    assert touches.untouched([tmp_path / kind for kind in runs]) == ["list"]


def test_the_rows_of_a_table_are_one_field() -> None:
    assert touches.general("CNCStepper_Machine_axes_1_name") == touches.general("CNCStepper_Machine_axes_0_name")
    assert touches.general("CNCStepper_Dock_Step1") != touches.general("CNCStepper_Dock_Step2")
    assert touches.general("CNCStepper_Dock_Relay_lights") == touches.general("CNCStepper_Dock_Relay_flood")
    assert touches.general("CNCStepper_Machine_relay_0_device") == "CNCStepper_Machine_relay_#_device"
