# SPDX-License-Identifier: LGPL-2.1-or-later
"""The model of the dock; it imports Qt and FreeCAD only inside functions."""
