# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words that a person sees, in FreeCAD's language."""

from __future__ import annotations

CONTEXT = "CNCStepper"


def tr(text: str) -> str:
    """Return an English text in FreeCAD's language; values are put in afterwards: `tr("{0} mm").format(depth)`."""
    import FreeCAD

    return FreeCAD.Qt.translate(CONTEXT, text)


def later(text: str) -> str:
    """Return the text as it is: it marks one in a table for the translators, `tr` translates it when it is shown."""
    return text


def QT_TRANSLATE_NOOP(context: str, text: str) -> str:
    """Return the text as it is: it marks one that FreeCAD itself translates when it shows it, in a context of its own.

    FreeCAD looks up a command's menu text and tooltip in the context of the command's name. The name is
    the one that Qt's and FreeCAD's translators know.
    """
    return text
