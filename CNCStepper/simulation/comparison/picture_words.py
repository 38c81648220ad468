# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of the picture of two paths; whoever asks for it gives them in another language."""

from __future__ import annotations

WORDS = {
    "first": "only in {name}",
    "second": "only in {name}",
    "common": "in both",
    "rapid": "rapid",
    "deviation": "largest deviation: {distance:.3f} mm",
}
