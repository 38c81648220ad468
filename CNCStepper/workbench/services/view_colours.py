# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours of lines and marks in FreeCAD's 3D view, red, green and blue from 0 to 1.

People who see red, green or blue poorly tell them apart, too, and from FreeCAD's own red and green paths: a test
computes what they see. They are taken from Okabe and Ito's palette where that has one.
"""

from __future__ import annotations

Rgb = tuple[float, float, float]

FEED_RGB: Rgb = (0.13, 0.15, 0.18)
RAPID_RGB: Rgb = (0.90, 0.62, 0.0)
REPORTED_RGB: Rgb = (0.90, 0.62, 0.0)  # the path of the machine's reports, which is shown in place of the program's
STOCK_RGB: Rgb = (0.55, 0.45, 0.35)  # of wood: seen on FreeCAD's blue and on white
MARKER_RGB: Rgb = (0.85, 0.20, 0.05)  # of a finding and of the line under the cursor
CLAMP_RGB: Rgb = (0.78, 0.16, 0.55)
