# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verbs for a connected machine without a job: ports, homing, zero, jog, console, and virtual controllers."""
