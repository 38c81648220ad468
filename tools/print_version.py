# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints `FreeCAD.Version()` from inside: `freecadcmd tools/print_version.py`."""

import os
import sys

import FreeCAD

print("FreeCAD.Version()", ".".join(FreeCAD.Version()[:3]), FreeCAD.Version(), flush=True)
sys.stdout.flush()
os._exit(0)
