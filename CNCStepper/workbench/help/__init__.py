# SPDX-License-Identifier: LGPL-2.1-or-later
"""Help in FreeCAD's window: F1 at a field, in a panel or in the dock opens its page; the menu opens the contents."""
