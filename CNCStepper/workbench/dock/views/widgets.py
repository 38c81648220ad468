# SPDX-License-Identifier: LGPL-2.1-or-later
"""The small parts of which the dock's sections are built: buttons, captions, figures, locks."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.errors import Text
from CNCStepper.workbench.dock.model.button_states import CALM, DANGER, GOING, OFF, WAITING
from CNCStepper.workbench.dock.views.keyboard import KeyButton
from CNCStepper.workbench.services import icons
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

NAME = "CNCStepper_Dock_"
SPACE = 6
# Ground and letters of each tone; both are set, so that they read in light and in dark themes alike.
TONES = {
    OFF: ("#5b6673", "#ffffff"),
    CALM: ("#2f6f9f", "#ffffff"),
    GOING: ("#23803f", "#ffffff"),
    WAITING: ("#f2b632", "#231a00"),
    DANGER: ("#b3261e", "#ffffff"),
}
# Themes make their buttons wide: ours are as wide as what stands on them, and the one chosen is seen in every theme.
BUTTON = (
    "QPushButton {{ padding: 3px 4px; min-width: {0}px; }}"
    f"QPushButton:checked {{{{ background: {TONES[CALM][0]}; color: {TONES[CALM][1]}; border-radius: 3px; }}}}"
)
ICON_WIDTH = 24
LONG_WORD, UNBROKEN, BREAK = 24, 8, "\u200b"  # characters; a place for a line's end that takes no room


def named(widget: Any, what: str) -> Any:
    """Return the widget after giving it the name by which tests and style sheets find it."""
    widget.setObjectName(NAME + what)
    return widget


def button(what: str, text: str, clicked: Callable[[], object] | None = None, icon: str = "") -> Any:
    """Return a button with a text that is translated already, and an icon of ours by its short name."""
    made = named(KeyButton(text), what)
    made.setStyleSheet(BUTTON.format(made.fontMetrics().boundingRect(text).width() + (ICON_WIDTH if icon else 2)))
    made.setSizePolicy(QtGui.QSizePolicy.Policy.Expanding, QtGui.QSizePolicy.Policy.Fixed)
    if icon:
        made.setIcon(icons.icon(NAME + icon))
    if clicked is not None:
        made.clicked.connect(guarded(clicked))
    return made


def caption(text: str) -> Any:
    """Return the heading of a section."""
    label = QtGui.QLabel(text)
    font = label.font()
    font.setBold(True)
    label.setFont(font)
    return label


def breakable(text: str) -> str:
    """Return a text whose long words, such as lines of pulse letters, may be broken between any few letters."""
    return " ".join(
        BREAK.join(word[at : at + UNBROKEN] for at in range(0, len(word), UNBROKEN)) if len(word) > LONG_WORD else word
        for word in text.split(" ")
    )


def wrapped(what: str, text: str = "") -> Any:
    """Return a label for sentences, as high as they need; words of controllers are never taken for rich text."""
    label = named(QtGui.QLabel(text), what)
    label.setTextFormat(QtCore.Qt.TextFormat.PlainText)
    label.setWordWrap(True)
    label.setMinimumWidth(1)
    return label


def steady(label: Any, lines: int) -> Any:
    """Return a label with room for so many lines: what stands below does not move when its text grows."""
    label.setMinimumHeight(lines * label.fontMetrics().lineSpacing())
    label.setAlignment(QtCore.Qt.AlignmentFlag.AlignTop | QtCore.Qt.AlignmentFlag.AlignLeft)
    return label


def figure(what: str, scale: float = 1.0, text: str = "–", widest: str = "") -> Any:
    """Return a right-aligned label with digits of equal width; widest: a text for which there is always room."""
    label = named(QtGui.QLabel(text), what)
    font = QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.SystemFont.FixedFont)
    font.setPointSizeF(label.font().pointSizeF() * scale)
    label.setFont(font)
    label.setMinimumWidth(QtGui.QFontMetrics(font).boundingRect(widest).width() + 2 if widest else 0)
    label.setAlignment(QtCore.Qt.AlignmentFlag.AlignRight | QtCore.Qt.AlignmentFlag.AlignVCenter)
    return label


def line() -> Any:
    """Return a thin line between two sections."""
    made = QtGui.QFrame()
    made.setFrameShape(QtGui.QFrame.Shape.HLine)
    made.setFrameShadow(QtGui.QFrame.Shadow.Sunken)
    return made


def column(parent: Any = None) -> Any:
    """Return a vertical layout without margins."""
    layout = QtGui.QVBoxLayout(parent) if parent is not None else QtGui.QVBoxLayout()
    layout.setContentsMargins(0, 0, 0, 0)
    layout.setSpacing(SPACE)
    return layout


def row(*widgets: Any) -> Any:
    """Return widgets in a row."""
    layout = QtGui.QHBoxLayout()
    layout.setContentsMargins(0, 0, 0, 0)
    layout.setSpacing(SPACE)
    for widget in widgets:
        layout.addWidget(widget)
    return layout


def grid(parent: Any = None) -> Any:
    """Return a grid without margins."""
    layout = QtGui.QGridLayout(parent) if parent is not None else QtGui.QGridLayout()
    layout.setContentsMargins(0, 0, 0, 0)
    layout.setSpacing(SPACE)
    return layout


def lock(widget: Any, why_not: str, does: str) -> None:
    """Enable a widget when `why_not` is empty; its tooltip has its purpose, or the reason."""
    widget.setEnabled(not why_not)
    widget.setToolTip(translated(why_not) if isinstance(why_not, Text) else tr(why_not or does))
