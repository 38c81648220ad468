# SPDX-License-Identifier: LGPL-2.1-or-later
"""The geometry of moves: end points, arcs, polar and rotated coordinates, splines."""
