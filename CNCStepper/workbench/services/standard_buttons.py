# SPDX-License-Identifier: LGPL-2.1-or-later
"""Qt's standard buttons with texts of ours: some FreeCADs lack Qt's own catalogue for Portuguese."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.services.translation import later, tr

PANEL = "CNCStepper_Panel"
TEXTS = {"Ok": later("OK"), "Cancel": later("Cancel"), "Close": later("Close"), "Apply": later("Apply")}


def name_standard_buttons(box: Any, prefix: str) -> None:
    """Give the buttons of a QDialogButtonBox our texts, and names: PREFIX_ok, PREFIX_cancel, PREFIX_close."""
    from PySide import QtGui

    for name, text in TEXTS.items():
        button = box.button(getattr(QtGui.QDialogButtonBox.StandardButton, name))
        if button is not None:
            button.setText(tr(text))
            button.setObjectName(f"{prefix}_{name.lower()}")
    box.installEventFilter(_make_filter(box))


def _make_filter(box: Any) -> Any:
    """Return the filter that keeps our texts; its class is made here because Qt is loaded only with a window."""
    from PySide import QtCore

    class Texts(QtCore.QObject):
        """Takes the news of a catalogue, at which a QDialogButtonBox gives its buttons Qt's own texts."""

        def eventFilter(self, watched: Any, event: Any) -> bool:
            """Return whether the event ends here."""
            return isinstance(event, QtCore.QEvent) and event.type() == QtCore.QEvent.Type.LanguageChange

    return Texts(box)


class PanelButtons:
    """What FreeCAD's task view asks of a panel about the buttons above it."""

    def modifyStandardButtons(self, box: Any) -> None:
        """Name the buttons; FreeCAD calls this before it shows the panel."""
        name_standard_buttons(box, PANEL)
