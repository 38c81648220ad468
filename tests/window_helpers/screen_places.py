# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where things are on the screen; all of it runs on the interface thread. Places are pixels of the X screen."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

try:
    from shiboken6 import isValid
except ImportError:
    from shiboken2 import isValid

ARROW_PX = 8  # from the right end of a combo box to the middle of its arrow
Point = tuple[float, float]


def _scale() -> float:
    return float(QtGui.QApplication.primaryScreen().devicePixelRatio())


def _on_screen(widget: Any, point: Any) -> Point:
    spot = widget.mapToGlobal(point)
    return spot.x() * _scale(), spot.y() * _scale()


def _plain(text: str) -> str:
    return text.replace("&", "").rstrip(".…").strip()


def all_widgets() -> list[Any]:
    """Return all widgets; PySide2 may still hand out one that Qt has deleted."""
    return [widget for widget in QtGui.QApplication.allWidgets() if isValid(widget)]


def visible(name: str) -> list[Any]:
    """Return the visible widgets with this objectName."""
    return [w for w in all_widgets() if w.objectName() == name and w.isVisible()]


def find(target: Any) -> Any:
    """Return the widget itself, or the one with this objectName."""
    if not isinstance(target, str):
        return target
    found = visible(target) or [w for w in all_widgets() if w.objectName() == target]
    assert found, f"no widget is named {target}; there are {_our_names()}"
    return found[0]


def _our_names() -> list[str]:
    return sorted({w.objectName() for w in all_widgets() if w.objectName().startswith("CNC")})


class Pressed(QtCore.QObject):
    """Hears whether a button is pressed, or a line gets a click; anything else hears every click.

    The window manager hands a click on later, and a key at once: who types into a line waits for its click.
    """

    def __init__(self, target: Any):
        super().__init__()
        widget = find(target)
        is_button = isinstance(widget, QtGui.QAbstractButton)
        self._line = widget if widget.inherits("QLineEdit") or widget.inherits("QAbstractSpinBox") else None
        self._heard = not is_button and self._line is None
        self._watched = [self._line, *self._line.findChildren(QtGui.QLineEdit)] if self._line is not None else []
        for part in self._watched:
            part.installEventFilter(self)
        if is_button:
            widget.pressed.connect(self._on_message)

    @QtCore.Slot()
    def _on_message(self) -> None:
        self._heard = True

    def eventFilter(self, watched: Any, event: Any) -> bool:
        """Note a click on the line; Qt calls this."""
        self._heard |= event.type() == QtCore.QEvent.Type.MouseButtonPress
        return False

    def told(self) -> bool:
        """Return whether the click has come."""
        return self._heard

    def end(self) -> bool:
        """Listen no longer; return whether the click has come, or the line has the keyboard."""
        try:
            for part in self._watched:
                part.removeEventFilter(self)
            return self._heard or (self._line is not None and self._line.hasFocus())
        except RuntimeError:  # the click has closed what the line stood in
            return True


def all_is_selected(target: Any) -> bool:
    """Tell whether all of a field's line is selected, of a number with words beside it the number; no line: yes.

    Qt forgets which keys are held when the X server tells it of a new key, as after the first € of a test. Qt itself
    is asked what the field is: PySide2 may hand out a wrapper of another class.
    """
    widget = find(target)
    line = widget if widget.inherits("QLineEdit") else widget.findChild(QtGui.QLineEdit)
    if line is None:
        return True
    selected, whole = str(line.property("selectedText")), str(line.property("text"))
    number_is_selected = bool(selected) and not re.search(r"\d", whole.replace(selected, "", 1))
    return selected == whole or (line is not widget and number_is_selected)


def tooltip() -> str:
    """Return the text of the tooltip that is shown, "" when there is none."""
    return str(QtGui.QToolTip.text()) if QtGui.QToolTip.isVisible() else ""


def text(widget: Any) -> str:
    """Return what a widget shows as text."""
    for method in ("text", "currentText", "toPlainText", "windowTitle"):
        if hasattr(widget, method):
            return str(getattr(widget, method)())
    raise AssertionError(f"{widget} shows no text")


def of_widget(target: Any, at: Point | None) -> Point:
    """Return the middle of a widget, or a place in it; a widget that cannot be clicked there is an error."""
    widget = find(target)
    name = widget.objectName() or type(widget).__name__
    assert widget.isVisible(), f"{name} is not visible"
    assert widget.isEnabled(), f"{name} is disabled: {widget.toolTip()}"
    scroll_to(widget)
    spot = QtCore.QPoint(round(at[0]), round(at[1])) if at else _middle(widget)
    there = QtGui.QApplication.widgetAt(widget.mapToGlobal(spot))
    assert there is widget or (there and widget.isAncestorOf(there)), f"{name} is covered by {_chain(there)}"
    return _on_screen(widget, spot)


def _middle(widget: Any) -> Any:
    """A check box and a radio button are clicked on their mark: their widget may be wider than what answers."""
    if isinstance(widget, (QtGui.QCheckBox, QtGui.QRadioButton)):
        return QtCore.QPoint(10, widget.height() // 2)
    if isinstance(widget, QtGui.QAbstractSpinBox):  # its line, not the arrows at its end
        return QtCore.QPoint(min(20, widget.width() // 3), widget.height() // 2)
    return widget.rect().center()


def scroll_to(widget: Any) -> None:
    """Scroll to a widget, without asking for its parents: PySide2 keeps what it was asked for that Qt has deleted."""
    for area in [w for w in all_widgets() if isinstance(w, QtGui.QScrollArea)]:
        if area.isVisible() and area.isAncestorOf(widget):
            area.ensureWidgetVisible(widget)


def _scroll_to_spot(widget: Any, spot: Any) -> None:
    """Scroll the panels around a widget until a spot of it is seen: a list may be taller than what its panel shows."""
    for area in [w for w in all_widgets() if isinstance(w, QtGui.QScrollArea)]:
        if area.isVisible() and area.isAncestorOf(widget):
            inside = widget.mapTo(area.widget(), spot)
            area.ensureVisible(inside.x(), inside.y())


def widgets_around(widget: Any) -> list[Any]:
    """Return a widget and those that contain it, the innermost first, without asking for parents: see `scroll_to`."""
    holders = [each for each in all_widgets() if each.isAncestorOf(widget)]  # which for Qt is its own, too
    return sorted(holders, key=lambda holder: -sum(each.isAncestorOf(holder) for each in holders))


def _chain(widget: Any) -> str:
    if widget is None:
        return "nothing of FreeCAD's"
    return " in ".join(f"{type(each).__name__}({each.objectName()})" for each in widgets_around(widget))


def tool_button(command: str) -> Any:
    """Return the visible toolbar button of a FreeCAD command."""
    actions = FreeCADGui.Command.get(command).getAction()
    buttons = [
        button
        for button in FreeCADGui.getMainWindow().findChildren(QtGui.QToolButton)
        if button.isVisible() and button.defaultAction() in actions
    ]
    assert buttons, f"no toolbar shows a button for {command}"
    return buttons[0]


def menu_bar_entry(label: str) -> Point:
    """Return the place of an entry of the menu bar."""
    bar = FreeCADGui.getMainWindow().menuBar()
    entries = [action for action in bar.actions() if _plain(action.text()) == _plain(label) and action.isVisible()]
    assert entries, f"the menu bar has no {label}; it has {[_plain(a.text()) for a in bar.actions()]}"
    return _on_screen(bar, bar.actionGeometry(entries[0]).center())


def popup_entry(label: str) -> Point:
    """Return the place of an entry of the menu that is open."""
    menu = QtGui.QApplication.activePopupWidget()
    assert isinstance(menu, QtGui.QMenu), "no menu is open"
    for action in menu.actions():
        if _plain(action.text()) == _plain(label):
            assert action.isEnabled(), f"{label} is disabled: {action.toolTip()}"
            return _on_screen(menu, menu.actionGeometry(action).center())
    raise AssertionError(f"the menu has no {label!r}; it has {[_plain(a.text()) for a in menu.actions()]}")


def has_keyboard() -> bool:
    """Tell whether keys arrive where a person would expect: in the modal dialog, when there is one."""
    modal = QtGui.QApplication.activeModalWidget()
    if QtGui.QApplication.activePopupWidget() is not None:
        return True
    return bool(modal.isActiveWindow()) if modal is not None else QtGui.QApplication.activeWindow() is not None


def button(label: str) -> Any:
    """Return the visible button with this text, in the modal dialog when there is one."""
    within = QtGui.QApplication.activeModalWidget() or FreeCADGui.getMainWindow()
    buttons = [b for b in within.findChildren(QtGui.QAbstractButton) if b.isVisible()]
    found = [b for b in buttons if _plain(b.text()) == _plain(label)]
    assert found, f"no button says {label}; there are {sorted({_plain(b.text()) for b in buttons})}"
    assert len(found) == 1, f"{len(found)} buttons say {label}"
    return found[0]


def of_item(target: Any, label: str) -> Point:
    """Return the middle of what is seen of an entry of a list, tree or table, named by its text or the first line.

    A row may be wider than its list: Qt lays rows out once, and a panel becomes narrower when FreeCAD shows it.
    """
    view = find(target)
    index = _find_index(view.model(), view.rootIndex(), label)
    assert index is not None, f"{view.objectName() or view} has no entry {label!r}"
    view.scrollTo(index)
    seen = view.visualRect(index).intersected(view.viewport().rect())
    assert not seen.isEmpty(), f"the entry {label!r} is hidden"
    _scroll_to_spot(view.viewport(), seen.center())
    return _on_screen(view.viewport(), seen.center())


def _find_index(model: Any, parent: Any, label: str) -> Any:
    for row in range(model.rowCount(parent)):
        # PySide2 hides the columns of a plain list's model: there is one
        for column in range(1 if isinstance(model, QtCore.QAbstractListModel) else model.columnCount(parent)):
            index = model.index(row, column, parent)
            if label in (str(index.data()), str(index.data()).partition("\n")[0]):
                return index
        inside = _find_index(model, model.index(row, 0, parent), label)
        if inside is not None:
            return inside
    return None


def of_tree_item(label: str, height: float = 0.5) -> Point:
    """Return the place of an object in FreeCAD's tree, by its label; height: of its row, from its top."""
    for tree, item in _tree_items(label):
        tree.scrollToItem(item)
        rect = tree.visualItemRect(item)
        on_text = min(rect.left() + 60, rect.right() - 6)  # not on the eye before it, which hides the object
        return _on_screen(tree.viewport(), QtCore.QPoint(on_text, round(rect.top() + height * rect.height())))
    raise AssertionError(f"the tree shows no {label!r}")


def is_in_tree(label: str) -> bool:
    """Tell whether FreeCAD's tree has a row of an object, by its label."""
    return next(_tree_items(label), None) is not None


def _tree_items(label: str) -> Iterator[tuple[Any, Any]]:
    for tree in FreeCADGui.getMainWindow().findChildren(QtGui.QTreeWidget):
        if isValid(tree) and tree.isVisible() and tree.metaObject().className() == "Gui::TreeWidget":
            items = tree.findItems(label, QtCore.Qt.MatchFlag.MatchExactly | QtCore.Qt.MatchFlag.MatchRecursive)
            yield from ((tree, item) for item in items)


def selected() -> list[str]:
    """Return the labels of what is selected in FreeCAD."""
    return [chosen.Label for chosen in FreeCADGui.Selection.getSelection("*")]


def is_selected(label: str) -> bool:
    """Tell whether FreeCAD has an object with this label among what is selected."""
    return label in selected()


def is_selected_alone(label: str) -> bool:
    """Tell whether an object with this label is all that is selected in FreeCAD."""
    return set(selected()) == {label}


def combo_list(target: Any) -> Any:
    """Return the list that a combo box opens."""
    return find(target).view()


def list_arrow(target: Any) -> Point | None:
    """Return where in a combo box a click opens the list: anywhere, or on the arrow of one that can be typed into."""
    combo = find(target)
    return (combo.width() - ARROW_PX, combo.height() // 2) if combo.isEditable() else None


def view_widget() -> Any:
    """Return the widget that shows the active 3D view."""
    # Not by findChildren: PySide would keep what it found, and give the closed view's remains for a new one.
    view = FreeCADGui.activeDocument() and FreeCADGui.activeDocument().activeView()
    assert hasattr(view, "graphicsView"), "no 3D view is open"
    return view.graphicsView()


def of_view(point: Point) -> Point:
    """Return the place of a pixel of the active 3D view, counted from its upper left corner."""
    widget = view_widget()
    assert widget.rect().contains(round(point[0]), round(point[1])), f"{point} is outside the 3D view {widget.size()}"
    spot = QtCore.QPoint(round(point[0]), round(point[1]))
    there = QtGui.QApplication.widgetAt(widget.mapToGlobal(spot))
    assert there is not None and widget.isAncestorOf(there), f"the 3D view is covered there by {_chain(there)}"
    return _on_screen(widget, spot)


def view_pixels(x_mm: float, y_mm: float, z_mm: float) -> Point:
    """Return the pixel of the active 3D view at which a point of the drawing appears."""
    view = FreeCADGui.activeDocument().activeView()
    project = getattr(view, "getPointOnViewport", None) or view.getPointOnScreen
    x, y = project(FreeCAD.Vector(x_mm, y_mm, z_mm))
    widget = view_widget()
    return x / _scale(), widget.height() - 1 - y / _scale()


def picture(target: Any | None) -> Any:
    """Return the screen, or the window of a widget with its frame."""
    screen = QtGui.QApplication.primaryScreen()
    whole = screen.grabWindow(0)
    if target is None:
        return whole
    frame = find(target).window().frameGeometry()
    scale = _scale()
    corner, size = frame.topLeft() * scale, frame.size() * scale
    return whole.copy(QtCore.QRect(corner, size))


def describe() -> str:
    """Return what is open, in a line."""
    modal, popup = QtGui.QApplication.activeModalWidget(), QtGui.QApplication.activePopupWidget()
    focus = QtGui.QApplication.focusWidget()
    return f"modal dialog: {_chain(modal)}; popup: {_chain(popup)}; focus: {_chain(focus)}"


def at_rest() -> Point:
    """Return a place on the left of the status bar, where no panel of FreeCAD unfolds under the pointer."""
    bar = FreeCADGui.getMainWindow().statusBar()
    return _on_screen(bar, QtCore.QPoint(bar.width() // 4, bar.height() // 2))


def hide_our_windows() -> None:
    """Hide the workbench's docks, which make the 3D view narrower, and its dialogs, which lie over docks and panels."""
    for window in all_widgets():
        if isinstance(window, (QtGui.QDockWidget, QtGui.QDialog)) and window.objectName().startswith("CNCStepper_"):
            window.hide()


def close_one_popup() -> bool:
    """Close the open menu, list or modal dialog; return whether there was one."""
    open_one = QtGui.QApplication.activePopupWidget() or QtGui.QApplication.activeModalWidget()
    if open_one is not None:
        open_one.close()
    return open_one is not None


def narrower_than_their_text(dialog: Any) -> list[str]:
    """Return labels and buttons of a dialog that are shown narrower than what stands on them, with both widths."""
    shown = [one for one in dialog.findChildren(QtGui.QLabel) if one.isVisible() and not one.wordWrap()]
    shown += [one for one in dialog.findChildren(QtGui.QAbstractButton) if one.isVisible() and one.text()]
    return [
        f"{one.objectName()} {one.text()!r}: {one.width()} < {one.sizeHint().width()}"
        for one in shown
        if one.width() < one.sizeHint().width() - 1
    ]


def area_around(target: Any) -> Any:
    """Return the scroll area in which a widget stands."""
    return next(each for each in widgets_around(find(target)) if isinstance(each, QtGui.QScrollArea))


def cut_texts(window: Any, spare_px: int = 0) -> list[str]:
    """Return what is too narrow, or too low for its lines, of the texts that a window or a panel's area shows.

    spare_px: by which an area may be too narrow.
    """
    labels = [label for label in window.findChildren(QtGui.QLabel) if isValid(label) and label.isVisible()]
    labels = [label for label in labels if label.wordWrap()]
    low = [
        f"{label.objectName()} {label.text()!r}: {label.height()} high < {label.heightForWidth(label.width())}"
        for label in labels
        if label.text() and label.height() < label.heightForWidth(label.width()) - 1
    ]
    inner = [*window.findChildren(QtGui.QScrollArea), *([window] if isinstance(window, QtGui.QScrollArea) else [])]
    areas = [area for area in inner if area.isVisible() and area.horizontalScrollBar().maximum() > spare_px]
    wide = [f"{area.objectName()} is {area.horizontalScrollBar().maximum()} too narrow" for area in areas]
    return narrower_than_their_text(window) + low + wide
