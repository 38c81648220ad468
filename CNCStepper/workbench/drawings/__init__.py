# SPDX-License-Identifier: LGPL-2.1-or-later
"""Geometry of drawings in a FreeCAD document: curves, circles, rectangles, ellipses, islands."""
