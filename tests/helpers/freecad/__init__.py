# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents and scripts for tests inside FreeCAD."""
