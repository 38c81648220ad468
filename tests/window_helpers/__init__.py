# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's window for tests: its start on a screen of its own, and a hand at its mouse and keys inside."""
