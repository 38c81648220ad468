# SPDX-License-Identifier: LGPL-2.1-or-later
"""What drawings in a FreeCAD document hold: curves, circles, rectangles, ellipses, islands."""
