# SPDX-License-Identifier: LGPL-2.1-or-later
"""Typing never freezes the window: every beginning of ten texts, by real keys, in every field of every panel.

All texts are typed as fast as the X server takes them, so that a panel leaves out some of what stands there only for a
moment; and one of them, in turn, so slowly that the panel applies what stands there after every key.

What is bounded is the longest time between two ticks of a timer in the window's thread (`interface.Watchdog`), in two
ways. Its own processor time there must stay below 50 ms: other programs on the machine do not count. What it waits for
besides (a lock, a file, another process) must stay below a quarter of a second, without the time in which the system
let other programs run in its place. The 3D view is hidden meanwhile: here the processor draws it, which takes many
times what a graphics card takes.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from typing import Any

import FreeCADGui
import screen_places as places
from hand import Hand
from PySide import QtCore, QtGui
from test_cycle_panels import PANEL, every_panel, unfold

from CNCStepper.workbench import api, editing
from CNCStepper.workbench.features.base import problem_of, proxy_type, values
from CNCStepper.workbench.features.catalogue import OPERATIONS

TEXTS = ("10 m", "10 mm + 2 in", "1e3 mm", "0,5 mm", "-3 mm", "1/0", "99999999 mm", "abc", "10 mm", "")
WHOLE = [text for text in TEXTS if not any(other.startswith(text) for other in TEXTS if other != text)]
AT_ONCE_MS = 50.0  # of processor time, of any call of ours
DRAWN_MS = 150.0  # of processor time in which Qt lays out and paints a large panel, all by itself
WAITS_MS = 250.0
KEY_S = 10.0  # so long may a key take to be seen
SHOWING = {  # values with which more lines are seen
    "pocket": {"pattern": "engagement"},
    "drill": {"pattern_kind": "grid", "style": "G83"},
    "bore": {"pattern_kind": "arc"},
    "thread": {"pattern_kind": "line"},
    "contour": {"tabs_by": "spacing", "lead_in_kind": "arc", "lead_out_kind": "line"},
}
KINDS = ("job", "tool", "line", *OPERATIONS)


def draw() -> dict[str, Any]:
    """Make one document for all panels: a job, its tool, an operation of each kind and a freehand line."""
    job = every_panel()
    line = api.add_freehand(job.Document, [(x, (x % 7) - 3) for x in range(-20, 20)], 0.01)
    for cycle, operation in zip(OPERATIONS, job.Operations, strict=True):
        api.edit(operation, **SHOWING.get(cycle, {}), active=cycle in ("pocket", "drill"))
    job.Document.recompute()
    return {"job": job, "tool": job.Tools[0], "line": line, **dict(zip(OPERATIONS, job.Operations, strict=True))}


class Typist:
    """A person at one open panel."""

    def __init__(self, hand: Hand, obj: Any):
        self.hand, self.obj, self.applied, self.slow = hand, obj, 0, False
        hand.main(editing.edit, obj)
        hand.wait(lambda: self.panel() is not None, 10, "the panel")
        hand.main(unfold)
        hand.settle()
        self.editors = hand.main(lambda: self._hurry())

    def panel(self) -> Any:
        found = FreeCADGui.getMainWindow().findChild(QtGui.QWidget, f"{PANEL}{proxy_type(self.obj)}")
        return found if found is not None and found.isVisible() else None

    def _hurry(self) -> list[Any]:
        """Let every single key be applied at once while the typist is slow, without the time that a pause takes."""
        editors = [self.panel(), *self.panel().findChildren(QtGui.QWidget)]
        editors = [widget for widget in editors if hasattr(widget, "apply") and hasattr(widget, "waiting")]
        for editor in editors:
            editor.form.changed.connect(partial(self._apply, editor))
        return editors

    def _apply(self, editor: Any) -> None:
        if self.slow:
            self.applied += 1
            editor.apply()

    def lines(self) -> list[Any]:
        """Return what can be typed into, from top to bottom."""
        kinds = (QtGui.QLineEdit, QtGui.QPlainTextEdit)
        found = [widget for kind in kinds for widget in self.panel().findChildren(kind)]
        return [widget for widget in found if widget.isVisible() and widget.isEnabled() and not widget.isReadOnly()]

    def type_all(self, line: Any, slow: str) -> None:
        """Type all texts, one after the other, then one slowly, then what stood there."""
        before = self.hand.main(partial(content, line))
        self.hand.main(partial(focus, line))
        for text in WHOLE:
            self.replace(line, text)
        self.slow = True
        self.replace(line, slow)
        self.slow = False
        self.replace(line, before)

    def replace(self, line: Any, text: str) -> None:
        """Type a text in place of what stands in a line."""
        self.hand.keyboard.stroke("Ctrl+A")
        self.hand.keyboard.stroke("BackSpace")
        for number, letter in enumerate(text, start=1):
            self.hand.keyboard.write(letter)
            if self.slow:
                self.seen(line, text[:number])
        self.seen(line, text)

    def seen(self, line: Any, text: str) -> None:
        """Wait until all keys have arrived."""
        until_s = time.monotonic() + KEY_S
        while self.hand.main(partial(content, line)) != text:
            assert time.monotonic() < until_s, f"{line.objectName()} does not show {text!r}; {self.hand.describe()}"

    def done(self) -> bool:
        return not any(editor.waiting or editor.timer.isActive() for editor in self.editors)


def content(line: Any) -> str:
    return str(line.text() if isinstance(line, QtGui.QLineEdit) else line.toPlainText())


def focus(line: Any) -> None:
    places.scroll_to(line)
    line.setFocus(QtCore.Qt.FocusReason.OtherFocusReason)


def test_no_beginning_of_a_text_freezes_a_panel(hand: Hand) -> None:
    plate = hand.main(draw, limit_s=120)
    hand.keyboard.learn("".join(TEXTS))
    with hidden_view(hand):
        for kind in KINDS:
            watch = type_into_all(hand, kind, plate[kind])
            if watch.max_python_ms >= AT_ONCE_MS or watch.max_waited_ms >= WAITS_MS:
                watch = type_into_all(hand, kind, plate[kind])  # what is slow is slow again; a shared core is not
            assert watch.max_python_ms < AT_ONCE_MS and watch.max_cpu_ms < DRAWN_MS, f"{kind}: {watch}"
            assert watch.max_waited_ms < WAITS_MS, f"{kind}: {watch}"


@contextmanager
def hidden_view(hand: Hand) -> Iterator[None]:
    """Hide what FreeCAD draws of the document."""

    def show(seen: bool) -> None:
        FreeCADGui.getMainWindow().findChild(QtGui.QMdiArea).setVisible(seen)

    hand.main(show, False)
    try:
        yield
    finally:
        hand.main(show, True)


def type_into_all(hand: Hand, kind: str, obj: Any) -> Any:
    """Type into every line of the panel of one object; return the watchdog of that time."""
    before, typist, begun_s = hand.main(values, obj), Typist(hand, obj), time.monotonic()
    lines = hand.main(typist.lines)
    assert lines
    with hand.watchdog() as watch:
        for number, line in enumerate(lines):
            typist.type_all(line, TEXTS[number % len(TEXTS)])
        hand.wait(typist.done, 60, "the last cut")
    took_s = time.monotonic() - begun_s
    print(
        f"{kind}: {len(lines)} fields, {typist.applied} values in {took_s:.1f} s, {watch}".partition(" in\n")[0],
        flush=True,
    )
    assert hand.main(values, obj) == before, kind
    assert hand.main(problem_of, obj) == "", kind
    hand.key("Esc")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 20, "the panel to close")
    return watch
