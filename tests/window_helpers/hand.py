# SPDX-License-Identifier: LGPL-2.1-or-later
"""A person's hand at FreeCAD's window, for the tests: it finds things on the screen, clicks, types and looks.

What it does goes through the X server; Qt is asked only where things are. Places are Qt's own pixels (with
QT_SCALE_FACTOR=2 one of them is two of the screen's).
"""

from __future__ import annotations

import os
import re
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
from PySide import QtGui

from window_helpers import report_view, x_input
from window_helpers import screen_places as places
from window_helpers.interface import EventWatchdog, Interface, Keeper, Watchdog, interface_stack
from window_helpers.touches import Touches

PICTURES = Path(os.environ["CNCSTEPPER_WINDOW_PICTURES"])
APPEARS_S = 5.0  # so long may a window or an entry take to appear
ENABLED_S = 20.0  # so long may FreeCAD take to see that a command can be run: it looks when it has nothing else to do
FINGER_S = 0.05  # between the clicks of a double click
NO_DOUBLE_S = 0.6  # between two clicks, so that Qt takes them for no double click (it does within 0.4 s)
NEAR_PX = 20.0  # two clicks that near might be taken for a double click
AGAIN_S = 0.2  # before a key is pressed once more that was not seen
SEEN_S = 1.0  # so long may a click take to be seen beside other windows
QUICK = 80  # the quality that lets Qt's writer of PNG compress least, without loss
LIST_S = 2.0  # so long may the list of a combo box take to appear
REST_S = 0.03  # what has not moved for so long rests
CLICKS = 3  # so often is a button clicked that does not see it
TOOLTIP_S = 2.0  # so long may a tooltip take that comes
DRAG_STEPS_PX = (2, 6, 12, 18)  # the way of a drag from its row, and to the other: Qt wants some before it begins
DRAG_S = 0.15  # between its last steps: FreeCAD looks at where it is only so often
UPPER, LOWER = 0.3, 0.7  # of a row's height
HOVERS = 4  # so often is the pointer brought back where no tooltip came
Target = Any  # an objectName or a widget
Point = tuple[float, float]


def _is_shown(widget: Any) -> bool:
    """Return whether a widget is there and shown: what is chosen in a list may make its form anew."""
    try:
        return bool(widget.isVisible())
    except RuntimeError:  # Qt has deleted it
        return False


class Hand:
    """See the module; every method is called in pytest's thread."""

    def __init__(self, interface: Interface, keeper: Keeper) -> None:
        self._interface, self._keeper = interface, keeper
        server = x_input.connect()
        self.mouse, self.keyboard = x_input.Mouse(server), x_input.Keyboard(server)
        self.touches = Touches()
        self.typed = 0  # texts that were typed
        self._allowed: list[str] = []
        self._clicked: tuple[Point, float] = ((-1.0, -1.0), 0.0)  # the last place, and when

    # ---- FreeCAD's own thread ----

    def main(self, function: Callable[..., Any], *arguments: Any, limit_s: float = 30.0) -> Any:
        """Run a function on the interface thread and return its result; what it raises is raised here."""
        return self._interface.call(function, *arguments, limit_s=limit_s)

    def wait(self, condition: Callable[[], Any], seconds: float = 10.0, what: str = "") -> Any:
        """Wait until the condition, asked on the interface thread, is true; return what it gave."""
        until_s = time.monotonic() + seconds
        while not (result := self.main(condition)):
            if time.monotonic() > until_s:
                raise AssertionError(f"waited {seconds} s in vain for {what or condition}; {self.describe()}")
            time.sleep(0.02)
        return result

    def settle(self) -> None:
        """Wait until FreeCAD has handled the events that were sent."""
        for pause_s in (0.005, 0.01):
            self.main(QtGui.QCursor.pos)  # a question to the X server: its answer comes after the events
            time.sleep(pause_s)
        self.main(int)

    def watchdog(self) -> Watchdog:
        """Measure the longest block of the interface thread: `with hand.watchdog() as watch: …; watch.max_ms`."""
        return Watchdog(self._interface)

    def event_watchdog(self) -> EventWatchdog:
        """Measure what our package takes in the longest event, without what the test itself asks for."""
        return EventWatchdog(self._interface)

    def memory_mb(self) -> float:
        """Return the memory that FreeCAD's process holds at this moment."""
        pages = int(Path("/proc/self/statm").read_text("ascii").split()[1])
        return pages * os.sysconf("SC_PAGE_SIZE") / 1e6

    def workbench_is_open(self) -> bool:
        """Tell whether FreeCAD has opened our workbench."""
        return bool(FreeCADGui.activeWorkbench().name() == "CNCStepperWorkbench")

    # ---- looking ----

    def find(self, name: str) -> Any:
        """Return the widget with this objectName, the visible one where several have it."""
        return self.main(places.find, name)

    def exists(self, name: str) -> bool:
        """Tell whether a visible widget has this objectName."""
        return bool(self.main(places.visible, name))

    def text(self, target: Target) -> str:
        """Return the text that a label, field, button, spin or combo box shows."""
        return str(self.main(lambda: places.text(places.find(target))))

    def report(self) -> list[report_view.Line]:
        """Return the lines of the report view since the test began; a line has .kind, .text and .bad."""
        return list(self.main(report_view.read))

    def expect_report(self, pattern: str) -> None:
        """Allow warnings and errors in the report view that match a pattern, for this test."""
        self._allowed.append(pattern)

    def unexpected(self) -> list[report_view.Line]:
        """Return the bad lines of the report view that the test did not ask for."""
        return [line for line in self.report() if line.bad and not any(re.search(p, line.text) for p in self._allowed)]

    def shot(self, name: str, target: Target | None = None) -> Path:
        """Save the screen, or the window that a widget stands in, as build/window/VERSION/NAME.png."""
        self.settle()
        path = PICTURES / (re.sub(r"[^\w.+-]+", "_", name) + ".png")
        assert self.main(places.picture, target).save(str(path), "PNG", QUICK), f"could not write {path}"
        return path

    def describe(self) -> str:
        """Return what is on the screen, for messages."""
        return str(self.main(places.describe)) + "\nthe interface thread is in\n" + interface_stack()

    # ---- mouse ----

    @property
    def clicks(self) -> int:
        """How often a mouse button was pressed so far, by whatever of this class; a double click counts twice."""
        return self.mouse.presses

    def click(
        self,
        target: Target,
        *,
        at: Point | None = None,
        button: int = x_input.LEFT,
        double: bool = False,
        modifiers: Sequence[str] = (),
    ) -> None:
        """Click a widget (or the one with this objectName), in its middle or `at` a place in it.

        A button that was not pressed by that, or a line that has not got the keyboard, is clicked again, as a person
        does: FreeCAD 1.1 lets clicks fall through a panel that has just grown.
        """
        for _ in range(CLICKS):
            place = self._place(places.of_widget, target, at)
            pressed = self.main(places.Pressed, target)
            self._click_place(place, button, double, modifiers)
            if button == x_input.LEFT:
                self.is_soon(pressed.told)
            if self.main(pressed.end) or button != x_input.LEFT:
                return
            print(f"{target} did not see the click", flush=True)
        raise AssertionError(f"{target} does not see clicks; {self.describe()}")

    def tap(self, target: Target) -> None:
        """Click a widget that rests already, of many one after the other; the caller looks at the effect of each."""
        self._click_place(self.main(places.of_widget, target, None))

    def is_soon(self, condition: Callable[..., bool], *arguments: Any) -> bool:
        """Return whether a condition holds after what was clicked; a second click may come too late for the first."""
        until_s = time.monotonic() + SEEN_S
        while not (holds := self.main(condition, *arguments)) and time.monotonic() < until_s:
            time.sleep(REST_S)
        return bool(holds)

    def _place(self, where: Callable[..., Point], *arguments: Any) -> Point:
        """Return a place as soon as it can be seen and rests: windows appear, and trees fill, a moment later."""
        until_s = time.monotonic() + APPEARS_S
        before = None
        while True:
            try:
                place = self.main(where, *arguments)
                if place == before:
                    return place
                before = place
            except (AssertionError, RuntimeError):  # not there yet, or going away at this moment
                if time.monotonic() > until_s:
                    raise
            time.sleep(REST_S)

    def _click_place(self, place: Point, button: int = 1, double: bool = False, modifiers: Sequence[str] = ()) -> None:
        self.mouse.move(*place)
        self.settle()
        self._let_a_double_click_pass(place)
        self.main(self.touches.note_click, *place)
        for key in modifiers:
            self.keyboard.down(key)
        for _ in range(2 if double else 1):
            self.mouse.down(button)
            self.mouse.up(button)
            time.sleep(FINGER_S)
        for key in reversed(modifiers):
            self.keyboard.up(key)
        self._clicked = place, time.monotonic()
        self.settle()

    def _let_a_double_click_pass(self, place: Point) -> None:
        """Wait where the last click was beside this place and a moment ago."""
        (x, y), when_s = self._clicked
        if abs(place[0] - x) <= NEAR_PX and abs(place[1] - y) <= NEAR_PX:
            time.sleep(max(0.0, when_s + NO_DOUBLE_S - time.monotonic()))

    def hover(self, target: Target) -> None:
        """Put the pointer on a widget."""
        self._hover_place(self._place(places.of_widget, target, None))

    def _hover_place(self, place: Point) -> None:
        for away in (3, 0):
            self.mouse.move(place[0] - away, place[1] - away)
            self.settle()

    def tooltip_in_tree(self, label: str) -> str:
        """Return the tooltip of an object in FreeCAD's tree; the pointer comes back when none appears."""
        for _ in range(HOVERS):
            self._hover_place(self._place(places.of_tree_item, label))
            until_s = time.monotonic() + TOOLTIP_S
            while time.monotonic() < until_s:
                if shown := self.main(places.tooltip):
                    return str(shown)
                time.sleep(REST_S)
            self.mouse.move(*self.main(places.at_rest))
        raise AssertionError(f"{label} in the tree has no tooltip; {self.describe()}")

    def command(self, name: str) -> None:
        """Click the toolbar button of a FreeCAD command, when FreeCAD has seen that it can be run.

        It looks at that every 0.3 s, when it has nothing else to do: until then the button sees no click.
        """
        self._place(lambda: places.of_widget(places.tool_button(name), None))
        self.wait(lambda: places.tool_button(name).isEnabled(), ENABLED_S, f"{name} to be possible")
        self.click(self.main(places.tool_button, name))

    def menu(self, *texts: str) -> None:
        """Click through the menu bar: `hand.menu("CNCStepper", "New job")`; & and … are left out."""
        self._click_place(self._place(places.menu_bar_entry, texts[0]))
        for text in texts[1:]:
            self.entry(text)

    def entry(self, text: str) -> None:
        """Click an entry of the menu that is open; & and … are left out."""
        self._click_place(self._place(places.popup_entry, text))

    def button(self, text: str) -> None:
        """Click the button with this text, in the open dialog or else anywhere in the window."""
        self._place(lambda: places.of_widget(places.button(text), None))
        self.click(self.main(places.button, text))

    def item(self, view: Target, text: str, *, double: bool = False, modifiers: Sequence[str] = ()) -> None:
        """Click an entry of a list, tree or table by its text; it is scrolled to first."""
        self._click_place(self._place(places.of_item, view, text), double=double, modifiers=modifiers)

    def tree(self, label: str, *, double: bool = False, modifiers: Sequence[str] = ()) -> None:
        """Click an object in FreeCAD's tree by its label; again where the tree moved under the pointer.

        FreeCAD fills its tree up to 0.3 s after a change, from its own selection: a row that is clicked before that
        stands beside what was selected then, which a person sees and clicks again.
        """
        chosen = places.is_selected if modifiers else places.is_selected_alone
        for _ in range(CLICKS):
            self._click_place(self._place(places.of_tree_item, label), double=double, modifiers=modifiers)
            if double or self.is_soon(chosen, label):
                return
            print(f"{label} in the tree did not see the click: {self.main(places.selected)} are selected", flush=True)
        raise AssertionError(f"{label} in the tree does not see clicks; {self.describe()}")

    def drag_in_tree(
        self, labels: Sequence[str], onto: str, *, lower: bool = True, modifiers: Sequence[str] = ()
    ) -> None:
        """Drag objects of FreeCAD's tree onto the upper or lower part of a row; a document's row is its label."""
        self.tree(labels[0])
        for label in labels[1:]:
            self.tree(label, modifiers=("Ctrl",))
        self.mouse.move(*self._place(places.of_tree_item, labels[-1]))
        self.settle()
        time.sleep(NO_DOUBLE_S)
        self.mouse.down(x_input.LEFT)
        x, y = self.main(places.of_tree_item, labels[-1])
        for away in DRAG_STEPS_PX:
            self.mouse.move(x + away, y + away)
            time.sleep(FINGER_S)
        for key in modifiers:
            self.keyboard.down(key)
        x, y = self.main(places.of_tree_item, onto, LOWER if lower else UPPER)
        for away in reversed(DRAG_STEPS_PX):
            self.mouse.move(x + away, y)
            time.sleep(DRAG_S)
        self.mouse.move(x, y)
        time.sleep(DRAG_S)

    def drop(self, modifiers: Sequence[str] = ()) -> None:
        """Let go what is dragged."""
        self.mouse.up(x_input.LEFT)
        time.sleep(DRAG_S)
        for key in reversed(modifiers):
            self.keyboard.up(key)
        self.settle()

    def choose(self, combo: Target, text: str) -> None:
        """Open a combo box and click the entry with this text until the list closes.

        Where the list opens under the pointer, Qt takes a click at the same place for half of a double click.
        """
        entries = self.main(places.combo_list, combo)
        self._open(combo, entries)
        until_s = time.monotonic() + APPEARS_S
        while self.main(_is_shown, entries):
            assert time.monotonic() < until_s, f"the list of {combo} does not see clicks at {text!r}; {self.describe()}"
            self.item(entries, text)

    def _open(self, combo: Target, entries: Any) -> None:
        """Click a combo box until its list is there."""
        for _ in range(CLICKS):
            self.click(combo, at=self.main(places.list_arrow, combo))
            until_s = time.monotonic() + LIST_S
            while time.monotonic() < until_s:
                if self.main(_is_shown, entries):
                    return
                time.sleep(REST_S)
            print(f"{combo} did not see the click", flush=True)
        raise AssertionError(f"the list of {combo} does not open; {self.describe()}")

    def click_view(
        self, point: Point, *, button: int = x_input.LEFT, double: bool = False, modifiers: Sequence[str] = ()
    ) -> None:
        """Click a place of the 3D view; pixels from its upper left corner."""
        self._click_place(self._place(places.of_view, point), button, double, modifiers)

    def drag(self, points: Sequence[Point], *, modifiers: Sequence[str] = (), button: int = x_input.LEFT) -> None:
        """Press at the first point of the 3D view, move through all, release; pixels from its upper left corner."""
        self.press_at(points[0], modifiers=modifiers, button=button)
        for point in points[1:]:
            self.move_to(point)
        self.release(modifiers=modifiers, button=button)

    def press_at(self, point: Point, *, modifiers: Sequence[str] = (), button: int = x_input.LEFT) -> None:
        """Press a mouse button at a place of the 3D view and keep it down."""
        self.move_to(point)
        for key in modifiers:
            self.keyboard.down(key)
        self.mouse.down(button)
        self.settle()

    def move_to(self, point: Point) -> None:
        """Move the pointer to a place of the 3D view, and wait until it has been seen there."""
        self.mouse.move(*self._place(places.of_view, point))
        self.settle()

    def release(self, *, modifiers: Sequence[str] = (), button: int = x_input.LEFT) -> None:
        """Release a mouse button, and the keys held with it."""
        self.mouse.up(button)
        for key in reversed(modifiers):
            self.keyboard.up(key)
        self.settle()

    def view_point(self, x_mm: float, y_mm: float, z_mm: float = 0.0) -> Point:
        """Return where a point of the drawing appears in the 3D view, which rests, for `drag` and `click_view`."""
        return self._place(places.view_pixels, x_mm, y_mm, z_mm)

    # ---- keys ----

    def type(self, text: str) -> None:
        """Type a text where the keyboard's focus is.

        Qt forgets that Shift is held when it hears of a new key: all keys are there before the first is pressed.
        """
        self.wait(places.has_keyboard, APPEARS_S, "the keyboard's focus")
        self.main(self.touches.note_typing)
        self.typed += 1
        self.keyboard.learn(text)
        self.settle()
        for letter in text:
            self.keyboard.write(letter)
        self.settle()

    def key(self, combination: str) -> None:
        """Press and release keys together: "Return", "Ctrl+Z"."""
        self.wait(places.has_keyboard, APPEARS_S, "the keyboard's focus")
        self.keyboard.stroke(combination)
        self.settle()

    def undo(self) -> None:
        """Press Ctrl+Z as soon as it works."""
        self.shortcut("Std_Undo", "Ctrl+Z")

    def redo(self) -> None:
        """Press Ctrl+Shift+Z as soon as it works."""
        self.shortcut("Std_Redo", "Ctrl+Shift+Z")

    def shortcut(self, command: str, keys: str) -> None:
        """Press a command's keys as soon as FreeCAD lets it work: it looks only every few hundred milliseconds."""
        self.wait(lambda: FreeCADGui.Command.get(command).getAction()[0].isEnabled(), APPEARS_S, f"{command} to work")
        self.touches.note_command(command)
        self.key(keys)

    def fill(self, target: Target, text: str) -> None:
        """Click a field, replace what stands in it, leave it with Tab."""
        self.click(target)
        until_s = time.monotonic() + APPEARS_S
        self.key("Ctrl+A")
        while not self.main(places.all_is_selected, target):
            assert time.monotonic() < until_s, f"Ctrl+A does not select what stands in {target}; {self.describe()}"
            print(f"Ctrl+A did not select what stands in {target}", flush=True)
            time.sleep(AGAIN_S)
            self.key("Ctrl+A")
        self.type(text)
        self.key("Tab")

    # ---- before and after a test ----

    def begin(self) -> None:
        """Start with an empty report view."""
        self._allowed.clear()
        self.main(report_view.clear)

    def tidy(self) -> None:
        """Release keys, rest the pointer where nothing answers it, close dialogs and documents."""
        self.mouse.release_all()
        self.mouse.move(*self.main(places.at_rest))
        self.keyboard.release_all()
        for _ in range(5):
            if not self.main(places.close_one_popup):
                break
            self.settle()
        self.main(FreeCADGui.Control.closeDialog)
        self.main(places.hide_our_windows)
        self.settle()
        for name in self.main(lambda: list(FreeCAD.listDocuments())):
            self.main(FreeCAD.closeDocument, name)
        self.settle()
        self.main(self._keeper.let_go)
