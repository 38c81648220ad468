# SPDX-License-Identifier: LGPL-2.1-or-later
"""From moves to segments of steps: look-ahead, ramps, path control modes, backlash, and the controller as a live
object."""
