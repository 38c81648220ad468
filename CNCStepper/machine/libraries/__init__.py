# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's own tools, materials and cut charts as tables that are edited, without a window."""
