# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper settings` at a virtual grbl, and `machine import` and `export` of FreeCAD's machine files."""

from __future__ import annotations

import json
from pathlib import Path

from CNCStepper.machine.profile import load_machine
from helpers.cli.command_line import called
from helpers.control.virtual_process import virtual_grbl


def said(*words: str) -> str:
    result = called(*words)
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout


def test_settings_are_backed_up_compared_restored_and_made_a_profile(tmp_path: Path) -> None:
    file = str(tmp_path / "before.txt")
    with virtual_grbl(speed=20.0) as address:
        at = ("--port", address, "--keep-open", "1")
        assert "34 settings of grbl 1.1" in said("settings", "backup", "-o", file, *at)
        assert "0 of 34 settings differ" in said("settings", "compare", file, *at)
        there = said("settings", "restore", "genmitsu-3018-pro", "--yes", *at)
        assert "$100: 80 -> 800  (X: steps per mm, 1/mm)" in there and "written and read back" in there
        assert "$120: 10 -> 250" in said("settings", "compare", file, *at)
        assert "written" in said("settings", "profile", "mine", "--from", "table-a", *at)
        assert load_machine("mine").axis["x"].travel_min_mm == -300
        assert "written and read back" in said("settings", "restore", file, "--yes", *at)
        asked = called("settings", "restore", "genmitsu-3018-pro", *at, answer="n\n")
        assert "nothing was written" in asked.stdout
        assert "0 of 34 settings differ" in said("settings", "compare", file, *at)
        (tmp_path / "bad.txt").write_text("$100=0\n$110=7\n", "utf-8")
        refused = called("settings", "restore", str(tmp_path / "bad.txt"), "--yes", *at)
        assert refused.returncode == 1 and "the controller refused $100=0" in refused.stderr
        said("disconnect", "--port", address)


def test_a_profile_is_written_for_freecad_and_read_from_it(tmp_path: Path) -> None:
    file = tmp_path / "mill.fcm"
    said("machine", "export", "genmitsu-3018-pro", "-o", str(file))
    content = json.loads(file.read_text("utf-8"))
    content["machine"]["name"] = "My mill"
    file.write_text(json.dumps(content), "utf-8")
    said("machine", "import", str(file), "my-mill", "--from", "genmitsu-3018-pro")
    assert load_machine("my-mill").name == "My mill"
    assert load_machine("my-mill").own_axes == load_machine("genmitsu-3018-pro").own_axes
