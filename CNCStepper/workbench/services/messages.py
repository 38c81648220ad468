# SPDX-License-Identifier: LGPL-2.1-or-later
"""Messages to the person at the window, and the one guard through which Qt and FreeCAD call us.

A CNCStepperError becomes a message with its text. Anything else that escapes is a fault of the program: it
becomes a message that says where to report it, with the details, and stands in the report view.
"""

from __future__ import annotations

import functools
import inspect
import traceback
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from CNCStepper.errors import CNCStepperError, Place, Text
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.plain_words import plain
from CNCStepper.workbench.services.translation import tr

NAME = "CNCStepper"
REPORT_AT = "https://github.com/cncstepper/CNCStepper/issues"
NOTE_MS = 8000
Answers = Mapping[str, tuple[str, str]]  # by their names: the text of the button, its role in Qt


def guarded(function: Callable[..., Any], repeat: bool = True) -> Callable[..., Any]:
    """Return `function` for Qt or FreeCAD to call: an exception is reported, and None returned.

    Surplus arguments are dropped, as Qt itself does for a slot: `clicked` sends one that few slots take.
    repeat: whether the same fault is told again when it happens again.
    """
    takes = _arguments_taken(function)
    told: set[str] = set()

    @functools.wraps(function)
    def call(*arguments: Any, **named: Any) -> Any:
        try:
            return function(*arguments[:takes], **named)
        except Exception as problem:
            if repeat or str(problem) not in told:
                told.add(str(problem))
                error(problem)
            return None

    del call.__wrapped__  # type: ignore[attr-defined]  # PySide must count the arguments of `call`
    return call


def polled(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return `function` guarded, for a timer: each fault is reported once."""
    return guarded(function, repeat=False)


def _arguments_taken(function: Callable[..., Any]) -> int | None:
    """Return how many positional arguments a function takes, None for any number."""
    kinds = [parameter.kind for parameter in inspect.signature(function).parameters.values()]
    if inspect.Parameter.VAR_POSITIONAL in kinds:
        return None
    return sum(kind in (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD) for kind in kinds)


def error(problem: BaseException) -> None:
    """Show an error and return at once; without a window it is printed."""
    if isinstance(problem, CNCStepperError):
        _show("error", "Warning", sentence(problem), plain(translated(problem.advice)))
        return
    import FreeCAD

    details = "".join(traceback.format_exception(problem))
    FreeCAD.Console.PrintError(f"{NAME}: {details}\n")
    what = tr("CNCStepper has a fault: {0}").format(f"{type(problem).__name__}: {problem}")
    _show("fault", "Critical", what, tr("Please report it, with the details, at {0}").format(REPORT_AT), details)


def notice(text: str, more: str = "", remedy: tuple[str, Callable[[], Any]] | None = None) -> None:
    """Show something that concerns the whole workbench in a window of its own, and return at once.

    remedy: the text of a button, and what it does.
    """
    _show("notice", "Information", text, more, remedy=remedy)


def note(text: str) -> None:
    """Say something in passing, in the status bar."""
    import FreeCAD

    if FreeCAD.GuiUp:
        import FreeCADGui

        FreeCADGui.getMainWindow().statusBar().showMessage(text, NOTE_MS)
    else:
        FreeCAD.Console.PrintMessage(f"{NAME}: {text}\n")


def ask(question: str, yes: str, no: str, more: str = "") -> bool:
    """Ask a question, wait, and return whether the button `yes` was pressed; Esc and closing mean no."""
    box = _box("ask", "Question", question, more)
    return _answer(box, "CNCStepper_Tell", {"yes": (yes, "Accept"), "no": (no, "Reject")}, "no") == "yes"


def choose(name: str, icon: str, title: str, text: str, answers: Answers, default: str, more: str = "") -> str:
    """Ask which of several answers, wait, and return the name of one; Esc and closing mean the last one.

    name: of the box for Qt, with which those of its buttons begin.
    """
    import FreeCADGui
    from PySide import QtGui

    box = QtGui.QMessageBox(FreeCADGui.getMainWindow())
    box.setObjectName(name)
    box.setIcon(getattr(QtGui.QMessageBox.Icon, icon))
    box.setWindowTitle(title)
    box.setText(text)
    box.setInformativeText(more)
    return _answer(box, name, answers, default)


def _answer(box: Any, prefix: str, answers: Answers, default: str) -> str:
    """Show a box with a button for each answer, wait, and return the name of the one that was pressed."""
    from PySide import QtGui

    roles, last = QtGui.QMessageBox.ButtonRole, [*answers][-1]
    buttons = {name: box.addButton(text, getattr(roles, f"{role}Role")) for name, (text, role) in answers.items()}
    for name, button in buttons.items():
        button.setObjectName(f"{prefix}_{name}")
    box.setEscapeButton(buttons[last])
    box.setDefaultButton(buttons[default])
    getattr(box, "exec", box.exec_)()
    clicked = box.clickedButton()
    box.deleteLater()
    return next((name for name, button in buttons.items() if button is clicked), last)


def sentence(problem: CNCStepperError) -> str:
    """Return an error's text, with its place, value and limit, without its advice and code."""
    limit = problem.limit and tr("limit {0}").format(translated(problem.limit))
    value = translated(problem.value) if isinstance(problem.value, Text) else problem.value
    numbers = [part for part in (value, limit) if part]
    place = f"{_named(problem.place)}: " if problem.place else ""
    return plain(f"{place}{translated(problem.what)}" + (f" ({', '.join(numbers)})" if numbers else ""))


def _named(place: Place) -> Place:
    """Return a place that is an operation, a row or a profile with its name in FreeCAD's language."""
    return replace(place, file=translated(place.file))


def _show(
    kind: str,
    icon: str,
    text: str,
    more: str = "",
    details: str = "",
    remedy: tuple[str, Callable[[], Any]] | None = None,
) -> None:
    import FreeCAD

    if not FreeCAD.GuiUp:
        FreeCAD.Console.PrintMessage(f"{NAME}: {text}; {more}\n")
        return
    from PySide import QtCore, QtGui

    box = _box(kind, icon, text, more)
    button = box.addButton(QtGui.QMessageBox.StandardButton.Ok)
    button.setText(tr("OK"))
    button.setObjectName("CNCStepper_Tell_ok")
    if remedy:
        button = box.addButton(remedy[0], QtGui.QMessageBox.ButtonRole.ActionRole)
        button.setObjectName("CNCStepper_Tell_remedy")
        button.clicked.connect(guarded(remedy[1]))
        box.setDefaultButton(button)
    if details:
        box.setDetailedText(details)
    box.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
    box.open() if kind != "notice" else box.show()


def _box(kind: str, icon: str, text: str, more: str) -> Any:
    import FreeCADGui
    from PySide import QtCore, QtGui

    box = QtGui.QMessageBox(FreeCADGui.getMainWindow())
    box.setObjectName(f"CNCStepper_Tell_{kind}")
    box.setModal(kind != "notice")
    box.setWindowTitle(NAME)
    box.setIcon(getattr(QtGui.QMessageBox.Icon, icon))
    box.setTextFormat(QtCore.Qt.TextFormat.PlainText)
    box.setText(text)
    box.setInformativeText(more)
    box.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
    return box
