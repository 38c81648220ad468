# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the dock knows and remembers; Qt and FreeCAD only inside functions."""
