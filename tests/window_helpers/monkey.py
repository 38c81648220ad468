# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random clicks, keys and typed values at all that is ours in the window, from a seed: what a person may do by mistake.

Only what a person sees is touched, through the X server. Files are neither chosen nor written: a dialog that is not
ours is left with Esc. Commands that reach beyond the window, to a machine, a browser or the network, are not chosen.
"""

from __future__ import annotations

import random
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from CNCStepper.workbench.editor.window import EditorDock
from CNCStepper.workbench.features.base import proxy_type
from window_helpers import screen_places as places
from window_helpers.hand import Hand

TYPED = (
    *("", "0", "-1", "3", "12.5", "0,5", "2 mm", "1/8 in", "1e400", "nan", "abc", "(", "99999999", "6", "0.001"),
    *("{0}", "%s", "<b>", "1;2", "0.1.2", "-0", "45", "20000", " 7 ", "=1+1"),
)
KEYS = ("Tab", "Tab", "Up", "Down", "Prior", "Next", "Return", "space", "Ctrl+A", "BackSpace", "Ctrl+Z", "Home", "End")
TOUCHED = ("QAbstractButton", "QLineEdit", "QAbstractSpinBox", "QComboBox", "QAbstractItemView", "QAbstractSlider")
TOUCHED += ("QPlainTextEdit",)
TYPED_INTO = ("QLineEdit", "QAbstractSpinBox", "QPlainTextEdit")
OURS = "CNCStepper_"
NOT_CHOSEN = tuple(f"{OURS}{name}" for name in ("Send", "Controller", "Help", "Install", "FirstSteps"))
ORDERS = ("CNCStepper_Duplicate", "CNCStepper_MoveUp", "CNCStepper_MoveDown")
LEFT_ALONE = ("_choose", "_file", "_import", "_help")  # buttons that open FreeCAD's dialogs of files, or a browser
LAST = 60  # steps that a failure names
MOST_UNDOS = 500
MOST_UNHEARD = 10  # of them, or heard late
ANSWERS_S = 30.0  # so long may the interface thread be busy with one step


@dataclass(frozen=True)
class Spot:
    """A widget that a person sees, and where."""

    name: str
    kind: str
    x: float
    y: float


class Monkey:
    """Does one random step after the other; `done` has the last of them."""

    def __init__(self, hand: Hand, seed: int) -> None:
        self._hand, self._random = hand, random.Random(seed)
        self.done: deque[str] = deque(maxlen=LAST)
        self.steps = 0

    def step(self) -> None:
        """Do something that what is open allows."""
        self.steps += 1
        state = self._hand.main(state_of_window, limit_s=ANSWERS_S)
        {"popup": self._in_popup, "dialog": self._in_dialog, "panel": self._in_panel, "tree": self._in_tree}[state]()

    def leave(self) -> None:
        """Close what is open as a person does: lists and dialogs with Esc, the panel with OK or Cancel."""
        for _ in range(20):
            state = self._hand.main(state_of_window, limit_s=ANSWERS_S)
            if state == "tree":
                return
            if state == "panel":
                button = self._random.choice(("CNCStepper_Panel_ok", "CNCStepper_Panel_cancel"))
                if spots := self._hand.main(spots_of, partial(places.visible, button)):
                    self._click(spots[0])
                    continue
            self._key("Esc")
        raise AssertionError(f"a panel cannot be left: {self._hand.describe()}")

    def undo_all(self, document: Any) -> None:
        """Press Ctrl+Z until nothing is left to undo; FreeCAD hears it when its menu has followed the document.

        What a panel's OK began beside the window may become a step of its own meanwhile. FreeCAD switches the entry of
        its menu some times a second, so that a key can come while it is off: it is pressed again then.
        """
        unheard = 0
        for _ in range(MOST_UNDOS):
            names = self._hand.main(lambda: list(document.UndoNames))
            if not names:
                return
            self._hand.undo()
            if self._hand.is_soon(lambda names=names: list(document.UndoNames) != names):
                continue
            unheard += 1
            assert unheard < MOST_UNHEARD, f"to be undone: {names}; done again: {self._hand.main(redo_names, document)}"
        raise AssertionError(f"after {MOST_UNDOS} times Ctrl+Z there is something left to undo: {names[:2]}")

    def _in_popup(self) -> None:
        rows = self._hand.main(rows_of_popup)
        if rows and self._random.random() < 0.8:
            self._click(self._random.choice(rows))
        else:
            self._key("Esc")

    def _in_dialog(self) -> None:
        spots = self._hand.main(spots_of, widgets_of_dialog)
        if spots and self._random.random() < 0.5:
            self._touch(self._random.choice(spots))
        else:
            self._key("Esc")

    def _in_panel(self) -> None:
        chance = self._random.random()
        spots = self._hand.main(spots_of, widgets_of_ours)
        if chance < 0.04 or not spots:
            self.leave()
        elif chance < 0.2:
            self._key(self._random.choice(KEYS))
        else:
            self._touch(self._random.choice(spots))

    def _in_tree(self) -> None:
        chance, labels = self._random.random(), self._hand.main(labels_of_ours)
        if chance < 0.15 or not labels:
            self._key(self._random.choice(("Ctrl+Z", "Ctrl+Shift+Z")))
        elif chance < 0.3:
            self._command()
        elif chance < 0.45 and (spots := self._hand.main(spots_of, widgets_of_ours)):
            self._touch(self._random.choice(spots))
        elif chance < 0.55:
            self._order(self._random.choice(labels))
        else:
            self._double_click(self._random.choice(labels))

    def _command(self) -> None:
        """Click a tool button of ours that can be clicked now."""
        if spots := self._hand.main(spots_of, tool_buttons_of_ours):
            self._click(self._random.choice(spots))

    def _order(self, label: str) -> None:
        """Select an object, and delete, duplicate or move it."""
        act = self._random.choice(("Delete", *ORDERS))
        self.done.append(f"click {label}, {act}")
        if not self._row(label):
            return
        if act == "Delete":
            self._key("Delete")
        elif self._hand.main(lambda: FreeCADGui.Command.get(act).isActive()):
            self._hand.main(partial(FreeCADGui.runCommand, act))

    def _double_click(self, label: str) -> None:
        self.done.append(f"double click {label}")
        self._row(label, double=True)

    def _row(self, label: str, double: bool = False) -> bool:
        """Click a row of the tree; return whether it is there: a panel of before may have opened in its place."""
        try:
            self._hand.tree(label, double=double)
        except AssertionError:
            if self._hand.main(state_of_window) == "tree":
                raise
            return False
        return True

    def _touch(self, spot: Spot) -> None:
        self._click(spot)
        if spot.kind in TYPED_INTO:
            self._key("Ctrl+A")
            text = self._random.choice(TYPED)
            self.done.append(f"type {text!r}")
            if self._hand.main(places.has_keyboard):
                self._hand.type(text)

    def _click(self, spot: Spot) -> None:
        self.done.append(f"click {spot.name or spot.kind}")
        self._hand.mouse.move(spot.x, spot.y)
        self._hand.settle()
        self._hand.mouse.down()
        self._hand.mouse.up()
        self._hand.settle()

    def _key(self, keys: str) -> None:
        self.done.append(keys)
        if self._hand.main(places.has_keyboard):
            self._hand.key(keys)


# ---- on the interface thread ----


def redo_names(document: Any) -> list[str]:
    """Return what can be done again."""
    return list(document.RedoNames)


def state_of_window() -> str:
    """Return what is open in front: a popup, a modal dialog, a task panel, or nothing before the tree."""
    if QtGui.QApplication.activePopupWidget() is not None:
        return "popup"
    if QtGui.QApplication.activeModalWidget() is not None:
        return "dialog"
    return "panel" if FreeCADGui.Control.activeDialog() else "tree"


def labels_of_ours() -> list[str]:
    """Return the labels of our objects that FreeCAD's tree shows, in the order of the document."""
    document = FreeCAD.ActiveDocument
    labels = [obj.Label for obj in document.Objects if proxy_type(obj)] if document else []
    return [label for label in labels if places.is_in_tree(label)]


def close_windows() -> None:
    """Close the editors and dialogs of ours without a question; what was typed is lost."""
    for dock in FreeCADGui.getMainWindow().findChildren(EditorDock):
        dock.panel.edit.document().setModified(False)
        dock.close()
    for dialog in FreeCADGui.getMainWindow().findChildren(QtGui.QDialog):
        if dialog.objectName().startswith(OURS):
            dialog.deleteLater()  # hidden, it would ask when FreeCAD closes


def widgets_of_ours() -> list[Any]:
    """Return what can be touched of ours beside the toolbar: the open panel with OK and Cancel, docks, windows."""
    ours = [widget for widget in places.all_widgets() if widget.objectName().startswith(OURS)]
    return [widget for widget in ours if not widget.objectName().endswith(LEFT_ALONE)]


def tool_buttons_of_ours() -> list[Any]:
    """Return the tool buttons of the commands that may be chosen."""
    names = [name for name in FreeCADGui.Command.listAll() if name.startswith(OURS) and name not in NOT_CHOSEN]
    actions = [action for name in names for action in FreeCADGui.Command.get(name).getAction()]
    buttons = FreeCADGui.getMainWindow().findChildren(QtGui.QToolButton)
    return [button for button in buttons if button.defaultAction() in actions]


def widgets_of_dialog() -> list[Any]:
    """Return what can be touched of a modal dialog of ours; none of FreeCAD's."""
    dialog = QtGui.QApplication.activeModalWidget()
    if dialog is None or not dialog.objectName().startswith(OURS) or dialog.inherits("QFileDialog"):
        return []
    return [widget for widget in dialog.findChildren(QtGui.QWidget) if not widget.objectName().endswith(LEFT_ALONE)]


def spots_of(widgets: Callable[[], list[Any]]) -> list[Spot]:
    """Return those widgets that a click can reach now, each with its middle."""
    found = []
    for widget in widgets():
        kind = next((kind for kind in TOUCHED if widget.inherits(kind)), "")
        if not (kind and widget.isVisible() and widget.isEnabled()):
            continue
        middle = places._middle(widget)
        there = QtGui.QApplication.widgetAt(widget.mapToGlobal(middle))
        if there is widget or (there is not None and widget.isAncestorOf(there)):
            found.append(Spot(widget.objectName(), kind, *places._on_screen(widget, middle)))
    return sorted(found, key=lambda spot: (spot.y, spot.x, spot.name))


def rows_of_popup() -> list[Spot]:
    """Return the entries of the open menu or list."""
    popup = QtGui.QApplication.activePopupWidget()
    if isinstance(popup, QtGui.QMenu):
        entries = [(action, popup.actionGeometry(action).center()) for action in popup.actions() if action.isEnabled()]
        return [Spot(action.text(), "menu", *places._on_screen(popup, place)) for action, place in entries]
    view = popup.findChild(QtGui.QAbstractItemView) if popup is not None else None
    if view is None:
        return []
    return [
        Spot(str(index.data()), "row", *places._on_screen(view.viewport(), view.visualRect(index).center()))
        for index in (view.model().index(row, 0, QtCore.QModelIndex()) for row in range(view.model().rowCount()))
        if view.viewport().rect().contains(view.visualRect(index).center())
    ]
