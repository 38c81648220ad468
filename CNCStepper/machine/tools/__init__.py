# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutters, and the tool files of FreeCAD and LinuxCNC."""
