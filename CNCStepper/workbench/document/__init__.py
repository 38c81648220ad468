# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects of a FreeCAD document and the core's values: job, machine, stock, clamps, order, undo, selection."""
