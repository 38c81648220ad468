# SPDX-License-Identifier: LGPL-2.1-or-later
"""The jog pad: steps of a chosen length, or motion for as long as a button is held down.

Held down, the motion is renewed ten times a second, only while the button is still down and the window has the focus:
when a window hangs or dies, the machine stops by itself within a few tenths of a second.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.control.service.connection_client import JOG_RENEW_S
from CNCStepper.workbench.dock.model import settings
from CNCStepper.workbench.dock.model.button_states import RULES, ControllerSnapshot, why_not, why_not_axis
from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.dock.views.jog_keys import JogKeys
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.number_format import Lengths
from CNCStepper.workbench.services.translation import tr

DEFAULT_STEP = 2  # 1 mm
PAD = (  # name, axis, sign, row, column
    ("YPlus", "y", 1, 0, 1),
    ("XMinus", "x", -1, 1, 0),
    ("XPlus", "x", 1, 1, 2),
    ("YMinus", "y", -1, 2, 1),
    ("ZPlus", "z", 1, 0, 3),
    ("ZMinus", "z", -1, 2, 3),
)
LONGEST_FEED_MM_MIN = 20_000.0
RENEW_MS = round(1000 * JOG_RENEW_S)


class JogView(QtGui.QWidget):
    """Arrows, steps and feed; `command` passes "jog", "jog_on" and "jog_cancel" to the connection client."""

    def __init__(self, lengths: Lengths, point: str, command: Callable[..., None]):
        super().__init__()
        self._lengths, self._command = lengths, command
        self._held: tuple[Any, dict[str, float]] | None = None  # the arrow that is down, and its direction
        self.arrows = {name: self._arrow(name, axis, sign) for name, axis, sign, *_ in PAD}
        pad = widgets.grid()
        for name, _, _, line, place in PAD:
            pad.addWidget(self.arrows[name], line, place)
        layout = widgets.column(self)
        layout.addLayout(pad)
        layout.addLayout(self._steps(point))
        layout.addLayout(widgets.row(self._continuous(), self._feed_box()))
        self.keys = JogKeys(self.arrows)
        layout.addWidget(self.keys)
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(RENEW_MS)
        self._timer.timeout.connect(guarded(self._renew))

    @property
    def feed_mm_min(self) -> float:
        """The feed chosen for jogging."""
        return self.feed.value() * self._lengths.mm

    def lock(self, moment: ControllerSnapshot) -> None:
        """Enable the arrows when the machine can be moved by hand."""
        why = why_not("jog", moment)
        if why and self._held:
            self._release()
        for name, axis, *_ in PAD:
            widgets.lock(self.arrows[name], why or why_not_axis(axis, moment), RULES["jog"].does)

    def _arrow(self, name: str, axis: str, sign: int) -> Any:
        arrow = widgets.button(f"Jog{name}", f"{axis.upper()}{'+' if sign > 0 else '−'}", icon=f"Jog{name}")
        arrow.setFocusPolicy(QtCore.Qt.FocusPolicy.NoFocus)  # no key may move the machine but those of `JogKeys`
        arrow.setAccessibleName(f"{tr('Jog')} {arrow.text()}")
        arrow.setMinimumHeight(arrow.sizeHint().height() + 8)
        arrow.pressed.connect(guarded(partial(self._pressed, arrow, axis, sign)))
        arrow.released.connect(guarded(self._release))
        return arrow

    def _steps(self, point: str) -> Any:
        self.group = QtGui.QButtonGroup(self)
        buttons = [self._choice(self._lengths.step_text(step, point)) for step in self._lengths.steps]
        for button in buttons:
            button.setAccessibleName(f"{tr('Step ({0})').format(self._lengths.name)}: {button.text()}")
            button.setToolTip(tr("How far one click moves the machine."))
        buttons[DEFAULT_STEP].setChecked(True)
        return widgets.row(QtGui.QLabel(tr("Step ({0})").format(self._lengths.name)), *buttons)

    def _continuous(self) -> Any:
        button = self._choice(tr("While pressed"))
        button.setToolTip(tr("Move for as long as an arrow is held down; letting go stops."))
        return button

    def _choice(self, text: str) -> Any:
        index = len(self.group.buttons())
        button = widgets.button(f"Step{index}", text)
        button.setCheckable(True)
        self.group.addButton(button, index)
        return button

    def _feed_box(self) -> Any:
        self.feed = widgets.named(QtGui.QDoubleSpinBox(), "JogFeed")
        self.feed.setDecimals(self._lengths.decimals - 3)
        self.feed.setRange(1.0, LONGEST_FEED_MM_MIN / self._lengths.mm)
        self.feed.setValue(settings.jog_feed_mm_min() / self._lengths.mm)
        self.feed.setPrefix(tr("Feed") + " ")
        self.feed.setAccessibleName(tr("Feed"))
        self.feed.setSuffix(f" {self._lengths.speed_name}")
        self.feed.setToolTip(tr("How fast the machine moves while jogging; it never goes faster than it can."))
        self.feed.valueChanged.connect(guarded(self._remember))
        return self.feed

    def _remember(self) -> None:
        settings.remember_jog_feed(self.feed_mm_min)

    def _pressed(self, arrow: Any, axis: str, sign: int) -> None:
        step = self.group.checkedId()
        if step < len(self._lengths.steps):
            length_mm = sign * self._lengths.steps[step] * self._lengths.mm
            self._command("jog", feed_mm_min=self.feed_mm_min, **{f"{axis}_mm": length_mm})
            return
        self._held = (arrow, {axis: float(sign)})
        self._renew()
        self._timer.start()

    def _renew(self) -> None:
        """Go on while the arrow is still held and seen; stop otherwise."""
        if not self._held:
            return
        arrow, direction = self._held
        if arrow.isDown() and arrow.isVisible() and self.window().isActiveWindow():
            self._command("jog_on", feed_mm_min=self.feed_mm_min, **direction)
        else:
            self._release()

    def _release(self) -> None:
        if self._held:
            self._held = None
            self._timer.stop()
            self._command("jog_cancel")
