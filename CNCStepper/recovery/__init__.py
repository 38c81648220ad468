# SPDX-License-Identifier: LGPL-2.1-or-later
"""Restart of a program in its middle, and retract of a held tool along its path."""
