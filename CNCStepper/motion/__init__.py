# SPDX-License-Identifier: LGPL-2.1-or-later
"""From moves to steps: look-ahead planner, ramps and step generator, behaving as grbl 1.1 does."""
