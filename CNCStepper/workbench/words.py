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
