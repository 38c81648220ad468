# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of the picture of two turned parts; whoever asks for it gives them in another language."""

from __future__ import annotations

from CNCStepper.simulation.comparison.picture_words import WORDS

TURNED_WORDS = {
    **WORDS,
    "rapid": "rapid moves",
    "removed": "removed only by {name}: {volume:.3f} cm³",
    "left": "in both parts",
    "bar": "raw bar",
    "deepest": "largest difference: {distance:.3f} mm",
    "enlarged": "enlarged {times:.3g} times",
}
