# SPDX-License-Identifier: LGPL-2.1-or-later
"""Interpolators that turn one line, arc or ellipse into steps: Bresenham and DDA."""
