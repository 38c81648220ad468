# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pockets of every shape: any region with islands, circles, rectangles, ellipses."""
