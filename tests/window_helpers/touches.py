# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a person could touch in the window during a run of tests, and what the tests' hand did touch.

Every click notes the widgets of ours that are on the screen and the one under the pointer, by objectName; of a command
it is the name, whether the click was on its tool button or in a menu, of another entry of a menu of ours the text.
Numbers of rows are left out of names: the fields of a table's second row are those of its first. So are the names that
a profile gives to relays: their buttons are one kind of button.

Each run writes one file beside its pictures, `build/window/VERSION[-KIND]/touches.json`. A run of named tests adds to
the file that is there. This script prints what nobody touched, over all kinds of one version but those that click at
random: `.venv/bin/python tests/window_helpers/touches.py host`; its exit status is 0 when nothing is left.
`make matrix` prints the same at its end.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterable
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
from window_helpers import window_kinds

OURS = "CNCStepper_"
FILE = "touches.json"
PICTURES = Path(__file__).resolve().parents[2] / "build" / "window"
KINDS = ("QAbstractButton", "QLineEdit", "QAbstractSpinBox", "QComboBox", "QAbstractItemView", "QAbstractSlider")
KINDS += ("QPlainTextEdit", "QTextEdit", "QTabWidget")
ROW = re.compile(r"(?<=_)\d+(?=_|$)|(?<=_Dock_Relay_)\w+$|(?<=_MachineTest_relay_)\w+$")


def general(name: str) -> str:
    """Return a widget's name without the numbers of rows and the names of relays."""
    return ROW.sub("#", name)


class Touches:
    """The names of what was seen and of what was touched; `note_*` run on the interface thread."""

    def __init__(self) -> None:
        self.seen: set[str] = set()
        self.touched: set[str] = set()

    def note_click(self, x: float, y: float) -> None:
        """Note what is on the screen and what lies under the pointer, at pixels of the X screen."""
        from PySide import QtCore, QtGui

        scale = float(QtGui.QApplication.primaryScreen().devicePixelRatio())
        spot = QtCore.QPoint(round(x / scale), round(y / scale))
        self._note(QtGui.QApplication.widgetAt(spot), spot)

    def note_typing(self) -> None:
        """Note what is on the screen and what has the keyboard."""
        from PySide import QtGui

        self._note(QtGui.QApplication.focusWidget(), None)

    def note_command(self, name: str) -> None:
        """Note a command whose keys were pressed."""
        if name.startswith(OURS):
            self.touched.add(name)

    def _note(self, there: object, spot: object) -> None:
        from PySide import QtGui

        shown = _shown()
        self.seen.update(general(widget.objectName()) for widget in shown)
        if there is None:
            return
        around = [widget for widget in shown if widget.isAncestorOf(there)]  # Qt: also of itself
        innermost = [widget for widget in around if sum(widget.isAncestorOf(other) for other in around) == 1]
        self.touched.update(general(widget.objectName()) for widget in innermost)
        if spot is not None and isinstance(there, QtGui.QMenu):
            self._note_menu(there, there.actionAt(there.mapFromGlobal(spot)))
        elif spot is not None and isinstance(there, QtGui.QToolButton):
            self.touched.update(_commands_of(there.defaultAction()))

    def _note_menu(self, menu: object, chosen: object) -> None:
        if menu.objectName().startswith(OURS):
            self.seen.update(_entry(menu, action) for action in menu.actions() if action.text())
            self.touched.update(_entry(menu, action) for action in [chosen] if action is not None)
        self.touched.update(_commands_of(chosen))

    def save(self, path: Path) -> None:
        """Add what was noted to a file, with all commands of ours as seen."""
        import FreeCADGui

        self.seen.update(name for name in FreeCADGui.listCommands() if name.startswith(OURS))
        before = _read(path) if path.exists() else Touches()
        noted = {"seen": sorted(self.seen | before.seen), "touched": sorted(self.touched | before.touched)}
        path.write_text(json.dumps(noted, indent=1), "utf-8")


def _shown() -> list[object]:
    """Return our named widgets on the screen that a person can click or type into."""
    from window_helpers import screen_places  # needs Qt, as no reader of the files does

    named = [widget for widget in screen_places.all_widgets() if widget.objectName().startswith(OURS)]
    return [widget for widget in named if widget.isVisible() and any(widget.inherits(kind) for kind in KINDS)]


def _commands_of(action: object) -> list[str]:
    """Return our command that an entry of a menu or a toolbar runs."""
    import FreeCADGui

    ours = [name for name in FreeCADGui.listCommands() if name.startswith(OURS)] if action is not None else []
    return [name for name in ours if action in FreeCADGui.Command.get(name).getAction()]


def _entry(menu: object, action: object) -> str:
    return f"{menu.objectName()}: {action.objectName() or action.text().replace('&', '')}"


def _read(path: Path) -> Touches:
    """Return what a file has noted."""
    noted, made = json.loads(path.read_text("utf-8")), Touches()
    made.seen, made.touched = set(noted["seen"]), set(noted["touched"])
    return made


def files(version: str) -> list[Path]:
    """Return what the runs of a version have written, without the kinds whose clicks prove nothing."""
    kinds = [f"-{kind}" for kind in window_kinds.KINDS if kind not in window_kinds.UNCOUNTED]
    paths = [PICTURES / f"{version}{kind}" / FILE for kind in ("", *kinds)]
    return [path for path in paths if path.exists()]


def untouched(files: Iterable[Path]) -> list[str]:
    """Return what these runs have seen and none of them has touched."""
    runs = [_read(path) for path in files]
    return sorted(set().union(*(run.seen for run in runs)) - set().union(*(run.touched for run in runs)))


if __name__ == "__main__":
    found = files(sys.argv[1])
    left = untouched(found)
    print("\n".join([f"{len(left)} untouched in {', '.join(path.parent.name for path in found)}:", *left]))
    sys.exit(bool(left) or not found)
