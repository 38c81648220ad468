# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a contour is made of: its sides, leads, tabs, dog-bones, levels and what it removes."""
